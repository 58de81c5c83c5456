// The rows of the benchmark page, measured in the site that the page has in its frame. By hand the rows of dragging wait
// for a hand; run.mjs has one.
const frame = document.getElementById('site').contentWindow;
const now = document.getElementById('now');
const body = document.querySelector('tbody');
const sides = (new URLSearchParams(location.search).get('sides') ?? '100,316,1000').split(',').map(Number);

/// For run.mjs: the rows so far, and where a handle waits to be dragged, in this page's pixels.
window.results = { rows: [], drag: null, done: false };

const nextFrame = () => new Promise((resolve) => frame.requestAnimationFrame(resolve));

async function loaded() {
  while (!frame.knotwork) await nextFrame();
  await frame.knotwork.ready;
  return frame.knotwork;
}

/// Until nothing is drawn any more.
async function settled(knotwork) {
  for (let still = 0, last = -1; still < 20; ) {
    const { frames } = knotwork.stats();
    still = frames === last ? still + 1 : 0;
    last = frames;
    await nextFrame();
  }
}

/// Means over the next `count` frames that are drawn; `events` is what else has taken time meanwhile.
async function overFrames(knotwork, count, events = () => 0) {
  const rows = [];
  let last = knotwork.stats();
  const before = events();
  while (rows.length < count) {
    await nextFrame();
    const stats = knotwork.stats();
    if (stats.frames > last.frames) rows.push({ ...stats, uploaded: stats.uploadBytes - last.uploadBytes });
    last = stats;
  }
  const mean = (key) => rows.reduce((sum, row) => sum + row[key], 0) / rows.length;
  return {
    vertices: Math.round(mean('vertices')), evaluate: mean('evaluateMs'),
    frame: mean('frameMs') + (events() - before) / count, kilobytes: mean('uploaded') / 1000,
    draws: mean('drawCalls'), changes: mean('stateChanges'), allocations: mean('allocations'),
  };
}

function add(work, cost, target, met) {
  const { vertices, evaluate, frame: whole, kilobytes, draws, changes, allocations } = cost;
  const cells = [
    work, vertices, evaluate.toFixed(3), whole.toFixed(2), kilobytes.toFixed(1), draws.toFixed(0), changes.toFixed(0),
    allocations.toFixed(0), target, met === null ? '' : met ? 'yes' : 'NO',
  ];
  const row = body.insertRow();
  for (const cell of cells) row.insertCell().textContent = String(cell);
  window.results.rows.push(cells);
}

async function show(knotwork, chapter, change, adaptive = false) {
  knotwork.open(chapter);
  const start = knotwork.document();
  Object.assign(start.objects[0], change);
  start.display.adaptive = adaptive;
  knotwork.load(start);
  await settled(knotwork);
}

async function animated(knotwork, work, frames) {
  now.textContent = `${work} …`;
  knotwork.play();
  await overFrames(knotwork, 3);
  const cost = await overFrames(knotwork, frames);
  knotwork.pause();
  return cost;
}

async function dragged(knotwork, work) {
  let spent = 0;
  let start = 0;
  let moves = 0;
  const begin = () => (start = performance.now());
  const end = () => {
    spent += performance.now() - start;
    ++moves;
  };
  frame.addEventListener('pointermove', begin, { capture: true });
  frame.addEventListener('pointermove', end);
  const front = knotwork.handles().filter(({ id, screen }) => screen && id !== 'parameter')
    .sort((a, b) => a.screen[2] - b.screen[2])[0];
  const place = document.getElementById('site').getBoundingClientRect();
  window.results.drag = [front.screen[0] + place.x + 1, front.screen[1] + place.y + 1];
  now.textContent = `${work}: take a handle and move it about.`;
  while (moves < 5) await nextFrame();
  const cost = await overFrames(knotwork, 40, () => spent);
  window.results.drag = null;
  frame.removeEventListener('pointermove', begin, { capture: true });
  frame.removeEventListener('pointermove', end);
  add(work, cost, 'frame ≤ 4 ms', cost.frame <= 4);
}

const locals = (count, kind = 'sub-surface') => ({ u: count, v: count, kind, degreeU: 3, degreeV: 3 });
const closed = { topology: { u: 'closed', v: 'closed' }, patches: [] };
const klein = { kind: 'figure-eight-klein-bottle', radius: 2, size: 1 };
const moving = {
  'blending torus, 20 × 20 patches': { ...closed, locals: locals(20) },
  'the same of Bézier–Hermite patches': { ...closed, locals: locals(20, 'bezier-hermite') },
  'Klein bottle, 20 × 20 patches, twisted': { ...closed, locals: locals(20), model: klein },
};

const knotwork = await loaded();
for (const [work, change] of Object.entries(moving)) {
  for (const side of sides) {
    await show(knotwork, 'blending-surface', { ...change, samples: { u: side, v: side } });
    const cost = await animated(knotwork, work, side > 500 ? 12 : side > 200 ? 30 : 60);
    add(work, cost, 'evaluate and upload ≤ 0.3 ms', cost.evaluate <= 0.3);
  }
  await show(knotwork, 'blending-surface', change, true);
  add(`${work}, fitted to the screen`, await animated(knotwork, work, 30), '', null);
}
await show(knotwork, 'blending-surface', { ...closed, locals: locals(6), samples: { u: 500, v: 500 } });
await dragged(knotwork, 'dragging a local patch');
await show(knotwork, 'tensor-surface', { samples: { u: 500, v: 500 } });
await dragged(knotwork, 'dragging a control point of a net');

now.textContent = 'Idling for two seconds …';
await settled(knotwork);
const before = knotwork.stats().frames;
await new Promise((later) => setTimeout(later, 2000));
const idle = knotwork.stats().frames - before;
now.textContent = `Done. Idle for two seconds: ${idle} frames.`;
window.results.idle = idle;
window.results.done = true;
