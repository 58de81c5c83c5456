/// The script interface: `window.knotwork`, for embedding and for tests. Positions on the screen are CSS pixels of the
/// viewport. Everything but `ready` is to be used after `await window.knotwork.ready`.

declare global {
  interface Window {
    knotwork: Knotwork;
  }
}

export type Vector3 = [x: number, y: number, z: number];

/// The whole of what a reader can change, as versioned JSON (schema: core/knotwork/scene).
export type DocumentJson = Record<string, unknown>;

/// One row of the parameter table.
export interface Parameter {
  readonly id: string;
  readonly label: string;
  readonly group: string;
  readonly kind: 'number' | 'integer' | 'choice' | 'toggle';
  /// null for a choice or a toggle.
  readonly min: number | null;
  readonly max: number | null;
  /// Where sliders begin and end: beyond lie values for those who ask for them.
  readonly softMin: number | null;
  readonly softMax: number | null;
  readonly step: number | null;
  readonly unit: string;
  readonly choices: readonly Choice[];
  readonly value: number | string | boolean;
  /// Why the row cannot be changed now; '' when it can.
  readonly disabled: string;
}

export interface Choice {
  readonly id: string;
  readonly label: string;
  /// Why this choice is refused now; '' when it is not.
  readonly refused: string;
}

export interface Handle {
  readonly id: string;
  readonly object: string;
  readonly label: string;
  readonly position: Vector3;
  /// null when behind the camera.
  readonly screen: [x: number, y: number] | null;
  readonly selected: boolean;
}

/// An item of the panel on the stage, as drawn last.
export interface Widget {
  readonly label: string;
  readonly rect: [x: number, y: number, width: number, height: number];
}

export interface SurfaceJet {
  readonly S: Vector3;
  readonly Su?: Vector3;
  readonly Sv?: Vector3;
  readonly Suu?: Vector3;
  readonly Suv?: Vector3;
  readonly Svv?: Vector3;
}

/// `frames` and `uploadBytes` are counted since the start, the others are those of the last frame.
export interface Stats {
  readonly frames: number;
  /// The interface's included.
  readonly drawCalls: number;
  /// Of program, textures, targets, blending and depth; without the interface's.
  readonly stateChanges: number;
  readonly vertices: number;
  readonly uploadBytes: number;
  readonly evaluateMs: number;
  readonly frameMs: number;
  /// How often the frame has asked for memory.
  readonly allocations: number;
}

/// A chapter of the page, and the rows of the table that it is about.
export interface ChapterRow {
  readonly id: string;
  readonly title: string;
  readonly parameters: readonly string[];
}

/// What the functions throw: a sentence, and where in the input the fault lies.
export interface KnotworkError extends Error {
  readonly path: string;
}

export type ExportFormat = 'obj' | 'stl' | 'glb' | 'svg' | 'png';

export interface Knotwork {
  /// Resolves when the stage has drawn its first frame; rejects when it cannot be had.
  readonly ready: Promise<void>;
  readonly version: string;

  document(): DocumentJson;
  /// Throws a KnotworkError and changes nothing when `document` is not a valid one.
  load(document: DocumentJson): void;

  parameters(): Parameter[];
  /// Throws on an unknown id, a value of the wrong kind or out of range, and a choice that is refused.
  set(id: string, value: number | string | boolean): void;

  handles(): Handle[];
  widgets(): Widget[];

  /// The core's point and derivatives up to `order` (surfaces 0 to 2, model and blending curves 0 to 3,
  /// other curves 0 to 16): of a curve at t, of a surface at [u, v].
  evaluate(object: string, parameter: number, order?: number): Vector3[];
  evaluate(object: string, parameter: [u: number, v: number], order?: number): SurfaceJet;

  play(): void;
  pause(): void;
  seek(seconds: number): void;

  undo(): void;
  redo(): void;

  /// Throws: exporting comes in a later version.
  export(format: ExportFormat): Uint8Array | string;

  stats(): Stats;

  chapters(): ChapterRow[];
  /// Loads the chapter's start document.
  open(id: string): void;
}
