import type { Bridge } from './bridge';
import { parseGoal, reached, type Comparison } from './goals';
import type { Parameter } from './knotwork';
import type { Figure, Scenes } from './scenes';
import { say } from './words';

const storageKey = 'knotwork.solved';

/// Exercises notice by themselves that they are solved; which ones have been is kept in this browser alone.
export class Exercises {
  private readonly rows: { figure: Figure; goal: Comparison[]; state: HTMLElement; done: HTMLElement }[] = [];
  private readonly solved: Set<string>;
  /// What addresses have made of figures (Scenes.giftOf), where the reader has gone on from there.
  private readonly left = new WeakSet<object>();
  private held = false;
  private readonly scenes: Scenes;
  private readonly bridge: Bridge;
  private readonly announce: (words: string) => void;
  private readonly forgetButton = document.getElementById('forget');

  /// `refresh` has to call update().
  constructor(
    figures: readonly Figure[],
    scenes: Scenes,
    bridge: Bridge,
    announce: (words: string) => void,
    refresh: () => void,
  ) {
    this.scenes = scenes;
    this.bridge = bridge;
    this.announce = announce;
    this.solved = new Set(read());
    for (const figure of figures) {
      const goal = figure.element.dataset['goal'];
      const state = figure.element.querySelector<HTMLElement>('.exercise-state');
      const done = figure.element.querySelector<HTMLElement>('.exercise-done');
      if (goal && state && done) this.rows.push({ figure, goal: parseGoal(goal), state, done });
    }
    this.forgetButton?.addEventListener('click', () => this.forget());
    let letGo = 0;
    const hold = (): void => {
      clearTimeout(letGo);
      this.held = true;
    };
    const release = (): void => {
      // A frame or two later the stage has seen it, too.
      letGo = window.setTimeout(() => {
        this.held = false;
        refresh();
      }, 100);
    };
    addEventListener('pointerdown', hold, true);
    for (const end of ['pointerup', 'pointercancel']) addEventListener(end, release, true);
    this.show();
  }

  /// `goesBack`: something has been taken back.
  update(parameters: ReadonlyMap<string, Parameter>, goesBack: boolean): void {
    const row = this.rows.find(({ figure }) => figure === this.scenes.shown);
    if (!row || this.solved.has(row.figure.id)) return;
    // A hand that seeks a place (< and >) has found it when it passes there. A slider passes all numbers: what is to be
    // chosen (= and != alone) has been chosen when it is let go.
    if (this.held && !row.goal.some(({ sign }) => /[<>]/.test(sign))) return;
    const look = (name: string): Parameter['value'] | undefined =>
      parameters.get(name)?.value ?? this.bridge.measure(name) ?? undefined;
    const there = reached(row.goal, look);
    if (this.borrowed(row.figure, there, goesBack) || !there) return;
    this.solved.add(row.figure.id);
    write([...this.solved]);
    this.show();
    this.announce(`${say('Solved.')} ${row.done.textContent}`);
  }

  /// Whether the figure stands as an address has put it and not as the reader has: until he has seen the goal missed in
  /// a state of his own, and then come to it by a step of his own. Steps taken back lead to the address's state again.
  private borrowed(figure: Figure, there: boolean, goesBack: boolean): boolean {
    const gift = this.scenes.giftOf(figure);
    if (!gift) return false;
    if (!there && !goesBack) this.left.add(gift);
    if (there && goesBack) this.left.delete(gift);
    return !this.left.has(gift);
  }

  /// How many of a chapter's exercises are solved.
  private progress(chapter: Element): [solved: number, all: number] {
    const own = this.rows.filter(({ figure }) => chapter.contains(figure.element));
    return [own.filter(({ figure }) => this.solved.has(figure.id)).length, own.length];
  }

  private forget(): void {
    this.solved.clear();
    write([]);
    this.show();
  }

  private show(): void {
    for (const { figure, state, done } of this.rows) {
      const solved = this.solved.has(figure.id);
      figure.element.toggleAttribute('data-solved', solved);
      const words = solved ? say('Solved') : '';
      if (state.textContent !== words) state.textContent = words;
      done.hidden = !solved;
    }
    if (this.forgetButton) this.forgetButton.hidden = this.solved.size === 0;
    for (const place of document.querySelectorAll<HTMLElement>('[data-progress]')) {
      const [solved, all] = this.progress(document.getElementById(place.dataset['progress']!)!);
      place.textContent = all > 0 ? `${solved} / ${all}` : '';
      place.title = all > 0 ? say('{} of {} exercises solved', solved, all) : '';
    }
  }
}

/// Storage may be full, forbidden or hold something else.
function read(): string[] {
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(storageKey) ?? '[]');
    return Array.isArray(stored) ? stored.filter((id) => typeof id === 'string') : [];
  } catch {
    return [];
  }
}

function write(solved: string[]): void {
  try {
    localStorage.setItem(storageKey, JSON.stringify(solved));
  } catch {
    // then it is known until the page is left
  }
}
