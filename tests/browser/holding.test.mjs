// Local patches held by mouse, pen and touch: what moves, how far, and what undo makes of it.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertMovedOnSupportOnly, call, clickWidget, cross, distance, documentOf, dot, drag, eyeOf, fingers, frameDrawn,
  freeHandles, frontHandle, grid, handleAt, handlesOf, jet, length, minus, nextUndo, patchOf, plus, projection,
  sampleCells, settled, stageRect, surfaceOf, times, unit, until,
} from './stage.mjs';

const edits = async (page) => (await surfaceOf(page)).patches;
const editOf = async (page, [i, j]) => (await edits(page)).find((edit) => edit.i === i && edit.j === j);

/// The normal of the patch at its own centre.
async function normalAt(page, [i, j]) {
  const { u, v } = await grid(page);
  const { Su, Sv } = await jet(page, [u.centre(i), v.centre(j)]);
  return unit(cross(Su, Sv));
}

pageTest('a dragged handle stays under the pointer and moves its support only', { full: true }, async (page) => {
  const start = await documentOf(page);
  const handle = await frontHandle(page);
  const patch = patchOf(handle);
  const before = await sampleCells(page);
  // Taken off its centre, so that a handle that jumps to the pointer is noticed.
  const grab = plus(handle.screen, [3, -2]);
  const target = plus(grab, [57, -31]);
  await drag(page, grab, target, { hold: true, steps: 8 });
  const held = await handleAt(page, handle.id);
  assert.ok(distance(held.screen, plus(target, [-3, 2])) < 1.5, 'the handle has left the pointer during the drag');
  await page.mouse.up();
  await settled(page);

  const moved = await handleAt(page, handle.id);
  assert.ok(distance(moved.screen, plus(target, [-3, 2])) < 1.5, 'the handle has left the pointer');
  assert.equal(moved.selected, true);
  const { target: at, ...camera } = start.camera;
  const forward = unit(minus(at, eyeOf({ target: at, ...camera })));
  const way = minus(moved.position, handle.position);
  assert.ok(length(way) > 0.01 && Math.abs(dot(way, forward)) < 1e-9 * length(way), 'it has left the view plane');
  assertMovedOnSupportOnly(before, await sampleCells(page), await grid(page), patch);

  const { u, v } = await grid(page);
  const { S } = await jet(page, [u.centre(patch[0]), v.centre(patch[1])]);
  assert.ok(distance(S, moved.position) < 1e-12, 'the surface does not go through its handle');
  assert.ok(await editOf(page, patch), 'the document does not hold the edit');

  const dragged = await documentOf(page);
  await call(page, 'undo');
  assert.deepEqual(await documentOf(page), start, 'one undo does not take the whole drag back');
  assert.deepEqual(await sampleCells(page), before);
  await call(page, 'redo');
  assert.deepEqual(await documentOf(page), dragged);
});

pageTest('each drag is one step of undo, and a click on a handle is none', {}, async (page) => {
  const undo = await nextUndo(page);
  const handle = await frontHandle(page);
  const states = [await documentOf(page)];
  for (const way of [[40, 10], [-15, -50], [5, 30]]) {
    const { screen } = await handleAt(page, handle.id);
    await drag(page, screen, plus(screen, way));
    states.push(await documentOf(page));
  }
  const { screen } = await handleAt(page, handle.id);
  await page.mouse.click(...screen);
  await frameDrawn(page);
  assert.deepEqual(await documentOf(page), states[3]);
  for (const state of states.slice(0, 3).reverse()) {
    await call(page, 'undo');
    assert.deepEqual((await documentOf(page)).objects, state.objects);
  }
  assert.equal(await nextUndo(page), undo, 'there are more steps than drags');
  for (const state of states.slice(1)) {
    await call(page, 'redo');
    assert.deepEqual((await documentOf(page)).objects, state.objects);
  }
});

pageTest('with Shift a handle moves along its normal', {}, async (page) => {
  const handle = await frontHandle(page);
  const patch = patchOf(handle);
  const normal = await normalAt(page, patch);
  const { project } = await projection(page);
  const along = unit(minus(project(plus(handle.position, times(0.1, normal))), handle.screen));
  await page.keyboard.down('Shift');
  await drag(page, handle.screen, plus(handle.screen, times(45, along)));
  await page.keyboard.up('Shift');
  await settled(page);
  const moved = await handleAt(page, handle.id);
  const way = minus(moved.position, handle.position);
  assert.ok(dot(way, normal) > 0.02, 'it has not moved outwards');
  assert.ok(length(cross(way, normal)) < 1e-9 * length(way), 'it has left its normal');
  assert.ok(distance(moved.screen, plus(handle.screen, times(45, along))) < 1.5, 'it has left the pointer');
  const edit = await editOf(page, patch);
  assert.deepEqual(edit.translation.slice(0, 2).map((x) => Math.abs(x) < 1e-12), [true, true]);
});

/// Points of the gizmo round a handle, its arms given in ring radii along the patch's own axes.
async function gizmo(page, handle) {
  const [i, j] = patchOf(handle);
  const { u, v } = await grid(page);
  const { Su, Sv } = await jet(page, [u.centre(i), v.centre(j)]);
  const normal = unit(cross(Su, Sv));
  const axes = [unit(Su), unit(cross(normal, Su)), normal];
  const { project, scale, depth } = await projection(page);
  const radius = (46 / scale) * depth(handle.position);
  return {
    axes,
    at: (arms) =>
      project(arms.reduce((point, arm, k) => plus(point, times(radius * arm, axes[k])), handle.position)),
  };
}

/// Drags at any of `places` ([from, to] on the screen) until one does what is asked; a place that is covered by another
/// part of the gizmo is undone and the next one tried.
async function dragUntil(page, places, done) {
  const before = await documentOf(page);
  for (const [from, to] of places) {
    await drag(page, from, to);
    if (await done()) return;
    const after = await documentOf(page);
    if (JSON.stringify(after.objects) !== JSON.stringify(before.objects)) await call(page, 'undo');
    const { camera } = await documentOf(page);
    assert.deepEqual(camera, before.camera, 'what should have turned a patch has turned the camera');
  }
  assert.fail('no part of the gizmo could be taken');
}

for (const [name, axis] of [['u', 0], ['v', 1], ['normal', 2]]) {
  pageTest(`the gizmo's ring turns a patch about its ${name} axis`, { size: [1200, 760] }, async (page) => {
    const handle = await frontHandle(page);
    const patch = patchOf(handle);
    await page.mouse.click(...handle.screen);
    await until(page, (id) => window.knotwork.handles().some((h) => h.id === id && h.selected), handle.id);
    const { at } = await gizmo(page, handle);
    const onRing = (angle) => {
      const arms = [0, 0, 0];
      arms[(axis + 1) % 3] = Math.cos(angle);
      arms[(axis + 2) % 3] = Math.sin(angle);
      return at(arms);
    };
    const places = Array.from({ length: 12 }, (_, k) => 0.26 + (k * Math.PI) / 6).map((angle) => [
      onRing(angle), onRing(angle + 0.5),
    ]);
    await dragUntil(page, places, async () => {
      const edit = await editOf(page, patch);
      if (!edit) return false;
      const [x, y, z, w] = edit.rotation;
      const vector = [x, y, z];
      const turn = vector[axis];
      return Math.abs(turn) > 0.02 && Math.abs(Math.hypot(x, y, z) - Math.abs(turn)) < 1e-9 && Math.abs(w) < 1;
    });
    const edit = await editOf(page, patch);
    assert.deepEqual([edit.translation, edit.scale], [[0, 0, 0], [1, 1, 1]]);
    const after = await handleAt(page, handle.id);
    assert.ok(distance(after.position, handle.position) < 1e-12, 'a turn has moved the handle');
    await call(page, 'undo');
    assert.deepEqual(await edits(page), []);
  });
}

for (const [name, arms, changes] of [
  ['u', [1.26, 0, 0], [true, false, false]],
  ['v', [0, 1.26, 0], [false, true, false]],
  ['every', [1.3 / Math.SQRT2, 1.3 / Math.SQRT2, 0], [true, true, true]],
]) {
  pageTest(`the gizmo's knob scales a patch along ${name} axis`, { size: [1200, 760] }, async (page) => {
    const handle = await frontHandle(page);
    const patch = patchOf(handle);
    await page.mouse.click(...handle.screen);
    await until(page, (id) => window.knotwork.handles().some((h) => h.id === id && h.selected), handle.id);
    const { at } = await gizmo(page, handle);
    const knob = at(arms);
    const outwards = unit(minus(knob, handle.screen));
    await dragUntil(page, [[knob, plus(knob, times(24, outwards))]], async () => {
      const edit = await editOf(page, patch);
      return edit !== undefined && edit.scale.every((factor, k) => factor > 1.05 === changes[k]);
    });
    const edit = await editOf(page, patch);
    assert.deepEqual([edit.translation, edit.rotation], [[0, 0, 0], [0, 0, 0, 1]]);
    await call(page, 'undo');
    assert.deepEqual(await edits(page), []);
  });
}

pageTest('the gizmo\'s arrow moves a patch along its normal', { size: [1200, 760] }, async (page) => {
  // An arrow towards the eye is all but a point: one that is seen from the side is taken.
  const { project } = await projection(page);
  const seen = [];
  for (const handle of (await freeHandles(page)).slice(0, 6)) {
    const normal = await normalAt(page, patchOf(handle));
    const tip = project(plus(handle.position, times(0.1, normal)));
    seen.push({ handle, normal, length: distance(tip, handle.screen) });
  }
  const { handle, normal } = seen.reduce((best, one) => (one.length > best.length ? one : best));
  const patch = patchOf(handle);
  await page.mouse.click(...handle.screen);
  await until(page, (id) => window.knotwork.handles().some((h) => h.id === id && h.selected), handle.id);
  const { at } = await gizmo(page, handle);
  await dragUntil(page, [1.5, 1.4, 1.3, 1.2].map((arm) => [at([0, 0, arm]), at([0, 0, arm + 0.6])]), async () => {
    const edit = await editOf(page, patch);
    return edit !== undefined && edit.translation[2] > 0.02;
  });
  const way = minus((await handleAt(page, handle.id)).position, handle.position);
  assert.ok(length(cross(way, normal)) < 1e-9 * length(way));
});

pageTest('a finger drags a handle', { size: [412, 780], scale: 2, touch: true }, async (page) => {
  const start = await documentOf(page);
  const handle = await frontHandle(page);
  const before = await sampleCells(page);
  const target = plus(handle.screen, [-28, 34]);
  const { sweep } = await fingers(page);
  await sweep([handle.screen], [target]);
  await settled(page);
  const moved = await handleAt(page, handle.id);
  assert.ok(distance(moved.screen, target) < 1.5, 'the handle has left the finger');
  assertMovedOnSupportOnly(before, await sampleCells(page), await grid(page), patchOf(handle));
  assert.deepEqual((await documentOf(page)).camera, start.camera, 'the camera has moved with it');
  assert.equal(await page.evaluate(() => scrollY), 0, 'the page has scrolled');
  await call(page, 'undo');
  assert.deepEqual(await documentOf(page), start);
});

pageTest('a pen drags a handle', {}, async (page) => {
  const start = await documentOf(page);
  const handle = await frontHandle(page);
  const target = plus(handle.screen, [36, -22]);
  const { pen } = await fingers(page);
  await pen('mouseMoved', handle.screen, 0);
  await pen('mousePressed', handle.screen, 1);
  for (let k = 1; k <= 8; ++k) await pen('mouseMoved', plus(handle.screen, times(k / 8, [36, -22])), 1);
  await pen('mouseReleased', target, 0);
  await settled(page);
  assert.ok(distance((await handleAt(page, handle.id)).screen, target) < 1.5);
  await call(page, 'undo');
  assert.deepEqual(await documentOf(page), start);
});

pageTest('Escape takes a drag back while it lasts', {}, async (page) => {
  const start = await documentOf(page);
  const undo = await nextUndo(page);
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [60, 20]), { hold: true });
  assert.notDeepEqual((await documentOf(page)).objects, start.objects);
  await page.keyboard.press('Escape');
  await frameDrawn(page);
  assert.deepEqual(await documentOf(page), start);
  await page.mouse.move(...plus(handle.screen, [90, 40]), { steps: 3 });
  await page.mouse.up();
  await settled(page);
  assert.deepEqual(await documentOf(page), start, 'the drag has gone on after Escape');
  assert.equal(await nextUndo(page), undo, 'a drag that was taken back is in the history');
});

pageTest('a drag ends when the pointer is let go outside the stage', {}, async (page) => {
  const handle = await frontHandle(page);
  const stage = await stageRect(page);
  await drag(page, handle.screen, [stage.x - 60, handle.screen[1]]);
  const ended = await documentOf(page);
  assert.notDeepEqual(ended.objects[0].patches, []);
  await page.mouse.move(...handle.screen, { steps: 4 });
  await settled(page);
  assert.deepEqual(await documentOf(page), ended);
});

pageTest('patches edited by hand can all be put back at once', {}, async (page) => {
  const start = await documentOf(page);
  for (const way of [[30, 12], [-26, 18]]) {
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, way));
  }
  const edited = await documentOf(page);
  await page.mouse.move(3, 3);
  await settled(page);
  await clickWidget(page, 'reset');
  await settled(page);
  assert.deepEqual((await documentOf(page)).objects, start.objects);
  await call(page, 'undo');
  assert.deepEqual((await documentOf(page)).objects, edited.objects);
});

pageTest('while patches move, a held one stays under the pointer', {}, async (page) => {
  await call(page, 'play');
  const handle = await frontHandle(page);
  await page.mouse.move(...handle.screen);
  const now = (await handleAt(page, handle.id)).screen;
  await page.mouse.move(...now);
  await page.mouse.down();
  const target = plus(now, [40, -20]);
  await page.mouse.move(...target, { steps: 3 });
  await frameDrawn(page);
  // From here on the pointer rests, and the clock goes on.
  const { time } = (await documentOf(page)).animation;
  const offsets = [];
  for (let k = 1; k <= 4; ++k) {
    await until(page, (later) => window.knotwork.document().animation.time > later, time + 0.2 * k);
    offsets.push(distance((await handleAt(page, handle.id)).screen, target));
  }
  await page.mouse.up();
  await call(page, 'pause');
  assert.ok(Math.max(...offsets) < 6, `the held handle runs away by ${Math.max(...offsets)} px`);
  assert.equal((await handlesOf(page)).filter((h) => h.selected).length, 1);
});
