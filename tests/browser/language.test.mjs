// The page in a pseudo-language, English in a disguise: what shows without its accents could not be translated, and its
// words are two fifths longer than ours, as other languages' are. Of the canvas, the disguised page keeps in
// `window.heard` what has been drawn.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { serve } from '../../shell/scripts/static.mjs';
import { pageTest } from './page_test.mjs';
import { call, clickWidget, frameDrawn, settled, stageRect, widget } from './stage.mjs';

const folder = fileURLToPath(new URL('../../build/pseudo-site', import.meta.url));
assert.ok(existsSync(join(folder, 'index.html')), 'there is no page in the pseudo-language: tests/run site builds it');
const server = await serve(folder, 0);
const address = `http://localhost:${server.address().port}/`;
after(() => {
  server.closeAllConnections();
  server.close();
});

/// Texts and spoken attributes of the page that have words (two letters in a row) and no disguise at all: of a text put
/// together from parts, one disguised part hides the others.
const undisguised = (page) =>
  page.evaluate(() => {
    const bare = (text) => /[A-Za-z]{2}/.test(text) && !/[áéíóúýçñÁÉÍÓÚÇÑ·]/.test(text);
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode())
      if (!node.parentElement.closest('.katex, pre, code, script, noscript, svg, textarea') && bare(node.data))
        found.push(node.data.trim());
    for (const element of document.querySelectorAll('[aria-label], [title], [alt], [aria-valuetext]'))
      for (const name of ['aria-label', 'title', 'alt', 'aria-valuetext'])
        if (bare(element.getAttribute(name) ?? '')) found.push(`${name}: ${element.getAttribute(name)}`);
    return [...new Set(found)].filter((text) => text !== 'Knotwork');
  });

const unfold = (page) =>
  page.evaluate(() => document.querySelectorAll('details').forEach((details) => (details.open = true)));

pageTest('nothing that the page says stays English in another language', { address, followed: true }, async (page) => {
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'en-XA');
  assert.ok((await page.locator('article').count()) > 9);
  const opened = await page.evaluate(() => window.knotwork.chapters().map(({ id }) => id));
  for (const id of opened) {
    await call(page, 'open', id);
    await unfold(page);
    assert.deepEqual(await undisguised(page), [], id);
  }
  // What is said of an action, and of a refusal.
  await call(page, 'open', 'least-squares');
  await unfold(page);
  await page.locator('#points-text').fill('1, 2\n1, x');
  await page.locator('.points .button').first().click();
  await page.waitForFunction(() => document.getElementById('points-fault').textContent !== '');
  await call(page, 'set', 'curve.degree', 2);
  assert.deepEqual(await undisguised(page), []);
  // And of addresses: one that cannot be copied, or followed.
  await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
  await page.locator('[data-copy]').first().click();
  await page.locator('.said label').waitFor();
  assert.deepEqual(await undisguised(page), []);
  for (const hash of ['#figure-of-nothing?a=1', '#figure-hold-it?document=x']) {
    await page.evaluate((to) => {
      document.querySelector('.said').hidden = true;
      location.hash = to;
    }, hash);
    await page.locator('.said p').waitFor();
    assert.deepEqual(await undisguised(page), []);
  }
});

/// What the canvas has drawn since this was last asked, and which of it has words and no disguise.
async function drawn(page) {
  await settled(page);
  const heard = await page.evaluate(() => {
    const words = [...window.heard];
    window.heard.clear();
    return words;
  });
  return { heard, bare: heard.filter((text) => /[A-Za-z]{2}/.test(text) && !/[áéíóúýçñÁÉÍÓÚÇÑ·]/.test(text)) };
}

async function restOn(page, { x, y, width, height }) {
  await page.mouse.move(x + width / 2, y + height / 2);
  await frameDrawn(page);
}

/// Brings about what the figure on the stage can say: all that it shows, each shading, a handle that is held, what lies
/// under the pointer, the hints of the buttons, the open lists of choices, and a refusal.
async function sayAll(page, touch) {
  const rows = await call(page, 'parameters');
  // Drawn in software, the surface is what takes time.
  for (const { id } of rows) if (/^samples\.[uv]$/.test(id)) await call(page, 'set', id, 8);
  for (const { id, kind, disabled } of rows)
    if (kind === 'toggle' && !disabled && id !== 'animation.playing') await call(page, 'set', id, true);
  for (const { id } of rows.find(({ id }) => id === 'display.shading')?.choices ?? []) {
    await call(page, 'set', 'display.shading', id);
    await settled(page);
  }
  if (rows.some(({ id }) => id === 'display.surface')) await call(page, 'set', 'display.surface', false);
  await page.locator('canvas').focus();
  await page.keyboard.press(']');
  if (touch) return clickWidget(page, 'controls');
  const stage = await stageRect(page);
  for (const [x, y] of [[0.3, 0.4], [0.35, 0.3], [0.25, 0.5]])
    await restOn(page, { x: stage.x + x * stage.width, y: stage.y + y * stage.height, width: 0, height: 0 });
  await clickWidget(page, 'more');
  await settled(page);
  const widgets = (await call(page, 'widgets')).map(({ label }) => label);
  // What has hints of its own is no row of the table.
  for (const label of widgets)
    if (!/knot|basis|: /.test(label) && !rows.some(({ id }) => id === label)) await restOn(page, await widget(page, label));
  for (const { id } of rows.filter(({ id, kind }) => kind === 'choice' && widgets.includes(id))) {
    await clickWidget(page, id);
    await settled(page);
    await page.keyboard.press('Escape');
    await settled(page);
  }
  await assert.rejects(call(page, 'set', 'no.such.parameter', 1));
}

const chapters = [
  'blending-surface', 'bezier-curve', 'bspline-curve', 'tensor-surface', 'model-surface', 'least-squares', 'subdivision',
  'model-curve', 'blending-curve',
];
for (const id of chapters) {
  for (const [device, touch, size] of [['desktop', false, [1040, 860]], ['phone', true, [390, 844]]]) {
    const options = { address, reducedMotion: true, touch, size };
    pageTest(`nothing that the canvas says of a ${id} stays English: ${device}`, options, async (page) => {
      await call(page, 'open', id);
      await drawn(page);  // and what another figure has said before is forgotten
      await sayAll(page, touch);
      const { heard, bare } = await drawn(page);
      assert.deepEqual(bare, []);
      assert.ok(heard.filter((text) => /·/.test(text)).length > (touch ? 6 : 16), `it says: ${heard.join('; ')}`);
    });
  }
}

for (const [name, size] of [['desktop', [1440, 900]], ['tablet', [1024, 768]], ['phone', [390, 844]]]) {
  pageTest(`longer words have room: ${name}`, { address, size }, async (page) => {
    await unfold(page);
    const wide = await page.evaluate(() =>
      [...document.querySelectorAll('body *')]
        .filter((element) => {
          if (element.closest('.hidden, svg, pre, .formula, .stage')) return false;
          const { right, width } = element.getBoundingClientRect();
          return width > 0 && right > innerWidth + 1;
        })
        .map((element) => `${element.tagName}.${element.className}: ${element.textContent.slice(0, 40)}`),
    );
    assert.deepEqual(wide, []);
    assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth <= innerWidth));
  });
}
