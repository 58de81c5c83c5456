import type { FigureLinks } from './figure_links';
import type { Figure, Scenes } from './scenes';
import { say } from './words';

/// The words under a figure's caption: which one is on the stage, its address, and how it starts again. The stage is described by the
/// caption of what it shows.
export class FigureTools {
  private readonly rows: { figure: Figure; show: HTMLButtonElement; again: HTMLButtonElement }[] = [];
  private readonly scenes: Scenes;
  private readonly canvas: HTMLCanvasElement;
  private readonly keys: string;
  private described: Figure | null = null;

  constructor(
    figures: readonly Figure[],
    scenes: Scenes,
    links: FigureLinks,
    canvas: HTMLCanvasElement,
    failed: (error: unknown) => void,
  ) {
    this.scenes = scenes;
    this.canvas = canvas;
    this.keys = canvas.getAttribute('aria-describedby') ?? '';
    for (const figure of figures) {
      const show = figure.element.querySelector<HTMLButtonElement>('[data-show]');
      const again = figure.element.querySelector<HTMLButtonElement>('[data-again]');
      const copy = figure.element.querySelector<HTMLButtonElement>('[data-copy]');
      if (!show || !again || !copy) continue;
      // Of a figure that is there already, it leads onto the stage: for keys the way through the prose would be long.
      show.addEventListener('click', () => {
        if (figure === scenes.shown) canvas.focus({ preventScroll: true });
        else void scenes.show(figure).catch(failed);
      });
      again.addEventListener('click', () => {
        if (again.ariaDisabled === 'false') void scenes.again(figure).catch(failed);
      });
      copy.addEventListener('click', () => void links.copy(figure).catch(failed));
      show.disabled = again.disabled = copy.disabled = false;
      this.rows.push({ figure, show, again });
    }
  }

  update(canUndo: boolean): void {
    const { shown } = this.scenes;
    if (shown !== this.described) {
      this.described = shown;
      this.canvas.setAttribute('aria-describedby', `${shown ? `caption-${shown.id} ` : ''}${this.keys}`);
    }
    for (const { figure, show, again } of this.rows) {
      const here = figure === shown;
      figure.element.toggleAttribute('data-shown', here);
      show.textContent = here ? say('On the stage') : say('Show on the stage');
      again.ariaDisabled = String(!here || !canUndo);  // disabled, it would lose the focus
    }
  }
}
