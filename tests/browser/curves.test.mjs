// Bezier and B-spline curves on the stage: points and knots held, added and deleted; bad input refused.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertRefused, call, clickWidget, distance, distinctColours, documentOf, drag, frameDrawn, handleAt,
  handlesOf, picture, plus, settled, until, widget,
} from './stage.mjs';

async function opened(page, chapter) {
  await call(page, 'open', chapter);
  await settled(page);
  return curveOf(page);
}

const curveOf = async (page) => (await documentOf(page)).objects[0];
const points = async (page, parameters, order = 0) =>
  Promise.all(parameters.map((t) => call(page, 'evaluate', 'curve', t, order)));
const steps = (from, to, count) => Array.from({ length: count + 1 }, (_, k) => from + ((to - from) * k) / count);

pageTest('a control point is dragged under the pointer and moves the curve on its support only', { full: true }, async (page) => {
  const start = await opened(page, 'bspline-curve');
  const inside = steps(0.1, 3.9, 19);
  const before = await points(page, inside);
  const handle = await handleAt(page, 'point-1');
  await drag(page, plus(handle.screen, [3, -2]), plus(handle.screen, [-40, 30]), { steps: 6 });
  await settled(page);
  const moved = await handleAt(page, 'point-1');
  assert.ok(distance(moved.screen, plus(handle.screen, [-43, 32])) < 1.5, 'the point has left the pointer');
  // Point 1 has a say on [t_1, t_5] = [0, 2].
  const after = await points(page, inside);
  inside.forEach((t, k) => {
    const way = distance(before[k][0], after[k][0]);
    assert.ok(t < 1.99 ? way > 1e-6 : way === 0, `at t = ${t} the curve moved by ${way}`);
  });
  await page.keyboard.press('Control+z');
  assert.deepEqual(await curveOf(page), start);
});

pageTest('a knot is dragged on the strip; on its neighbour it snaps, and the curve is smooth no more', { full: true }, async (page) => {
  const start = await opened(page, 'bspline-curve');
  const knot = await widget(page, 'knot 5');
  const other = await widget(page, 'knot 6');
  await drag(page, knot.centre, plus(knot.centre, [-30, 0]), { steps: 6 });
  await settled(page);
  const moved = await curveOf(page);
  assert.ok(moved.knots[5] < 1.95 && moved.knots[5] > 1, `knot 5 is at ${moved.knots[5]}`);
  assert.deepEqual(moved.points, start.points);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await curveOf(page), start);

  await drag(page, knot.centre, plus(other.centre, [-3, 0]), { steps: 8 });
  await settled(page);
  const double = await curveOf(page);
  assert.deepEqual(double.knots, [0, 0, 0, 0, 1, 3, 3, 4, 4, 4, 4]);
  const [[, , left], [, , right]] = await points(page, [3 - 1e-9, 3], 2);
  assert.ok(distance(left, right) > 1, 'a double knot should break the second derivative');
});

pageTest('a press on the polygon adds a point that is in the hand, Delete takes it away', { full: true }, async (page) => {
  const start = await opened(page, 'bspline-curve');
  const [a, b] = [await handleAt(page, 'point-0'), await handleAt(page, 'point-1')];
  const at = a.screen.map((x, k) => 0.6 * x + 0.4 * b.screen[k]);
  await drag(page, at, plus(at, [-20, 40]), { steps: 6 });
  await settled(page);
  const longer = await curveOf(page);
  assert.equal(longer.points.length, 8);
  assert.equal(longer.knots.length, 12);
  const added = await handleAt(page, 'point-1');
  assert.equal(added.selected, true);
  assert.ok(distance(added.screen, plus(at, [-20, 40])) < 2, 'the new point has left the pointer');
  await page.keyboard.press('Delete');
  assert.deepEqual((await curveOf(page)).points, start.points);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await curveOf(page), start);
});

pageTest('buttons add and delete points for fingers', { full: true, touch: true, size: [390, 844], scale: 1 }, async (page) => {
  const start = await opened(page, 'bspline-curve');
  const handle = await handleAt(page, 'point-6');
  await page.touchscreen.tap(...handle.screen);
  await frameDrawn(page);
  assert.equal((await handleAt(page, 'point-6')).selected, true);
  await page.touchscreen.tap(...(await widget(page, 'add')).centre);
  await settled(page);
  assert.equal((await curveOf(page)).points.length, 8);
  await page.touchscreen.tap(...(await widget(page, 'remove')).centre);
  await settled(page);
  assert.deepEqual((await curveOf(page)).points, start.points);
});

pageTest('open and closed, degree and parameter by the panel', { full: true }, async (page) => {
  await opened(page, 'bspline-curve');
  await clickWidget(page, 'curve.topology: closed');
  await settled(page);
  const closed = await curveOf(page);
  assert.equal(closed.topology, 'closed');
  assert.equal(closed.knots.length, 14);
  // The seam is as smooth as any other knot.
  const [[s, s1, s2], [e, e1, e2]] = await points(page, [0, 7 - 1e-10], 2);
  for (const [x, y] of [[s, e], [s1, e1], [s2, e2]]) assert.ok(distance(x, y) < 1e-6, 'the seam shows');
  const slider = await widget(page, 'curve.degree');
  await page.mouse.click(slider.x + 1, slider.centre[1]);
  await settled(page);
  assert.equal((await curveOf(page)).degree, 1);
  const basis = await widget(page, 'basis');
  await page.mouse.click(basis.x + basis.width / 2, basis.centre[1]);
  await settled(page);
  const row = (await call(page, 'parameters')).find(({ id }) => id === 'curve.parameter');
  assert.ok(Math.abs(row.value - 3.5) < 0.05, `t is ${row.value}`);
  assert.deepEqual([row.min, row.max], [0, 7]);
});

pageTest("the Bezier curve's parameter is dragged along the curve, with its construction", { full: true }, async (page) => {
  const start = await opened(page, 'bezier-curve');
  const dot = await handleAt(page, 'parameter');
  const [aim] = await points(page, [0.75]);
  await drag(page, dot.screen, plus(dot.screen, [160, -10]), { steps: 8 });
  await settled(page);
  const moved = await curveOf(page);
  assert.ok(moved.parameter > start.parameter + 0.1, `the parameter is ${moved.parameter}`);
  const [[point]] = await points(page, [moved.parameter]);
  assert.ok(distance(point, (await handleAt(page, 'parameter')).position) < 1e-12);
  assert.deepEqual(moved.points, start.points);
  assert.deepEqual(aim, (await points(page, [0.75]))[0]);
  assert.ok(!(await call(page, 'widgets')).some(({ label }) => label.startsWith('knot')), 'its knots cannot be moved');
});

pageTest('the settings at the foot are those of the curve on the stage; controls of a surface rest', { full: true }, async (page) => {
  const surface = (await documentOf(page)).objects[0];
  await opened(page, 'bspline-curve');
  await page.locator('[data-settings] summary', { hasText: 'Curve' }).click();
  await page.locator('[data-settings]').getByRole('slider', { name: 'degree' }).focus();
  await page.keyboard.press('ArrowLeft');
  assert.equal((await curveOf(page)).degree, 2);
  await call(page, 'undo');
  const chapter = page.locator('#blending-surface');
  const toggles = chapter.getByRole('group', { name: /topology u/i }).getByRole('radio');
  assert.deepEqual(await toggles.evaluateAll((inputs) => inputs.map((input) => input.disabled || input.checked)), [true, true]);
  // A phrase brings the figure that it is about, as its chapter has it.
  await chapter.getByRole('button', { name: 'Open it', exact: true }).click();
  await until(page, () => window.knotwork.document().objects[0].kind === 'blendingSurface');
  const now = (await documentOf(page)).objects[0];
  assert.deepEqual(now.topology, { u: 'closed', v: 'open' });
  assert.deepEqual({ ...now, topology: surface.topology }, surface);
  assert.equal(await toggles.first().isDisabled(), false);
});

pageTest('curve, polygon and basis functions are drawn', { full: true, size: [1200, 800] }, async (page) => {
  await opened(page, 'bspline-curve');
  const all = { x: 0, y: 0, width: 1200, height: 800 };
  const basis = await widget(page, 'basis');
  assert.ok(distinctColours(await picture(page, all), { x: basis.x, y: basis.y, w: basis.width, h: basis.height }) > 60);
  const [handle] = await handlesOf(page);
  const [x, y] = handle.screen;
  const around = { x: x - 40, y: y - 40, w: 80, h: 80 };
  const shown = distinctColours(await picture(page, all), around);
  for (const id of ['display.polygon', 'display.handles', 'display.colours']) await call(page, 'set', id, false);
  await settled(page);
  assert.ok(shown > distinctColours(await picture(page, all), around), 'what is shown makes no difference');
});

pageTest('a curve that cannot be is refused with the place and the reason, and nothing changes', { full: true }, async (page) => {
  await opened(page, 'bspline-curve');
  const good = await documentOf(page);
  const bad = [
    ['objects[0].knots', /decrease/, (curve) => (curve.knots[5] = 9)],
    ['objects[0].points', /belong to 6 control points/, (curve) => curve.knots.pop()],
    ['objects[0].knots', /multipl|often|times|coincide|knots/i, (curve) => (curve.knots = [0, 0, 0, 0, 2, 2, 2, 2, 2, 2, 2])],
    ['objects[0].points', /points/, (curve) => curve.points.pop()],
    ['objects[0].points', /512/, (curve) => (curve.points = Array.from({ length: 600 }, () => [0, 0, 0]))],
    ['objects[0].points[2]', /list of 3 numbers/, (curve) => (curve.points[2] = [1, 2])],
    ['objects[0].degree', /9/, (curve) => (curve.degree = 12)],
    ['objects[0].parameter', /0 to 1/, (curve) => (curve.parameter = 1.5)],
    ['objects[0].kind', /blendingSurface, bezierCurve, bsplineCurve/, (curve) => (curve.kind = 'nurbs')],
  ];
  await assertRefused(page, good, bad);
  await assert.rejects(call(page, 'evaluate', 'curve', [0, 0]), /at t, a finite number/);
  await assert.rejects(call(page, 'set', 'locals.u', 5), /no such parameter/);
});
