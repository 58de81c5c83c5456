import { applies, fulfilled, parseAction, run, type Action } from './actions';
import type { Bridge } from './bridge';
import { element, makeControl, type Control, type Setter } from './controls';
import { describe } from './description';
import { Exercises } from './exercises';
import { FigureLinks } from './figure_links';
import { FigureTools } from './figures';
import { HistoryControls } from './history';
import type { Parameter } from './knotwork';
import { PatchList } from './patches';
import { listenToPlaces } from './place_links';
import { givePoints, PointsField, pointsText } from './points';
import { ReportTable } from './report';
import { Said } from './said';
import { readFigures, Scenes, type Figure } from './scenes';
import { listenToHolds } from './terms';
import { say, sayRow } from './words';

/// Everything beside the stage that shows the module's state or changes it.
export class Page {
  private readonly setter: Setter;
  readonly scenes: Scenes;
  private readonly controls: { control: Control; figure: Figure | null }[] = [];
  private waiting: { place: HTMLElement; figure: Figure | null }[];
  private settings: Control[] = [];
  private settingsFor = '';
  private readonly phrases: { button: HTMLButtonElement; action: Action; figure: Figure | null }[] = [];
  private readonly links: FigureLinks;
  private readonly figureTools: FigureTools;
  private readonly exercises: Exercises;
  private readonly tables: ReportTable[] = [];
  private readonly patchLists: PatchList[] = [];
  private readonly points: PointsField;
  private readonly history: HistoryControls;
  private readonly notice = document.getElementById('notice')!;
  private readonly description = document.getElementById('stage-state')!;
  private readonly bridge: Bridge;
  private revision = -1;
  private lastNotice = '';
  private insistsUntil = 0;
  private lastUpdate = 0;
  private late = 0;

  constructor(bridge: Bridge, canvas: HTMLCanvasElement) {
    this.bridge = bridge;
    this.setter = {
      set: (id, value) => this.attempt(() => bridge.set(id, value)),
      gesture: (open) => this.attempt(() => bridge.gesture(open)),
    };

    const figures = readFigures(document);
    const failed = (error: unknown): void => this.refuse(error);
    this.scenes = new Scenes(bridge, figures, () => this.update(), failed);
    const said = new Said((words) => this.insist(words));
    listenToPlaces(document.getElementById('prose')!, said);
    listenToHolds(canvas, bridge, () => this.scenes.shown?.element.closest<HTMLElement>('[data-chapter]') ?? null);
    this.links = new FigureLinks(figures, this.scenes, said);
    this.figureTools = new FigureTools(figures, this.scenes, this.links, canvas, failed);
    this.exercises = new Exercises(
      figures, this.scenes, bridge, (words) => this.insist(words), () => this.update(),
    );
    this.waiting = [...document.querySelectorAll<HTMLElement>('[data-parameter]')].map((place) => ({
      place, figure: this.scenes.about(place),
    }));
    for (const button of document.querySelectorAll<HTMLButtonElement>('[data-run]')) {
      const phrase = { button, action: parseAction(button.dataset['run']!), figure: this.scenes.about(button) };
      button.addEventListener('click', () => void this.act(phrase.action, phrase.figure));
      button.disabled = false;
      this.phrases.push(phrase);
    }
    for (const place of document.querySelectorAll<HTMLElement>('[data-report]')) {
      const setBoth = (u: string, v: string): void =>
        this.attemptAsOne(() => {
          bridge.set('topology.u', u);
          bridge.set('topology.v', v);
        });
      this.tables.push(new ReportTable(place, setBoth));
    }
    for (const place of document.querySelectorAll<HTMLElement>('[data-patches]')) {
      const choose = (id: string): void => this.attempt(() => bridge.select(id));
      this.patchLists.push(new PatchList(place, choose, () => canvas.focus({ preventScroll: true })));
    }
    this.points = new PointsField(
      (text) => {
        try {
          givePoints(bridge, text);
        } finally {
          this.update();
        }
      },
      () => pointsText((bridge.document() as { objects: { points: number[][] }[] }).objects[0]!.points),
    );
    this.history = new HistoryControls(
      () => this.attempt(() => bridge.undo()),
      () => this.attempt(() => bridge.redo()),
    );
    this.update();
  }

  /// From now on the stage goes with the reader and with the page's address.
  follow(): void {
    this.scenes.follow();
    this.links.follow();
  }

  /// After a frame or a command: shows what has changed. While frames follow each other, ten times a second at most.
  sync(now: number): void {
    if (this.bridge.revision() === this.revision) return;
    clearTimeout(this.late);
    if (now - this.lastUpdate >= 100) {
      this.lastUpdate = now;
      this.update();
    } else {
      this.late = window.setTimeout(() => this.sync(performance.now()), 100);
    }
  }

  /// Shows the module's state at once.
  update(): void {
    this.revision = this.bridge.revision();
    const state = this.bridge.state();
    const rows = this.rows();
    this.makeControls(rows);
    this.makeSettings(rows);
    this.points.element.hidden = state.points === null;
    const follow = (control: Control): void => {
      const row = rows.get(control.id);
      if (row) control.update(row);
      else control.rest();
    };
    const { shown } = this.scenes;
    this.settings.forEach(follow);
    // One of another figure keeps what its own last said.
    for (const { control, figure } of this.controls) if (!figure || !shown || shown === figure) follow(control);
    for (const { button, action, figure } of this.phrases)
      button.classList.toggle('done', (!shown || shown === figure) && fulfilled(action, rows));
    this.figureTools.update(state.canUndo);
    if (state.surface) for (const table of this.tables) table.update(state.surface, rows);
    for (const list of this.patchLists) list.update(state, () => this.bridge.handles());
    this.history.update(state);
    const description = describe(rows, state.selectedName);
    if (this.description.textContent !== description) this.description.textContent = description;
    // What comes while something else is to be heard is said with the first change after it.
    if (state.notice !== this.lastNotice && performance.now() > this.insistsUntil) {
      this.announce(say(state.notice));
      this.lastNotice = state.notice;
    }
    this.exercises.update(rows, state.canRedo);  // what it says is said last
  }

  private rows(): Map<string, Parameter> {
    return new Map(this.bridge.parameters().map((row) => [row.id, sayRow(row)]));
  }

  /// Does what a phrase says to the figure that it is about, which may have made room for another one.
  private async act(action: Action, figure: Figure | null): Promise<void> {
    const perform = (): void => this.attemptAsOne(() => run(action, this.bridge));
    if (action.kind === 'open') {
      this.scenes.own(perform);
      this.update();
      return;
    }
    const { shown } = this.scenes;
    const other = shown ? shown !== figure : !applies(action, this.rows());
    if (figure && other) {
      try {
        await this.scenes.show(figure);
      } catch (error) {
        this.refuse(error);
      }
      if (this.scenes.shown !== figure) return;  // the reader has gone on meanwhile
    }
    perform();
  }

  /// What is set beside the prose is set in the figure that it belongs to, which may have to come to the stage first:
  /// then the last value counts, and all that happened until the hand let go is one step of undo.
  private setterOf(figure: Figure | null): Setter {
    let held = false;
    let opened = false;
    let coming = false;
    let last: (() => void) | null = null;
    const open = (): void => {
      if (!opened) this.setter.gesture((opened = true));
    };
    const close = (): void => {
      if (opened) this.setter.gesture((opened = false));
    };
    const isOwn = (id?: string): boolean => {
      const { shown } = this.scenes;
      return !figure || (shown ? shown === figure : id === undefined || this.rows().has(id));
    };
    const come = async (): Promise<void> => {
      coming = true;
      try {
        await this.scenes.show(figure!);
        if (this.scenes.shown === figure) {
          open();
          last?.();
          if (!held) close();
        }
      } catch (error) {
        this.refuse(error);
      } finally {
        coming = false;
        last = null;
      }
    };
    return {
      set: (id, value) => {
        const command = (): void => this.setter.set(id, value);
        if (isOwn(id)) return command();
        last = command;
        if (!coming) void come();
      },
      gesture: (begins) => {
        held = begins;
        if (!begins) return close();
        if (isOwn()) open();
        else if (!coming) void come();
      },
    };
  }

  private refuse(error: unknown): void {
    this.announce(say(error instanceof Error ? error.message : String(error)));
  }

  /// Rows beside the prose are made when the figure that has them first comes to the stage.
  private makeControls(rows: ReadonlyMap<string, Parameter>): void {
    const { shown } = this.scenes;
    this.waiting = this.waiting.filter(({ place, figure }) => {
      const row = !figure || !shown || shown === figure ? rows.get(place.dataset['parameter']!) : undefined;
      if (row) this.controls.push({ control: makeControl(place, row, this.setterOf(figure)), figure });
      return !row;
    });
  }

  /// What the stage has to say meanwhile is not said over it: an exercise is often solved in the middle of a drag, and
  /// the hand lets go; and of an address the stage knows but the value that it refuses.
  private insist(text: string): void {
    this.insistsUntil = performance.now() + 4000;
    this.announce(text);
  }

  private announce(text: string): void {
    this.notice.textContent = text;
  }

  /// Runs a command; a refusal is said, and the controls go back to what is true.
  private attempt(command: () => void): void {
    try {
      command();
    } catch (error) {
      this.refuse(error);
    }
    this.update();
  }

  /// The same as one step of undo, whatever it consists of.
  private attemptAsOne(commands: () => void): void {
    this.attempt(() => {
      this.bridge.gesture(true);
      try {
        commands();
      } finally {
        this.bridge.gesture(false);
      }
    });
  }

  /// All rows of the figure on the stage, folded by group at the foot of the page.
  private makeSettings(rows: ReadonlyMap<string, Parameter>): void {
    const place = document.querySelector<HTMLElement>('[data-settings]');
    const ids = [...rows.keys()].join(' ');
    if (!place || ids === this.settingsFor) return;
    this.settingsFor = ids;
    const open = new Set([...place.querySelectorAll('details[open] > summary')].map((summary) => summary.textContent));
    const groups = new Map<string, HTMLElement>();
    this.settings = [];
    place.replaceChildren();
    place.append(this.points.element);
    for (const row of rows.values()) {
      let group = groups.get(row.group);
      if (!group) {
        const details = element('details', '');
        details.open = open.has(row.group);
        group = element('div', 'controls');
        details.append(element('summary', '', row.group), group);
        place.append(details);
        groups.set(row.group, group);
      }
      const control = element('div', 'control');
      control.dataset['parameter'] = row.id;
      group.append(control);
      this.settings.push(makeControl(control, row, this.setter));
    }
  }
}
