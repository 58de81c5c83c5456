// What a test does with the stage: ask the script interface, find handles and widgets, move the pointer, see pixels.
import assert from 'node:assert/strict';
import { PNG } from 'pngjs';

/// window.knotwork.<name>(...values); an error is thrown here as {message, path}.
export async function call(page, name, ...values) {
  const answer = await page.evaluate(
    ([name, values]) => {
      try {
        return { value: window.knotwork[name](...values) };
      } catch (error) {
        return { error: { isError: error instanceof Error, message: error.message, path: error.path } };
      }
    },
    [name, values],
  );
  if (answer.error) throw Object.assign(new Error(answer.error.message), answer.error);
  return answer.value;
}

export const documentOf = (page) => call(page, 'document');
export const handlesOf = (page) => call(page, 'handles');
export const statsOf = (page) => call(page, 'stats');
export const surfaceOf = async (page) => (await documentOf(page)).objects[0];

export async function parameter(page, id) {
  const row = (await call(page, 'parameters')).find((row) => row.id === id);
  assert.ok(row, `there is no parameter ${id}`);
  return row;
}

/// Brings a place of the prose to where it is read.
export async function scrollTo(page, selector) {
  await page.evaluate((place) => {
    const stage = document.getElementById('stage').getBoundingClientRect();
    const top = stage.width >= innerWidth ? stage.bottom : 0;
    const { top: at } = document.querySelector(place).getBoundingClientRect();
    window.scrollTo({ top: at + scrollY - top - 0.3 * (innerHeight - top), behavior: 'instant' });
  }, selector);
}

/// The figure on the stage; null while it shows something else.
export async function shownFigure(page) {
  return page.evaluate(() => document.querySelector('[data-shown]')?.dataset.figure ?? null);
}

/// Resolves when the stage has come to rest: the page's own transitions have ended, some animation frames have gone by,
/// and none of them was drawn.
export async function settled(page) {
  await page.evaluate(
    () =>
      new Promise((resolve, reject) => {
        const end = performance.now() + 40000;
        let frames = -1;
        let quiet = 0;
        // Asked in every frame: a transition out of sight may be told finished only when there is a frame again.
        const moves = ({ playState, effect }) =>
          playState === 'running' && Number.isFinite(effect.getComputedTiming().endTime);
        const look = () => {
          const now = window.knotwork.stats().frames;
          quiet = now === frames && !document.getAnimations().some(moves) ? quiet + 1 : 0;
          frames = now;
          if (quiet >= 6) resolve();
          else if (performance.now() > end) reject(new Error('the stage does not come to rest'));
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
}

/// Waits until the page has handled what was sent to it and drawn the answer.
export async function frameDrawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

/// What every animation frame shows from before `act` until, after a first change, nothing has changed for a while:
/// [{at (ms), camera, clock, handles (positions)}].
export async function record(page, act) {
  await page.evaluate(() => {
    window.recording = new Promise((resolve, reject) => {
      const rows = [];
      const end = performance.now() + 20000;
      let last = '';
      let changes = 0;
      let quiet = 0;
      const look = () => {
        const { camera, animation } = window.knotwork.document();
        const handles = window.knotwork.handles().map((handle) => handle.position);
        const now = JSON.stringify([camera, handles]);
        quiet = now === last ? quiet + 1 : 0;
        changes += now === last ? 0 : 1;
        last = now;
        rows.push({ at: performance.now(), camera, clock: animation.time, handles });
        if (changes > 1 && quiet > 12) resolve(rows);
        else if (performance.now() > end) reject(new Error('nothing has changed'));
        else requestAnimationFrame(look);
      };
      look();
    });
    window.recording.catch(() => undefined);  // if acting fails, that is what the test should tell
  });
  await act();
  return page.evaluate(() => window.recording);
}

/// How many different values a recording has of something, for how long it was changing, and the longest frame then. A
/// row may tell of the frame before it, so that the frame in which the change began, before the first row that differs,
/// counts among them.
export function course(recording, read) {
  const values = recording.map((row) => JSON.stringify(read(row)));
  const changes = values.map((value, k) => k > 0 && value !== values[k - 1]);
  const first = changes.indexOf(true);
  const last = changes.lastIndexOf(true);
  if (first < 0) return { stages: 0, ms: 0, slowest: 0 };
  const times = recording.map((row) => row.at);
  const frames = times.map((at, k) => at - times[Math.max(0, k - 1)]).slice(first - 1, last + 1);
  return { stages: changes.filter(Boolean).length, ms: times[last] - times[first - 1], slowest: Math.max(...frames) };
}

export async function until(page, condition, argument) {
  await page.waitForFunction(condition, argument, { timeout: 10000 });
}

/// The stage's rectangle in the viewport.
export async function stageRect(page) {
  const box = await page.locator('canvas').boundingBox();
  assert.ok(box, 'there is no canvas');
  return box;
}

export async function handleAt(page, id) {
  const handle = (await handlesOf(page)).find((handle) => handle.id === id);
  assert.ok(handle, `there is no handle ${id}`);
  return handle;
}

/// The handles that lie free on the stage, away from the panel, the edge and other handles; nearest to the eye first.
export async function freeHandles(page) {
  const [handles, camera, stage, widgets] = [
    await handlesOf(page), (await documentOf(page)).camera, await stageRect(page), await call(page, 'widgets'),
  ];
  const eye = eyeOf(camera);
  const inside = ([x, y]) =>
    x > stage.x + 30 && y > stage.y + 30 && x < stage.x + stage.width - 30 && y < stage.y + stage.height - 90;
  const free = (handle) =>
    widgets.every(({ rect: [x, y, w, h] }) => {
      const [a, b] = handle.screen;
      return a < x - 25 || a > x + w + 25 || b < y - 25 || b > y + h + 25;
    }) &&
    handles.every(
      (other) => other === handle || !other.screen || distance(other.screen, handle.screen) > 18,
    );
  const candidates = handles.filter((handle) => handle.screen && inside(handle.screen) && free(handle));
  assert.ok(candidates.length > 0, 'no handle lies free on the stage');
  return candidates.sort((a, b) => distance(a.position, eye) - distance(b.position, eye));
}

export const frontHandle = async (page) => (await freeHandles(page))[0];

/// "patch-2-1" -> [2, 1].
export function patchOf(handle) {
  const match = /^patch-(\d+)-(\d+)$/.exec(handle.id);
  assert.ok(match, `a handle is called ${handle.id}`);
  return [Number(match[1]), Number(match[2])];
}

export async function widget(page, label) {
  const found = (await call(page, 'widgets')).find((item) => item.label === label);
  assert.ok(found, `the panel shows no ${label}`);
  const [x, y, width, height] = found.rect;
  return { x, y, width, height, centre: [x + width / 2, y + height / 2] };
}

export async function hasWidget(page, label) {
  return (await call(page, 'widgets')).some((item) => item.label === label);
}

/// What the button for undo offers; the same text before and after means that nothing was added to the history.
export async function nextUndo(page) {
  await frameDrawn(page);
  const button = page.getByRole('button', { name: /^Undo/ });
  return `${await button.textContent()} ${await button.getAttribute('aria-disabled')}`.replaceAll(/\s+/g, ' ').trim();
}

/// A real click on an item of the panel.
export async function clickWidget(page, label) {
  const { centre } = await widget(page, label);
  await page.mouse.click(...centre);
}

/// Opens the rows of the panel that are folded away at first.
export async function showMore(page, label) {
  if (await hasWidget(page, label)) return;
  await clickWidget(page, 'more');
  await until(page, (label) => window.knotwork.widgets().some((item) => item.label === label), label);
  await settled(page);
}

/// Mouse down at `from`, a few moves, and up at `to` unless `hold`.
export async function drag(page, from, to, { steps = 5, hold = false, button = 'left' } = {}) {
  await page.mouse.move(...from);
  await page.mouse.down({ button });
  await page.mouse.move(...to, { steps });
  if (!hold) await page.mouse.up({ button });
  await frameDrawn(page);
}

/// Fingers on the screen, through the browser's own input queue.
export async function fingers(page) {
  const session = await page.context().newCDPSession(page);
  const send = (type, points) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id, radiusX: 4, radiusY: 4, force: 0.6 })),
    });
  return {
    /// Moves each finger from its start to its end along a straight line.
    async sweep(starts, ends, steps = 6) {
      await send('touchStart', starts);
      for (let k = 1; k <= steps; ++k) {
        const share = k / steps;
        await send(
          'touchMove',
          starts.map(([x, y], i) => [x + share * (ends[i][0] - x), y + share * (ends[i][1] - y)]),
        );
      }
      await send('touchEnd', []);
      await frameDrawn(page);
    },
    async pen(type, [x, y], buttons) {
      await session.send('Input.dispatchMouseEvent', {
        type, x, y, buttons, button: 'left', pointerType: 'pen', force: 0.5, clickCount: 1,
      });
    },
  };
}

// Geometry.

export const minus = (a, b) => a.map((x, k) => x - b[k]);
export const plus = (a, b) => a.map((x, k) => x + b[k]);
export const times = (s, a) => a.map((x) => s * x);
export const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
export const length = (a) => Math.hypot(...a);
export const distance = (a, b) => length(minus(a, b));
export const unit = (a) => times(1 / length(a), a);
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

export function eyeOf({ target, distance, azimuth, elevation }) {
  const level = Math.cos(elevation);
  return plus(target, times(distance, [level * Math.cos(azimuth), level * Math.sin(azimuth), Math.sin(elevation)]));
}

/// Where a point of model space lies on the screen, from the camera in the document; where the picture's centre is and
/// how large it is drawn follow from the handles. A camera that does not show the handles where it should fails here.
export async function projection(page) {
  const camera = (await documentOf(page)).camera;
  const handles = (await handlesOf(page)).filter((handle) => handle.screen);
  const eye = eyeOf(camera);
  const forward = unit(minus(camera.target, eye));
  const right = unit(cross(forward, [0, 0, 1]));
  const up = cross(right, forward);
  const seen = (point) => {
    const p = minus(point, eye);
    const depth = dot(p, forward);
    return { x: dot(p, right) / depth, y: -dot(p, up) / depth, depth };
  };
  // Least squares for s = centre + scale * seen, over x and y together.
  const pairs = handles.map((handle) => ({ ...seen(handle.position), screen: handle.screen }));
  const mean = (f) => pairs.reduce((sum, pair) => sum + f(pair), 0) / pairs.length;
  const [mx, my, sx, sy] = [mean((p) => p.x), mean((p) => p.y), mean((p) => p.screen[0]), mean((p) => p.screen[1])];
  const scale =
    mean((p) => (p.x - mx) * (p.screen[0] - sx) + (p.y - my) * (p.screen[1] - sy)) /
    mean((p) => (p.x - mx) ** 2 + (p.y - my) ** 2);
  const project = (point) => {
    const { x, y } = seen(point);
    return [sx + scale * (x - mx), sy + scale * (y - my)];
  };
  for (const handle of handles) {
    assert.ok(distance(project(handle.position), handle.screen) < 0.5, `the camera shows ${handle.id} elsewhere`);
  }
  return { project, scale, eye, depth: (point) => seen(point).depth };
}

/// Knots and cells of the first object, as THEORY 2.8 counts them: local k is centred at start + k h.
export async function grid(page) {
  const object = await surfaceOf(page);
  const domains = {
    sheet: { u: [-Math.PI, Math.PI], v: [-Math.PI, Math.PI] },
    plane: { u: [0, 1], v: [0, 1] },
    cylinder: { u: [-0.5, 0.5], v: [-1.5 * Math.PI, 0.5 * Math.PI] },
    torus: { u: [0, 2 * Math.PI], v: [0, 2 * Math.PI] },
  };
  const direction = (name) => {
    const [start, end] = domains[object.model.kind][name];
    const closed = object.topology[name] === 'closed';
    const locals = object.locals[name];
    const cells = closed ? locals : locals - 1;
    const h = (end - start) / cells;
    return {
      start, end, closed, locals, cells, h,
      centre: (k) => start + k * h,
      /// Whether cell c (from centre c to centre c+1) belongs to the support of local k.
      supports: (k, c) => c === k || c === k - 1 || (closed && k === 0 && c === cells - 1),
    };
  };
  return { object, id: object.id, u: direction('u'), v: direction('v') };
}

/// Jets of the first object at many parameters, in one go.
export async function jets(page, parameters, order = 0) {
  return page.evaluate(
    ([list, order]) => {
      const { id } = window.knotwork.document().objects[0];
      return list.map((uv) => window.knotwork.evaluate(id, uv, order));
    },
    [parameters, order],
  );
}

export async function jet(page, uv, order = 1) {
  return (await jets(page, [uv], order))[0];
}

/// The surface at points inside every cell: [{i, j, uv, S}], (i, j) the cell.
export async function sampleCells(page, fractions = [0.25, 0.5, 0.75]) {
  const { u, v } = await grid(page);
  const points = [];
  for (let i = 0; i < u.cells; ++i) {
    for (let j = 0; j < v.cells; ++j) {
      for (const a of fractions) {
        for (const b of fractions) points.push({ i, j, uv: [u.start + (i + a) * u.h, v.start + (j + b) * v.h] });
      }
    }
  }
  const values = await jets(page, points.map((point) => point.uv));
  return points.map((point, k) => ({ ...point, S: values[k].S }));
}

/// Asserts that between two samplings the surface has moved on the support of patch [i, j], and not by a bit elsewhere.
export function assertMovedOnSupportOnly(before, after, { u, v }, [i, j]) {
  let inside = 0;
  before.forEach((point, k) => {
    if (u.supports(i, point.i) && v.supports(j, point.j)) {
      ++inside;
      assert.notDeepEqual(after[k].S, point.S, `cell ${point.i}, ${point.j} has not moved`);
    } else {
      assert.deepEqual(after[k].S, point.S, `cell ${point.i}, ${point.j} has moved`);
    }
  });
  assert.ok(inside > 0 && inside < before.length, 'the samples tell nothing');
}

// Pixels.

export async function picture(page, clip) {
  const png = PNG.sync.read(await page.screenshot({ clip: clip ?? (await stageRect(page)), scale: 'device' }));
  return { width: png.width, height: png.height, data: png.data };
}

export function pixel({ width, data }, x, y) {
  const at = 4 * (Math.round(y) * width + Math.round(x));
  return [data[at], data[at + 1], data[at + 2]];
}

export function distinctColours({ width, height, data }, { x = 0, y = 0, w = width, h = height } = {}) {
  const colours = new Set();
  for (let row = Math.round(y); row < Math.min(height, Math.round(y + h)); ++row) {
    for (let column = Math.round(x); column < Math.min(width, Math.round(x + w)); ++column) {
      const at = 4 * (row * width + column);
      colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    }
  }
  return colours.size;
}

/// The share of pixels of which some channel differs by more than `tolerance`.
export function difference(a, b, tolerance = 3) {
  assert.deepEqual([a.width, a.height], [b.width, b.height], 'the pictures differ in size');
  let differing = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const most = Math.max(...[0, 1, 2].map((k) => Math.abs(a.data[at + k] - b.data[at + k])));
    if (most > tolerance) ++differing;
  }
  return differing / (a.width * a.height);
}

/// Relative luminance of an sRGB colour, 0 to 1.
export function luminance(colour) {
  const [r, g, b] = colour.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/// Each of the documents that `bad` makes of a good one ([path, words, spoil]) is refused with that path and such words,
/// and the good one stays.
export async function assertRefused(page, good, bad) {
  for (const [path, words, spoil] of bad) {
    const document = structuredClone(good);
    spoil(document.objects[0]);
    await assert.rejects(call(page, 'load', document), (error) => {
      assert.ok(error.path.startsWith(path), `${error.path} instead of ${path}: ${error.message}`);
      assert.match(error.message, words);
      return true;
    });
    assert.deepEqual(await documentOf(page), good);
  }
}
