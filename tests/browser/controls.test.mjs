// Panel and page beside topology: blending function, counts, what is shown, undo. Both work on the one document.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, clickWidget, difference, documentOf, drag, fingers, frontHandle, handlesOf, hasWidget, nextUndo, parameter, picture,
  plus, sampleCells, settled, showMore, statsOf, surfaceOf, until, widget,
} from './stage.mjs';

const functionOf = async (page) => (await surfaceOf(page)).blending.function;

pageTest('the blending function is chosen in the panel and in the page', {}, async (page) => {
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [50, -20]));
  await page.mouse.move(3, 3);
  await settled(page);
  const smooth = await sampleCells(page);
  await clickWidget(page, 'blending.function');
  await until(page, () => window.knotwork.widgets().some((item) => item.label === 'blending.function: linear'));
  await settled(page);
  await clickWidget(page, 'blending.function: linear');
  await settled(page);
  assert.equal(await functionOf(page), 'linear');
  assert.equal(await hasWidget(page, 'blending.function: linear'), false, 'the list stays open');
  assert.notDeepEqual(await sampleCells(page), smooth);

  const select = page.locator('#blending-surface').getByRole('combobox', { name: (await parameter(page, 'blending.function')).label });
  assert.equal(await select.inputValue(), 'linear', 'the page does not follow the panel');
  await select.selectOption('expo_rational');
  await settled(page);
  assert.equal(await functionOf(page), 'expo_rational');
  assert.equal(await select.getByRole('option').count(), 11);
  await call(page, 'undo');
  await call(page, 'undo');
  assert.deepEqual(await sampleCells(page), smooth);
});

pageTest('Escape and a click beside it close the open list and change nothing', {}, async (page) => {
  const before = await documentOf(page);
  const item = 'blending.function: linear';
  const { x, centre } = await widget(page, 'blending.function');
  const ways = [() => page.keyboard.press('Escape'), () => page.mouse.click(x - 60, centre[1])];
  for (const close of ways) {
    await clickWidget(page, 'blending.function');
    await until(page, (label) => window.knotwork.widgets().some((w) => w.label === label), item);
    await settled(page);
    await close();
    await until(page, (label) => !window.knotwork.widgets().some((w) => w.label === label), item);
    await settled(page);
    assert.deepEqual(await documentOf(page), before);
  }
});

pageTest('the number of patches follows the range beside the prose and the slider in the panel', {}, async (page) => {
  const { label, min, max } = await parameter(page, 'locals.u');
  const range = page.getByRole('slider', { name: label }).first();
  await range.focus();
  const start = (await surfaceOf(page)).locals.u;
  await page.keyboard.press('ArrowRight');
  await settled(page);
  assert.equal((await surfaceOf(page)).locals.u, start + 1);
  assert.equal((await handlesOf(page)).length, (start + 1) * (await surfaceOf(page)).locals.v);

  const slider = await widget(page, 'locals.u');
  await page.mouse.move(slider.x + slider.width * 0.5, slider.centre[1]);
  await page.mouse.down();
  await page.mouse.move(slider.x + slider.width * 0.62, slider.centre[1], { steps: 4 });
  await page.mouse.move(slider.x + slider.width * 0.66, slider.centre[1], { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const { u, v } = (await surfaceOf(page)).locals;
  assert.ok(u !== start + 1 && u >= min && u <= max, `the slider gives ${u}`);
  assert.equal((await handlesOf(page)).length, u * v);
  assert.equal(await range.inputValue(), String(u), 'the page does not follow the panel');
  await call(page, 'undo');
  assert.equal((await surfaceOf(page)).locals.u, start + 1, 'a drag of the slider is not one step of undo');
});

pageTest('a drag of a range beside the prose is one step of undo', {}, async (page) => {
  const start = await documentOf(page);
  const { label } = await parameter(page, 'locals.v');
  const range = page.getByRole('slider', { name: label }).first();
  await range.scrollIntoViewIfNeeded();
  const box = await range.boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.1, y);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.4, y, { steps: 10 });
  await page.mouse.up();
  await settled(page);
  assert.notEqual((await surfaceOf(page)).locals.v, start.objects[0].locals.v);
  await call(page, 'undo');
  assert.deepEqual((await documentOf(page)).objects, start.objects);
});

const toggles = [
  'display.surface', 'display.colours', 'display.knots', 'display.wireframe', 'display.locals', 'display.frames',
  'display.normals', 'display.handles',
];

const still = { drawn: true, reducedMotion: true, size: [1040, 800], scale: 0.5 };

pageTest('each thing shown can be switched in the panel, and makes a difference', still, async (page) => {
  await showMore(page, 'display.wireframe');
  for (const id of toggles) {
    const was = (await parameter(page, id)).value;
    const { centre } = await widget(page, id);
    await page.mouse.move(...centre);
    await settled(page);
    const before = await picture(page);
    await page.mouse.click(...centre);
    await settled(page);
    assert.equal((await parameter(page, id)).value, !was, `${id} has not been switched`);
    assert.ok(difference(before, await picture(page)) > 0.002, `${id} changes nothing in the picture`);
    await page.mouse.click(...centre);
    await settled(page);
    assert.equal((await parameter(page, id)).value, was);
    assert.ok(difference(before, await picture(page)) < 0.001, `${id} leaves something behind`);
  }
});

pageTest('the buttons for undo and redo do it, on the page and in the panel', { reducedMotion: true }, async (page) => {
  const [undo, redo] = [/^Undo/, /^Redo/].map((name) => page.getByRole('button', { name }));
  const possible = async (button) => (await button.getAttribute('aria-disabled')) !== 'true';
  const topologyIs = async (expected) => {
    await settled(page);
    assert.equal((await surfaceOf(page)).topology.v, expected);
  };
  const before = await nextUndo(page);
  assert.equal(await possible(redo), false);
  await clickWidget(page, 'topology.v: open');
  await topologyIs('open');
  assert.equal(await possible(undo), true);
  assert.notEqual(await nextUndo(page), before, 'the button does not say what it would undo');
  await undo.click();
  await topologyIs('closed');
  assert.deepEqual([await nextUndo(page), await possible(redo)], [before, true]);
  await redo.click();
  await topologyIs('open');

  await clickWidget(page, 'undo');
  await topologyIs('closed');
  await clickWidget(page, 'redo');
  await topologyIs('open');
  await clickWidget(page, 'undo');
  await topologyIs('closed');  // the click has been taken before something else is done
  await call(page, 'set', 'locals.u', 5);
  // The page takes up what has changed after the stage has: what was undone cannot be redone any more.
  await page.getByRole('button', { name: /^Redo/, disabled: true }).waitFor();
});

pageTest('64 x 64 patches and 1024 x 1024 samples are drawn', { drawn: true, reducedMotion: true, size: [900, 480], scale: 0.5 }, async (page) => {
  await call(page, 'set', 'locals.u', 64);
  await call(page, 'set', 'locals.v', 64);
  await settled(page);
  assert.equal((await handlesOf(page)).length, 4096);
  await call(page, 'set', 'samples.u', 1024);
  await call(page, 'set', 'samples.v', 1024);
  await settled(page);
  const stats = await statsOf(page);
  assert.ok(stats.vertices >= 1e6, `${stats.vertices} vertices are drawn`);
  const { S } = await call(page, 'evaluate', (await surfaceOf(page)).id, [0.1, 0.2], 0);
  assert.ok(S.every(Number.isFinite));
  for (let k = 0; k < 4; ++k) await call(page, 'undo');
  await settled(page);
});

pageTest('the panel is a drawer on a phone', { size: [390, 844], scale: 2, touch: true }, async (page) => {
  assert.equal(await hasWidget(page, 'topology.u: open'), false, 'the panel covers the small stage');
  const open = await widget(page, 'controls');
  await page.touchscreen.tap(...open.centre);
  await until(page, () => window.knotwork.widgets().some((item) => item.label === 'topology.u: open'));
  await settled(page);
  const { centre } = await widget(page, 'topology.u: open');
  await page.touchscreen.tap(...centre);
  await settled(page);
  assert.equal((await surfaceOf(page)).topology.u, 'open');
});

const thumb = 'a thumb that goes up scrolls the drawer; sideways it takes a slider, and a tap brings the slider there';
pageTest(thumb, { size: [390, 844], scale: 2, touch: true }, async (page) => {
  await page.touchscreen.tap(...(await widget(page, 'controls')).centre);
  await settled(page);
  const hand = await fingers(page);
  const slider = () => widget(page, 'locals.u');
  const start = await surfaceOf(page);
  const { centre: [x, y] } = await slider();

  await hand.sweep([[x, y]], [[x + 4, y - 90]]);
  await settled(page);
  assert.deepEqual((await surfaceOf(page)).locals, start.locals, 'scrolling has changed a value');
  const scrolled = await call(page, 'widgets');
  const now = scrolled.find(({ label }) => label === 'locals.u');
  assert.ok(!now || now.rect[1] + now.rect[3] / 2 < y - 40, 'the drawer has not scrolled');

  await hand.sweep([[x, y - 90]], [[x, y + 40]]);
  await settled(page);
  const { x: left, y: top, width, height } = await slider();
  await hand.sweep([[left + width / 2, top + height / 2]], [[left + width - 12, top + height / 2]]);
  await settled(page);
  const dragged = (await surfaceOf(page)).locals.u;
  assert.ok(dragged > start.locals.u, `${dragged} patches`);
  await page.touchscreen.tap(left + 12, top + height / 2);
  await settled(page);
  assert.ok((await surfaceOf(page)).locals.u < dragged);
});

pageTest('a drawer that has closed leaves the picture as it was', { full: true, size: [390, 844], scale: 2, touch: true }, async (page) => {
  const distance = async () => (await documentOf(page)).camera.distance;
  const tap = async () => {
    const { x, y, width, height } = await widget(page, 'controls');
    await page.touchscreen.tap(x + width / 2, y + height / 2);
    await settled(page);
  };
  const before = await distance();
  await tap();
  assert.ok(Math.abs((await distance()) / before - 1) > 0.1, 'the drawer takes no room from the picture');
  await tap();
  assert.ok(Math.abs((await distance()) / before - 1) < 1e-6);
});

pageTest('items of the panel lie on the stage and are large enough to hit', {}, async (page) => {
  await showMore(page, 'display.wireframe');
  const stage = await page.locator('canvas').boundingBox();
  for (const { label, rect: [x, y, w, h] } of await call(page, 'widgets')) {
    assert.ok(w >= 16 && h >= 16, `${label} is ${w} by ${h}`);
    const inside =
      x >= stage.x - 1 && y >= stage.y - 1 && x + w <= stage.x + stage.width + 1 && y + h <= stage.y + stage.height + 1;
    assert.ok(inside, `${label} is outside of the stage`);
  }
});
