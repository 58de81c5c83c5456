import type { DocumentJson, Parameter } from './knotwork';
import { parseValue, type Value } from './goals';

/// What an address says of a figure: `#figure-ID` is the figure, `#figure-ID?id=value&id=value` the figure with
/// parameters of its own, `#figure-ID?document=...` with a whole document (JSON, deflated, in base64url). It only says
/// what is to be seen: values go to the module's `set`, documents to its `load`, and both are checked there.

/// How a figure differs from its start.
export type FigureState = { values: readonly [id: string, value: Value][] } | { document: string };

/// No browser is asked to keep a longer address.
const longestAddress = 100_000;
/// No longer document is unpacked: the module would not read it (core/knotwork/scene/document_json.h).
const longestDocument = 8 * 1024 * 1024;

export function readFigureHash(hash: string): { id: string; query: string } | null {
  const [, id, query = ''] = /^#figure-([\w-]+)(?:\?(.*))?$/s.exec(hash) ?? [];
  return id === undefined ? null : { id, query };
}

/// The hash of a figure, as it stands or (null) at its start.
export async function figureHash(id: string, state: FigureState | null): Promise<string> {
  const query = state === null ? '' : await writeState(state);
  if (query.length > longestAddress) throw new Error('This figure is too large for an address.');
  return `#figure-${id}${query && `?${query}`}`;
}

async function writeState(state: FigureState): Promise<string> {
  const pairs = new URLSearchParams();
  if ('document' in state) pairs.set('document', await packed(state.document));
  else for (const [id, value] of state.values) pairs.set(id, String(value));
  return pairs.toString();
}

/// Null where the query says nothing; throws where it says what nobody can read.
export async function readState(query: string): Promise<FigureState | null> {
  const pairs = [...new URLSearchParams(query)];
  const document = pairs.find(([id]) => id === 'document');
  if (document) return { document: await unpacked(document[1]) };
  return pairs.length > 0 ? { values: pairs.map(([id, value]) => [id, parseValue(value)]) } : null;
}

/// The parameters that have another value now, in the order of the table. A clock that runs says nothing; where it
/// stands still it belongs to the picture. What follows from other rows cannot be set.
export function changedValues(start: readonly Parameter[], now: readonly Parameter[]): [id: string, value: Value][] {
  const before = new Map(start.map(({ id, value }) => [id, value]));
  const runs = now.some(({ id, value }) => id === 'animation.playing' && value === true);
  return now
    .filter(({ id, disabled, value }) => !disabled && !(runs && id === clock) && !alike(before.get(id), value))
    .map(({ id, value }) => [id, typeof value === 'number' ? rounded(value) : value]);
}

const clock = 'animation.time';
/// Digits that an address keeps of a number; what differs less is the same to the eye.
const digits = 10;
const rounded = (value: number): number => Number(value.toPrecision(digits));

/// Whether two documents show the same, from wherever one looks and whenever.
export function showTheSame(a: DocumentJson, b: DocumentJson): boolean {
  const shown = ({ objects, display, animation }: DocumentJson): unknown =>
    ({ objects, display, animation: { ...(animation as object), time: 0 } });
  return alike(shown(a), shown(b));
}

/// Whether a document is one of the figure that starts so: the same kinds of objects, and rings in the same places.
export function sameFigure(start: DocumentJson, document: DocumentJson): boolean {
  const frame = ({ objects, display }: DocumentJson): unknown =>
    [(objects as { kind: string }[]).map(({ kind }) => kind), (display as { rings?: unknown }).rings ?? null];
  return alike(frame(start), frame(document));
}

function alike(a: unknown, b: unknown): boolean {
  if (typeof a === 'number' && typeof b === 'number')
    return Math.abs(a - b) <= 10 ** (1 - digits) * Math.max(1, Math.abs(a), Math.abs(b));
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b;
  const [left, right] = [Object.entries(a), b as Record<string, unknown>];
  return left.length === Object.keys(b).length && left.every(([key, value]) => key in b && alike(value, right[key]));
}

async function packed(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/// A small text may unpack into a huge one: it is read no further than a document may go.
async function unpacked(text: string): Promise<string> {
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  try {
    const letters = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
    let length = 0;
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      chunks.push(part.value);
      length += part.value.length;
      if (length <= longestDocument) continue;
      await reader.cancel();
      throw new RangeError();
    }
  } catch {
    throw new Error('The document in this address cannot be read: perhaps a part of the address is missing.');
  }
  return new Blob(chunks).text();
}
