import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { applies, fulfilled, parseAction, run } from '../src/actions';
import { exportMessage } from '../src/api';
import { Bridge, RefusedError, unwrap, type EmscriptenModule } from '../src/bridge';
import { decimalsOf, format } from '../src/controls';
import { parseGoal, reached } from '../src/goals';
import { historyKey } from '../src/history';
import { modifiersOf, wheelUnit } from '../src/input';
import type { Parameter } from '../src/knotwork';
import { faultText, givePoints, pointsText } from '../src/points';
import { countBytes } from '../src/progress';
import { direction, rows, subscript } from '../src/report';

const none = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };

/// A module that writes down what it is called with.
function recorder(answer: string | number = '{"value":null}'): [Bridge, unknown[][]] {
  const calls: unknown[][] = [];
  const module: EmscriptenModule = {
    ccall: (name, _result, types, values) => {
      calls.push([name, types, values]);
      return answer;
    },
    lengthBytesUTF8: (text) => Buffer.byteLength(text),
    stringToUTF8: (text, address, most) => calls.push(['written', text.length, address, most]),
    writeArrayToMemory: (bytes, address) => calls.push(['written', bytes.length, address]),
    _malloc: (size) => size === 0 ? 0 : 4096,
    _free: (address) => calls.push(['freed', address]),
  };
  return [new Bridge(module), calls];
}

test('a goal is reached when all its comparisons hold, and what has no value holds in none', () => {
  const goal = parseGoal('fit.rms < 0.02 and fitted.count <= 7 and curve.topology = closed');
  const look = (values: Record<string, number | string>) => (name: string) => values[name];
  const reachedBy = { 'fit.rms': 0.01, 'fitted.count': 7, 'curve.topology': 'closed' };
  assert.ok(reached(goal, look(reachedBy)));
  assert.ok(!reached(goal, look({ ...reachedBy, 'fit.rms': 0.02 })));
  assert.ok(!reached(goal, look({ ...reachedBy, 'fitted.count': 8 })));
  assert.ok(!reached(goal, look({ ...reachedBy, 'curve.topology': 'open' })));
  assert.ok(!reached(goal, look({ 'fit.rms': 0.01 })));
  assert.ok(reached(parseGoal('a != b and c >= 2 and d > -1'), look({ a: 'c', c: 2, d: 0 })));
  assert.throws(() => parseGoal('a < b'), /no number/);
  assert.throws(() => parseGoal(''), /comparisons/);
});

test('an answer is unwrapped, an error is thrown with its path', () => {
  assert.deepEqual(unwrap('{"value":[1,2]}'), [1, 2]);
  assert.equal(unwrap('{"value":null}'), null);
  assert.throws(
    () => unwrap('{"error":{"message":"Must be a number.","path":"objects[0].locals"}}'),
    (error) =>
      error instanceof RefusedError && error.message === 'Must be a number.' && error.path === 'objects[0].locals',
  );
});

test('points as text go to the module, no longer than it reads, and faults name their line', () => {
  const [bridge, calls] = recorder();
  givePoints(bridge, '1, 2\n3, 4');
  assert.deepEqual(calls.pop(), ['knotwork_points', ['string'], ['1, 2\n3, 4']]);
  givePoints(bridge, '7'.repeat(50_000_000));
  assert.deepEqual(calls[0], ['written', 8 * 1024 * 1024 + 1, 4096, 8 * 1024 * 1024 + 2]);
  assert.equal(faultText(new RefusedError('That is no number.', 'line 12')), 'Line 12: That is no number.');
  assert.equal(faultText(new RefusedError('There are no points here.', '')), 'There are no points here.');
  assert.equal(faultText(new RefusedError('All in one place.', 'points')), 'All in one place.');
  assert.equal(pointsText([[1, 2, 0], [-3.5, 0, 1e-7]]), '1, 2, 0\n-3.5, 0, 1e-7');
});

test('long texts and bytes go through the heap and are given back', () => {
  const [bridge, calls] = recorder();
  const text = 'é'.repeat(5000);
  bridge.load(text);
  assert.deepEqual(calls, [
    ['written', 5000, 4096, 10001],
    ['knotwork_load', ['number'], [4096]],
    ['freed', 4096],
  ]);
  calls.length = 0;
  bridge.font(new Uint8Array(7), 600);
  assert.deepEqual(calls, [
    ['written', 7, 4096],
    ['knotwork_font', ['number', 'number', 'number'], [4096, 7, 600]],
    ['freed', 4096],
  ]);
});

test('values cross the border with the types that bridge.h declares', () => {
  const [bridge, calls] = recorder();
  bridge.set('topology.u', 'open');
  bridge.gesture(true);
  assert.deepEqual(calls, [
    ['knotwork_set_choice', ['string', 'string'], ['topology.u', 'open']],
    ['knotwork_gesture', ['number'], [1]],
  ]);
});

test('phrases are parsed into actions', () => {
  assert.deepEqual(parseAction('set?topology.v=open&locals.u=8&display.frames=true'), {
    kind: 'set',
    values: [['topology.v', 'open'], ['locals.u', 8], ['display.frames', true]],
  });
  assert.deepEqual(parseAction('play'), { kind: 'play' });
  assert.deepEqual(parseAction('open?id=blending-surface'), { kind: 'open', chapter: 'blending-surface' });
  for (const text of ['', 'set', 'jump', 'open?chapter=x']) assert.throws(() => parseAction(text), /cannot do/);
});

test('an action calls the module, once for each value', () => {
  const [bridge, calls] = recorder();
  run(parseAction('set?topology.u=open&topology.v=closed'), bridge);
  run(parseAction('pause'), bridge);
  assert.deepEqual(calls.map(([name]) => name), ['knotwork_set_choice', 'knotwork_set_choice', 'knotwork_play']);
  assert.deepEqual(calls[2]![2], [0]);
});

test('an action is about what has its parameters', () => {
  const curve = new Map([['curve.degree', { value: 3 } as Parameter]]);
  assert.equal(applies(parseAction('set?curve.degree=2'), curve), true);
  assert.equal(applies(parseAction('set?curve.degree=2&topology.u=open'), curve), false);
  assert.equal(applies(parseAction('play'), curve), false);
  assert.equal(applies(parseAction('open?id=bezier-curve'), curve), true);
});

test('an action is fulfilled when nothing is left to do', () => {
  const table = new Map([['topology.u', { value: 'open' } as Parameter]]);
  assert.equal(fulfilled(parseAction('set?topology.u=open'), table), true);
  assert.equal(fulfilled(parseAction('set?topology.u=closed'), table), false);
  assert.equal(fulfilled(parseAction('open?id=x'), table), false);
});

test('the report: counts and domains of a 6 by 4 net in all four topologies', () => {
  const knots = (count: number): number[] => Array<number>(count).fill(0);
  const state = {
    u: { ...direction('u', 'closed', 6), knots: knots(9) },
    v: { ...direction('v', 'open', 4), knots: knots(6) },
  };
  const sheet = new Map([['model', { value: 'sheet' } as Parameter]]);
  const shown = rows({ ...state, shape: 'cylinder' }, sheet).map(({ u, v, shape, current }) => [
    u.domain, v.domain, u.knots, v.knots, u.patches, v.patches, u.locals, v.locals, shape, current,
  ]);
  assert.deepEqual(shown, [
    ['[u₁, u₆]', '[v₁, v₄]', 8, 6, 5, 3, 6, 4, 'plane', false],
    ['[u₁, u₆]', '[v₁, v₅)', 8, 7, 5, 4, 6, 4, 'cylinder', false],
    ['[u₁, u₇)', '[v₁, v₄]', 9, 6, 6, 3, 6, 4, 'cylinder', true],
    ['[u₁, u₇)', '[v₁, v₅)', 9, 7, 6, 4, 6, 4, 'torus', false],
  ]);
  assert.equal(subscript(1280), '₁₂₈₀');
});

test('the row of the present topology shows what the module says', () => {
  const said = { topology: 'open' as const, domain: '[u₁, u₉]', knots: [0, 0, 1], patches: 77, locals: 6 };
  const state = { u: said, v: { ...said, domain: '[v₁, v₉]' }, shape: 'plane' };
  const present = rows(state, new Map()).find((row) => row.current)!;
  assert.deepEqual([present.u.domain, present.u.knots, present.u.patches], ['[u₁, u₉]', 3, 77]);
});

test('a fixed model keeps its shape, and says which topologies it cannot have', () => {
  const choices = [{ id: 'open', label: 'open', refused: '' }, { id: 'closed', label: 'closed', refused: 'Not in u.' }];
  const table = new Map([
    ['model', { value: 'cylinder' } as Parameter],
    ['topology.u', { value: 'open', choices } as unknown as Parameter],
  ]);
  const said = { topology: 'open' as const, domain: '', knots: [0, 0, 1], patches: 1, locals: 2 };
  const shown = rows({ u: said, v: said, shape: 'cylinder' }, table);
  assert.deepEqual(shown.map((row) => row.shape), ['cylinder', 'cylinder', 'cylinder', 'cylinder']);
  assert.deepEqual(shown.map((row) => row.refused), ['', '', 'Not in u.', 'Not in u.']);
});

test('numbers have as many decimals as their step, a true minus and their unit', () => {
  const show = (value: number, step: number | null, unit = '', kind: Parameter['kind'] = 'number'): string =>
    format({ value, step, unit, kind });
  assert.equal(show(0.5, 0.01), '0.50');
  assert.equal(show(-1.25, 0.25), '−1.25');
  assert.equal(show(6, 1, '', 'integer'), '6');
  assert.equal(show(2, 0.1, 's'), '2.0\u00a0s');
  assert.deepEqual([1, 0.1, 0.05, 1e-9, 0, null].map(decimalsOf), [0, 1, 2, 6, 2, 2]);
});

test('undo and redo have the keys that readers know', () => {
  const key = (name: string, held: Partial<typeof none>) => historyKey({ ...none, ...held, key: name });
  assert.equal(key('z', { ctrlKey: true }), 'undo');
  assert.equal(key('z', { metaKey: true }), 'undo');
  assert.equal(key('Z', { ctrlKey: true, shiftKey: true }), 'redo');
  assert.equal(key('y', { ctrlKey: true }), 'redo');
  assert.equal(key('z', {}), null);
  assert.equal(key('z', { ctrlKey: true, altKey: true }), null);
});

test('modifiers are bits, a wheel turns in pixels, lines or pages', () => {
  assert.equal(modifiersOf({ ...none, shiftKey: true, metaKey: true }), 9);
  assert.equal(modifiersOf({ ...none, ctrlKey: true, altKey: true }), 6);
  assert.deepEqual([0, 1, 2].map((mode) => wheelUnit(mode, 700)), [1, 16, 700]);
});

test('bytes are counted as they pass, and pass unchanged', async () => {
  const totals: number[] = [];
  const source = new Blob([new Uint8Array([1, 2, 3]), new Uint8Array([4])]).stream();
  const passed = await new Response(countBytes(source, (total) => totals.push(total))).arrayBuffer();
  assert.deepEqual([...new Uint8Array(passed)], [1, 2, 3, 4]);
  assert.equal(totals.at(-1), 4);
});

test('export says what will come, and what will not', () => {
  assert.match(exportMessage('stl'), /not part of this version.*obj, stl/);
  assert.match(exportMessage('doc'), /no such format/);
});

test('text has a contrast of at least 4.5 on paper and cards, controls of 3, in both schemes', () => {
  const css = readFileSync('src/style/tokens.css', 'utf8');
  const [light, dark] = css.split(/@media [^{]*dark[^{]*|@media print/).map(colours);
  for (const scheme of [light!, new Map([...light!, ...dark!])]) {
    for (const ground of ['--paper', '--card']) {
      for (const text of ['--ink', '--ink-soft', '--accent', '--local-a', '--local-b', '--local-c', '--local-d', '--local-e']) {
        const ratio = contrast(scheme.get(text)!, scheme.get(ground)!);
        assert.ok(ratio >= 4.5, `${text} on ${ground}: ${ratio.toFixed(2)}`);
      }
      assert.ok(contrast(scheme.get('--edge')!, scheme.get(ground)!) >= 3, `--edge on ${ground}`);
    }
    assert.ok(contrast(scheme.get('--ink-soft')!, scheme.get('--stage')!) >= 4.5);
  }
});

function colours(css: string): Map<string, string> {
  return new Map([...css.matchAll(/(--[\w-]+):\s*(#[0-9a-f]{6})\b/g)].map(([, name, value]) => [name!, value!]));
}

/// WCAG's ratio of relative luminances.
function contrast(a: string, b: string): number {
  const luminance = (colour: string): number =>
    [1, 3, 5]
      .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
      .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i]!, 0);
  const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (high! + 0.05) / (low! + 0.05);
}
