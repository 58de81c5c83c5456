// The clock: playing, pausing, seeking, and doing nothing at all.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, clickWidget, course, documentOf, frameDrawn, handlesOf, nextUndo, record, sampleCells, settled, statsOf,
  surfaceOf, until,
} from './stage.mjs';

const clockOf = async (page) => (await documentOf(page)).animation;

/// Frames drawn and bytes sent to the graphics card over a second of the page's own time.
const overASecond = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const before = window.knotwork.stats();
        const start = performance.now();
        const look = (now) => {
          if (now - start < 1000) return requestAnimationFrame(look);
          const after = window.knotwork.stats();
          done({ frames: after.frames - before.frames, bytes: after.uploadBytes - before.uploadBytes });
        };
        requestAnimationFrame(look);
      }),
  );

pageTest('an idle page draws no frame for a second', {}, async (page) => {
  await settled(page);
  assert.deepEqual(await overASecond(page), { frames: 0, bytes: 0 });
});

pageTest('a page is idle again after it has been used', {}, async (page) => {
  await page.mouse.move(...(await handlesOf(page)).find((handle) => handle.screen).screen);
  await clickWidget(page, 'topology.v: open');
  await clickWidget(page, 'play');
  await until(page, () => window.knotwork.document().animation.time > 0);
  await clickWidget(page, 'play');
  await settled(page);
  assert.deepEqual(await overASecond(page), { frames: 0, bytes: 0 });
});

pageTest('while playing the clock and the surface move on; paused they stand still', {}, async (page) => {
  const start = await documentOf(page);
  const first = await sampleCells(page, [0.5]);
  await clickWidget(page, 'play');
  await until(page, (time) => window.knotwork.document().animation.time > time + 0.2, start.animation.time);
  const playing = await statsOf(page);
  const second = await sampleCells(page, [0.5]);
  assert.notDeepEqual(second, first, 'the surface has not moved');
  await until(page, (frames) => window.knotwork.stats().frames > frames + 3, playing.frames);
  assert.notDeepEqual(await sampleCells(page, [0.5]), second, 'the surface has stopped');

  await clickWidget(page, 'play');
  await until(page, () => !window.knotwork.document().animation.playing);
  await settled(page);
  const paused = await documentOf(page);
  const still = await sampleCells(page, [0.5]);
  await frameDrawn(page);
  await frameDrawn(page);
  assert.deepEqual(await documentOf(page), paused);
  assert.deepEqual(await sampleCells(page, [0.5]), still);
  assert.deepEqual(paused.objects, start.objects, 'playing has changed the patches themselves');
});

pageTest('the clock runs at its speed, whatever the frame rate', {}, async (page) => {
  await call(page, 'set', 'animation.speed', 2);
  await call(page, 'seek', 0);
  await settled(page);
  const rows = await page.evaluate(
    () =>
      new Promise((done) => {
        const rows = [];
        window.knotwork.play();
        const look = (now) => {
          rows.push([now / 1000, window.knotwork.document().animation.time]);
          if (rows.length < 12) return requestAnimationFrame(look);
          window.knotwork.pause();
          done(rows);
        };
        requestAnimationFrame(look);
      }),
  );
  // A frame that took longer than a tenth of a second moves the clock on by a tenth only: no leaps.
  const steps = rows.slice(1).map(([now], k) => Math.min(now - rows[k][0], 0.1));
  const expected = 2 * steps.reduce((sum, step) => sum + step, 0);
  const clock = rows.at(-1)[1] - rows[0][1];
  const frame = 2 * Math.max(...steps);
  assert.ok(Math.abs(clock - expected) <= 1.5 * frame, `the clock went by ${clock} s, not by ${expected} s`);
});

pageTest('play(), pause() and seek() are the same clock', {}, async (page) => {
  await call(page, 'seek', 1.25);
  await settled(page);
  const { time, playing } = await clockOf(page);
  assert.deepEqual([time, playing], [1.25, false]);
  const there = await sampleCells(page, [0.5]);
  await call(page, 'play');
  await until(page, () => window.knotwork.document().animation.time > 1.3);
  await call(page, 'pause');
  assert.equal((await clockOf(page)).playing, false);
  assert.notDeepEqual(await sampleCells(page, [0.5]), there);
  await call(page, 'seek', 1.25);
  assert.deepEqual(await sampleCells(page, [0.5]), there, 'the same time gives another surface');
  await call(page, 'seek', 0);
  await settled(page);
});

/// Nothing happens for five seconds, longer than a notice stands.
async function pause(page) {
  await page.evaluate(() => (window.since = performance.now()));
  await until(page, () => performance.now() - window.since > 5000);
}

pageTest('what begins after a long pause begins then: camera and notice', {}, async (page) => {
  await call(page, 'set', 'model', 'plane');
  await page.locator('canvas').focus();
  await settled(page);
  const { camera } = await documentOf(page);
  await call(page, 'load', { ...(await documentOf(page)), camera: { ...camera, distance: 2 * camera.distance } });
  await settled(page);
  await pause(page);
  const way = course(await record(page, () => page.keyboard.press('Home')), (row) => row.camera);
  assert.ok(way.stages > 3 || way.ms > 200, `the camera leaps: ${way.stages} stages in ${way.ms} ms`);

  await settled(page);
  await pause(page);
  await assert.rejects(call(page, 'set', 'topology.u', 'closed'));
  const { frames } = await statsOf(page);
  await page.evaluate(() => (window.since = performance.now()));
  await until(page, () => performance.now() - window.since > 1500);
  assert.ok((await statsOf(page)).frames > frames + 8, 'the reason of the refusal is gone before it could be read');
});

pageTest('seek takes any finite time, and no other', {}, async (page) => {
  const period = 2 * Math.PI;
  for (const [asked, time] of [[-1, period - 1], [1e9, 1e9 % period], [-1e-20, 0], [period, 0], [3 * period + 1, 1]]) {
    await call(page, 'seek', asked);
    const clock = (await clockOf(page)).time;
    assert.ok(clock >= 0 && clock < period, `seek(${asked}) sets the clock to ${clock}`);
    assert.ok(Math.abs(clock - time) < 1e-6, `seek(${asked}) sets the clock to ${clock}, not to ${time}`);
  }
  const before = await clockOf(page);
  for (const wrong of [Infinity, -Infinity, NaN, 'soon']) await assert.rejects(call(page, 'seek', wrong));
  assert.deepEqual(await clockOf(page), before);
});

pageTest('neither playing nor seeking is a step of undo', {}, async (page) => {
  const undo = await nextUndo(page);
  await call(page, 'seek', 2);
  await call(page, 'play');
  await until(page, () => window.knotwork.document().animation.time > 2.05);
  await call(page, 'pause');
  await settled(page);
  assert.equal(await nextUndo(page), undo);
});

pageTest('the clock is scrubbed in the panel', {}, async (page) => {
  const label = 'animation.time';
  const slider = (await call(page, 'widgets')).find((item) => item.label === label);
  assert.ok(slider, `the panel shows no ${label}`);
  const [x, y, w, h] = slider.rect;
  await page.mouse.move(x + w * 0.3, y + h / 2);
  await page.mouse.down();
  const times = [];
  for (const share of [0.4, 0.6, 0.8]) {
    await page.mouse.move(x + w * share, y + h / 2, { steps: 3 });
    await frameDrawn(page);
    times.push((await clockOf(page)).time);
  }
  await page.mouse.up();
  await settled(page);
  assert.ok(times[0] > 0 && times[0] < times[1] && times[1] < times[2], `the clock has gone ${times}`);
});

pageTest('the switch beside the prose starts and stops the clock', {}, async (page) => {
  const row = (await call(page, 'parameters')).find(({ id }) => id === 'animation.playing');
  const toggle = page.locator('#blending-surface').getByRole('switch', { name: row.label });
  await toggle.click();
  await until(page, () => window.knotwork.document().animation.time > 0.05);
  await page.waitForFunction(() => document.querySelector('[data-parameter="animation.playing"] [aria-checked=true]'));
  await page.locator('#blending-surface').getByRole('button', { name: 'stop', exact: true }).click();
  await until(page, () => !window.knotwork.document().animation.playing);
  await settled(page);
  assert.equal(await toggle.getAttribute('aria-checked'), 'false');
});

pageTest('an animated frame uploads the maps and nothing else', {}, async (page) => {
  await call(page, 'set', 'samples.u', 256);
  await call(page, 'set', 'samples.v', 256);
  await call(page, 'play');
  await until(page, () => window.knotwork.document().animation.time > 0.1);
  const { u, v } = (await surfaceOf(page)).locals;
  const { frames, bytes } = await overASecond(page);
  await call(page, 'pause');
  assert.ok(frames > 2);
  // 256 x 256 samples of three floats would be 786 KB; 24 maps are 1.2 KB. The rest is handles and the panel.
  assert.ok(bytes / frames < 60 * u * v + 120_000, `${bytes / frames} bytes a frame`);
});
