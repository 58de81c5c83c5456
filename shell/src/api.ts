import { RefusedError, type Bridge } from './bridge';
import type { ExportFormat, Knotwork } from './knotwork';

/// Makes window.knotwork. Until `attach` the functions say that it is too early.
export class ScriptInterface {
  private bridge: Bridge | null = null;
  private readonly canvas: HTMLCanvasElement;
  private readonly changed: () => void;
  private readonly own: (command: () => void) => void;
  private resolve!: () => void;
  private reject!: (reason: Error) => void;

  /// `own`: runs a command that puts something of the script's own on the stage.
  constructor(canvas: HTMLCanvasElement, changed: () => void, own: (command: () => void) => void) {
    this.canvas = canvas;
    this.changed = changed;
    this.own = own;
    const ready = new Promise<void>((resolve, reject) => {
      this.resolve = resolve;
      this.reject = reject;
    });
    ready.catch(() => undefined);  // a page without a stage has said so; nobody need listen
    window.knotwork = this.make(ready);
  }

  attach(bridge: Bridge): void {
    this.bridge = bridge;
  }
  settle(error?: Error): void {
    if (error) this.reject(error);
    else this.resolve();
  }

  private make(ready: Promise<void>): Knotwork {
    const module = (): Bridge => {
      if (!this.bridge) throw new Error('await knotwork.ready first');
      return this.bridge;
    };
    const change = (command: (bridge: Bridge) => void): void => {
      command(module());
      this.changed();
    };
    const put = (command: (bridge: Bridge) => void): void =>
      change((bridge) => this.own(() => command(bridge)));
    const corner = (): DOMRect => this.canvas.getBoundingClientRect();
    return {
      ready,
      get version() {
        return module().version();
      },
      document: () => module().document(),
      load: (document) => put((bridge) => bridge.load(jsonOf(document))),
      parameters: () => module().parameters(),
      set: (id, value) => change((bridge) => bridge.set(String(id), value)),
      handles: () => {
        const { left, top } = corner();
        return module()
          .handles()
          .map((handle) => ({
            ...handle,
            screen: handle.screen && [handle.screen[0] + left, handle.screen[1] + top],
          }));
      },
      widgets: () => {
        const { left, top } = corner();
        return module()
          .widgets()
          .map(({ label, rect: [x, y, width, height] }) => ({ label, rect: [x + left, y + top, width, height] }));
      },
      evaluate: ((object: string, parameter: number | [number, number], order = 0) =>
        module().evaluate(String(object), parameter, Number.isInteger(order) ? order : -1)) as Knotwork['evaluate'],
      play: () => change((bridge) => bridge.play(true)),
      pause: () => change((bridge) => bridge.play(false)),
      seek: (seconds) => change((bridge) => bridge.seek(typeof seconds === 'number' ? seconds : Number.NaN)),
      undo: () => change((bridge) => bridge.undo()),
      redo: () => change((bridge) => bridge.redo()),
      export: (format) => {
        throw new Error(exportMessage(format));
      },
      stats: () => module().stats(),
      chapters: () => module().chapters(),
      open: (id) => put((bridge) => bridge.open(String(id))),
    };
  }
}

/// A cycle or a big integer makes JSON.stringify throw an error that names no path.
function jsonOf(document: unknown): string {
  try {
    return JSON.stringify(document) ?? 'null';
  } catch {
    throw new RefusedError('The document holds something that JSON cannot say.', '');
  }
}

const formats: readonly ExportFormat[] = ['obj', 'stl', 'glb', 'svg', 'png'];

export function exportMessage(format: string): string {
  const list = formats.join(', ');
  return (formats as readonly string[]).includes(format)
    ? `export("${format}"): exporting is not part of this version; a later one will write ${list}`
    : `export("${format}"): there is no such format; a later version will write ${list}`;
}
