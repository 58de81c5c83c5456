// The stage by keys alone, and the way in and out of it.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  assertMovedOnSupportOnly, call, difference, distance, documentOf, drag, frontHandle, grid, handlesOf, length, minus,
  patchOf, picture, plus, sampleCells, settled, surfaceOf,
} from './stage.mjs';

const focused = (page) =>
  page.evaluate(() => {
    const { tagName, id } = document.activeElement;
    return tagName === 'CANVAS' ? 'stage' : `${tagName} ${id}`;
  });

/// Presses Tab until the stage has the focus.
async function tabToStage(page) {
  for (let k = 0; k < 60; ++k) {
    await page.keyboard.press('Tab');
    if ((await focused(page)) === 'stage') return;
  }
  assert.fail('Tab does not reach the stage');
}

const selectedOf = async (page) => (await handlesOf(page)).filter((handle) => handle.selected);

pageTest('Tab reaches the stage and leaves it again, both ways', {}, async (page) => {
  await tabToStage(page);
  await page.keyboard.press('Tab');
  assert.notEqual(await focused(page), 'stage', 'Tab does not leave the stage');
  await page.keyboard.press('Shift+Tab');
  assert.equal(await focused(page), 'stage');
  await page.keyboard.press('Shift+Tab');
  assert.notEqual(await focused(page), 'stage', 'Shift+Tab does not leave the stage');
});

pageTest('the focus on the stage can be seen', {}, async (page) => {
  await settled(page);
  const without = await picture(page);
  await tabToStage(page);
  await settled(page);
  assert.ok(difference(without, await picture(page), 30) > 0.001, 'the stage looks as if it had no focus');
});

pageTest('arrow keys move the selected patch, and its support only', {}, async (page) => {
  await tabToStage(page);
  await page.keyboard.press(']');
  await settled(page);
  const [handle] = await selectedOf(page);
  assert.ok(handle, '] selects no patch');
  const before = await sampleCells(page);
  const start = await documentOf(page);
  for (let k = 0; k < 4; ++k) await page.keyboard.press('ArrowRight');
  await settled(page);
  const [moved] = await selectedOf(page);
  assert.equal(moved.id, handle.id);
  assert.ok(moved.screen[0] > handle.screen[0] + 2, 'it has not moved to the right');
  assert.ok(Math.abs(moved.screen[1] - handle.screen[1]) < 1, 'it has moved up or down');
  assertMovedOnSupportOnly(before, await sampleCells(page), await grid(page), patchOf(handle));

  await page.keyboard.press('ArrowUp');
  await settled(page);
  const [higher] = await selectedOf(page);
  assert.ok(higher.screen[1] < moved.screen[1] - 0.5);
  const coarse = distance(higher.position, moved.position);
  await page.keyboard.press('Shift+ArrowUp');
  await settled(page);
  const [finer] = await selectedOf(page);
  const fine = length(minus(finer.position, higher.position));
  assert.ok(fine > 0 && fine < coarse / 2, `Shift is not finer: ${fine} after ${coarse}`);

  await page.keyboard.press('Delete');
  await settled(page);
  assert.deepEqual((await documentOf(page)).objects, start.objects, 'Delete does not put the patch back');
});

pageTest('[ and ] walk through the patches, and Escape lets go', {}, async (page) => {
  await tabToStage(page);
  const walked = [];
  for (let k = 0; k < 3; ++k) {
    await page.keyboard.press(']');
    await settled(page);
    walked.push((await selectedOf(page)).map((handle) => handle.id).join());
  }
  assert.equal(new Set(walked).size, 3, `walked over ${walked}`);
  await page.keyboard.press('[');
  await settled(page);
  assert.equal((await selectedOf(page))[0].id, walked[1]);
  await page.keyboard.press('Escape');
  await settled(page);
  assert.deepEqual(await selectedOf(page), []);
});

pageTest('Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y undo and redo, on the stage and off it', {}, async (page) => {
  const start = await documentOf(page);
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [40, 12]));
  const dragged = await documentOf(page);
  const objectsAre = async (expected, keys) => {
    await page.keyboard.press(keys);
    await settled(page);
    assert.deepEqual((await documentOf(page)).objects, expected.objects, keys);
  };
  await objectsAre(start, 'Control+z');
  await objectsAre(dragged, 'Control+Shift+Z');
  await objectsAre(start, 'Control+z');
  await objectsAre(dragged, 'Control+y');
  await page.keyboard.press('Tab');
  assert.notEqual(await focused(page), 'stage');
  await objectsAre(start, 'Control+z');
  await objectsAre(dragged, 'Control+Shift+Z');
});

pageTest('space plays and pauses, plus and minus zoom, 0 frames', {}, async (page) => {
  await tabToStage(page);
  const playing = async () => (await documentOf(page)).animation.playing;
  const was = await playing();
  await page.keyboard.press(' ');
  await page.waitForFunction((was) => window.knotwork.document().animation.playing !== was, was);
  await page.keyboard.press(' ');
  await page.waitForFunction((was) => window.knotwork.document().animation.playing === was, was);
  for (let k = 0; k < 4; ++k) await page.keyboard.down(' ');  // held: one press, and its repetitions
  await page.keyboard.up(' ');
  await page.waitForFunction((was) => window.knotwork.document().animation.playing !== was, was);
  await page.keyboard.press(' ');
  await page.waitForFunction((was) => window.knotwork.document().animation.playing === was, was);
  assert.equal(await page.evaluate(() => scrollY), 0, 'space has scrolled the page');

  const away = async () => (await documentOf(page)).camera.distance;
  const start = await away();
  await page.keyboard.press('+');
  await settled(page);
  const closer = await away();
  assert.ok(closer < start);
  for (let k = 0; k < 4; ++k) await page.keyboard.press('-');
  await settled(page);
  assert.ok((await away()) > start);
  await page.keyboard.press('0');
  await settled(page);
  assert.ok(Math.abs((await away()) / start - 1) < 0.6);
});

pageTest('the list of patches selects one for the keys', {}, async (page) => {
  const list = page.getByRole('combobox', { name: 'Selected patch' });
  const { locals } = await surfaceOf(page);
  assert.equal(await list.getByRole('option').count(), locals.u * locals.v + 1);
  await list.selectOption({ index: 3 });
  await settled(page);
  const [handle] = await selectedOf(page);
  assert.equal(handle.id, await list.inputValue());
  await page.locator('#blending-surface').getByRole('button', { name: 'move it with the keys' }).click();
  assert.equal(await focused(page), 'stage');
  await page.keyboard.press('PageUp');
  await settled(page);
  assert.equal((await surfaceOf(page)).patches.length, 1);
  const front = await frontHandle(page);
  await page.mouse.click(...front.screen);
  await settled(page);
  assert.equal(await list.inputValue(), (await selectedOf(page))[0].id, 'the list does not follow the stage');
  assert.equal(await call(page, 'handles').then((all) => all.filter((h) => h.selected).length), 1);
});
