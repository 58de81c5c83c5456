// Every exercise of the page, solved as a reader would: with a pointer, a finger or keys, and nothing else.
import assert from 'node:assert/strict';
import { PNG } from 'pngjs';
import { pageTest } from './page_test.mjs';
import {
  call, clickWidget, distance, documentOf, fingers, frameDrawn, frontHandle, handleAt, minus, parameter, plus,
  projection, scrollTo, settled, shownFigure, times, unit, until, widget,
} from './stage.mjs';

const reading = { followed: true, full: true, size: [1200, 800], scale: 0.5 };
const phone = { followed: true, full: true, size: [390, 844], scale: 1, touch: true };

const solved = (page, id) => page.evaluate((name) => 'solved' in document.getElementById(`figure-${name}`).dataset, id);
const ringOf = async (page) => (await documentOf(page)).display.rings[0];

// --- Hands -----------------------------------------------------------------------------------------------------------

/// The page looks at what is dragged ten times a second: waits until it has looked at this state.
const looked = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const begun = performance.now();
        const wait = () => (performance.now() - begun > 120 ? done() : requestAnimationFrame(wait));
        wait();
      }),
  );

/// Takes a handle and goes on along `way` (CSS pixels), `step` pixels at a time, until the page says that this was it,
/// or to its end.
async function pull(page, id, handle, way, { shift = false, step = 6 } = {}) {
  const { screen } = await handleAt(page, handle);
  await page.mouse.move(...screen);
  if (shift) await page.keyboard.down('Shift');
  await page.mouse.down();
  const steps = Math.ceil(distance(way, [0, 0]) / step);
  for (let k = 1; k <= steps && !(await solved(page, id)); ++k) {
    await page.mouse.move(...plus(screen, times(k / steps, way)));
    await looked(page);
  }
  await page.mouse.up();
  if (shift) await page.keyboard.up('Shift');
  await frameDrawn(page);
}

/// A handle goes to a point of space, as far as the screen tells.
async function bring(page, handle, to) {
  const { project } = await projection(page);
  const { screen } = await handleAt(page, handle);
  await page.mouse.move(...screen);
  await page.mouse.down();
  await page.mouse.move(...project(to), { steps: 6 });
  await page.mouse.up();
  await frameDrawn(page);
}

/// A thing of the panel or a plot, on the screen, is dragged by so much.
async function shove(page, label, way, { id, step = 24 } = {}) {
  const { centre } = await widget(page, label);
  await page.mouse.move(...centre);
  await page.mouse.down();
  const steps = Math.ceil(distance(way, [0, 0]) / step);
  for (let k = 1; k <= steps && !(id && (await solved(page, id))); ++k) {
    await page.mouse.move(...plus(centre, times(k / steps, way)));
    await frameDrawn(page);
  }
  await page.mouse.up();
  await frameDrawn(page);
}

/// One knot of the strip onto another, where it snaps.
async function joinKnots(page, from, to) {
  const [a, b] = [await widget(page, from), await widget(page, to)];
  await shove(page, from, minus(b.centre, a.centre));
  await settled(page);
}

/// A slider's thumb in the panel is held and moved to and fro until the value stands there.
async function slide(page, id, value) {
  const { x, width, centre } = await widget(page, id);
  let [low, high] = [x, x + width];
  await page.mouse.move(...centre);
  await page.mouse.down();
  let now;
  for (let k = 0; k < 8 && now !== value; ++k) {
    const middle = (low + high) / 2;
    await page.mouse.move(middle, centre[1]);
    await frameDrawn(page);
    now = (await parameter(page, id)).value;
    if (now < value) low = middle;
    else high = middle;
  }
  await page.mouse.up();
  await settled(page);
  assert.equal(now, value, `the slider of ${id}`);
}

/// Something of the panel is clicked.
async function press(page, label) {
  await clickWidget(page, label);
  await settled(page);
}

/// A slider beside the prose goes to a value by keys.
async function type(page, exercise, id, keys) {
  const slider = page.locator(`#figure-${exercise} ~ .controls [data-parameter="${id}"] input`).first();
  await slider.focus();
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
}

// --- Solutions -------------------------------------------------------------------------------------------------------

/// `wrong` is a move that must not be taken for the solution. All that is read is what a reader sees: handles, widgets,
/// and the place of the ring.
const solutions = {
  'no-room-left': {
    wrong: async (page) => bring(page, 'point-1', [1.8, 0.13, 0]),
    solve: async (page) => {
      await bring(page, 'point-1', [1.8, 0.13, 0]);
      await bring(page, 'point-2', [3.7, 0.27, 0]);
    },
  },
  'through-one-point': {
    wrong: async (page) => bring(page, 'point-1', await ringOf(page)),
    solve: async (page, id) => {
      const { project } = await projection(page);
      const dot = await handleAt(page, 'parameter');
      await pull(page, id, 'point-1', times(3, minus(project(await ringOf(page)), dot.screen)));
    },
  },
  'squeezed-span': {
    wrong: async (page) => shove(page, 'knot 7', [-60, 0]),
    solve: async (page, id) => shove(page, 'knot 7', [130, 0], { id, step: 4 }),
  },
  'corner-by-knots': {
    wrong: async (page) => joinKnots(page, 'knot 5', 'knot 6'),
    solve: async (page) => {
      await joinKnots(page, 'knot 5', 'knot 6');
      await joinKnots(page, 'knot 7', 'knot 6');
    },
  },
  'closed-crease': {
    wrong: async (page) => joinKnots(page, 'knot 5', 'knot 6'),
    solve: async (page) => {
      await press(page, 'curve.topology: closed');
      await joinKnots(page, 'knot 4', 'knot 5');
    },
  },
  'calm-curve': {
    wrong: async (page) => slide(page, 'fitted.count', 10),
    solve: async (page) => type(page, 'calm-curve', 'fitted.smoothing', ['ArrowRight', 'ArrowRight', 'ArrowRight']),
  },
  'bridge-the-gap': {
    wrong: async (page) => press(page, 'fitted.knots: averaged'),
    solve: async (page) => {
      await press(page, 'fitted.knots: averaged');
      await slide(page, 'fitted.count', 14);
    },
  },
  'seven-will-do': {
    wrong: async (page) => {
      await press(page, 'curve.topology: closed');
      await slide(page, 'fitted.count', 7);
    },
    solve: async (page) => {
      await press(page, 'curve.topology: closed');
      await slide(page, 'fitted.count', 7);
      await press(page, 'fitted.parameters');
      await press(page, 'fitted.parameters: chordLength');
    },
  },
  'put-back': {
    wrong: async (page) => bring(page, 'point-2', [0.6, 4.2, 0]),
    solve: async (page, id) => {
      const { project } = await projection(page);
      const outwards = unit(minus((await handleAt(page, 'point-1')).screen, project([0, 0, 0])));
      await pull(page, id, 'point-1', times(200, outwards));
    },
  },
  'already-there': {
    wrong: async (page) => press(page, 'step on'),
    solve: async (page) => {
      await bring(page, 'point-1', [-1.67, 0, 0]);
      await bring(page, 'point-2', [1.67, 0, 0]);
    },
  },
  'one-of-them': {
    wrong: async (page) => press(page, 'topology.v: open'),
    solve: async (page, id) => pull(page, id, (await frontHandle(page)).id, [0, -60]),
  },
  'flat-sheet': {
    wrong: async (page) => press(page, 'topology.v: open'),
    solve: async (page) => {
      await press(page, 'topology.u: open');
      await press(page, 'topology.v: open');
    },
  },
  'dented-arch': {
    wrong: async (page) => bring(page, 'point-3', [0, 2, 0]),
    solve: async (page) => bring(page, 'point-3', [0, 3.4, 0]),
  },
  'whole-hodograph': {
    wrong: async (page) => bring(page, 'point-4', [2, 0, 0]),
    solve: async (page) => bring(page, 'point-4', [1, 0, 0]),
  },
  'straight-stripes': {
    wrong: async (page) => {
      await press(page, 'blending.function');
      await press(page, 'blending.function: polynomial1');
    },
    solve: async (page) => {
      await press(page, 'blending.function');
      await press(page, 'blending.function: polynomial2');
    },
  },
  'unbroken-comb': {
    wrong: async (page) => slide(page, 'blending.parameter', 4),
    solve: async (page) => slide(page, 'blending.parameter', 3),
  },
  'through-the-ring': {
    wrong: async (page) => slide(page, 'blending.parameter', 5),
    solve: async (page) => slide(page, 'blending.parameter', 3),
  },
  'into-the-ring': {
    wrong: async (page) => bring(page, 'local-3', [-0.7, 0.1, 0]),
    solve: async (page) => bring(page, 'local-3', await ringOf(page)),
  },
  'only-by-turning': {
    wrong: async (page) => bring(page, 'local-1', await ringOf(page)),
    solve: async (page, id) => {
      const { screen } = await handleAt(page, 'local-1');
      await page.mouse.click(...screen);
      await settled(page);
      const at = (angle) => plus(screen, [46 * Math.cos(angle), 46 * Math.sin(angle)]);
      for (const start of [2.2, 2.8, 0.9, 3.9]) {
        const before = (await documentOf(page)).objects;
        await page.mouse.move(...at(start));
        await page.mouse.down();
        for (let k = 1; k <= 45 && !(await solved(page, id)); ++k) {
          await page.mouse.move(...at(start - 0.02 * k));
          await frameDrawn(page);
        }
        await page.mouse.up();
        await frameDrawn(page);
        if (await solved(page, id)) return;
        const changed = JSON.stringify((await documentOf(page)).objects) !== JSON.stringify(before);
        if (changed) await page.keyboard.press('Control+z');
      }
    },
  },
  'few-locals': {
    wrong: async (page) => slide(page, 'locals.count', 10),
    solve: async (page) => {
      await slide(page, 'locals.count', 10);
      await slide(page, 'locals.degree', 3);
    },
  },
  'net-ring': {
    wrong: async (page, id) => pull(page, id, 'point-2-2', [-60, 20], { shift: true }),
    solve: async (page, id) => {
      const { project } = await projection(page);
      const { position, screen } = await handleAt(page, 'point-2-2');
      await pull(page, id, 'point-2-2', minus(project(plus(position, [2.4, 0, 0])), screen), { shift: true, step: 10 });
    },
  },
  'one-patch': {
    wrong: async (page) => slide(page, 'net.u', 4),
    solve: async (page) => {
      await slide(page, 'net.u', 4);
      await slide(page, 'net.v', 4);
    },
  },
  'tube-of-24': {
    wrong: async (page) => press(page, 'topology.u: closed'),
    solve: async (page) => {
      await press(page, 'topology.u: closed');
      await slide(page, 'net.v', 7);
    },
  },
  'patch-ring': {
    wrong: async (page) => bring(page, 'patch-2-3', await ringOf(page)),
    solve: async (page, id) => {
      const { project } = await projection(page);
      const { position, screen } = await handleAt(page, 'patch-3-3');
      await pull(page, id, 'patch-3-3', minus(project(plus(position, [0, 0, 0.8])), screen), { shift: true });
    },
  },
  'fifteen-cells': {
    wrong: async (page) => press(page, 'topology.u: open'),
    solve: async (page) => press(page, 'topology.v: open'),
  },
  'seven-by-three': {
    wrong: async (page) => slide(page, 'locals.u', 7),
    solve: async (page) => {
      await slide(page, 'locals.u', 7);
      await slide(page, 'locals.v', 3);
    },
  },
  'polygon-itself': {
    wrong: async (page) => press(page, 'curve.topology: closed'),
    solve: async (page) => {
      await press(page, 'curve.topology: closed');
      await slide(page, 'curve.degree', 1);
    },
  },
};

const exercisesOf = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('[data-goal]')].map((element) => ({
      id: element.dataset.figure,
      chapter: element.closest('[data-chapter]').id,
    })),
  );

/// Scrolls to an exercise and waits until it is on the stage.
async function turnTo(page, id) {
  await scrollTo(page, `#figure-${id}`);
  await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
  await settled(page);
}

const acknowledged = async (page, id) => {
  await page
    .waitForFunction((name) => 'solved' in document.getElementById(`figure-${name}`).dataset, id, { timeout: 3000 })
    .catch(() => assert.fail(`${id} is not taken for solved`));
  const exercise = page.locator(`#figure-${id}`);
  assert.equal(await exercise.locator('.exercise-state').textContent(), 'Solved');
  const done = exercise.locator('.exercise-done');
  assert.ok(await done.isVisible(), `${id}: nothing is said`);
  const words = (text) => text.replaceAll(/\s+/g, ' ').trim();
  assert.equal(words(await page.locator('#notice').textContent()), words(`Solved. ${await done.textContent()}`));
};

const progressOf = async (page, chapter) => {
  const text = await page.locator(`[data-progress="${chapter}"]`).textContent();
  return Number(/^(\d+) \//.exec(text)[1]);
};

/// The ring lies on the stage, with nothing of the panel over it, and it is drawn: its rim is there in its own colour.
async function assertRingShows(page, id) {
  const { project } = await projection(page);
  const place = project(await ringOf(page));
  const there = await page.evaluate((at) => document.elementFromPoint(...at)?.tagName, place);
  assert.equal(there, 'CANVAS', `${id}: no ring`);
  for (const { label, rect: [x, y, width, height] } of await call(page, 'widgets')) {
    const beside = place[0] < x - 12 || place[0] > x + width + 12 || place[1] < y - 12 || place[1] > y + height + 12;
    assert.ok(beside, `${id}: its ring is under ${label}`);
  }
  const ratio = await page.evaluate(() => devicePixelRatio);
  const { data, width } = PNG.sync.read(await page.screenshot());
  const middle = 9.75;  // of the rim, CSS pixels from the centre (add_rings in web/stage_ornaments.cpp)
  let red = 0;
  for (let k = 0; k < 72; ++k) {
    const turn = (k * Math.PI) / 36;
    const way = [middle * Math.cos(turn), middle * Math.sin(turn)];
    const [x, y] = plus(place, way).map((c) => Math.round(ratio * c - 0.5));
    const [r, g, b] = data.subarray(4 * (y * width + x));
    if (r > g + 40 && r > b + 40) ++red;
  }
  assert.ok(red > 36, `${id}: of its ring ${red} of 72 places are seen`);
}

/// As the chapter has it.
async function startAgain(page, id, start) {
  const again = page.locator(`#figure-${id} [data-again]`);
  await again.click();
  await settled(page);
  assert.deepEqual((await documentOf(page)).objects, start.objects, `${id} does not start again`);
}

/// The chapters that have exercises.
const chapters = [
  'hold-it', 'bezier-curves', 'bsplines', 'fitting', 'subdivision-curves', 'blending-functions', 'blending-splines',
  'tensor-surfaces', 'blending-surface', 'quality', 'in-code',
];

pageTest('each exercise has a solution here, and is in one of the chapters that are read', {}, async (page) => {
  const all = await exercisesOf(page);
  assert.deepEqual(Object.keys(solutions).sort(), all.map(({ id }) => id).sort());
  assert.deepEqual([...new Set(all.map(({ chapter }) => chapter))], chapters);
});

for (const chapter of chapters) {
  pageTest(`the exercises of a chapter are solved by hand: ${chapter}`, reading, async (page) => {
    const own = (await exercisesOf(page)).filter((exercise) => exercise.chapter === chapter);
    assert.ok(own.length > 0, `${chapter} has no exercise`);
    for (const [k, { id }] of own.entries()) {
      const { wrong, solve } = solutions[id];
      await turnTo(page, id);
      const start = await documentOf(page);
      if (start.display.rings) await assertRingShows(page, id);
      await page.locator(`#figure-${id} .hint summary`).click();
      assert.ok(await page.locator(`#figure-${id} .hint p`).isVisible());
      await wrong(page, id);
      await settled(page);
      assert.equal(await solved(page, id), false, `${id}: a wrong move is taken for the solution`);
      await startAgain(page, id, start);
      await solve(page, id);
      await acknowledged(page, id);
      assert.equal(await progressOf(page, chapter), k + 1);
      assert.equal(await shownFigure(page), id);
      // What has been solved stays so while it starts again.
      await startAgain(page, id, start);
      assert.ok(await solved(page, id));
    }
  });
}

pageTest('an exercise is solved by a finger', phone, async (page) => {
  const id = 'no-room-left';
  await turnTo(page, id);
  const touch = await fingers(page);
  for (const [handle, to] of [['point-1', [1.8, 0.13, 0]], ['point-2', [3.7, 0.27, 0]]]) {
    const { project } = await projection(page);
    await touch.sweep([(await handleAt(page, handle)).screen], [project(to)], 10);
    await settled(page);
  }
  await acknowledged(page, id);
});

pageTest('an exercise is solved by keys alone', reading, async (page) => {
  const id = 'into-the-ring';
  await turnTo(page, id);
  // From the hint of the exercise to the words "On the stage", which lead there.
  await page.locator(`#figure-${id} .hint summary`).focus();
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'On the stage');
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement.tagName), 'CANVAS');
  assert.equal(await shownFigure(page), id);
  const held = 'local-3';
  for (let k = 0; k < 6 && !(await handleAt(page, held)).selected; ++k) {
    await page.keyboard.press(']');
    await frameDrawn(page);
  }
  const { project } = await projection(page);
  const ring = project(await ringOf(page));
  for (let k = 0; k < 60 && !(await solved(page, id)); ++k) {
    const [right, down] = minus(ring, (await handleAt(page, held)).screen);
    const key = Math.abs(right) > Math.abs(down) ? (right > 0 ? 'Right' : 'Left') : down > 0 ? 'Down' : 'Up';
    await page.keyboard.press(`${Math.hypot(right, down) < 16 ? 'Shift+' : ''}Arrow${key}`);
    await frameDrawn(page);
  }
  await acknowledged(page, id);
});

pageTest('a figure that starts again is seen whole, and one step back is what was there', reading, async (page) => {
  // A file of its own has a camera of its own, which does not know of this stage.
  await turnTo(page, 'patch-ring');
  const start = await documentOf(page);
  const stage = await page.locator('canvas').boundingBox();
  const { screen } = await handleAt(page, 'patch-3-3');
  await pull(page, 'patch-ring', 'patch-3-3', [30, 0]);
  await page.mouse.move(stage.x + 60, stage.y + 60);
  await page.mouse.down();
  await page.mouse.move(stage.x + 260, stage.y + 120, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const edited = await documentOf(page);
  assert.notEqual(edited.camera.azimuth, start.camera.azimuth);
  await startAgain(page, 'patch-ring', start);
  for (const [name, value] of Object.entries(start.camera))
    for (const [k, number] of [value].flat().entries())
      assert.ok(Math.abs(number - [(await documentOf(page)).camera[name]].flat()[k]) < 1e-3, `the camera's ${name}`);
  assert.ok(distance((await handleAt(page, 'patch-3-3')).screen, screen) < 1);
  await call(page, 'undo');
  assert.deepEqual((await documentOf(page)).objects, edited.objects);
});

pageTest('where nothing may be stored, exercises are solved all the same', {
  ...reading,
  before: (page) =>
    page.addInitScript(() => {
      const refuse = { get: () => { throw new DOMException('The operation is insecure.', 'SecurityError'); } };
      Object.defineProperty(window, 'localStorage', refuse);
    }),
}, async (page) => {
  assert.equal(await page.evaluate(() => { try { return localStorage.length; } catch { return 'refused'; } }), 'refused');
  await turnTo(page, 'fifteen-cells');
  await press(page, 'topology.v: open');
  await acknowledged(page, 'fifteen-cells');
  await page.locator('#contents summary').click();
  await page.locator('#forget').click();
  assert.equal(await solved(page, 'fifteen-cells'), false);
  assert.equal(await progressOf(page, 'blending-surface'), 0);
});
