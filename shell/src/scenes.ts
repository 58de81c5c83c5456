import type { Bridge } from './bridge';
import { parseValue, type Value } from './goals';
import { readingLine } from './sections';

/// A figure of the prose or an exercise: a place in the page, and what the stage shows there at first.
export interface Figure {
  id: string;
  element: HTMLElement;
  /// Where it comes to the stage: a chapter's first figure with the chapter.
  from: Element;
  start: string;
  values: [id: string, value: Value][];
}

export function readFigures(root: ParentNode): Figure[] {
  const begun = new Set<Element>();
  const from = (element: Element): Element => {
    const chapter = element.closest('[data-chapter]');
    if (!chapter || begun.has(chapter)) return element;
    begun.add(chapter);
    return chapter;
  };
  return [...root.querySelectorAll<HTMLElement>('[data-figure]')].map((element) => ({
    id: element.dataset['figure']!,
    element,
    from: from(element),
    start: element.dataset['start']!,
    values: [...new URLSearchParams(element.dataset['values'])].map(([id, value]) => [id, parseValue(value)]),
  }));
}

const documents = import.meta.glob<string>('../scenes/*.json', { query: '?raw', import: 'default' });

/// One stage serves all figures: it shows the one that is being read, as the reader has left it. A script or a document
/// of the reader's own pins the stage, until a figure is asked for.
export class Scenes {
  private current: Figure | null = null;
  private wanted: Figure | null = null;
  private pinned = false;
  private following = false;
  private readonly figures: readonly Figure[];
  private readonly bridge: Bridge;
  private readonly changed: () => void;

  constructor(bridge: Bridge, figures: readonly Figure[], changed: () => void) {
    this.bridge = bridge;
    this.figures = figures;
    this.changed = changed;
  }

  /// From now on the stage goes with the reader.
  follow(): void {
    this.following = true;
    if (!this.pinned && this.figures[0]) this.adopt(this.figures[0]);
    let scheduled = false;
    const look = (): void => {
      scheduled = false;
      const figure = this.beingRead();
      if (figure && !this.pinned) void this.enter(figure);
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

  pin(): void {
    this.pinned = true;
  }

  get shown(): Figure | null {
    return this.pinned ? null : this.current;
  }

  /// The figure that something in the prose is about: the last one before it in its chapter, or the chapter's first.
  about(element: Element): Figure | null {
    const chapter = element.closest('[data-chapter]');
    const own = this.figures.filter((figure) => chapter?.contains(figure.element));
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
  again(figure: Figure): Promise<void> {
    if (figure !== this.current || this.pinned) return this.show(figure).then(() => this.begin(figure));
    return this.begin(figure);
  }

  /// What the stage starts with is the first figure, which a quick reader may have taken in hand already.
  private adopt(figure: Figure): void {
    this.current = figure;
    this.bridge.enter(figure.id);
    if (this.bridge.state().canUndo) return;
    this.set(figure);
    this.bridge.begin();
    this.changed();
  }

  private async enter(figure: Figure): Promise<void> {
    this.wanted = figure;
    if (figure === this.current && !this.pinned) return;
    const document = await this.documentOf(figure);
    if (figure !== this.wanted || (this.following && this.pinned)) return;  // the reader has gone on meanwhile
    this.current = figure;
    if (!this.bridge.enter(figure.id)) {
      this.load(figure, document);
      this.bridge.begin();
    }
    this.changed();
  }

  private async begin(figure: Figure): Promise<void> {
    const document = await this.documentOf(figure);
    if (figure !== this.current) return;
    this.bridge.gesture(true);
    try {
      this.load(figure, document);
    } finally {
      this.bridge.gesture(false);
    }
    this.changed();
  }

  private load(figure: Figure, document: string | null): void {
    if (document === null) this.bridge.open(figure.start);
    else this.bridge.load(document);
    this.set(figure);
  }

  private set(figure: Figure): void {
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    for (const [id, value] of figure.values) {
      if (id === 'animation.playing' && still) continue;
      this.bridge.set(id, value);
    }
  }

  private async documentOf(figure: Figure): Promise<string | null> {
    return figure.start === 'file' ? documents[`../scenes/${figure.id}.json`]!() : null;
  }

  /// The last one whose head has come to the reading line, in the prose's order.
  private beingRead(): Figure | null {
    const line = readingLine();
    let found: Figure | null = null;
    for (const figure of this.figures) {
      if (figure.from.getBoundingClientRect().top > line) break;
      found = figure;
    }
    return found ?? this.figures[0] ?? null;
  }
}
