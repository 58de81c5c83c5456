// What a frame of the stage costs the page's main thread, in the built site: node tests/benchmark/stage.mjs
// Times are means over many frames, since a page's clock ticks in tenths of a millisecond. Drawing itself happens in
// another process, in software here: it is not counted.
import { closeShared, openPage } from '../browser/site.mjs';
import { call, drag, handlesOf, plus, settled } from '../browser/stage.mjs';

const blending = (page, change) =>
  page.evaluate(async (change) => {
    window.knotwork.open('blending-surface');
    const document = window.knotwork.document();
    Object.assign(document.objects[0], { patches: [], ...change });
    document.display.surface = true;
    window.knotwork.load(document);
  }, change);

/// Means over the next `count` frames that are drawn, and what had been uploaded by a frame.
const overFrames = (page, count) =>
  page.evaluate(
    (count) =>
      new Promise((resolve) => {
        const rows = [];
        let last = window.knotwork.stats();
        const look = () => {
          const now = window.knotwork.stats();
          if (now.frames > last.frames) rows.push({ ...now, uploaded: now.uploadBytes - last.uploadBytes });
          last = now;
          if (rows.length < count) return requestAnimationFrame(look);
          const mean = (key) => rows.reduce((sum, row) => sum + row[key], 0) / rows.length;
          resolve({
            evaluate: mean('evaluateMs'), frame: mean('frameMs'), kilobytes: mean('uploaded') / 1000,
            draws: mean('drawCalls'), changes: mean('stateChanges'), vertices: mean('vertices'),
          });
        };
        requestAnimationFrame(look);
      }),
    count,
  );

function row(name, { evaluate, frame, kilobytes, draws, changes, vertices }, met = '') {
  const cells = [
    name.padEnd(50), `${Math.round(vertices)}`.padStart(9), evaluate.toFixed(3).padStart(9), frame.toFixed(2).padStart(8),
    kilobytes.toFixed(0).padStart(8), draws.toFixed(0).padStart(6), changes.toFixed(0).padStart(8), `  ${met}`,
  ];
  console.log(cells.join(''));
}

const { page } = await openPage({ full: true, size: [900, 600], scale: 0.5 });
console.log(`${''.padEnd(50)} vertices evaluate frame ms kB/frame draws changes  evaluate and upload <= 0.3 ms?`);
const locals = (count, kind = 'sub-surface') => ({ u: count, v: count, kind, degreeU: 3, degreeV: 3 });
const torus = { topology: { u: 'closed', v: 'closed' }, locals: locals(20) };
const kinds = {
  'blending torus 20 x 20, animated': torus,
  'the same of Bezier-Hermite patches': { ...torus, locals: locals(20, 'bezier-hermite') },
  'Klein bottle 20 x 20, twisted, animated': { ...torus, model: { kind: 'figure-eight-klein-bottle', radius: 2, size: 1 } },
};
for (const [name, change] of Object.entries(kinds)) {
  for (const side of (process.env.SIDES ?? "100,316,1000").split(",").map(Number)) {
    await blending(page, { ...change, samples: { u: side, v: side } });
    await settled(page);
    await call(page, 'play');
    await overFrames(page, 3);
    const cost = await overFrames(page, side > 500 ? 6 : 60);
    await call(page, 'pause');
    row(name, cost, cost.evaluate <= 0.3 ? 'yes' : 'NO');
  }
}

/// Of a drag of one handle by real mouse moves: events and frames together, a frame.
async function dragging(name, handle) {
  await page.evaluate(() => {
    window.eventMs = 0;
    let start = 0;
    addEventListener('pointermove', () => (start = performance.now()), { capture: true });
    addEventListener('pointermove', () => (window.eventMs += performance.now() - start));
  });
  await drag(page, handle.screen, plus(handle.screen, [10, 8]), { hold: true });
  await page.evaluate(() => (window.eventMs = 0));
  const frames = 30;
  const watched = overFrames(page, frames);
  let moves = 0;
  const start = Date.now();
  for (let done = false; !done && Date.now() - start < 60000; ++moves) {
    await page.mouse.move(...plus(handle.screen, [20 * Math.cos(moves / 9), 20 * Math.sin(moves / 9)]));
    done = await Promise.race([watched.then(() => true), new Promise((later) => setTimeout(later, 8, false))]);
  }
  const cost = await watched;
  const events = (await page.evaluate(() => window.eventMs)) / frames;
  await page.mouse.up();
  const whole = cost.frame + events;
  row(name, cost, `with events ${whole.toFixed(2)} ms, <= 4 ms: ${whole <= 4 ? 'yes' : 'NO'}`);
}

await blending(page, { ...torus, locals: locals(6), samples: { u: 500, v: 500 } });
await settled(page);
const front = (handles) =>
  handles.filter(({ id, screen }) => screen && id !== 'parameter').sort((a, b) => a.screen[2] - b.screen[2])[0];
await dragging('dragging a local patch', front(await handlesOf(page)));
await page.evaluate(() => {
  window.knotwork.open('tensor-surface');
  const document = window.knotwork.document();
  document.objects[0].samples = { u: 500, v: 500 };
  window.knotwork.load(document);
});
await settled(page);
await dragging('dragging a control point of a net', front(await handlesOf(page)));

await settled(page);
const before = await call(page, 'stats');
await page.evaluate(() => new Promise((later) => setTimeout(later, 2000)));
console.log(`idle for two seconds: ${(await call(page, 'stats')).frames - before.frames} frames`);
await closeShared();
