import url from '@module/later.wasm?url';

/// The module's second part: all that the first figure does without. Its functions have slots in the module's table,
/// where placeholders stand until it has come. A placeholder that is called before then fetches the part on the spot
/// and goes on with the function itself.
export class SecondPart {
  private first: WebAssembly.Exports | null = null;
  private table: WebAssembly.Table | null = null;
  private here = false;

  /// What the first part imports under the name `later`: for each slot a function that is named by its number.
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

  /// Behind the first picture. Should it fail, the first call that needs the part tries again.
  async fetch(): Promise<void> {
    if (this.here || !this.first) return;
    const response = await fetch(url, { credentials: 'same-origin' });
    if (!response.ok) throw new Error(`the module's second part: ${response.status}`);
    const compiled = await WebAssembly.compile(await response.arrayBuffer());
    if (!this.here) await WebAssembly.instantiate(compiled, { first: this.first });
    this.here = true;
  }

  private call(slot: number, values: unknown[]): unknown {
    if (!this.here) {
      new WebAssembly.Instance(new WebAssembly.Module(fetchNow()), { first: this.first! });
      this.here = true;
    }
    return (this.table!.get(slot) as (...values: unknown[]) => unknown)(...values);
  }
}

function fetchNow(): Uint8Array<ArrayBuffer> {
  const request = new XMLHttpRequest();
  request.open('GET', url, false);
  // A synchronous request in a page answers in text only: this character set keeps each byte in its character.
  request.overrideMimeType('text/plain; charset=x-user-defined');
  request.send();
  if (request.status !== 200) throw new Error(`the module's second part: ${request.status}`);
  return Uint8Array.from(request.responseText, (character) => character.charCodeAt(0) & 0xff);
}
