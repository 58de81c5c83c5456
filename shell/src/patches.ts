import type { State } from './bridge';
import { element } from './controls';
import type { Handle } from './knotwork';
import { say } from './words';

/// Stands in for the handles on the stage: a list to choose one from, by keyboard and for screen readers. Moving the
/// chosen one is done with the arrow keys on the stage, which gets the focus from the button.
export class PatchList {
  private readonly select = element('select', '');
  private listed = '';

  constructor(place: HTMLElement, choose: (id: string) => void, goToStage: () => void) {
    this.select.id = 'patch';
    const label = element('label', 'label', say('Selected patch'));
    label.htmlFor = this.select.id;
    this.select.addEventListener('change', () => choose(this.select.value));
    const frame = element('div', 'choose');
    frame.append(this.select);
    const button = element('button', 'act', say('move it with the keys'));
    button.type = 'button';
    button.addEventListener('click', goToStage);
    place.replaceChildren(label, frame, button);
  }

  /// Asks for the handles only when their number has changed: there may be thousands.
  update(state: State, handles: () => readonly Handle[]): void {
    const { surface } = state;
    this.select.disabled = !surface;
    const key = surface ? `${surface.u.locals} ${surface.v.locals}` : '';
    if (key !== this.listed) {
      this.listed = key;
      this.select.replaceChildren(
        new Option(say('none'), ''),
        ...(surface ? handles().map((handle) => new Option(say(handle.label), handle.id)) : []),
      );
    }
    if (surface && this.select.value !== state.selected) this.select.value = state.selected;
  }
}
