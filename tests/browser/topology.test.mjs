// Opening and closing the surface, on the stage's panel and on the page, and what becomes of the surface.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, clickWidget, course, cross, distance, documentOf, dot, drag, frontHandle, grid, handlesOf, hasWidget, jet,
  jets, length, minus, plus, record, sampleCells, settled, surfaceOf, times, unit,
} from './stage.mjs';

const all = [['open', 'open'], ['open', 'closed'], ['closed', 'open'], ['closed', 'closed']];
const topologyOf = async (page) => (await surfaceOf(page)).topology;

/// The row of the report's table that is marked as the present one, as text of its cells.
async function reportRow(page) {
  const row = page.locator('#blending-surface .report').getByRole('table').locator('[aria-current=true]');
  assert.equal(await row.count(), 1, 'not exactly one row of the table is the present one');
  return (await row.locator('th, td').allInnerTexts()).map((text) => text.replaceAll(/\s+/g, ' ').trim());
}

/// [a, b] of "a × b", numbers or intervals; in a narrow table a stands above b.
function pair(text) {
  const match = /^(\d+|\[.+?[)\]]) (?:× )?(\d+|\[.+[)\]])$/.exec(text);
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

const mean = (points) => times(1 / points.length, points.reduce(plus));
const steps = (count, { start, end }) => Array.from({ length: count }, (_, k) => start + (k / count) * (end - start));

/// The surface is the plane, the cylinder or the torus that its topology means.
async function assertShape(page, topology) {
  const { u, v } = await grid(page);
  const at = async (parameters) => (await jets(page, parameters)).map(({ S }) => S);
  const points = (await sampleCells(page, [0, 0.5])).map((sample) => sample.S);
  const size = Math.max(...points.map((point) => distance(point, mean(points))));
  const tiny = 1e-9 * size;

  if (topology.u === 'open' && topology.v === 'open') {
    const { Su, Sv } = await jet(page, [0.3, 0.2], 1);
    const normal = unit(cross(Su, Sv));
    for (const point of points) assert.ok(Math.abs(dot(minus(point, points[0]), normal)) < tiny, 'not a plane');
  } else if (topology.u !== topology.v) {
    // Circles of one size across one axis.
    const [closed, open] = topology.u === 'closed' ? [u, v] : [v, u];
    const uv = (c, o) => (topology.u === 'closed' ? [c, o] : [o, c]);
    const middle = 0.5 * (open.start + open.end);
    const [foot, head, ...ring] = await at([
      uv(closed.start, open.start), uv(closed.start, open.end), ...steps(12, closed).map((c) => uv(c, middle)),
    ]);
    const axis = unit(minus(head, foot));
    const centre = mean(ring);
    for (const point of ring) {
      assert.ok(Math.abs(dot(minus(point, centre), axis)) < tiny, 'a ring is not across the axis');
    }
    const fromAxis = (point) => length(cross(minus(point, centre), axis));
    for (const point of points) assert.ok(Math.abs(fromAxis(point) - fromAxis(foot)) < tiny, 'not a cylinder');
  } else {
    // A round tube whose centres lie on a circle.
    const flat = await at(steps(8, u).flatMap((a) => steps(8, v).map((b) => [a, b])));
    const rings = Array.from({ length: 8 }, (_, k) => flat.slice(8 * k, 8 * k + 8));
    const centres = rings.map(mean);
    const spread = (lengths) => Math.max(...lengths) - Math.min(...lengths);
    const tube = rings.flatMap((ring, k) => ring.map((point) => distance(point, centres[k])));
    const wheel = centres.map((centre) => distance(centre, mean(centres)));
    assert.ok(spread(tube) < tiny, 'the tube is not round');
    assert.ok(spread(wheel) < tiny, 'the tube does not go round a circle');
    assert.ok(wheel[0] > tube[0], 'the torus has no hole');
  }
}

/// A closed direction's end is its start, in the point and all partials, and from inside as well; an open one's is not.
async function assertSeams(page) {
  const { u, v } = await grid(page);
  const names = ['S', 'Su', 'Sv', 'Suu', 'Suv', 'Svv'];
  for (const [d, uv] of [
    [u, (t, share) => [t, v.start + share * (v.end - v.start)]],
    [v, (t, share) => [u.start + share * (u.end - u.start), t]],
  ]) {
    const shares = [0.13, 0.41, 0.77];
    const ends = [d.start, d.end, d.end - 1e-7 * d.h];
    const found = await jets(page, shares.flatMap((share) => ends.map((t) => uv(t, share))), 2);
    for (let k = 0; k < shares.length; ++k) {
      const [first, last, inside] = found.slice(3 * k, 3 * k + 3);
      if (!d.closed) {
        assert.ok(distance(first.S, last.S) > 0.01, 'an open direction has no two ends');
        continue;
      }
      for (const name of names) {
        assert.ok(distance(first[name], last[name]) < 1e-11, `${name} jumps at the seam`);
        const allowed = 1e-4 * (1 + length(first[name]));
        assert.ok(distance(first[name], inside[name]) < allowed, `${name} jumps before the seam`);
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

/// The radio buttons for a direction's topology beside the prose.
function radiosOf(page, direction) {
  const groups = page.getByRole('group', { name: new RegExp(`${direction}$`) });
  return groups.filter({ has: page.getByRole('radio') }).first();
}

pageTest('every topology can be had by clicks on the panel', {}, async (page) => {
  // Each direction is opened and closed with the other one open and closed.
  const way = [['open', 'closed'], ['open', 'open'], ['closed', 'open'], ['closed', 'closed']];
  assert.deepEqual([...way].sort(), [...all].sort());
  for (const [u, v] of way) {
    const now = await topologyOf(page);
    if (now.u !== u) await clickWidget(page, `topology.u: ${u}`);
    if (now.v !== v) await clickWidget(page, `topology.v: ${v}`);
    await check(page, [u, v]);
  }
});

pageTest('every topology can be had through the controls beside the prose', {}, async (page) => {
  const choose = async (name, topology) => {
    const group = radiosOf(page, name);
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
  const group = radiosOf(page, 'u');
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
  await page.locator('#blending-surface').getByRole('button', { name: 'Open it', exact: true }).click();
  await check(page, ['closed', 'open']);
  await page.locator('#blending-surface').getByRole('button', { name: 'Close the surface in v' }).click();
  await check(page, ['closed', 'closed']);
  await page.locator('#blending-surface .report').getByRole('table').getByRole('button', { name: 'open, open' }).click();
  await check(page, ['open', 'open']);
});

pageTest('edits ride along: a pulled patch is the same after opening and closing', {}, async (page) => {
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [40, -20]));
  const before = await documentOf(page);
  const samples = await sampleCells(page);
  const openings = async () => Object.values(await topologyOf(page));
  for (const label of ['topology.u: open', 'topology.v: open', 'topology.u: closed', 'topology.v: closed']) {
    await clickWidget(page, label);
    await settled(page);
    assert.deepEqual((await surfaceOf(page)).patches, before.objects[0].patches);
    await assertSeams(page);
  }
  assert.deepEqual((await documentOf(page)).objects, before.objects);
  assert.deepEqual(await sampleCells(page), samples);
  assert.deepEqual(await openings(), ['closed', 'closed']);
  for (const expected of [['closed', 'open'], ['open', 'open'], ['open', 'closed'], ['closed', 'closed']]) {
    await call(page, 'undo');
    assert.deepEqual(await openings(), expected, 'a click on a switch is not one step');
  }
  assert.deepEqual((await documentOf(page)).objects, before.objects);
});

pageTest('the sheet rolls into its new shape in about 0.6 s', {}, async (page) => {
  await settled(page);
  const recording = await record(page, () => clickWidget(page, 'topology.v: open'));
  const { stages, ms, slowest } = course(recording, (row) => row.handles);
  assert.ok(stages >= 3, `the sheet has been seen in ${stages} shapes only`);
  const right = ms > 600 - 2 * slowest && ms < 600 + 3 * slowest;
  assert.ok(right, `it has rolled for ${ms} ms, in frames of up to ${slowest} ms`);
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

  const group = radiosOf(page, 'u');
  const radio = group.getByRole('radio', { name: 'closed' });
  assert.equal(await radio.isDisabled(), true);
  const reason = await radio.evaluate((element) => {
    const line = document.getElementById(element.getAttribute('aria-describedby'));
    return { text: line?.textContent ?? '', seen: line?.checkVisibility() ?? false };
  });
  assert.match(reason.text, /plane/i);
  assert.equal(reason.seen, true, 'the reason is hidden');

  await clickWidget(page, 'topology.u: closed');
  await page.waitForFunction(() => /plane/i.test(document.getElementById('notice').textContent));
  await settled(page);
  assert.deepEqual(await documentOf(page), before, 'the refused closure has changed something');
});

pageTest('a fixed model stays what it is: an opened torus has a free seam', {}, async (page) => {
  await call(page, 'set', 'model', 'torus');
  await settled(page);
  const closed = await sampleCells(page);
  await clickWidget(page, 'topology.u: open');
  await settled(page);
  const { u, v } = await grid(page);
  const b = v.start + 0.3 * (v.end - v.start);
  const ends = async () => (await jets(page, [[u.start, b], [u.end, b]])).map(({ S }) => S);
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
