import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { changedValues, figureHash, readFigureHash, readState, sameFigure, showTheSame } from '../src/addresses';
import type { Parameter } from '../src/knotwork';

const row = (id: string, value: Parameter['value'], disabled = ''): Parameter => ({ id, value, disabled }) as Parameter;

test('a state comes out of an address as it went in', async () => {
  const values: [string, number | string | boolean][] = [['a.b', 0.25], ['c', 'open'], ['d', true], ['e', -1e-9]];
  const hash = await figureHash('two-points', { values });
  assert.equal(hash, '#figure-two-points?a.b=0.25&c=open&d=true&e=-1e-9');
  const { id, query } = readFigureHash(hash)!;
  assert.equal(id, 'two-points');
  assert.deepEqual(await readState(query), { values });
  const document = JSON.stringify({ label: 'Bézier', points: Array.from({ length: 300 }, (_, k) => [k, k / 7, 0]) });
  const packed = await figureHash('x', { document });
  assert.match(packed, /^#figure-x\?document=[\w-]+$/);
  assert.ok(packed.length < document.length);
  assert.deepEqual(await readState(readFigureHash(packed)!.query), { document });
  assert.equal(await figureHash('x', null), '#figure-x');
  assert.equal(await readState(''), null);
});

test('only the addresses of figures are read', () => {
  for (const hash of ['', '#', '#fitting', '#figure-', '#figure-a%b', '#figure-<b>?a=1'])
    assert.equal(readFigureHash(hash), null);
  assert.deepEqual(readFigureHash('#figure-a?b=1?2'), { id: 'a', query: 'b=1?2' });
});

test('a document that cannot be unpacked is refused, and so is one that unpacks without end', async () => {
  const bomb = deflateRawSync(Buffer.alloc(40 * 1024 * 1024, ' ')).toString('base64url');
  for (const text of ['', '!', 'abcd', 'VVJb', bomb])
    await assert.rejects(readState(`document=${text}`), /cannot be read/, text.slice(0, 20));
  const code = (k: number): number => 33 + (((k * 7919) ^ (k >> 3)) % 90);
  const noise = Array.from({ length: 400_000 }, (_, k) => String.fromCharCode(code(k))).join('');
  await assert.rejects(figureHash('x', { document: noise }), /too large/);
});

test('what differs is said, but not what follows from it, and no clock that runs', () => {
  const start = [row('a', 1), row('b', 'open'), row('c', true), row('d', 5), row('animation.time', 0)];
  const follows = row('d', 6, 'It follows.');
  const now = [row('a', 1 + 1e-13), row('b', 'closed'), row('c', true), follows, row('animation.time', 2)];
  assert.deepEqual(changedValues(start, now), [['b', 'closed'], ['animation.time', 2]]);
  const playing = row('animation.playing', true);
  assert.deepEqual(changedValues(start, [...now, playing]), [['b', 'closed'], ['animation.playing', true]]);
  assert.deepEqual(changedValues([row('x', 0)], [row('x', 0.1 + 0.2)]), [['x', 0.3]]);
});

test('documents that differ in camera and clock alone show the same, and rings and kinds make the figure', () => {
  const document = {
    objects: [{ kind: 'bezierCurve', points: [[0, 0, 0], [1, 2, 3]] }],
    camera: { azimuth: 1 },
    display: { polygon: true, rings: [{ centre: [1, 1, 0] }] },
    animation: { time: 1, playing: false },
  };
  const other = structuredClone(document);
  Object.assign(other, { camera: { azimuth: 2 }, animation: { time: 3, playing: false } });
  assert.ok(showTheSame(document, other));
  other.objects[0]!.points[1]![2] = 3.001;
  assert.ok(!showTheSame(document, other));
  assert.ok(sameFigure(document, other));
  other.display.rings[0]!.centre[0] = 2;
  assert.ok(!sameFigure(document, other));
  other.display.rings = document.display.rings;
  other.objects[0]!.kind = 'bsplineCurve';
  assert.ok(!sameFigure(document, other));
  assert.ok(!sameFigure(document, { ...document, display: {} }));
});
