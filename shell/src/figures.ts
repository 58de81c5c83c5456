import type { Figure, Scenes } from './scenes';

/// The words under a figure's caption: which one is on the stage, and how it starts again.
export class FigureTools {
  private readonly rows: { figure: Figure; show: HTMLButtonElement; again: HTMLButtonElement }[] = [];
  private readonly scenes: Scenes;

  constructor(figures: readonly Figure[], scenes: Scenes, failed: (error: unknown) => void) {
    this.scenes = scenes;
    for (const figure of figures) {
      const show = figure.element.querySelector<HTMLButtonElement>('[data-show]');
      const again = figure.element.querySelector<HTMLButtonElement>('[data-again]');
      if (!show || !again) continue;
      show.addEventListener('click', () => void scenes.show(figure).catch(failed));
      again.addEventListener('click', () => void scenes.again(figure).catch(failed));
      show.disabled = false;
      this.rows.push({ figure, show, again });
    }
  }

  update(canUndo: boolean): void {
    const { shown } = this.scenes;
    for (const { figure, show, again } of this.rows) {
      const here = figure === shown;
      figure.element.toggleAttribute('data-shown', here);
      show.textContent = here ? 'On the stage' : 'Show on the stage';
      show.ariaDisabled = String(here);
      again.disabled = !here || !canUndo;
    }
  }
}
