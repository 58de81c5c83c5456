// B-spline surfaces and model surfaces on the stage: points and knots held, lines added and deleted, directions closed.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, clickWidget, distance, documentOf, drag, frameDrawn, handleAt, handlesOf, picture, plus, settled, stageRect, statsOf, widget,
} from './stage.mjs';

async function opened(page, chapter) {
  await call(page, 'open', chapter);
  await settled(page);
  return objectOf(page);
}

const objectOf = async (page) => (await documentOf(page)).objects[0];
const pointsAt = async (page, places, order = 0) =>
  Promise.all(places.map((uv) => call(page, 'evaluate', 'surface', uv, order)));
const grid = (u, v, count = 7) =>
  Array.from({ length: count * count }, (_, k) => [
    u[0] + ((u[1] - u[0]) * (k % count)) / (count - 1),
    v[0] + ((v[1] - v[0]) * Math.floor(k / count)) / (count - 1),
  ]);
const largestWay = (a, b) => Math.max(...a.map(({ S }, k) => distance(S, b[k].S)));

async function refused(page, spoil, path) {
  const before = await documentOf(page);
  const bad = structuredClone(before);
  spoil(bad.objects[0]);
  await assert.rejects(call(page, 'load', bad), (error) => {
    assert.ok(error.path.startsWith(`objects[0].${path}`), `the path is ${error.path}: ${error.message}`);
    assert.ok(error.message.length > 10);
    return true;
  });
  assert.deepEqual(await documentOf(page), before);
}

pageTest('a point of the net is dragged under the pointer and moves the surface on its support only', { full: true }, async (page) => {
  const start = await opened(page, 'tensor-surface');
  const places = grid([0, 3], [0, 2], 9);
  const before = await pointsAt(page, places);
  const handle = await handleAt(page, 'point-5-0');
  const uploaded = (await statsOf(page)).uploadBytes;
  await drag(page, plus(handle.screen, [2, -2]), plus(handle.screen, [-40, 26]), { steps: 6 });
  await settled(page);
  const moved = await handleAt(page, 'point-5-0');
  assert.ok(distance(moved.screen, plus(handle.screen, [-42, 28])) < 1.5, 'the point has left the pointer');
  assert.ok((await statsOf(page)).uploadBytes > uploaded, 'the picture should have changed');
  // Point 5, 0 has a say on [2, 3] x [0, 1].
  const after = await pointsAt(page, places);
  places.forEach(([u, v], k) => {
    const way = distance(before[k].S, after[k].S);
    assert.ok(u > 2.01 && v < 0.99 ? way > 1e-7 : u < 2 || v > 1 ? way === 0 : true, `at ${u}, ${v} it moved by ${way}`);
  });
  await page.keyboard.press('Control+z');
  assert.deepEqual(await objectOf(page), start);
});

pageTest('a net that is closed before it has come to rest stands whole above its plots', { full: true, size: [1440, 900] }, async (page) => {
  await call(page, 'open', 'tensor-surface');
  await call(page, 'set', 'topology.u', 'closed');
  await call(page, 'set', 'topology.v', 'closed');
  await settled(page);
  const stage = await stageRect(page);
  const plots = await widget(page, 'u knot 3');
  for (const { id, screen: [x, y] } of await handlesOf(page)) {
    assert.ok(x > stage.x + 5 && x < stage.x + stage.width - 5 && y > stage.y + 5 && y < plots.y, `${id} is at ${x}, ${y}`);
  }
});

pageTest('with Shift a point goes along the normal of its surface, arrows nudge it', { full: true }, async (page) => {
  await opened(page, 'tensor-surface');
  const handle = await handleAt(page, 'point-1-1');
  await page.keyboard.down('Shift');
  await drag(page, handle.screen, plus(handle.screen, [-60, 20]), { steps: 6 });
  await page.keyboard.up('Shift');
  await settled(page);
  const moved = await handleAt(page, 'point-1-1');
  const way = moved.position.map((x, k) => x - handle.position[k]);
  assert.ok(Math.hypot(...way) > 0.05, 'the point has not moved');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press(']');
  await frameDrawn(page);
  assert.equal((await handlesOf(page)).find(({ selected }) => selected).id, 'point-1-2');
  assert.ok(distance((await handleAt(page, 'point-1-1')).position, moved.position) > 1e-3, 'the arrow did nothing');
});

pageTest('u and v close and open again: plane, cylinder, torus, and the net is what it was', { full: true }, async (page) => {
  const start = await opened(page, 'tensor-surface');
  await clickWidget(page, 'topology.u: closed');
  await settled(page);
  const cylinder = await objectOf(page);
  assert.deepEqual(cylinder.topology, { u: 'closed', v: 'open' });
  assert.equal(cylinder.knots.u.length, 13);
  const seam = await pointsAt(page, [[0, 0.7], [6 - 1e-9, 0.7]], 2);
  for (const name of ['S', 'Su', 'Sv', 'Suu', 'Suv']) assert.ok(distance(seam[0][name], seam[1][name]) < 1e-6, `${name} at the seam`);
  await clickWidget(page, 'topology.v: closed');
  await settled(page);
  const radii = (await handlesOf(page)).map(({ position: [x, y, z] }) => Math.hypot(Math.hypot(x, y) - 1, z));
  assert.equal(radii.filter((radius) => Math.abs(radius - 0.45) < 1e-9).length, 29, 'all points but the pulled one lie on the torus');
  await clickWidget(page, 'topology.u: open');
  await clickWidget(page, 'topology.v: open');
  await settled(page);
  const back = await objectOf(page);
  assert.ok(Math.max(...back.net.flat().map((point, k) => distance(point, start.net.flat()[k]))) < 1e-12);
  for (let k = 0; k < 4; ++k) await call(page, 'undo');
  assert.deepEqual(await objectOf(page), start);
});

pageTest('a press on a net line adds a line there without a change of the surface; a deleted row changes it', { full: true }, async (page) => {
  const start = await opened(page, 'tensor-surface');
  const places = grid([0, 3], [0, 2]);
  const before = await pointsAt(page, places);
  const [a, b] = [await handleAt(page, 'point-2-4'), await handleAt(page, 'point-3-4')];
  const at = a.screen.map((x, k) => 0.5 * x + 0.5 * b.screen[k]);
  await page.mouse.move(...at);
  await page.mouse.down();
  await page.mouse.up();
  await settled(page);
  const finer = await objectOf(page);
  assert.equal(finer.net.length, 7);
  assert.ok(largestWay(before, await pointsAt(page, places)) < 1e-12, 'the surface has changed');
  await clickWidget(page, 'delete row');
  await settled(page);
  assert.equal((await objectOf(page)).net.length, 6);
  assert.ok(largestWay(before, await pointsAt(page, places)) > 1e-4);
  await call(page, 'undo');
  await call(page, 'undo');
  assert.deepEqual(await objectOf(page), start);
});

pageTest('buttons add and delete rows and columns for fingers', { full: true, touch: true, size: [390, 844], scale: 1 }, async (page) => {
  const start = await opened(page, 'tensor-surface');
  await page.touchscreen.tap(...(await handleAt(page, 'point-2-2')).screen);
  await frameDrawn(page);
  for (const [name, rows, columns] of [['add row', 7, 5], ['add column', 7, 6], ['delete column', 7, 5], ['delete row', 6, 5]]) {
    await page.touchscreen.tap(...(await widget(page, name)).centre);
    await settled(page);
    const { net } = await objectOf(page);
    assert.deepEqual([net.length, net[0].length], [rows, columns], name);
  }
  for (let k = 0; k < 4; ++k) await call(page, 'undo');
  assert.deepEqual(await objectOf(page), start);
});

pageTest('knots of u and v are dragged on their strips; degrees and counts are parameters', { full: true }, async (page) => {
  const start = await opened(page, 'tensor-surface');
  const knot = await widget(page, 'v knot 4');
  await drag(page, knot.centre, plus(knot.centre, [-18, 0]), { steps: 6 });
  await settled(page);
  const moved = await objectOf(page);
  assert.ok(moved.knots.v[4] < 0.98 && moved.knots.v[4] > 0, `the knot is at ${moved.knots.v[4]}`);
  assert.deepEqual(moved.knots.u, start.knots.u);
  await call(page, 'undo');
  assert.deepEqual(await objectOf(page), start);

  const places = grid([0, 1], [0, 2]);
  await call(page, 'set', 'surface.degree.u', 5);
  const bezier = await pointsAt(page, places);
  await call(page, 'set', 'surface.degree.u', 8);
  assert.equal((await objectOf(page)).net.length, 9);
  assert.ok(largestWay(bezier, await pointsAt(page, places)) < 1e-12, 'elevation keeps the surface');
  await call(page, 'set', 'net.v', 9);
  assert.ok(largestWay(bezier, await pointsAt(page, places)) < 1e-12, 'new columns keep the surface');
  await assert.rejects(call(page, 'set', 'net.v', 3), { path: 'net.v' });
  await assert.rejects(call(page, 'set', 'surface.degree.v', 10), { path: 'surface.degree.v' });
  for (let k = 0; k < 3; ++k) await call(page, 'undo');
  assert.deepEqual(await objectOf(page), start);
});

pageTest('a net that is none is refused with its path, and nothing changes', { full: true }, async (page) => {
  await opened(page, 'tensor-surface');
  await refused(page, (surface) => surface.net[2].pop(), 'net[2]');
  await refused(page, (surface) => surface.net.splice(3), 'net');
  await refused(page, (surface) => (surface.degree.u = 10), 'degree.u');
  await refused(page, (surface) => surface.knots.v.reverse(), 'knots.v[');
  await refused(page, (surface) => (surface.net[1][1][2] = null), 'net[1][1][2]');
  await refused(page, (surface) => (surface.net[0][0] = [1, 2]), 'net[0][0]');
  await assert.rejects(call(page, 'evaluate', 'surface', [1], 0), { path: 'parameter' });
  await assert.rejects(call(page, 'evaluate', 'surface', [1, 1], 3), { path: 'order' });
});

pageTest('every surface of the catalogue stands on the stage, in view, without a black spot', { full: true }, async (page) => {
  const start = await opened(page, 'model-surface');
  assert.equal(start.model.kind, 'boy');
  const row = (await call(page, 'parameters')).find(({ id }) => id === 'model');
  const choices = row.choices.filter(({ refused }) => !refused).map(({ id }) => id);
  assert.equal(choices.length, 28);
  for (const id of choices) {
    await call(page, 'set', 'model', id);
    await settled(page);
    const { S, Su, Sv } = await call(page, 'evaluate', 'surface', [0.4, 0.3], 1);
    assert.ok([...S, ...Su, ...Sv].every(Number.isFinite), id);
    const pixels = await picture(page);
    let black = 0;
    for (let k = 0; k < pixels.data.length; k += 4)
      if (pixels.data[k] + pixels.data[k + 1] + pixels.data[k + 2] < 60) ++black;
    assert.ok(black < 200, `${id} has ${black} black pixels`);
  }
  await assert.rejects(call(page, 'set', 'model', 'sheet'), { path: 'model' });
  await call(page, 'set', 'model', 'torus');
  await assert.rejects(call(page, 'set', 'model.tubeRadius', -1), { path: 'model.tubeRadius' });
  await call(page, 'set', 'model.tubeRadius', 0.2);
  const { S } = await call(page, 'evaluate', 'surface', [0, 0], 0);
  assert.ok(Math.abs(S[0] - 1.2) < 1e-12, `S is ${S}`);
});
