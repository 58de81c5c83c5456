import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Bridge } from '../src/bridge';
import { heldKind, listenToHolds } from '../src/terms';

test('what a hand holds is told by the member that it moves', () => {
  const curve = { kind: 'bsplineCurve', points: [[0, 0, 0]], knots: [0, 1], parameter: 0.5 };
  assert.equal(heldKind(curve, { ...curve }), null);
  assert.equal(heldKind(curve, { ...curve, points: [[0, 0, 1]] }), 'point');
  assert.equal(heldKind(curve, { ...curve, knots: [0, 2] }), 'knot');
  assert.equal(heldKind(curve, { ...curve, parameter: 0.6 }), 'parameter');
  assert.equal(heldKind(curve, { ...curve, degree: 2 }), null);
  for (const kind of ['fittedCurve', 'subdivisionCurve'])
    assert.equal(heldKind({ kind, points: [[0, 0, 0]] }, { kind, points: [[1, 0, 0]] }), 'datum');
  assert.equal(heldKind({ patches: [] }, { patches: [{ i: 1 }] }), 'local');
  assert.equal(heldKind({ edits: [] }, { edits: [{ i: 1 }] }), 'local');
  assert.equal(heldKind({ net: [] }, { net: [[]] }), 'point');
});

/// A stage that counts how often it is asked, and animation frames that come when they are called.
function stage() {
  const canvas = new EventTarget();
  const chapter = { dataset: {} as Record<string, string> };
  const now = { objects: [{ kind: 'bezierCurve', points: [[0, 0, 0]] }], camera: { azimuth: 0 } };
  const frames: (() => void)[] = [];
  Object.assign(globalThis, { requestAnimationFrame: (act: () => void) => frames.push(act) });
  let asked = 0;
  let points: number | null = 1;
  const bridge = { document: () => (++asked, structuredClone(now)), state: () => ({ points }) } as unknown as Bridge;
  listenToHolds(canvas as HTMLCanvasElement, bridge, () => chapter as unknown as HTMLElement);
  return {
    now,
    lit: () => chapter.dataset['inHand'] ?? null,
    asked: () => asked,
    crowd: () => (points = 5000),
    send: (type: string) => void canvas.dispatchEvent(Object.assign(new Event(type), { button: 0, isPrimary: true })),
    frame: () => frames.splice(0).forEach((act) => act()),
  };
}

test('the module is asked while a pointer is down and it is not known what it holds, once a frame', () => {
  const { now, lit, asked, send, frame } = stage();
  for (let k = 0; k < 5; ++k) send('pointermove');
  frame();
  assert.equal(asked(), 0, 'nothing is held');
  send('pointerdown');
  for (let k = 0; k < 5; ++k) send('pointermove');
  frame();
  assert.deepEqual([asked(), lit()], [2, null]);
  now.objects[0]!.points[0]![0] = 1;
  send('pointermove');
  frame();
  assert.deepEqual([asked(), lit()], [3, 'point']);
  for (let k = 0; k < 5; ++k) send('pointermove');
  frame();
  assert.equal(asked(), 3, 'it is known');
  send('pointerup');
  assert.equal(lit(), null);
});

test('who turns the view is not asked about again; nor is a crowd of points written down', () => {
  const { now, lit, asked, crowd, send, frame } = stage();
  send('pointerdown');
  now.camera.azimuth = 1;
  for (let k = 0; k < 5; ++k) {
    send('pointermove');
    frame();
  }
  assert.deepEqual([asked(), lit()], [2, null]);
  send('pointerup');
  crowd();
  send('pointerdown');
  send('pointermove');
  frame();
  assert.equal(asked(), 2);
});

test('a hand that lets go before the frame leaves no light', () => {
  const { now, lit, send, frame } = stage();
  send('pointerdown');
  now.objects[0]!.points[0]![0] = 1;
  send('pointermove');
  send('pointercancel');
  frame();
  assert.equal(lit(), null);
});

test('who drags something that changes nothing is not asked about for ever', () => {
  const { asked, lit, send, frame } = stage();
  send('pointerdown');
  for (let k = 0; k < 40; ++k) {
    send('pointermove');
    frame();
  }
  assert.deepEqual([asked(), lit()], [13, null]);
});
