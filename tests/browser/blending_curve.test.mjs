// Model curves and blending curves on the stage: locals held, turned and put back, knots and parameter moved, topology,
// number and kind of the locals, the clock; bad input refused.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertRefused, call, clickWidget, distance, distinctColours, documentOf, drag, handleAt, handlesOf,
  hasWidget, parameter, picture, plus, settled, showMore, widget,
} from './stage.mjs';

const turn = 2 * Math.PI;
const objectOf = async (page) => (await documentOf(page)).objects[0];
const steps = (from, to, count) => Array.from({ length: count + 1 }, (_, k) => from + ((to - from) * k) / count);

async function opened(page, chapter) {
  await call(page, 'open', chapter);
  await settled(page);
  return objectOf(page);
}

const points = (page, parameters, order = 0) =>
  page.evaluate(
    ([list, order]) => list.map((t) => window.knotwork.evaluate('curve', t, order)),
    [parameters, order],
  );

/// The curve has moved between t_k and t_{k+2}, and not by a bit elsewhere. Local k of ten, evenly spaced.
function assertMovedOnSupport(parameters, before, after, k) {
  const h = turn / 10;
  const inside = (t) => [0, turn].some((round) => t - round > (k - 1) * h + 1e-9 && t - round < (k + 1) * h - 1e-9);
  parameters.forEach((t, i) => {
    const way = distance(before[i][0], after[i][0]);
    assert.ok(inside(t) ? way > 1e-9 : way === 0, `at t = ${t} the curve moved by ${way}`);
  });
}

pageTest('a local curve is dragged under the pointer and moves the curve on its support only', { full: true }, async (page) => {
  const start = await opened(page, 'blending-curve');
  const everywhere = steps(0.05, 6.25, 61);
  for (const k of [6, 0]) {
    const before = await points(page, everywhere);
    const handle = await handleAt(page, `local-${k}`);
    await drag(page, plus(handle.screen, [3, -2]), plus(handle.screen, [-30, 24]), { steps: 6 });
    await settled(page);
    const moved = await handleAt(page, `local-${k}`);
    assert.equal(moved.selected, true);
    assert.ok(distance(moved.screen, plus(handle.screen, [-33, 26])) < 1.5, 'the local has left the pointer');
    assertMovedOnSupport(everywhere, before, await points(page, everywhere), k);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await objectOf(page), start);
  }
});

pageTest('the gizmo turns a local, keys move it and Delete puts it back', { full: true }, async (page) => {
  await opened(page, 'blending-curve');
  const handle = await handleAt(page, 'local-7');
  await page.mouse.click(...handle.screen);
  await settled(page);
  const start = await objectOf(page);
  // Somewhere on the circle round the handle there are rings.
  let turned = start;
  for (const angle of steps(0, turn, 12)) {
    const from = plus(handle.screen, [46 * Math.cos(angle), 46 * Math.sin(angle)]);
    const to = plus(handle.screen, [46 * Math.cos(angle + 0.7), 46 * Math.sin(angle + 0.7)]);
    await drag(page, from, to, { steps: 8 });
    await settled(page);
    turned = await objectOf(page);
    if (turned.edits.some((edit) => edit.i === 7 && Math.abs(edit.rotation[3]) < 0.999)) break;
    while ((await objectOf(page)).edits.length > 1) await page.keyboard.press('Control+z');
  }
  const edit = turned.edits.find(({ i }) => i === 7);
  assert.ok(edit && Math.abs(edit.rotation[3]) < 0.999, 'nothing has turned');
  assert.deepEqual(edit.translation, [0, 0, 0]);
  // The handle is the centre of the turn: it stays.
  assert.ok(distance((await handleAt(page, 'local-7')).position, handle.position) < 1e-12);
  await page.keyboard.press('ArrowUp');
  assert.ok(distance((await handleAt(page, 'local-7')).screen, handle.screen) > 4);
  await page.keyboard.press('Delete');
  assert.deepEqual(await objectOf(page), start);
  await page.keyboard.press(']');
  assert.equal((await handleAt(page, 'local-8')).selected, true);
});

pageTest('open and closed, number and kind of the locals by the panel; undo goes all the way back', { full: true }, async (page) => {
  const start = await opened(page, 'blending-curve');
  // The seam is as smooth as any other knot.
  const [[s, s1], [e, e1]] = await points(page, [0, turn - 1e-10], 1);
  for (const [x, y] of [[s, e], [s1, e1]]) assert.ok(distance(x, y) < 1e-7, 'the seam shows');
  await clickWidget(page, 'curve.topology: open');
  await settled(page);
  const [[first], [last]] = await points(page, [0, turn]);
  assert.equal((await objectOf(page)).topology, 'open');
  assert.equal((await handlesOf(page)).filter(({ id }) => id.startsWith('local-')).length, 10);
  assert.ok(distance(first, last) < 1e-9, 'the model of this curve is closed');
  await clickWidget(page, 'curve.topology: closed');
  await settled(page);
  assert.deepEqual(await objectOf(page), start);

  const slider = await widget(page, 'locals.count');
  await page.mouse.click(slider.x + 1, slider.centre[1]);
  await settled(page);
  assert.equal((await objectOf(page)).locals.count, 2);
  assert.equal((await handlesOf(page)).filter(({ id }) => id.startsWith('local-')).length, 2);
  await call(page, 'undo');
  const t = [0.2, 1.1, 3.3];
  const before = await points(page, t, 3);
  for (const kind of ['bezier-hermite', 'arc']) {
    await clickWidget(page, `locals.kind: ${kind}`);
    await settled(page);
    assert.equal((await objectOf(page)).locals.kind, kind);
    const after = await points(page, t, 3);
    after.forEach((jet, k) => assert.ok(distance(jet[0], before[k][0]) > 1e-6, `${kind} changes nothing`));
  }
  await call(page, 'set', 'locals.kind', 'bezier-hermite');
  await call(page, 'set', 'locals.degree', 1);
  await call(page, 'set', 'curve.model', 'helix');
  await call(page, 'set', 'curve.turns', 2);
  const open = await objectOf(page);
  assert.equal(open.topology, 'open');
  await assert.rejects(call(page, 'set', 'curve.topology', 'closed'), /Helix is not closed/);
  assert.deepEqual(await objectOf(page), open);
  for (let k = 0; k < 20; ++k) await call(page, 'undo');
  assert.equal((await objectOf(page)).kind, 'blendingSurface');
  for (let k = 0; k < 20; ++k) await call(page, 'redo');
  assert.deepEqual(await objectOf(page), open);
});

pageTest('knots and parameter are dragged on the strip of weights', { full: true }, async (page) => {
  const start = await opened(page, 'blending-curve');
  const knot = await widget(page, 'knot 4');
  const far = await widget(page, 'knot 7');
  await drag(page, knot.centre, plus(knot.centre, [14, 0]), { steps: 6 });
  await settled(page);
  const moved = await objectOf(page);
  assert.equal(moved.knots.length, 9);
  assert.ok(moved.knots[2] > 0.301 && moved.knots[2] < 0.4, `knot 4 is at ${moved.knots[2]}`);
  assert.deepEqual({ ...moved, knots: start.knots }, start);
  // Never on its neighbour.
  await drag(page, (await widget(page, 'knot 4')).centre, far.centre, { steps: 8 });
  const { knots } = await objectOf(page);
  assert.ok(knots[2] > 0.39 && knots[2] < 0.4, `knot 4 is at ${knots[2]}`);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await objectOf(page), start);

  const weights = await widget(page, 'weights');
  await page.mouse.click(weights.x + weights.width / 2, weights.centre[1]);
  await settled(page);
  const { value, min, max } = await parameter(page, 'curve.parameter');
  assert.ok(Math.abs(value - Math.PI) < 0.05, `t is ${value}`);
  assert.deepEqual([min, max], [0, turn]);
  const [[at]] = await points(page, [value]);
  assert.ok(distance(at, (await handleAt(page, 'parameter')).position) < 1e-12);
});

pageTest('the clock moves all locals, neighbours against each other, and comes round to where it began', { full: true }, async (page) => {
  await opened(page, 'blending-curve');
  const rest = await handlesOf(page);
  const t = steps(0.1, 6.2, 30);
  const before = await points(page, t);
  await call(page, 'seek', 1.3);
  const moved = await handlesOf(page);
  const ways = rest.slice(0, 10).map((handle, k) => moved[k].position.map((x, c) => x - handle.position[c]));
  ways.forEach((way, k) => {
    assert.ok(Math.hypot(...way) > 0.05, `local ${k} keeps still`);
    if (k > 0) assert.ok(distance(way, ways[k - 1].map((x) => -x)) < 1e-12, `locals ${k - 1} and ${k} move together`);
  });
  (await points(page, t)).forEach(([point], k) => assert.ok(distance(point, before[k][0]) > 1e-6));
  await call(page, 'seek', 0);
  assert.deepEqual(await points(page, t), before);
  await clickWidget(page, 'play');
  await page.waitForFunction(() => window.knotwork.document().animation.time > 0.3);
  await clickWidget(page, 'play');
  await settled(page);
  assert.equal((await documentOf(page)).animation.playing, false);
});

pageTest('a model curve: any of the catalogue, its measures, its frame at a parameter that is dragged', { full: true }, async (page) => {
  const start = await opened(page, 'model-curve');
  const dot = await handleAt(page, 'parameter');
  await drag(page, dot.screen, plus(dot.screen, [40, 10]), { steps: 8 });
  await settled(page);
  const moved = await objectOf(page);
  assert.notEqual(moved.parameter, start.parameter);
  assert.deepEqual({ ...moved, parameter: start.parameter }, start);
  const [[at]] = await points(page, [(await parameter(page, 'curve.parameter')).value]);
  assert.ok(distance(at, (await handleAt(page, 'parameter')).position) < 1e-12);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await objectOf(page), start);

  const { choices } = await parameter(page, 'curve.model');
  assert.equal(choices.length, 17);
  for (const { id } of choices) {
    await call(page, 'set', 'curve.model', id);
    await settled(page);
    const object = await objectOf(page);
    const measures = Object.keys(object.model).filter((name) => name !== 'kind');
    const rows = (await call(page, 'parameters')).map((row) => row.id);
    for (const name of measures) assert.ok(rows.includes(`curve.${name}`), `${id} has no row for ${name}`);
    const [jet] = await points(page, [0.4], 3);
    assert.equal(jet.length, 4);
    assert.ok(jet.flat().every(Number.isFinite));
  }
  await call(page, 'set', 'curve.model', 'torus-knot');
  const [before] = await points(page, [1]);
  await call(page, 'set', 'curve.tubeRadius', 0.1);
  assert.ok(distance((await points(page, [1]))[0][0], before[0]) > 0.05);
  await assert.rejects(call(page, 'set', 'curve.turnsAround', 2.5), /whole number from 1 to 24/);
  await assert.rejects(call(page, 'evaluate', 'curve', 0, 4), /from 0 to 3/);
  await assert.rejects(call(page, 'set', 'curve.turns', 2), /no such parameter/);
  const plot = await widget(page, 'curvature');
  await page.mouse.click(plot.x + 0.75 * plot.width, plot.centre[1]);
  await settled(page);
  assert.ok(Math.abs((await objectOf(page)).parameter - 0.75) < 0.02);
});

pageTest('curve, strands and weights are drawn; what is switched off is not', { full: true, size: [1200, 800] }, async (page) => {
  await opened(page, 'blending-curve');
  const all = { x: 0, y: 0, width: 1200, height: 800 };
  const weights = await widget(page, 'weights');
  const area = { x: weights.x, y: weights.y, w: weights.width, h: weights.height };
  assert.ok(distinctColours(await picture(page, all), area) > 60);
  const [x, y] = (await handleAt(page, 'local-5')).screen;
  const around = { x: x - 60, y: y - 60, w: 120, h: 120 };
  const shown = distinctColours(await picture(page, all), around);
  for (const id of ['display.locals', 'display.construction', 'display.handles']) await call(page, 'set', id, false);
  await settled(page);
  assert.ok(shown > distinctColours(await picture(page, all), around), 'what is shown makes no difference');
  await showMore(page, 'display.locals');
  assert.ok(!(await hasWidget(page, 'display.wireframe')), 'a curve has no wireframe');
});

pageTest('a finger selects a local and plays the clock', { full: true, touch: true, size: [390, 844], scale: 1 }, async (page) => {
  await opened(page, 'blending-curve');
  const handle = await handleAt(page, 'local-8');
  await page.touchscreen.tap(...handle.screen);
  await settled(page);
  assert.equal((await handleAt(page, 'local-8')).selected, true);
  await clickWidget(page, 'play');
  await page.waitForFunction(() => window.knotwork.document().animation.time > 0.1);
  await clickWidget(page, 'play');
});

pageTest('a curve that cannot be is refused with the place and the reason, and nothing changes', { full: true }, async (page) => {
  await opened(page, 'blending-curve');
  const good = await documentOf(page);
  const bad = [
    ['objects[0].locals.count', /2 to 64/, (curve) => (curve.locals.count = 65)],
    ['objects[0].locals.count', /2 to 64/, (curve) => (curve.locals.count = 1)],
    ['objects[0].locals.degree', /1 to 3/, (curve) => (curve.locals.degree = 4)],
    ['objects[0].locals.kind', /sub-curve/, (curve) => (curve.locals.kind = 'clothoid')],
    ['objects[0].knots', /9 knots/, (curve) => (curve.knots = [0.5])],
    ['objects[0].knots[1]', /behind/, (curve) => (curve.knots = [0.1, 0.1, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9])],
    ['objects[0].knots', /63/, (curve) => (curve.knots = Array.from({ length: 1000 }, () => 0.5))],
    ['objects[0].model.kind', /torus-knot/, (curve) => (curve.model = { kind: 'spaghetti' })],
    ['objects[0].model.size', /missing/i, (curve) => delete curve.model.size],
    ['objects[0].model.girth', /not a member/, (curve) => (curve.model.girth = 1)],
    ['objects[0].topology', /not closed/, (curve) => (curve.model = { kind: 'helix', radius: 1, rise: 0.1, turns: 3 })],
    ['objects[0].edits', /j must be 0/, (curve) => (curve.edits[0].j = 1)],
    ['objects[0].parameter', /0 to 1/, (curve) => (curve.parameter = -1)],
  ];
  await assertRefused(page, good, bad);
  await assert.rejects(call(page, 'evaluate', 'curve', [0, 0]), /at t, a finite number/);
  await assert.rejects(call(page, 'set', 'locals.u', 5), /no such parameter/);
});
