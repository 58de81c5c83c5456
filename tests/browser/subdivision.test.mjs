// Subdivision curves on the stage: points held, steps walked, levels chosen; bad input refused.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertRefused, call, clickWidget, distance, documentOf, drag, handleAt, parameter, plus, settled, until,
  widget,
} from './stage.mjs';

const wide = { full: true, size: [1440, 900] };

async function opened(page) {
  await call(page, 'open', 'subdivision');
  await settled(page);
  return polygonOf(page);
}

const polygonOf = async (page) => (await documentOf(page)).objects[0];
const limitAt = async (page, parameters) =>
  Promise.all(parameters.map(async (t) => (await call(page, 'evaluate', 'polygon', t))[0]));
const along = Array.from({ length: 15 }, (_, k) => 3 + k / 2);

pageTest('a point is dragged, the limit follows where it has a say, undo brings both back', wide, async (page) => {
  const start = await opened(page);
  assert.deepEqual([start.kind, start.points.length, start.degree, start.topology], ['subdivisionCurve', 7, 3, 'closed']);
  const before = await limitAt(page, along);
  const handle = await handleAt(page, 'point-1');
  await drag(page, plus(handle.screen, [3, -2]), plus(handle.screen, [-40, 30]), { steps: 6 });
  await settled(page);
  assert.ok(distance((await handleAt(page, 'point-1')).screen, plus(handle.screen, [-43, 32])) < 1.5);
  const after = await limitAt(page, along);
  assert.ok(after.some((point, k) => distance(point, before[k]) > 0.1), 'the limit has not followed');
  assert.ok(after.some((point, k) => distance(point, before[k]) === 0), 'a point has a say everywhere');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await polygonOf(page), start);
  assert.deepEqual(await limitAt(page, along), before);
});

pageTest('points are added on the polygon and deleted', wide, async (page) => {
  const start = await opened(page);
  const [a, b] = [await handleAt(page, 'point-0'), await handleAt(page, 'point-1')];
  const at = a.screen.map((x, k) => 0.6 * x + 0.4 * b.screen[k]);
  await drag(page, at, plus(at, [-20, 40]), { steps: 6 });
  await settled(page);
  assert.equal((await polygonOf(page)).points.length, 8);
  assert.equal((await handleAt(page, 'point-1')).selected, true);
  await page.keyboard.press('Delete');
  assert.deepEqual((await polygonOf(page)).points, start.points);
});

pageTest('steps are walked by buttons and by the clock, levels chosen in the plot', wide, async (page) => {
  await opened(page);
  assert.equal((await polygonOf(page)).step, 4);
  await clickWidget(page, 'step on');
  await settled(page);
  assert.equal((await polygonOf(page)).step, 5);
  await clickWidget(page, 'step back');
  await clickWidget(page, 'step back');
  await settled(page);
  assert.equal((await polygonOf(page)).step, 3);

  await call(page, 'set', 'subdivision.levels', 1);
  await call(page, 'set', 'subdivision.step', 0);
  await call(page, 'set', 'animation.speed', 4);
  await clickWidget(page, 'walk');
  // At rest before the press is taken as well as after the last step.
  await until(page, () => {
    const { animation, objects } = window.knotwork.document();
    return !animation.playing && objects[0].step > 0;
  });
  assert.deepEqual([(await polygonOf(page)).step, (await polygonOf(page)).fraction], [4, 0]);

  const plot = await widget(page, 'levels');
  // Levels 0 to 10 of 7 points are measured without being asked for.
  await page.mouse.click(plot.x + 8 + (plot.width - 16) * 0.3, plot.centre[1]);
  await settled(page);
  const chosen = await polygonOf(page);
  assert.deepEqual([chosen.levels, chosen.step], [3, 12]);
  await page.keyboard.press('Control+z');
  assert.equal((await polygonOf(page)).levels, 1);
});

pageTest('degree and topology by the panel; the limit stays the uniform spline of the points', wide, async (page) => {
  const { points } = await opened(page);
  await call(page, 'set', 'curve.degree', 1);
  assert.deepEqual((await limitAt(page, [1]))[0].map((x) => +x.toFixed(9)), points[0]);
  await call(page, 'set', 'curve.degree', 3);
  await clickWidget(page, 'curve.topology: open');
  await settled(page);
  assert.equal((await polygonOf(page)).topology, 'open');
  // The vertex limit mask of a cubic: (1, 4, 1) / 6.
  const [limit] = await limitAt(page, [3]);
  const mask = points[0].map((x, k) => (x + 4 * points[1][k] + points[2][k]) / 6);
  assert.ok(distance(limit, mask) < 1e-12);
});

pageTest('a polygon that cannot be subdivided so is refused with the reason, and nothing changes', wide, async (page) => {
  await opened(page);
  const good = await documentOf(page);
  const bad = [
    ['objects[0].points', /at least 4 points for degree 3/, (object) => ((object.topology = 'open'), (object.points.length = 3))],
    ['objects[0].points', /512/, (object) => (object.points = Array.from({ length: 600 }, (_, k) => [k, 0, 0]))],
    ['objects[0].levels', /13 levels/, (object) => (object.levels = 14)],
    ['objects[0].step', /0 to 16/, (object) => (object.step = 17)],
    ['objects[0].degree', /1 to 9/, (object) => (object.degree = 10)],
    ['objects[0].limit', /true or false/, (object) => (object.limit = 1)],
  ];
  await assertRefused(page, good, bad);
  await assert.rejects(call(page, 'set', 'subdivision.levels', 14), /13 levels of 7 points/);
  await assert.rejects(call(page, 'set', 'subdivision.step', 17), /0 to 16/);
  assert.deepEqual(await documentOf(page), good);
  assert.equal((await parameter(page, 'subdivision.levels')).max, 13);
});
