// Fitted curves on the stage: data dragged, drawn, pasted, added and deleted; bad input refused.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertRefused, call, clickWidget, distance, distinctColours, documentOf, drag, fingers, handleAt, handlesOf,
  parameter, picture, plus, settled, stageRect, widget,
} from './stage.mjs';

const wide = { full: true, size: [1440, 900] };
const phone = { full: true, touch: true, size: [390, 844], scale: 1 };

async function opened(page, chapter = 'least-squares') {
  await call(page, 'open', chapter);
  await settled(page);
  return fitOf(page);
}

const fitOf = async (page) => (await documentOf(page)).objects[0];
const curveAt = async (page, end) =>
  Promise.all(Array.from({ length: 21 }, async (_, k) => (await call(page, 'evaluate', 'fit', (k * end) / 20))[0]));
const radialError = (points) => Math.max(...points.map((point) => Math.abs(Math.hypot(...point) - 5)));
const stageMiddle = async (page) => {
  const { x, y, width, height } = await stageRect(page);
  return [x + 0.38 * width, y + 0.42 * height];
};

/// Text in the clipboard of a paste event on the page, as Ctrl+V brings it.
const paste = (page, text) =>
  page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData('text/plain', text);
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);

pageTest("the report's circle is fitted openly, and far closer when it is closed", wide, async (page) => {
  const open = await opened(page);
  assert.deepEqual([open.kind, open.points.length, open.count, open.degree], ['fittedCurve', 20, 8, 3]);
  const report = radialError(await curveAt(page, 5));
  await opened(page, 'least-squares-closed');
  const corrected = radialError(await curveAt(page, 8));
  assert.ok(report > 5 * corrected && corrected > 0, `${report} and ${corrected}`);
});

pageTest('a datum is dragged, the curve follows, undo brings both back', wide, async (page) => {
  const start = await opened(page);
  const before = await curveAt(page, 5);
  const handle = await handleAt(page, 'point-4');
  await drag(page, plus(handle.screen, [2, 1]), plus(handle.screen, [-50, 40]), { steps: 6 });
  await settled(page);
  const moved = await handleAt(page, 'point-4');
  assert.ok(distance(moved.screen, plus(handle.screen, [-52, 39])) < 1.5, 'the point has left the pointer');
  const after = await curveAt(page, 5);
  assert.ok(Math.max(...after.map((point, k) => distance(point, before[k]))) > 0.1, 'the curve has not followed');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await fitOf(page), start);
  assert.deepEqual(await curveAt(page, 5), before);
});

pageTest('data are added and deleted by key; closing, ends and parameters by the panel', wide, async (page) => {
  const start = await opened(page);
  const handle = await handleAt(page, 'point-7');
  await page.mouse.click(...handle.screen);
  await page.keyboard.press('Insert');
  assert.equal((await fitOf(page)).points.length, 21);
  await page.keyboard.press('Delete');
  assert.deepEqual((await fitOf(page)).points, start.points);
  await clickWidget(page, 'curve.topology: closed');
  await settled(page);
  assert.equal((await fitOf(page)).topology, 'closed');
  assert.match((await parameter(page, 'fitted.ends')).disabled, /no ends/);
  const [first] = await call(page, 'evaluate', 'fit', 0);
  const [last] = await call(page, 'evaluate', 'fit', 8 - 1e-10);
  assert.ok(distance(first, last) < 1e-8, 'the seam is open');
  await call(page, 'set', 'curve.topology', 'open');
  await call(page, 'set', 'fitted.ends', 'interpolated');
  assert.deepEqual((await call(page, 'evaluate', 'fit', 0))[0], start.points[0]);
});

pageTest('a press in the plot of errors chooses the number of control points', wide, async (page) => {
  await opened(page);
  const plot = await widget(page, 'errors');
  // n runs from 4 to 20.
  const place = (n) => [plot.x + 8 + ((plot.width - 16) * (n - 4)) / 16, plot.centre[1]];
  await page.mouse.click(...place(6));
  await settled(page);
  assert.equal((await fitOf(page)).count, 6);
  await drag(page, place(6), place(12), { steps: 8 });
  await settled(page);
  assert.equal((await fitOf(page)).count, 12);
  await call(page, 'undo');
  assert.equal((await fitOf(page)).count, 6);
  await call(page, 'undo');
  assert.equal((await fitOf(page)).count, 8);
});

pageTest('the next drag after "Draw points" draws the data; Escape leaves', wide, async (page) => {
  const start = await opened(page);
  const middle = await stageMiddle(page);
  await clickWidget(page, 'draw');
  await settled(page);
  await page.keyboard.press('Escape');
  await drag(page, middle, plus(middle, [60, 0]));
  assert.deepEqual(await fitOf(page), start);
  await call(page, 'open', 'least-squares');
  await settled(page);

  await clickWidget(page, 'draw');
  await settled(page);
  await page.mouse.move(...middle);
  await page.mouse.down();
  for (let k = 1; k <= 30; ++k) await page.mouse.move(...plus(middle, [6 * k, 60 * Math.sin(k / 5)]));
  await page.mouse.up();
  await settled(page);
  const drawn = await fitOf(page);
  assert.ok(drawn.points.length > 25 && drawn.points.length < 80, `${drawn.points.length} points`);
  // Flat data stay in their plane.
  for (const [, , z] of drawn.points) assert.ok(Math.abs(z) < 1e-9);
  const ends = [await handleAt(page, 'point-0'), await handleAt(page, `point-${drawn.points.length - 1}`)];
  assert.ok(distance(ends[0].screen, middle) < 2);
  assert.ok(distance(ends[1].screen, plus(middle, [180, 60 * Math.sin(6)])) < 2);
  await page.keyboard.press('Control+z');
  assert.deepEqual((await fitOf(page)).points, start.points);
});

pageTest('a finger draws, too', phone, async (page) => {
  const start = await opened(page);
  await page.touchscreen.tap(...(await widget(page, 'draw')).centre);
  await settled(page);
  const { x, y, width } = await stageRect(page);
  const touch = await fingers(page);
  await touch.sweep([[x + 60, y + 120]], [[x + width - 60, y + 160]], 12);
  await settled(page);
  const drawn = await fitOf(page);
  assert.notDeepEqual(drawn.points, start.points);
  assert.ok(drawn.points.length > 20, `${drawn.points.length} points`);
});

pageTest('points are pasted as text while the stage has the focus', wide, async (page) => {
  const start = await opened(page);
  const wave = Array.from({ length: 40 }, (_, k) => [k / 4, Math.sin(k / 4), 0]);
  await paste(page, JSON.stringify(wave));
  assert.deepEqual(await fitOf(page), start, 'without the focus a paste is none of the stage');
  await page.locator('canvas').focus();
  await paste(page, JSON.stringify(wave));
  await settled(page);
  assert.deepEqual((await fitOf(page)).points, wave);
  await paste(page, 'x,y\n' + wave.map(([a, b]) => `${a},${b}`).join('\r\n'));
  assert.deepEqual((await fitOf(page)).points, wave);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await fitOf(page), start);
});

pageTest('bad text is refused with its line, a million points and 50 MB at once; nothing changes', wide, async (page) => {
  const start = await opened(page);
  await page.locator('canvas').focus();
  const bad = [
    ['1 2\n3 four', /line 2.*“four” is not a number/],
    ['1 2\n3 NaN', /line 2/],
    ['1 2\nInfinity 4', /line 2/],
    ['1 2\n3 1e9', /too large/],
    ['1 2 3 4', /more than 3 numbers/],
    ['[[1,2],[3', /bracket/],
    ['1 2\n3 4', /2 points for 8 control points/],
    ['', /no points/],
  ];
  for (const [text, words] of bad) {
    await paste(page, text);
    assert.match(await page.locator('#notice').textContent(), words, text);
    assert.deepEqual(await fitOf(page), start, text);
  }
  for (const [name, words] of [['million', /more than 20000 points/], ['garbage', /not a number/], ['blank', /8 MiB/]]) {
    const ms = await page.evaluate((name) => {
      const text = {
        million: () => '1.25 2.5 3.75\n'.repeat(1e6),
        garbage: () => 'garbage '.repeat(6.5e6),
        blank: () => ' '.repeat(50e6),
      }[name]();
      const data = new DataTransfer();
      data.setData('text/plain', text);
      const event = new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true });
      const begun = performance.now();
      document.body.dispatchEvent(event);
      return performance.now() - begun;
    }, name);
    assert.match(await page.locator('#notice').textContent(), words);
    assert.ok(ms < 8000, `${name} took ${ms} ms`);
    assert.deepEqual(await fitOf(page), start);
  }
});

pageTest('the field at the foot of the page takes points and names the fault', phone, async (page) => {
  const start = await opened(page);
  const form = page.locator('.points');
  await form.locator('summary').click();
  const field = form.getByRole('textbox');
  await form.getByRole('button', { name: 'Write the present ones' }).click();
  assert.equal((await field.inputValue()).split('\n').length, 20);
  await field.fill('0 0\n1 1\n2 oops');
  await form.getByRole('button', { name: 'Use these points' }).click();
  assert.match(await form.locator('.reason').textContent(), /^Line 3: “oops” is not a number/);
  assert.deepEqual(await fitOf(page), start);
  await field.fill(Array.from({ length: 12 }, (_, k) => `${k} ${k % 3}`).join('\n'));
  await form.getByRole('button', { name: 'Use these points' }).click();
  assert.equal(await form.locator('.reason').isHidden(), true);
  assert.equal((await fitOf(page)).points.length, 12);
  await call(page, 'open', 'bspline-curve');
  assert.equal(await form.isHidden(), true);
});

pageTest('what cannot be fitted is refused by panel, script and document', wide, async (page) => {
  await opened(page);
  const good = await documentOf(page);
  const bad = [
    ['objects[0].points', /6 points for 8 control points/, (fit) => (fit.points.length = 6)],
    ['objects[0].points', /longer list/, (fit) => (fit.points = Array.from({ length: 20001 }, (_, k) => [k, 0, 0]))],
    ['objects[0].points[2]', /list of 3 numbers/, (fit) => (fit.points[2] = [1, 2])],
    ['objects[0].count', /at least 10 control points/, (fit) => (fit.degree = 9)],
    ['objects[0].degree', /1 to 9/, (fit) => (fit.degree = 12)],
    ['objects[0].points', /one place/, (fit) => ((fit.points = fit.points.map(() => [1, 1, 1])), (fit.parameters = 'chordLength'))],
    ['objects[0].parameters', /uniform, centripetal or chordLength/, (fit) => (fit.parameters = 'arc')],
  ];
  await assertRefused(page, good, bad);
  await assert.rejects(call(page, 'set', 'fitted.count', 21), /20 points for 21 control points/);
  await assert.rejects(call(page, 'set', 'curve.degree', 8), /at least 9 control points/);
  assert.deepEqual(await documentOf(page), good);
});

pageTest('many data are drawn without handles and stay quick', wide, async (page) => {
  await opened(page);
  const document = await documentOf(page);
  document.objects[0].points = Array.from({ length: 20000 }, (_, k) => [Math.cos(k / 3000), Math.sin(k / 2000), k / 9000]);
  await call(page, 'load', document);
  await settled(page);
  assert.deepEqual(await handlesOf(page), []);
  await call(page, 'set', 'fitted.count', 30);
  await settled(page);
  assert.equal((await fitOf(page)).count, 30);
});

pageTest('whiskers, curve and both plots are drawn', wide, async (page) => {
  await opened(page);
  await call(page, 'set', 'fitted.count', 6);
  await settled(page);
  const all = { x: 0, y: 0, width: 1440, height: 900 };
  const plot = await widget(page, 'errors');
  assert.ok(distinctColours(await picture(page, all), { x: plot.x, y: plot.y, w: plot.width, h: plot.height }) > 20);
  const { screen: [x, y] } = await handleAt(page, 'point-0');
  const around = { x: x - 40, y: y - 40, w: 80, h: 80 };
  const shown = distinctColours(await picture(page, all), around);
  for (const id of ['display.polygon', 'display.handles', 'display.colours']) await call(page, 'set', id, false);
  await settled(page);
  assert.ok(shown > distinctColours(await picture(page, all), around), 'what is shown makes no difference');
});
