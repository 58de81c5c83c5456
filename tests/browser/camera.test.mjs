// The camera, turned, shifted and brought closer by mouse, wheel and fingers.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, course, difference, distance, documentOf, drag, fingers, frameDrawn, frontHandle, handlesOf, minus, nextUndo, picture,
  plus, projection, record, settled, stageRect, until,
} from './stage.mjs';

const cameraOf = async (page) => (await documentOf(page)).camera;

/// A place on the stage with nothing on it: no handle, no item of the panel, not the surface.
async function emptySpot(page) {
  const stage = await stageRect(page);
  const handles = (await handlesOf(page)).filter((handle) => handle.screen);
  const widgets = await call(page, 'widgets');
  let best = { free: -1 };
  for (let x = 0.06; x < 0.95; x += 0.06) {
    for (let y = 0.06; y < 0.85; y += 0.06) {
      const spot = [stage.x + x * stage.width, stage.y + y * stage.height];
      const covered = widgets.some(
        ({ rect: [a, b, w, h] }) =>
          spot[0] > a - 40 && spot[0] < a + w + 40 && spot[1] > b - 40 && spot[1] < b + h + 40,
      );
      if (covered) continue;
      const free = Math.min(...handles.map((handle) => distance(handle.screen, spot)));
      if (free > best.free) best = { spot, free };
    }
  }
  assert.ok(best.free > 30, 'the stage has no free spot');
  return best.spot;
}

pageTest('dragging beside the surface turns the camera, and undo has nothing of it', {}, async (page) => {
  const start = await documentOf(page);
  const undo = await nextUndo(page);
  const spot = await emptySpot(page);
  await drag(page, spot, plus(spot, [-50, 24]));
  await settled(page);
  const { camera, ...rest } = await documentOf(page);
  assert.ok(Math.abs(camera.azimuth - start.camera.azimuth) > 0.1, 'the azimuth has not changed');
  assert.ok(Math.abs(camera.elevation - start.camera.elevation) > 0.03, 'the elevation has not changed');
  assert.equal(camera.distance, start.camera.distance);
  assert.deepEqual(camera.target, start.camera.target);
  assert.deepEqual({ ...rest, camera: start.camera }, start, 'something beside the camera has changed');
  await projection(page);
  assert.equal(await nextUndo(page), undo);
});

pageTest('the camera stops short of the poles', {}, async (page) => {
  const spot = await emptySpot(page);
  for (const way of [900, -1800]) {
    await drag(page, spot, plus(spot, [0, way]), { steps: 20 });
    const { elevation } = await cameraOf(page);
    assert.ok(Math.abs(elevation) > 1.4 && Math.abs(elevation) < Math.PI / 2, `the elevation is ${elevation}`);
    await projection(page);
  }
});

pageTest('the right button shifts what is seen with the pointer', {}, async (page) => {
  const start = await cameraOf(page);
  const spot = await emptySpot(page);
  await drag(page, spot, plus(spot, [20, -20]), { button: 'right', hold: true });
  // The first pixels may be a click's; from then on the picture is fixed to the pointer.
  const before = (await projection(page)).project(start.target);
  await page.mouse.move(...plus(spot, [60, -50]), { steps: 3 });
  await page.mouse.up({ button: 'right' });
  await settled(page);
  const camera = await cameraOf(page);
  const { target, ...rest } = camera;
  assert.deepEqual({ ...rest, target: start.target }, start, 'the camera has turned');
  assert.notDeepEqual(target, start.target);
  const after = (await projection(page)).project(start.target);
  assert.ok(distance(after, plus(before, [40, -30])) < 1, 'the target has not followed the pointer');
});

pageTest('a wheel with Ctrl zooms, a plain wheel scrolls the page and not the camera', {}, async (page) => {
  const start = await documentOf(page);
  const stage = await stageRect(page);
  const spot = [stage.x + stage.width * 0.4, stage.y + stage.height * 0.6];
  await page.mouse.move(...spot);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  await until(page, (distance) => window.knotwork.document().camera.distance < distance, start.camera.distance);
  assert.equal(await page.evaluate(() => scrollY), 0);
  assert.equal(await page.evaluate(() => visualViewport.scale), 1, 'the browser has zoomed the page');
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, 240);
  await page.keyboard.up('Control');
  await until(page, (distance) => window.knotwork.document().camera.distance > distance, start.camera.distance);
  await settled(page);

  const before = await documentOf(page);
  await page.mouse.wheel(0, 200);
  await page.waitForFunction(() => scrollY > 100);
  await settled(page);
  assert.deepEqual(await documentOf(page), before);
});

pageTest('a double click brings the whole surface into view', {}, async (page) => {
  const start = await documentOf(page);
  const lost = structuredClone(start);
  lost.camera.distance = 30;
  lost.camera.target = [4, -3, 2];
  await call(page, 'load', lost);
  await settled(page);
  const spot = await emptySpot(page);
  await page.mouse.dblclick(...spot);
  await settled(page);
  const camera = await cameraOf(page);
  assert.ok(camera.distance < 12, `the camera is ${camera.distance} away`);
  assert.deepEqual([camera.azimuth, camera.elevation], [start.camera.azimuth, start.camera.elevation]);
  const stage = await stageRect(page);
  for (const { id, screen: [x, y] } of await handlesOf(page)) {
    const inside = x > stage.x && x < stage.x + stage.width && y > stage.y && y < stage.y + stage.height;
    assert.ok(inside, `${id} is outside of the stage`);
  }
});

pageTest('under reduced motion framing is done at once', { reducedMotion: true }, async (page) => {
  const lost = await documentOf(page);
  lost.camera.distance = 30;
  await call(page, 'load', lost);
  await settled(page);
  await page.locator('canvas').focus();
  const { stages } = course(await record(page, () => page.keyboard.press('Home')), (row) => row.camera);
  assert.equal(stages, 1, 'the camera has gone there step by step');
});

const phone = { size: [412, 780], scale: 2, touch: true };

pageTest('one finger turns the camera', phone, async (page) => {
  const start = await documentOf(page);
  const spot = await emptySpot(page);
  const { sweep } = await fingers(page);
  const inwards = spot[0] > 206 ? -1 : 1;
  await sweep([spot], [plus(spot, [60 * inwards, 16])]);
  await settled(page);
  const { camera, ...rest } = await documentOf(page);
  assert.ok(Math.abs(camera.azimuth - start.camera.azimuth) > 0.1);
  assert.equal(camera.distance, start.camera.distance);
  assert.deepEqual({ ...rest, camera: start.camera }, start);
  assert.equal(await page.evaluate(() => scrollY), 0, 'the page has scrolled');
});

pageTest('two fingers pinch and shift', phone, async (page) => {
  const start = await cameraOf(page);
  const stage = await stageRect(page);
  const centre = [stage.x + stage.width / 2, stage.y + stage.height * 0.45];
  const { sweep } = await fingers(page);
  const spread = (half, at = centre) => [[at[0] - half, at[1] - half / 2], [at[0] + half, at[1] + half / 2]];
  await sweep(spread(40), spread(80));
  await settled(page);
  const closer = await cameraOf(page);
  const nearer = start.distance / closer.distance;
  assert.ok(Math.abs(nearer / 2 - 1) < 0.15, `nearer by ${nearer}, not by 2`);
  assert.equal(await page.evaluate(() => visualViewport.scale), 1, 'the browser has zoomed the page');
  assert.deepEqual([closer.azimuth, closer.elevation], [start.azimuth, start.elevation]);

  const before = (await projection(page)).project(closer.target);
  await sweep(spread(50), spread(50, plus(centre, [36, -24])));
  await settled(page);
  const shifted = await cameraOf(page);
  assert.ok(Math.abs(shifted.distance / closer.distance - 1) < 0.01);
  const after = (await projection(page)).project(closer.target);
  // Each finger may wander a little before its way counts.
  const way = minus(after, before);
  assert.ok(distance(way, [36, -24]) < 15, `the fingers went by 36, -24, the picture by ${way}`);
  assert.equal(await page.evaluate(() => scrollY), 0, 'the page has scrolled');
});

pageTest('a finger on the prose scrolls the page and leaves the stage alone', phone, async (page) => {
  await settled(page);
  const before = await documentOf(page);
  const seen = await picture(page);
  const { sweep } = await fingers(page);
  await sweep([[150, 700]], [[150, 500]], 20);
  // Until the page has run out, too.
  await page.waitForFunction(
    () => {
      const [last, now] = [window.lastScroll, scrollY];
      window.lastScroll = now;
      return now > 60 && now === last;
    },
    null,
    { polling: 150 },
  );
  await settled(page);
  assert.deepEqual(await documentOf(page), before);
  assert.ok(difference(seen, await picture(page)) < 0.002, 'the stage has moved on the screen');
});

pageTest('the pointer shows what it would do', {}, async (page) => {
  const cursor = () => page.evaluate(() => getComputedStyle(document.querySelector('canvas')).cursor);
  const spot = await emptySpot(page);
  await page.mouse.move(...spot);
  await frameDrawn(page);
  assert.equal(await cursor(), 'default');
  const handle = await frontHandle(page);
  await page.mouse.move(...handle.screen);
  await frameDrawn(page);
  assert.equal(await cursor(), 'grab');
  for (const from of [handle.screen, spot]) {
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...plus(from, [6, 6]));
    await frameDrawn(page);
    assert.equal(await cursor(), 'grabbing');
    await page.mouse.up();
  }
});
