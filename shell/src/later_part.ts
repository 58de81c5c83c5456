import laterUrl from '@module/later.wasm?url';
import lastUrl from '@module/last.wasm?url';

/// A part of the module that the first figure does without. Its functions have slots in the module's table, where
/// placeholders stand until it has come. A placeholder that is called before then fetches the part on the spot and goes
/// on with the function itself.
export class LaterPart {
  private first: WebAssembly.Exports | null = null;
  private table: WebAssembly.Table | null = null;
  private here = false;
  private coming: Promise<void> | null = null;
  private readonly url: string;

  constructor(url: string) {
    this.url = url;
  }

  /// What the first part imports under the part's name: for each slot a function that is named by its number.
  readonly placeholders: WebAssembly.ModuleImports = new Proxy(
    {},
    {
      get:
        (_, slot) =>
        (...values: unknown[]) =>
          this.call(Number(slot), values),
    },
  );

  attach(first: WebAssembly.Instance): void {
    this.first = first.exports;
    this.table = Object.values(first.exports).find((value) => value instanceof WebAssembly.Table) ?? null;
  }

  /// Ahead of the first call. Should it fail, the first call that needs the part tries again.
  fetch(): Promise<void> {
    this.coming ??= this.instantiate().catch((error: unknown) => {
      this.coming = null;
      throw error;
    });
    return this.coming;
  }

  private async instantiate(): Promise<void> {
    if (this.here || !this.first) return;
    const response = await fetch(this.url, { credentials: 'same-origin' });
    if (!response.ok) throw this.missing(response.status);
    const compiled = await WebAssembly.compile(await response.arrayBuffer());
    if (!this.here) await WebAssembly.instantiate(compiled, { first: this.first });
    this.here = true;
  }

  private call(slot: number, values: unknown[]): unknown {
    if (!this.here) {
      new WebAssembly.Instance(new WebAssembly.Module(this.fetchNow()), { first: this.first! });
      this.here = true;
    }
    return (this.table!.get(slot) as (...values: unknown[]) => unknown)(...values);
  }

  private fetchNow(): Uint8Array<ArrayBuffer> {
    const request = new XMLHttpRequest();
    request.open('GET', this.url, false);
    // A synchronous request in a page answers in text only: this character set keeps each byte in its character.
    request.overrideMimeType('text/plain; charset=x-user-defined');
    request.send();
    if (request.status !== 200) throw this.missing(request.status);
    return Uint8Array.from(request.responseText, (character) => character.charCodeAt(0) & 0xff);
  }

  private missing(status: number): Error {
    return new Error(`a part of the module (${this.url}): ${status}`);
  }
}

/// By the names under which the first part imports them (web/cmake/split_module.mjs).
export interface LaterParts {
  later: LaterPart;  ///< what the first chapters need; behind the first picture
  last: LaterPart;   ///< the rest; when the reader comes near the chapter on B-splines
}

export const laterParts = (): LaterParts => ({ later: new LaterPart(laterUrl), last: new LaterPart(lastUrl) });
