import { changedValues, readState, sameFigure, showTheSame, type FigureState } from './addresses';
import type { Bridge } from './bridge';
import { parseValue, type Value } from './goals';
import type { DocumentJson, Parameter } from './knotwork';
import { readingLine } from './sections';

/// A figure of the prose or an exercise: a place in the page, and what the stage shows there at first.
export interface Figure {
  id: string;
  element: HTMLElement;
  start: string;
  values: [id: string, value: Value][];
}

export function readFigures(root: ParentNode): Figure[] {
  return [...root.querySelectorAll<HTMLElement>('[data-figure]')].map((element) => ({
    id: element.dataset['figure']!,
    element,
    start: element.dataset['start']!,
    values: [...new URLSearchParams(element.dataset['values'])].map(([id, value]) => [id, parseValue(value)]),
  }));
}

const documents = import.meta.glob<string>('../scenes/*.json', { query: '?raw', import: 'default' });

/// What stands on the stage, as far as an address can carry it.
interface Shown {
  document: DocumentJson;
  rows: Parameter[];
}

const stillness = '(prefers-reduced-motion: reduce)';

/// The scene of what is no figure of the page.
const ownScene = 'own';
/// The scene where something is tried out, out of the reader's sight.
const trialScene = 'trial';

/// One stage serves all figures: it shows the one that is being read, as the reader has left it. What a script or the
/// reader puts there has a scene of its own and stays, until a figure is asked for or read anew.
export class Scenes {
  private current: Figure | null = null;
  private wanted: Figure | null = null;
  private read: Figure | null = null;
  private pinned = false;
  private readonly begun = new Set<Figure>();
  private readonly starts = new Map<Figure, Shown>();
  private readonly gifts = new Map<Figure, object>();
  private readonly chapters: readonly { article: Element; figures: readonly Figure[] }[];
  private readonly figures: readonly Figure[];
  private readonly bridge: Bridge;
  private readonly changed: () => void;
  private readonly failed: (error: unknown) => void;

  constructor(bridge: Bridge, figures: readonly Figure[], changed: () => void, failed: (error: unknown) => void) {
    this.bridge = bridge;
    this.figures = figures;
    this.changed = changed;
    this.failed = failed;
    const articles = new Set(figures.map(({ element }) => element.closest('[data-chapter]')));
    this.chapters = [...articles].flatMap((article) =>
      article ? [{ article, figures: figures.filter(({ element }) => article.contains(element)) }] : [],
    );
  }

  /// From now on the stage goes with the reader.
  follow(): void {
    if (!this.pinned && !this.wanted && this.figures[0]) this.adopt(this.figures[0]);
    let scheduled = false;
    const look = (): void => {
      scheduled = false;
      const figure = this.beingRead();
      // Only what comes to be read: what the reader has asked for stays while the page moves a little.
      if (!figure || figure === this.read || this.pinned) return;
      this.read = figure;
      this.enter(figure).catch(this.failed);
    };
    const schedule = (): void => {
      if (scheduled) return;
      scheduled = true;
      requestAnimationFrame(look);
    };
    addEventListener('scroll', schedule, { passive: true });
    addEventListener('resize', schedule);
    look();
  }

  /// Puts something on the stage that is no figure of the page, and stays.
  own(command: () => void): void {
    if (this.pinned) {
      command();
      return;
    }
    const before = this.current;
    this.bridge.enter(ownScene);
    try {
      command();
    } catch (error) {
      if (before) this.bridge.enter(before.id);
      throw error;
    }
    this.pin();
  }

  /// What is on the stage is a script's, which came before the page.
  pin(): void {
    this.pinned = true;
    this.current = this.wanted = null;
  }

  get shown(): Figure | null {
    return this.current;
  }

  /// The figure that something in the prose is about: the last one before it in its chapter, or the chapter's first.
  about(element: Element): Figure | null {
    const own = this.chapters.find(({ article }) => article.contains(element))?.figures ?? [];
    const before = own.filter(
      ({ element: other }) =>
        other.contains(element) || other.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING,
    );
    return before.at(-1) ?? own[0] ?? null;
  }

  /// By the reader's wish, whatever is on the stage.
  show(figure: Figure): Promise<void> {
    this.pinned = false;
    return this.enter(figure);
  }

  /// As the chapter has it; undone by one step.
  async again(figure: Figure): Promise<void> {
    await this.show(figure);
    const document = await this.documentOf(figure);
    if (figure !== this.current) return;
    this.bridge.gesture(true);
    try {
      this.load(figure, document);
      this.bridge.begin(true);
    } finally {
      this.bridge.gesture(false);
    }
    this.changed();
  }

  /// How the figure, as the reader has left it, differs from its start; null where it does not.
  async difference(figure: Figure): Promise<FigureState | null> {
    if (!this.begun.has(figure)) return null;
    const start = await this.documentOf(figure);
    const now = this.aside(figure.id, () => this.look());
    const whole = { document: JSON.stringify(now.document) };
    // Only what has to be tried out is: who comes back from another scene has the view fitted anew.
    const began = this.starts.get(figure);
    if (began && changedValues(began.rows, now.rows).length === 0)
      return showTheSame(began.document, now.document) ? null : whole;
    return this.trial(() => {
      this.load(figure, start);
      const values = changedValues(this.bridge.parameters(), now.rows);
      try {
        this.setAll(values);
      } catch {
        return whole;  // in this order the values cannot be had
      }
      return showTheSame(this.bridge.document(), now.document) ? { values } : whole;
    });
  }

  /// Shows the figure with the state that an address asks for, as the reader's own: undone by one step. Throws what is
  /// wrong with that state; then the figure is on the stage as it was. False: the reader has gone on to another one
  /// meanwhile.
  async give(figure: Figure, query: string): Promise<boolean> {
    await this.show(figure);
    const [start, state] = await Promise.all([this.documentOf(figure), readState(query)]);
    if (figure !== this.current || !state) return false;
    // Tried first: of a state that is refused half way, nothing is to be seen.
    const document = this.trial(() => {
      this.load(figure, start);
      const before = this.bridge.document();
      if ('document' in state) this.bridge.load(state.document);
      this.setAll('values' in state ? state.values : []);
      if (matchMedia(stillness).matches && this.plays()) this.bridge.play(false);
      if (!sameFigure(before, this.bridge.document())) throw new Error('Its document is that of another figure.');
      return JSON.stringify(this.bridge.document());
    });
    this.gifts.set(figure, {});
    this.bridge.gesture(true);
    try {
      this.bridge.load(document);
      this.bridge.begin(true);
    } finally {
      this.bridge.gesture(false);
    }
    this.changed();
    return true;
  }

  /// The last thing that an address has made of the figure; nothing to look into. Null where none has.
  giftOf(figure: Figure): object | null {
    return this.gifts.get(figure) ?? null;
  }

  private look(): Shown {
    return { document: this.bridge.document(), rows: this.bridge.parameters() };
  }

  /// What is on the stage is the figure's start.
  private begin(figure: Figure): void {
    this.bridge.begin();
    this.starts.set(figure, this.look());
  }

  /// Does something out of the reader's sight; what the module has to say about it is not said.
  private trial<T>(act: () => T): T {
    return this.aside(trialScene, () => {
      try {
        return act();
      } finally {
        this.bridge.begin();
      }
    });
  }

  /// Looks at another scene, or does something there, while the stage goes on to show the present one.
  private aside<T>(scene: string, look: () => T): T {
    const present = this.current?.id ?? ownScene;
    if (scene === present) return look();
    const { selected } = this.bridge.state();
    this.bridge.enter(scene);
    try {
      return look();
    } finally {
      this.bridge.enter(present);
      if (selected) this.bridge.select(selected);
    }
  }

  /// What the stage starts with is the first figure, which a quick reader may have taken in hand already.
  private adopt(figure: Figure): void {
    this.current = figure;
    this.begun.add(figure);
    this.bridge.enter(figure.id);
    if (!this.bridge.state().canUndo) {
      this.set(figure);
      this.begin(figure);
    }
    this.changed();
  }

  private async enter(figure: Figure): Promise<void> {
    this.wanted = figure;
    if (figure === this.current) return;
    const document = await this.documentOf(figure);
    if (figure !== this.wanted) return;  // the reader has gone on meanwhile, or a script has come
    const before = this.current;
    // One that could not be begun the last time holds what was there before it.
    if (!this.bridge.enter(figure.id) || !this.begun.has(figure)) {
      try {
        this.load(figure, document);
      } catch (error) {
        if (before) this.bridge.enter(before.id);
        throw error;
      }
      this.begin(figure);
      this.begun.add(figure);
    }
    this.current = figure;
    this.changed();
  }

  private load(figure: Figure, document: string | null): void {
    if (document === null) this.bridge.open(figure.start);
    else this.bridge.load(document);
    this.set(figure);
  }

  private set(figure: Figure): void {
    const still = matchMedia(stillness).matches;
    this.setAll(figure.values.filter(([id]) => id !== 'animation.playing' || !still));
  }

  private plays(): boolean {
    return this.bridge.parameters().some(({ id, value }) => id === 'animation.playing' && value === true);
  }

  private setAll(values: readonly [id: string, value: Value][]): void {
    for (const [id, value] of values) this.bridge.set(id, value);
  }

  private async documentOf(figure: Figure): Promise<string | null> {
    return figure.start === 'file' ? documents[`../scenes/${figure.id}.json`]!() : null;
  }

  /// The last figure whose head has come to the reading line, in the chapter that is read.
  private beingRead(): Figure | null {
    const line = readingLine();
    const passed = (place: Element): boolean => place.getBoundingClientRect().top <= line;
    const chapter = this.chapters.filter(({ article }) => passed(article)).at(-1) ?? this.chapters[0];
    if (!chapter) return null;
    return chapter.figures.filter(({ element }) => passed(element)).at(-1) ?? chapter.figures[0] ?? null;
  }
}
