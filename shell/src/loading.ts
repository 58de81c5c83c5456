import wasmUrl from '@module/knotwork.wasm?url';
import regularUrl from '../generated/stage-400.ttf?url';
import semiboldUrl from '../generated/stage-600.ttf?url';
import type { EmscriptenModule, ModuleOptions } from './bridge';
import { laterParts, type LaterParts } from './later_part';
import { countBytes } from './progress';
import { say } from './words';

/// Why there is no module: the reader's browser, or the way to it.
export class LoadError extends Error {
  constructor(
    readonly reason: 'unsupported' | 'download' | 'script',
    options?: ErrorOptions,
  ) {
    super(
      reason === 'unsupported' ? 'this browser has no WebAssembly' : 'the module could not be downloaded',
      options,
    );
  }
}

const language: Pick<ModuleOptions, 'say' | 'hear'> = __WORDS__ ? { say } : {};
if (__WORDS__ === 'pseudo') {
  // All words that the stage has drawn so far, for the tests of the disguise.
  const heard = new Set<string>();
  language.hear = (words) => void heard.add(words);
  Object.assign(window, { heard });
}

/// Fetches script and WebAssembly side by side, compiles while bytes arrive, and reports the share that has come. The
/// later parts are not fetched yet.
export async function loadModule(
  canvas: HTMLCanvasElement,
  onFrameNeeded: () => void,
  onShare: (share: number) => void,
): Promise<{ module: EmscriptenModule; parts: LaterParts }> {
  if (typeof WebAssembly !== 'object') throw new LoadError('unsupported');
  const [{ default: create }, compiled] = await Promise.all([fetchScript(), compile(onShare)]);
  const parts = laterParts();
  const module = await new Promise<EmscriptenModule>((resolve, reject) => {
    create({
      canvas,
      onFrameNeeded,
      ...language,
      instantiateWasm: (imports, done) => {
        const { later, last } = parts;
        const placeholders = { later: later.placeholders, last: last.placeholders };
        WebAssembly.instantiate(compiled, { ...imports, ...placeholders }).then((instance) => {
          later.attach(instance);
          last.attach(instance);
          done(instance, compiled);
        }, reject);
        return {};
      },
      print: (text) => console.log(text),
      printErr: (text) => console.warn(text),
      onAbort: reject,
    }).then(resolve, reject);
  });
  return { module, parts };
}

/// The two typefaces of the stage.
export async function loadStageFonts(): Promise<[regular: Uint8Array, semibold: Uint8Array]> {
  return Promise.all([fetchBytes(regularUrl), fetchBytes(semiboldUrl)]);
}

async function fetchScript(): Promise<typeof import('@module/knotwork.js')> {
  try {
    return await import('@module/knotwork.js');
  } catch (cause) {
    throw new LoadError('script', { cause });
  }
}

async function compile(onShare: (share: number) => void): Promise<WebAssembly.Module> {
  let response: Response;
  try {
    response = await fetch(wasmUrl, { credentials: 'same-origin' });
  } catch (cause) {
    throw new LoadError('download', { cause });
  }
  if (!response.ok || !response.body) throw new LoadError('download', { cause: response.status });
  const counted = countBytes(response.body, (bytes) => onShare(Math.min(1, bytes / __WASM_BYTES__)));
  try {
    return await WebAssembly.compileStreaming(
      new Response(counted, { headers: { 'Content-Type': 'application/wasm' } }),
    );
  } catch (cause) {
    throw new LoadError('download', { cause });
  }
}

async function fetchBytes(url: string): Promise<Uint8Array> {
  try {
    const response = await fetch(url);
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
    throw new Error(`${response.status}`);
  } catch (cause) {
    throw new LoadError('download', { cause });
  }
}
