import { element } from './controls';
import { say } from './words';

/// A few words at the foot of the prose for a short while: that an address has been copied, or what is wrong with one.
/// Where the clipboard refuses, the address itself, to be copied by hand. For ears, `announce` says the same.
export class Said {
  private readonly place = element('div', 'said');
  private readonly announce: (words: string) => void;
  private goes = 0;

  constructor(announce: (words: string) => void) {
    this.announce = announce;
    this.place.hidden = true;
    document.getElementById('prose')!.append(this.place);
  }

  say(words: string, milliseconds = 4000): void {
    const text = element('p', '', words);
    text.ariaHidden = 'true';  // the live region has it
    this.show(text);
    this.announce(words);
    this.goes = window.setTimeout(() => this.hide(), milliseconds);
  }

  async copy(address: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(address);  // there is none on a page that did not come safely
    } catch {
      this.offer(address);
      return;
    }
    this.say(say('The link has been copied.'));
  }

  private offer(address: string): void {
    const before = document.activeElement;
    const label = element('label', '', say('The link, to be copied by hand'));
    const field = element('input', '');
    field.id = 'link-by-hand';
    field.readOnly = true;
    field.value = address;
    label.htmlFor = field.id;
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      if (before instanceof HTMLElement) before.focus({ preventScroll: true });
      this.hide();
    });
    field.addEventListener('blur', () => {
      if (document.hasFocus()) this.hide();  // not while the reader is in another window, where the address is to go
    });
    this.show(label, field);
    field.focus({ preventScroll: true });
    field.select();
  }

  private show(...parts: HTMLElement[]): void {
    clearTimeout(this.goes);
    this.place.replaceChildren(...parts);
    this.place.hidden = false;
  }

  private hide(): void {
    clearTimeout(this.goes);
    this.place.hidden = true;
  }
}
