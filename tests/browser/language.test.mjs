// The page in a pseudo-language, English in a disguise: what shows without its accents could not be translated, and its
// words are two fifths longer than ours, as other languages' are. The words on the canvas are English in every language.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { serve } from '../../shell/scripts/static.mjs';
import { pageTest } from './page_test.mjs';
import { call } from './stage.mjs';

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
