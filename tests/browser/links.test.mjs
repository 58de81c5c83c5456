// Links: all lead somewhere, and a reader who follows them and comes back is where he was.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import { shownFigure, until } from './stage.mjs';

const whole = { followed: true, full: true, scale: 0.5, size: [1440, 900] };

pageTest('every reference on the page has its target, and no name stands twice', whole, async (page) => {
  const faults = await page.evaluate(() => {
    const found = [];
    const names = [...document.querySelectorAll('[id]')].map(({ id }) => id);
    for (const name of new Set(names.filter((id, k) => names.indexOf(id) !== k))) found.push(`two are called ${name}`);
    const known = new Set(names);
    const lists = ['aria-describedby', 'aria-labelledby', 'aria-controls', 'aria-owns', 'for', 'headers', 'list'];
    for (const list of lists)
      for (const element of document.querySelectorAll(`[${list}]`))
        for (const id of element.getAttribute(list).split(/\s+/).filter(Boolean))
          if (!known.has(id)) found.push(`${list} of ${element.tagName} names ${id}`);
    for (const link of document.querySelectorAll('a')) {
      const target = link.getAttribute('href') ?? '';
      const words = link.textContent.trim() || link.ariaLabel || '';
      if (!words) found.push(`the link to ${target} has no words`);
      const { protocol, origin, hash, hostname, username } = link;
      if (target.startsWith('#')) {
        if (!known.has(decodeURIComponent(hash.slice(1)))) found.push(`${target} leads nowhere`);
      } else if (origin !== location.origin) {
        const open = protocol === 'https:' && /^[a-z\d-]+(\.[a-z\d-]+)+$/.test(hostname) && !username;
        if (!open) found.push(`${target} is no address of the open web`);
      }
    }
    return found;
  });
  assert.deepEqual(faults, []);
});

pageTest('every file that the page links to is there', {}, async (page) => {
  const files = await page.evaluate(() => {
    const links = [...document.querySelectorAll('a[href], link[href]')].map(({ href }) => href.split('#')[0]);
    return [...new Set(links)].filter((href) => new URL(href).origin === location.origin);
  });
  for (const file of files) assert.equal((await page.request.get(file)).status(), 200, file);
});

/// A click of the mouse where something stands: Playwright's own would scroll the page first.
async function clickOn(page, selector) {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
}

const placeOf = (page, id) => page.evaluate((name) => document.getElementById(name).getBoundingClientRect().top, id);

/// The head of a chapter has come to the top of the window, and what is there comes to the stage.
async function arrived(page, { id, figure }) {
  await until(page, (name) => {
    const { top } = document.getElementById(name).getBoundingClientRect();
    return top >= 0 && top < 0.25 * innerHeight;
  }, id);
  if (figure) await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, figure);
}

const chaptersOf = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('[data-chapter]')].map((chapter) => ({
      id: chapter.id,
      figure: chapter.querySelector('[data-figure]')?.dataset.figure ?? null,
      next: chapter.querySelector('a[rel="next"]')?.hash ?? null,
      before: chapter.querySelector('a[rel="prev"]')?.hash ?? null,
    })),
  );

pageTest('each chapter in the list leads to its head and its first figure; back leads back', whole, async (page) => {
  const chapters = await chaptersOf(page);
  assert.ok(chapters.length > 8, `${chapters.length} chapters`);
  for (const chapter of chapters) {
    await clickOn(page, '#contents summary');
    await clickOn(page, `#contents a[href="#${chapter.id}"]`);
    await arrived(page, chapter);
    assert.ok(page.url().endsWith(`#${chapter.id}`));
  }
  for (const chapter of chapters.slice(-5, -1).reverse()) {
    await page.goBack();
    await arrived(page, chapter);
    assert.ok(page.url().endsWith(`#${chapter.id}`));
  }
  await page.goForward();
  await arrived(page, chapters.at(-4));
});

pageTest('at its end each chapter leads to the one before and the next', whole, async (page) => {
  const chapters = await chaptersOf(page);
  const hash = (chapter) => (chapter ? `#${chapter.id}` : null);
  chapters.forEach(({ id, next, before }, k) => {
    assert.deepEqual([before, next], [hash(chapters[k - 1]), hash(chapters[k + 1])], id);
  });
  const [, second, third] = chapters;
  for (const [from, relation, to] of [[second, 'next', third], [third, 'prev', second]]) {
    const link = `#${from.id} a[rel="${relation}"]`;
    await page.locator(link).evaluate((element) => element.scrollIntoView({ block: 'center', behavior: 'instant' }));
    await until(page, (selector) => {
      const { top, bottom } = document.querySelector(selector).getBoundingClientRect();
      return top > 0 && bottom < innerHeight;
    }, link);
    await clickOn(page, link);
    await arrived(page, to);
  }
});

pageTest('a link to a chapter leads there from outside', whole, async (page) => {
  const chapter = (await chaptersOf(page)).find(({ id }) => id === 'tensor-surfaces');
  const address = page.url().split('#')[0];
  await page.goto('about:blank');
  await page.goto(`${address}#${chapter.id}`);
  await page.evaluate(() => window.knotwork.ready);
  await arrived(page, chapter);
  const place = await placeOf(page, chapter.id);
  // The reader's own way back is not lost: a reload stays there.
  await page.reload();
  await page.evaluate(() => window.knotwork.ready);
  await arrived(page, chapter);
  assert.ok(Math.abs((await placeOf(page, chapter.id)) - place) < 2);
  assert.equal(await shownFigure(page), chapter.figure);
});
