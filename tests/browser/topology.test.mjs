// Opening and closing the surface: through the panel on the stage and through the page, and what becomes of the surface.
import assert from 'node:assert/strict';
import { pageTest } from './site.mjs';
import {
  call, clickWidget, course, cross, distance, documentOf, dot, drag, frontHandle, grid, handlesOf, hasWidget, jet, length,
  minus, plus, record, sampleCells, settled, surfaceOf, times, unit,
} from './stage.mjs';

const all = [['open', 'open'], ['open', 'closed'], ['closed', 'open'], ['closed', 'closed']];
const topologyOf = async (page) => (await surfaceOf(page)).topology;

/// The row of the report's table that is marked as the present one, as text of its cells.
async function reportRow(page) {
  const row = page.getByRole('table').locator('[aria-current=true]');
  assert.equal(await row.count(), 1, 'not exactly one row of the table is the present one');
  return (await row.locator('th, td').allInnerTexts()).map((text) => text.replaceAll(/\s+/g, ' ').trim());
}

/// [a, b] of "a × b".
function pair(text) {
  const match = /^(.+?) × (.+)$/.exec(text);
  assert.ok(match, `the table says ${text}`);
  return match.slice(1);
}

const subscript = (number) => String(number).replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));

/// The report's table (THEORY 2.8) for what the surface is now.
async function assertReport(page) {
  const { u, v } = await grid(page);
  const [, domain, knots, patches, locals, shape] = await reportRow(page);
  const numbers = (text) => pair(text).map(Number);
  assert.deepEqual(numbers(knots), [u, v].map((d) => d.locals + (d.closed ? 3 : 2)));
  assert.deepEqual(numbers(patches), [u, v].map((d) => (d.closed ? d.locals : d.locals - 1)));
  assert.deepEqual(numbers(locals), [u.locals, v.locals]);
  const interval = (name, d) =>
    `[${name}₁, ${name}${subscript(d.closed ? d.locals + 1 : d.locals)}${d.closed ? ')' : ']'}`;
  assert.deepEqual(pair(domain), [interval('u', u), interval('v', v)]);
  return shape;
}

/// Whether all points lie in one plane, on a circular cylinder about an axis, or on neither.
async function assertShape(page, topology) {
  const points = (await sampleCells(page, [0, 0.5])).map((sample) => sample.S);
  const mean = times(1 / points.length, points.reduce(plus));
  const { u, v } = await grid(page);
  const at = async (a, b) => (await jet(page, [a, b], 0)).S;
  const size = Math.max(...points.map((point) => distance(point, mean)));

  if (topology.u === 'open' && topology.v === 'open') {
    const { Su, Sv } = await jet(page, [0.3, 0.2], 1);
    const normal = unit(cross(Su, Sv));
    for (const point of points) assert.ok(Math.abs(dot(minus(point, mean), normal)) < 1e-9 * size, 'not a plane');
  } else if (topology.u !== topology.v) {
    // Straight lines in the open direction; circles of one size in the closed one.
    const closed = topology.u === 'closed' ? u : v;
    const open = topology.u === 'closed' ? v : u;
    const point = (c, o) => (topology.u === 'closed' ? at(c, o) : at(o, c));
    const axis = unit(minus(await point(closed.start, open.end), await point(closed.start, open.start)));
    const middle = 0.5 * (open.start + open.end);
    const ring = [];
    for (let k = 0; k < 12; ++k) ring.push(await point(closed.start + (k / 12) * (closed.end - closed.start), middle));
    const centre = times(1 / 12, ring.reduce(plus));
    const radius = distance(ring[0], centre);
    for (const p of ring) {
      assert.ok(Math.abs(distance(p, centre) - radius) < 1e-9 * size, 'not round');
      assert.ok(Math.abs(dot(minus(p, centre), axis)) < 1e-9 * size, 'the ring is not across the axis');
    }
    for (const p of points) {
      const across = minus(p, plus(centre, times(dot(minus(p, centre), axis), axis)));
      assert.ok(Math.abs(length(across) - radius) < 1e-9 * size, 'not a cylinder');
    }
  } else {
    // Both families of parameter lines are closed rings, and the tube's centres lie on a circle about the axis.
    const centres = [];
    const radii = [];
    for (let k = 0; k < 8; ++k) {
      const a = u.start + (k / 8) * (u.end - u.start);
      const ring = [];
      for (let m = 0; m < 8; ++m) ring.push(await at(a, v.start + (m / 8) * (v.end - v.start)));
      const centre = times(1 / 8, ring.reduce(plus));
      centres.push(centre);
      radii.push(...ring.map((p) => distance(p, centre)));
    }
    assert.ok(Math.max(...radii) - Math.min(...radii) < 1e-9 * size, 'the tube is not round');
    const middle = times(1 / 8, centres.reduce(plus));
    const wheel = centres.map((c) => distance(c, middle));
    assert.ok(Math.max(...wheel) - Math.min(...wheel) < 1e-9 * size, 'the tube does not go round a circle');
    assert.ok(wheel[0] > radii[0], 'the torus has no hole');
  }
}

/// A closed direction's end is its start, in the point and both partials; an open one's is not.
async function assertSeams(page) {
  const { u, v } = await grid(page);
  for (const share of [0.13, 0.41, 0.77]) {
    for (const [d, uv] of [
      [u, (t) => [t, v.start + share * (v.end - v.start)]],
      [v, (t) => [u.start + share * (u.end - u.start), t]],
    ]) {
      const [first, last] = [await jet(page, uv(d.start), 2), await jet(page, uv(d.end), 2)];
      if (!d.closed) {
        assert.ok(distance(first.S, last.S) > 0.01, 'an open direction has no two ends');
        continue;
      }
      for (const name of ['S', 'Su', 'Sv', 'Suu', 'Suv', 'Svv']) {
        assert.ok(distance(first[name], last[name]) < 1e-11, `${name} jumps at the seam`);
      }
      // The end itself wraps; from inside the seam must be as smooth.
      const inside = await jet(page, uv(d.end - 1e-7 * d.h), 2);
      for (const name of ['S', 'Su', 'Sv', 'Suu', 'Suv', 'Svv']) {
        assert.ok(distance(first[name], inside[name]) < 1e-4 * (1 + length(first[name])), `${name} jumps before the seam`);
      }
    }
  }
}

async function check(page, [u, v]) {
  await settled(page);
  const topology = await topologyOf(page);
  assert.deepEqual(topology, { u, v });
  const shape = await assertReport(page);
  assert.equal(shape, { 0: 'plane', 1: 'cylinder', 2: 'torus' }[[u, v].filter((t) => t === 'closed').length]);
  await assertShape(page, topology);
  await assertSeams(page);
  assert.equal((await handlesOf(page)).length, (await surfaceOf(page)).locals.u * (await surfaceOf(page)).locals.v);
}

pageTest('every topology can be had by clicks on the panel', {}, async (page) => {
  // Each direction is opened and closed with the other one open and closed.
  const way = [['open', 'closed'], ['open', 'open'], ['closed', 'open'], ['closed', 'closed']];
  assert.deepEqual([...way].sort(), all);
  for (const [u, v] of way) {
    const now = await topologyOf(page);
    if (now.u !== u) await clickWidget(page, `topology.u: ${u}`);
    if (now.v !== v) await clickWidget(page, `topology.v: ${v}`);
    await check(page, [u, v]);
  }
});

pageTest('every topology can be had through the controls beside the prose', {}, async (page) => {
  const choose = async (name, topology) => {
    const group = page.getByRole('group', { name: new RegExp(`${name}$`) }).filter({ has: page.getByRole('radio') }).first();
    const radio = group.getByRole('radio', { name: topology, exact: false }).first();
    // The radio button itself is drawn by its label: that is what a reader clicks on.
    await group.getByText(new RegExp(`^${topology}`, 'i')).first().click();
    assert.equal(await radio.isChecked(), true);
  };
  for (const [u, v] of [['closed', 'open'], ['open', 'open'], ['open', 'closed'], ['closed', 'closed']]) {
    await choose('u', u);
    await choose('v', v);
    await check(page, [u, v]);
  }
});

pageTest('radio buttons can be had by keys, and follow the stage', {}, async (page) => {
  const group = page.getByRole('group', { name: /u$/ }).filter({ has: page.getByRole('radio') }).first();
  const [open, closed] = ['open', 'closed'].map((name) => group.getByRole('radio', { name }));
  assert.equal(await closed.isChecked(), true);
  await closed.focus();
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.deepEqual(await topologyOf(page), { u: 'open', v: 'closed' });
  assert.equal(await open.isChecked(), true);
  await clickWidget(page, 'topology.u: closed');
  await settled(page);
  assert.equal(await closed.isChecked(), true, 'the page does not follow the panel');
});

pageTest('phrases in the prose and rows of the table act', {}, async (page) => {
  await page.getByRole('button', { name: 'open the surface in v' }).click();
  await check(page, ['closed', 'open']);
  await page.getByRole('button', { name: 'Close it again' }).click();
  await check(page, ['closed', 'closed']);
  await page.getByRole('table').getByRole('button', { name: 'open, open' }).click();
  await check(page, ['open', 'open']);
});

pageTest('edits ride along: a pulled patch is the same after opening and closing', {}, async (page) => {
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [40, -20]));
  const before = await documentOf(page);
  const samples = await sampleCells(page);
  for (const label of ['topology.u: open', 'topology.v: open', 'topology.u: closed', 'topology.v: closed']) {
    await clickWidget(page, label);
    await settled(page);
    assert.deepEqual((await surfaceOf(page)).patches, before.objects[0].patches);
    await assertSeams(page);
  }
  assert.deepEqual((await documentOf(page)).objects, before.objects);
  assert.deepEqual(await sampleCells(page), samples);
  for (let k = 0; k < 4; ++k) await call(page, 'undo');
  assert.deepEqual(await documentOf(page), before, 'a click on a switch is not one step');
});

pageTest('the sheet rolls into its new shape in about 0.6 s', {}, async (page) => {
  await settled(page);
  const recording = await record(page, () => clickWidget(page, 'topology.v: open'));
  const { stages, ms } = course(recording, (row) => row.handles);
  assert.ok(stages >= 4, `the sheet has been seen in ${stages} shapes only`);
  assert.ok(ms > 400 && ms < 1000, `it has rolled for ${ms} ms`);
  // No jump: no step of a handle is much longer than the whole way divided by the steps taken.
  const whole = distance(recording[0].handles[0], recording.at(-1).handles[0]);
  assert.ok(whole > 0.05);
});

pageTest('under reduced motion it is there at once', { reducedMotion: true }, async (page) => {
  await settled(page);
  const recording = await record(page, () => clickWidget(page, 'topology.v: open'));
  assert.equal(course(recording, (row) => row.handles).stages, 1);
  await check(page, ['closed', 'open']);
});

pageTest('a closure that the model does not have is refused, with the reason in sight', {}, async (page) => {
  await call(page, 'set', 'topology.u', 'open');
  await call(page, 'set', 'topology.v', 'open');
  await call(page, 'set', 'model', 'plane');
  await settled(page);
  const before = await documentOf(page);

  await assert.rejects(call(page, 'set', 'topology.u', 'closed'), (error) => {
    assert.ok(error.isError);
    assert.match(error.message, /plane/i);
    assert.match(error.message, /\bu\b/);
    return true;
  });
  assert.deepEqual(await documentOf(page), before);

  const group = page.getByRole('group', { name: /u$/ }).filter({ has: page.getByRole('radio') }).first();
  const radio = group.getByRole('radio', { name: 'closed' });
  assert.equal(await radio.isDisabled(), true);
  const reason = await radio.evaluate((element) => {
    const line = document.getElementById(element.getAttribute('aria-describedby'));
    return { text: line?.textContent ?? '', seen: line?.checkVisibility() ?? false };
  });
  assert.match(reason.text, /plane/i);
  assert.equal(reason.seen, true, 'the reason is hidden');

  await clickWidget(page, 'topology.u: closed');
  await page.waitForFunction(() => /plane/i.test(document.querySelector('[role=status]').textContent));
  await settled(page);
  assert.deepEqual(await documentOf(page), before, 'the refused closure has changed something');
});

pageTest('a fixed model stays what it is: an opened torus has a free seam', {}, async (page) => {
  await call(page, 'set', 'model', 'torus');
  await settled(page);
  const closed = await sampleCells(page);
  await clickWidget(page, 'topology.u: open');
  await settled(page);
  const { u, v, id } = await grid(page);
  const b = v.start + 0.3 * (v.end - v.start);
  const ends = async () => [(await call(page, 'evaluate', id, [u.start, b], 0)).S, (await call(page, 'evaluate', id, [u.end, b], 0)).S];
  const [first, last] = await ends();
  assert.ok(distance(first, last) < 1e-12, 'the opened torus is no longer a torus');
  const document = await documentOf(page);
  document.objects[0].patches = [
    { i: 0, j: 1, translation: [0, 0, 0.4], rotation: [0, 0, 0, 1], scale: [1, 1, 1] },
  ];
  await call(page, 'load', document);
  const [moved, stayed] = await ends();
  assert.ok(distance(moved, first) > 0.05, 'the edge has not moved');
  assert.deepEqual(stayed, last, 'the other edge has moved with it');
  await call(page, 'undo');
  await clickWidget(page, 'topology.u: closed');
  await settled(page);
  assert.deepEqual(await sampleCells(page), closed);
  assert.equal(await hasWidget(page, 'topology.u: open'), true);
});
