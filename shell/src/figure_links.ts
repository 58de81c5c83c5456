import { figureHash, readFigureHash } from './addresses';
import { RefusedError } from './bridge';
import type { Said } from './said';
import type { Figure, Scenes } from './scenes';
import { say } from './words';

/// How long it is said that an address asks for too much.
const refusalMs = 12_000;

/// Addresses of figures: made for the reader, and followed when the page is opened with one, when it comes while the
/// page is open, and back and forth.
export class FigureLinks {
  private readonly figures: readonly Figure[];
  private readonly scenes: Scenes;
  private readonly said: Said;
  /// What the last address asked of a figure. Who comes back to that address finds the figure as he has left it.
  private readonly followed = new Map<Figure, string>();

  constructor(figures: readonly Figure[], scenes: Scenes, said: Said) {
    this.figures = figures;
    this.scenes = scenes;
    this.said = said;
  }

  async copy(figure: Figure): Promise<void> {
    const hash = await figureHash(figure.id, await this.scenes.difference(figure));
    await this.said.copy(location.href.replace(/#.*/s, '') + hash);
  }

  /// From now on the stage goes with the address.
  follow(): void {
    void this.go(cameBack());
    addEventListener('hashchange', () => {
      const back = cameBack();
      if (!back) scrollToFigure(location.hash);
      void this.go(back);
    });
    markVisited();
  }

  private async go(back: boolean): Promise<void> {
    markVisited();
    const asked = readFigureHash(location.hash);
    if (!asked) return;
    const { id, query } = asked;
    const figure = this.figures.find((other) => other.id === id);
    if (!figure) {
      this.said.say(say('There is no figure "{}" on this page.', id), refusalMs);
      return;
    }
    try {
      const known = this.followed.get(figure);
      if (query === '' || (back && query === known)) {
        await (back && query === '' && known ? this.scenes.again(figure) : this.scenes.show(figure));
      } else {
        // The reader may have gone on meanwhile.
        if (!(await this.scenes.give(figure, query))) return;
      }
      this.followed.set(figure, query);
    } catch (error) {
      const at = error instanceof RefusedError && error.path ? `${error.path}: ` : '';
      const reason = at + say(error instanceof Error ? error.message : String(error));
      this.said.say(say('What this address asks for cannot be shown. {}', reason), refusalMs);
    }
  }
}

/// A figure's address with a state is no name that the browser finds in the page.
export function scrollToFigure(hash: string): void {
  const asked = readFigureHash(hash);
  if (asked?.query) document.getElementById(`figure-${asked.id}`)?.scrollIntoView({ behavior: 'instant' });
}

/// Whether the reader has been at this address before, so that the browser restores where he was in the page.
export function cameBack(): boolean {
  return (history.state as { visited?: true } | null)?.visited === true;
}

function markVisited(): void {
  history.replaceState({ visited: true }, '');
}
