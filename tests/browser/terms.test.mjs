// While a hand moves something on the stage, the letters that denote it light up in the formulas of its chapter.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import { call, frameDrawn, handleAt, plus, scrollTo, settled, stageRect, until, widget } from './stage.mjs';

const whole = { followed: true, full: true, scale: 0.5, size: [1440, 900] };

async function bringUp(page, id) {
  await scrollTo(page, `#figure-${id}`);
  await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
  await settled(page);
}

/// What the symbols that are lit denote, and in which chapters they are.
const litNow = (page) =>
  page.evaluate(() => {
    const all = [...document.querySelectorAll('.prose [class*="of-"]')];
    const marked = all.filter(({ className }) => /\bof-\w+/.test(className));
    const lit = marked.filter((symbol) => getComputedStyle(symbol).borderBottomStyle === 'solid');
    return {
      kinds: [...new Set(lit.map((symbol) => /\bof-(\w+)/.exec(symbol.className)[1]))],
      chapters: [...new Set(lit.map((symbol) => symbol.closest('article').id))],
    };
  });

/// Where everything stands that a change of the formulas could move.
const layout = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('article p, .katex .base')].map((element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return [x, y, width, height].join(' ');
    }));

const at = {
  handle: (id) => async (page) => (await handleAt(page, id)).screen,
  panel: (label) => async (page) => (await widget(page, label)).centre,
};

/// What is taken of which figure, and what it is in the formulas of which chapter.
const holds = [
  ['de-casteljau', at.handle('point-1'), 'point', 'bezier-curves'],
  ['de-casteljau', at.handle('parameter'), 'parameter', 'bezier-curves'],
  ['uneven-knots', at.handle('point-4'), 'point', 'bsplines'],
  ['uneven-knots', at.panel('knot 9'), 'knot', 'bsplines'],
  ['circle-six', at.handle('point-3'), 'datum', 'fitting'],
  ['by-hand', at.handle('point-1'), 'datum', 'subdivision-curves'],
  ['ten-locals', at.handle('local-7'), 'local', 'blending-splines'],
  ['control-net', at.handle('point-3-2'), 'point', 'tensor-surfaces'],
  ['one-patch-pulled', at.handle('patch-2-1'), 'local', 'blending-surface'],
];

for (const [figure, place, kind, chapter] of holds) {
  pageTest(`of ${figure}, what is held is lit: ${kind}`, whole, async (page) => {
    await bringUp(page, figure);
    const before = await layout(page);
    const from = await place(page);
    await page.mouse.move(...from);
    assert.deepEqual((await litNow(page)).kinds, [], 'under a pointer that only comes by');
    await page.mouse.down();
    await page.mouse.move(...plus(from, [-8, -6]), { steps: 3 });
    await frameDrawn(page);
    await page.mouse.move(...plus(from, [-16, -8]), { steps: 2 });
    await until(page, () => document.querySelector('article[data-in-hand]'));
    // What is folded away comes to its tint when it is unfolded.
    await until(page, (name) =>
      [...document.querySelectorAll(`[data-in-hand] .of-${name}`)].every(
        (symbol) => !symbol.checkVisibility() || getComputedStyle(symbol).backgroundColor !== 'rgba(0, 0, 0, 0)',
      ), kind);
    assert.deepEqual(await litNow(page), { kinds: [kind], chapters: [chapter] });
    assert.deepEqual(await layout(page), before, 'nothing moves');
    await page.mouse.up();
    assert.deepEqual((await litNow(page)).kinds, []);
  });
}

pageTest('who turns the view holds nothing', whole, async (page) => {
  await bringUp(page, 'ten-locals');
  const { x, y } = await stageRect(page);
  const free = [x + 40, y + 300];
  const { azimuth } = (await call(page, 'document')).camera;
  await page.mouse.move(...free);
  await page.mouse.down();
  await page.mouse.move(...plus(free, [60, 20]), { steps: 5 });
  await frameDrawn(page);
  assert.notEqual((await call(page, 'document')).camera.azimuth, azimuth);
  assert.deepEqual((await litNow(page)).kinds, []);
  await page.mouse.up();
});

pageTest('the light comes at once for those who want no motion', { ...whole, reducedMotion: true }, async (page) => {
  await bringUp(page, 'de-casteljau');
  const { screen } = await handleAt(page, 'point-1');
  await page.mouse.move(...screen);
  await page.mouse.down();
  await page.mouse.move(...plus(screen, [-8, -6]), { steps: 3 });
  await frameDrawn(page);
  await page.mouse.move(...plus(screen, [-16, -8]), { steps: 2 });
  await until(page, () => document.querySelector('article[data-in-hand]'));
  const durations = await page.locator('[data-in-hand] .of-point').evaluateAll((all) =>
    all.map((symbol) => getComputedStyle(symbol).transitionDuration));
  assert.deepEqual([...new Set(durations)], ['0s']);
  await page.mouse.up();
});
