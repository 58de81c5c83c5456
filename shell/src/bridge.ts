import type { ChapterRow, DocumentJson, Handle, Parameter, Stats, SurfaceJet, Vector3, Widget } from './knotwork';

/// The typed side of web/bridge.h: one method for each exported function, JSON unwrapped. Positions here are CSS
/// pixels from the stage's upper left corner.

type Instantiate = (
  imports: WebAssembly.Imports,
  done: (instance: WebAssembly.Instance, module?: WebAssembly.Module) => void,
) => object;

/// What Emscripten's factory takes.
export interface ModuleOptions {
  canvas: HTMLCanvasElement;
  instantiateWasm: Instantiate;
  onFrameNeeded(): void;
  /// What the stage says, in the page's language; none for English.
  say?(english: string): string;
  /// Is told of all words that the stage draws.
  hear?(words: string): void;
  print(text: string): void;
  printErr(text: string): void;
  onAbort(reason: unknown): void;
}

export type ModuleFactory = (options: ModuleOptions) => Promise<EmscriptenModule>;

type Argument = number | string | Uint8Array;

export interface EmscriptenModule {
  ccall(name: string, result: 'string' | 'number', types: ('number' | 'string')[], values: (number | string)[]): unknown;
  stringToUTF8(text: string, address: number, most: number): void;
  lengthBytesUTF8(text: string): number;
  writeArrayToMemory(bytes: Uint8Array, address: number): void;
  _malloc(size: number): number;
  _free(address: number): void;
}

/// Longer texts go through the heap: ccall itself would put them on WebAssembly's small stack.
const longestOnStack = 2048;

export enum PointerKind { move, down, up, cancel, leave }
export enum Device { mouse, pen, touch }

export interface Direction {
  topology: 'open' | 'closed';
  domain: string;
  knots: readonly number[];
  patches: number;
  locals: number;
}

/// knotwork_state(): what the page beside the stage shows.
export interface State {
  canUndo: boolean;
  canRedo: boolean;
  undoLabel: string;
  redoLabel: string;
  notice: string;
  /// The id of a handle, and its name for readers; '' for none.
  selected: string;
  selectedName: string;
  /// How many points the figure on the stage is made from; null where it is not made from a list of points.
  points: number | null;
  /// null while a curve is on the stage.
  surface: SurfaceState | null;
}

export interface SurfaceState {
  shape: string;
  u: Direction;
  v: Direction;
}

/// An answer of the module that says no.
export class RefusedError extends Error {
  override readonly name = 'KnotworkError';
  constructor(
    message: string,
    readonly path: string,
  ) {
    super(message);
  }
}

type Answer = { value: unknown } | { error: { message: string; path: string } };

/// The value of a JSON answer, or its error thrown.
export function unwrap(json: string): unknown {
  const answer = JSON.parse(json) as Answer;
  if ('error' in answer) throw new RefusedError(answer.error.message, answer.error.path);
  return answer.value;
}

export class Bridge {
  constructor(private readonly module: EmscriptenModule) {}

  start(selector: string): boolean {
    return this.number('knotwork_start', selector) !== 0;
  }
  font(bytes: Uint8Array, weight: 400 | 600): void {
    this.number('knotwork_font', bytes, bytes.length, weight);
  }
  resize(width: number, height: number, pixelRatio: number): void {
    this.number('knotwork_resize', width, height, pixelRatio);
  }
  scheme(dark: boolean): void {
    this.number('knotwork_scheme', Number(dark));
  }
  reducedMotion(reduced: boolean): void {
    this.number('knotwork_reduced_motion', Number(reduced));
  }
  /// What fits grids to the screen is here.
  complete(): void {
    this.number('knotwork_complete');
  }
  /// Whether the stage can draw now.
  context(present: boolean): boolean {
    return this.number('knotwork_context', Number(present)) !== 0;
  }
  /// True: another frame is wanted.
  frame(now: number): boolean {
    return this.number('knotwork_frame', now) !== 0;
  }

  /// The input functions say whether the event was used.
  pointer(
    kind: PointerKind, id: number, device: Device, x: number, y: number, button: number, modifiers: number, time: number,
  ): boolean {
    return this.number('knotwork_pointer', kind, id, device, x, y, button, modifiers, time) !== 0;
  }
  wheel(deltaX: number, deltaY: number, x: number, y: number, modifiers: number): boolean {
    return this.number('knotwork_wheel', deltaX, deltaY, x, y, modifiers) !== 0;
  }
  key(down: boolean, key: string, modifiers: number): boolean {
    return this.number('knotwork_key', Number(down), key, modifiers) !== 0;
  }
  focus(focused: boolean): void {
    this.number('knotwork_focus', Number(focused));
  }
  cursor(): string {
    return this.string('knotwork_cursor');
  }

  version(): string {
    return this.string('knotwork_version');
  }
  document(): DocumentJson {
    return this.json('knotwork_document') as DocumentJson;
  }
  load(json: string): void {
    this.json('knotwork_load', json);
  }
  parameters(): Parameter[] {
    return this.json('knotwork_parameters') as Parameter[];
  }
  set(id: string, value: number | string | boolean): void {
    if (typeof value === 'string') this.json('knotwork_set_choice', id, value);
    else if (typeof value === 'boolean') this.json('knotwork_set_toggle', id, Number(value));
    else if (Number.isFinite(value)) this.json('knotwork_set_number', id, value);
    else throw new RefusedError("A value is a finite number, a choice's name, true or false.", id);
  }
  handles(): Handle[] {
    return this.json('knotwork_handles') as Handle[];
  }
  widgets(): Widget[] {
    return this.json('knotwork_widgets') as Widget[];
  }
  evaluate(object: string, parameter: number | [number, number], order: number): SurfaceJet & Vector3[] {
    const numbers = (Array.isArray(parameter) ? parameter : [parameter]).map((x) => (typeof x === 'number' ? x : NaN));
    const answer =
      numbers.length === 2
        ? this.json('knotwork_evaluate_surface', object, numbers[0]!, numbers[1]!, order)
        : this.json('knotwork_evaluate_curve', object, Array.isArray(parameter) ? NaN : numbers[0]!, order);
    return answer as SurfaceJet & Vector3[];
  }
  play(playing: boolean): void {
    this.json('knotwork_play', Number(playing));
  }
  seek(seconds: number): void {
    this.json('knotwork_seek', seconds);
  }
  /// Commands between an opened and a closed gesture are one step of undo.
  gesture(open: boolean): void {
    this.number('knotwork_gesture', Number(open));
  }
  undo(): void {
    this.json('knotwork_undo');
  }
  redo(): void {
    this.json('knotwork_redo');
  }
  stats(): Stats {
    return this.json('knotwork_stats') as Stats;
  }
  chapters(): ChapterRow[] {
    return this.json('knotwork_chapters') as ChapterRow[];
  }
  open(chapter: string): void {
    this.json('knotwork_open', chapter);
  }
  state(): State {
    return this.json('knotwork_state') as State;
  }
  revision(): number {
    return this.number('knotwork_revision');
  }
  /// Points as text replace those of the figure on the stage.
  points(text: string): void {
    this.json('knotwork_points', text);
  }
  /// Each figure has a document and a history of its own. True: this one is on the stage as it was left. False: it is
  /// new, and shows what has been there.
  enter(scene: string): boolean {
    return this.number('knotwork_enter_scene', scene) !== 0;
  }
  /// What exercises ask of the figure on the stage (core/knotwork/scene/measures.h); null where it has no such measure.
  measure(name: string): number | null {
    return this.json('knotwork_measure', name) as number | null;
  }
  /// What is on the stage now is the scene's start, seen whole; nothing can be undone, unless it has come back there.
  begin(again = false): void {
    this.number('knotwork_begin_scene', Number(again));
  }
  select(handle: string): void {
    this.json('knotwork_select', handle);
  }

  private number(name: string, ...values: Argument[]): number {
    return this.call(name, 'number', values) as number;
  }
  private string(name: string, ...values: Argument[]): string {
    return this.call(name, 'string', values) as string;
  }
  private call(name: string, result: 'number' | 'string', values: Argument[]): unknown {
    const borrowed: number[] = [];
    const passed = values.map((value) => {
      if (typeof value === 'number' || (typeof value === 'string' && value.length <= longestOnStack)) return value;
      const address = this.onHeap(value);
      borrowed.push(address);
      return address;
    });
    try {
      const types = passed.map((value) => (typeof value === 'number' ? 'number' : 'string'));
      return this.module.ccall(name, result, types, passed);
    } finally {
      borrowed.forEach((address) => this.module._free(address));
    }
  }
  private onHeap(value: string | Uint8Array): number {
    const { module } = this;
    const size = typeof value === 'string' ? module.lengthBytesUTF8(value) + 1 : value.length;
    const address = module._malloc(size);
    if (address === 0) throw new RefusedError('There is not enough memory for this.', '');
    if (typeof value === 'string') module.stringToUTF8(value, address, size);
    else module.writeArrayToMemory(value, address);
    return address;
  }
  private json(name: string, ...values: Argument[]): unknown {
    return unwrap(this.string(name, ...values));
  }
}
