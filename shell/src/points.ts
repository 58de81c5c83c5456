import { RefusedError, type Bridge } from './bridge';
import { element } from './controls';
import { say } from './words';

/// No longer text is read by the module; what is cut off here would only be refused there.
const longestText = 8 * 1024 * 1024 + 1;

/// Hands points written as text to the stage; throws a RefusedError that names line and fault.
export function givePoints(bridge: Bridge, text: string): void {
  bridge.points(text.slice(0, longestText));
}

/// Points pasted while the stage has the focus. What is wrong with them the stage says itself.
export function listenToPaste(canvas: HTMLCanvasElement, bridge: Bridge, after: () => void): void {
  document.addEventListener('paste', (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    try {
      givePoints(bridge, event.clipboardData?.getData('text/plain') ?? '');
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
    }
    after();
  });
}

/// The same for those without a keyboard: a field among the settings, shown while the stage has a figure that is made
/// from a list of points.
export class PointsField {
  readonly element = element('details', 'points');
  private readonly field = element('textarea', '');
  private readonly fault = element('p', 'reason');

  constructor(take: (text: string) => void, present: () => string) {
    const label = element('label', '', say('Two or three numbers on each line, or a JSON list of such lists'));
    this.field.id = 'points-text';
    this.field.rows = 6;
    this.field.spellcheck = false;
    this.field.autocapitalize = 'off';
    this.field.placeholder = '0, 0\n1.5, 2\n3, 1.2, 0.5';
    label.htmlFor = this.field.id;
    this.fault.id = 'points-fault';
    this.fault.setAttribute('role', 'status');
    const use = button(say('Use these points'), () => {
      try {
        take(this.field.value);
        this.say('');
      } catch (error) {
        this.say(faultText(error));
      }
    });
    const show = button(say('Write the present ones'), () => {
      this.field.value = present();
      this.say('');
    });
    const buttons = element('div', 'buttons');
    buttons.append(use, show);
    this.element.append(element('summary', '', say('Points as text')), label, this.field, this.fault, buttons);
    this.say('');
  }

  private say(text: string): void {
    this.fault.textContent = text;
    this.fault.hidden = text === '';
    this.field.setAttribute('aria-invalid', String(text !== ''));
    if (text === '') this.field.removeAttribute('aria-describedby');
    else this.field.setAttribute('aria-describedby', this.fault.id);
  }
}

/// "Line 3: ..." of an error that names a line.
export function faultText(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const line = error instanceof RefusedError && /^line \d+$/.test(error.path) ? error.path : '';
  return line ? `${say('Line {}', line.slice(5))}: ${say(error.message)}` : say(error.message);
}

/// A point on each line.
export function pointsText(points: readonly (readonly number[])[]): string {
  return points.map((point) => point.join(', ')).join('\n');
}

function button(text: string, press: () => void): HTMLButtonElement {
  const made = element('button', 'button', text);
  made.type = 'button';
  made.addEventListener('click', press);
  return made;
}
