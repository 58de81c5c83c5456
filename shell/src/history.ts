import type { State } from './bridge';
import { say } from './words';

/// Undo and redo: two buttons, and the usual keys anywhere on the page but in text fields.
export class HistoryControls {
  private readonly undoButton = button('undo');
  private readonly redoButton = button('redo');

  constructor(undo: () => void, redo: () => void) {
    this.undoButton.addEventListener('click', undo);
    this.redoButton.addEventListener('click', redo);
    addEventListener('keydown', (event) => {
      const meaning = historyKey(event);
      if (!meaning || event.defaultPrevented || editsText(event.target)) return;
      event.preventDefault();
      if (meaning === 'undo') undo();
      else redo();
    });
  }

  update(state: State): void {
    name(this.undoButton, say('Undo'), state.canUndo, state.undoLabel);
    name(this.redoButton, say('Redo'), state.canRedo, state.redoLabel);
  }
}

export function historyKey(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return null;
  const key = event.key.toLowerCase();
  if (key === 'z') return event.shiftKey ? 'redo' : 'undo';
  return key === 'y' && !event.shiftKey ? 'redo' : null;
}

function editsText(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches('textarea, input:not([type=range], [type=radio], [type=checkbox])'))
  );
}

function button(id: string): HTMLButtonElement {
  return document.getElementById(id) as HTMLButtonElement;
}

function name(target: HTMLButtonElement, verb: string, possible: boolean, label: string): void {
  const text = possible && label ? `${verb}: ${say(label)}` : verb;
  if (target.title !== text) {
    target.title = text;
    target.querySelector('.hidden')!.textContent = text;
  }
  // A disabled button would drop the focus that a reader has on it.
  target.setAttribute('aria-disabled', String(!possible));
  target.disabled = false;
}
