// Links: all lead somewhere, and a reader who follows them and comes back is where he was.
import assert from 'node:assert/strict';
import { deflateRawSync } from 'node:zlib';
import { pageTest } from './page_test.mjs';
import {
  call, documentOf, drag, frameDrawn, handleAt, handlesOf, nextUndo, parameter, plus, scrollTo, settled, shownFigure,
  until,
} from './stage.mjs';

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

// --- Addresses of figures --------------------------------------------------------------------------------------------

/// The clipboard as the page uses it, and no other program's: what was written last is window.copied.
const keepCopies = (page) =>
  page.addInitScript(() => {
    Object.defineProperty(navigator, 'clipboard', {
      value: { writeText: async (text) => void (window.copied = text) },
      configurable: true,
    });
  });
const noClipboard = (page) =>
  page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
const copying = { ...whole, before: keepCopies };

async function bringUp(page, id) {
  await scrollTo(page, `#figure-${id}`);
  await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
  await settled(page);
}

/// The address that "Copy link" under a figure gives.
async function linkOf(page, id) {
  await page.evaluate(() => (window.copied = ''));
  await page.locator(`#figure-${id} [data-copy]`).evaluate((button) => button.click());
  await until(page, () => window.copied !== '');
  return page.evaluate(() => window.copied);
}

/// Comes to an address from elsewhere, as a reader does who has been sent it.
async function arrive(page, address) {
  await page.goto('about:blank');
  await page.goto(address);
  await page.evaluate(() => window.knotwork.ready);
}

/// The figure is on the stage and in the window, and the state of the address has come.
async function shows(page, id, steps = 'false') {
  await until(page, ([name, possible]) =>
    document.querySelector('[data-shown]')?.dataset.figure === name &&
    document.getElementById('undo').getAttribute('aria-disabled') === possible, [id, steps]);
  await settled(page);
  const top = await placeOf(page, `figure-${id}`);
  assert.ok(top >= 0 && top < 400, `the figure ${id} is at ${top}`);
}

const again = (page, id) => page.locator(`#figure-${id} [data-again]`).evaluate((button) => button.click());
const objectsOf = async (page) => (await documentOf(page)).objects;

/// States of figures of different kinds, made by parameters alone.
const settings = {
  'uneven-knots': { 'curve.topology': 'closed', 'display.polygon': false },
  'circle-six': { 'fitted.count': 8, 'fitted.parameters': 'chordLength' },
  'by-hand': { 'curve.degree': 2, 'subdivision.step': 1 },
  'one-patch-pulled': { 'topology.v': 'open', 'locals.u': 5 },
};

pageTest('a link to a figure carries the parameters that were set, and no more', copying, async (page) => {
  for (const [id, values] of Object.entries(settings)) {
    await bringUp(page, id);
    assert.equal(new URL(await linkOf(page, id)).hash, `#figure-${id}`, 'at its start');
    for (const [name, value] of Object.entries(values)) await call(page, 'set', name, value);
    await settled(page);
    const steps = await nextUndo(page);
    const document = await documentOf(page);
    const link = await linkOf(page, id);
    const said = Object.fromEntries(new URLSearchParams(new URL(link).hash.split('?')[1]));
    for (const [name, value] of Object.entries(values)) assert.equal(said[name], String(value), `${id}: ${name}`);
    assert.equal(said.document, undefined, `${id}: ${link}`);
    // The view may be fitted anew, as it is when one comes back to a figure.
    const after = { ...(await documentOf(page)), camera: document.camera };
    assert.deepEqual(after, document, 'making a link changes nothing');
    assert.equal(await nextUndo(page), steps);
    settings[id].link = link;
    settings[id].objects = document.objects;
  }
  for (const [id, { link, objects, ...values }] of Object.entries(settings)) {
    await arrive(page, link);
    await shows(page, id);
    for (const [name, value] of Object.entries(values)) assert.equal((await parameter(page, name)).value, value, name);
    assert.deepEqual(await objectsOf(page), objects, id);
    // It is the reader's own: one step back is the figure as the chapter has it.
    await call(page, 'undo');
    assert.match(await nextUndo(page), /true/);
    assert.equal(new URL(await linkOf(page, id)).hash, `#figure-${id}`);
  }
});

for (const [id, handle] of [['uneven-knots', 'point-4'], ['one-patch-pulled', 'patch-2-1']]) {
  pageTest(`what a hand has moved comes with the link: ${handle}`, copying, async (page) => {
    await bringUp(page, id);
    const { objects: start } = await documentOf(page);
    const { screen } = await handleAt(page, handle);
    await drag(page, screen, plus(screen, [24, -18]));
    await settled(page);
    const document = await documentOf(page);
    const { objects } = document;
    assert.notDeepEqual(objects, start);
    const selected = (await handlesOf(page)).find((row) => row.selected)?.id;
    const link = await linkOf(page, id);
    assert.match(new URL(link).hash, new RegExp(`^#figure-${id}\\?document=[\\w-]+$`));
    assert.ok(link.length < 1500, `${link.length} characters`);
    await settled(page);
    assert.deepEqual(await documentOf(page), document);
    assert.equal((await handlesOf(page)).find((row) => row.selected)?.id, selected, 'the selection stays');
    await arrive(page, link);
    await shows(page, id);
    assert.deepEqual(await objectsOf(page), objects);
    await again(page, id);
    await settled(page);
    assert.deepEqual(await objectsOf(page), start);
  });
}

pageTest('a link to a figure that has made room carries it as it was left', copying, async (page) => {
  await bringUp(page, 'de-casteljau');
  await call(page, 'set', 'curve.parameter', 0.7);
  await bringUp(page, 'circle-six');
  const before = await documentOf(page);
  const { hash } = new URL(await linkOf(page, 'de-casteljau'));
  assert.equal(hash, '#figure-de-casteljau?curve.parameter=0.7');
  assert.deepEqual(await documentOf(page), before);
  assert.equal(await shownFigure(page), 'circle-six');
});

pageTest('addresses are followed while the page is open, back and forth', copying, async (page) => {
  const go = (hash) => page.evaluate((to) => void (location.hash = to), hash);
  const value = async () => (await parameter(page, 'curve.parameter')).value;
  await go('#figure-de-casteljau?curve.parameter=0.7');
  await shows(page, 'de-casteljau');
  assert.equal(await value(), 0.7);
  await go('#figure-circle-six?fitted.count=8');
  await shows(page, 'circle-six');
  await go('#figure-de-casteljau?curve.parameter=0.2');
  await shows(page, 'de-casteljau');
  assert.equal(await value(), 0.2);
  await page.goBack();
  await shows(page, 'circle-six');
  assert.equal((await parameter(page, 'fitted.count')).value, 8);
  // What the reader has done since is not taken from him by coming back.
  await call(page, 'set', 'fitted.count', 9);
  await page.goBack();
  await shows(page, 'de-casteljau');
  await until(page, () => window.knotwork.parameters().find(({ id }) => id === 'curve.parameter').value === 0.7);
  await page.goForward();
  await shows(page, 'circle-six');
  assert.equal((await parameter(page, 'fitted.count')).value, 9);
});

pageTest('a reload keeps the place in the page', copying, async (page) => {
  await arrive(page, `${page.url().split('#')[0]}#figure-de-casteljau?curve.parameter=0.7`);
  await shows(page, 'de-casteljau');
  await bringUp(page, 'circle-six');
  const place = await placeOf(page, 'figure-circle-six');
  await page.reload();
  await page.evaluate(() => window.knotwork.ready);
  await settled(page);
  assert.ok(Math.abs((await placeOf(page, 'figure-circle-six')) - place) < 2);
});

const packedText = (text) => deflateRawSync(Buffer.from(text)).toString('base64url');

/// Addresses that ask for what cannot be, and what is said about each.
const badStates = [
  ['curve.parameter=7', /^What this address asks for cannot be shown\. curve\.parameter: Must be .* from 0 to 1\.$/],
  ['curve.parameter=0.7&curve.parameter=open', /./],
  ['curve.parameter=0.7&no.such=1', /no parameter of this name/],
  ['curve.parameter=NaN', /./],
  ['constructor=1', /no parameter of this name/],
  ['<img src=x onerror=alert(1)>=1', /no parameter of this name/],
  ['document=', /cannot be read/],
  ['document=%%%', /cannot be read/],
  ['document=abcd', /cannot be read/],
  [`document=${packedText('{"format":"knotwork"')}`, /./],
  [`document=${packedText('{"format":"knotwork","version":1,"objects":[]}')}`, /./],
];

pageTest('a state that cannot be is refused with its reason; the figure is the chapter\'s', copying, async (page) => {
  const address = page.url().split('#')[0];
  const said = page.locator('.said');
  const say = async (words) => {
    await until(page, () => document.querySelector('.said:not([hidden]) p'));
    assert.match(await said.textContent(), words);
    assert.equal(await page.locator('#notice').textContent(), await said.textContent());
  };
  await bringUp(page, 'de-casteljau');
  const start = await objectsOf(page);
  await bringUp(page, 'circle-six');
  const other = packedText(JSON.stringify(await documentOf(page)));
  await page.goto('about:blank');
  for (const [query, words] of [...badStates, [`document=${other}`, /another figure/]]) {
    await page.goto(`${address}#figure-de-casteljau?${query}`);
    await page.evaluate(() => window.knotwork.ready);
    await say(words);
    await page.evaluate(() => (document.querySelector('.said').hidden = true));
    await shows(page, 'de-casteljau', 'true');
    assert.deepEqual(await objectsOf(page), start, query);
  }
  await page.goto(`${address}#figure-of-nothing?a=1`);
  await say(/^There is no figure "of-nothing" on this page\.$/);
});

const refusing = { ...whole, before: noClipboard };

pageTest('a clipboard that refuses leaves the address to be copied by hand', refusing, async (page) => {
  await bringUp(page, 'de-casteljau');
  await call(page, 'set', 'curve.parameter', 0.7);
  const button = page.locator('#figure-de-casteljau [data-copy]');
  await button.focus();
  await page.keyboard.press('Enter');
  const field = page.getByLabel('The link, to be copied by hand');
  await field.waitFor();
  const [value, marked] = await field.evaluate((input) =>
    [input.value, input.value.slice(input.selectionStart, input.selectionEnd)]);
  assert.match(value, /^http.*#figure-de-casteljau\?curve\.parameter=0\.7$/);
  assert.equal(marked, value);
  assert.ok(await field.evaluate((input) => input === document.activeElement));
  await page.keyboard.press('Escape');
  assert.ok(await field.isHidden());
  assert.ok(await button.evaluate((element) => element === document.activeElement));
});

pageTest('the browser\'s own clipboard takes the link', whole, async (page, { context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await bringUp(page, 'circle-six');
  await page.locator('#figure-circle-six [data-copy]').click();
  await until(page, () => document.querySelector('.said:not([hidden]) p'));
  assert.match(await page.evaluate(() => navigator.clipboard.readText()), /#figure-circle-six$/);
  assert.equal(await page.locator('#notice').textContent(), 'The link has been copied.');
});

pageTest('an address does not solve an exercise; who has left its state can', copying, async (page) => {
  const id = 'seven-will-do';
  const solved = () => page.evaluate((name) => 'solved' in document.getElementById(`figure-${name}`).dataset, id);
  const values = { 'curve.topology': 'closed', 'fitted.count': 7, 'fitted.parameters': 'chordLength' };
  const address = page.url().split('#')[0];
  await arrive(page, `${address}#figure-${id}?${new URLSearchParams(values)}`);
  await shows(page, id);
  for (const [name, value] of Object.entries(values)) assert.equal((await parameter(page, name)).value, value);
  const stays = async (what) => {
    await frameDrawn(page);
    assert.equal(await solved(), false, what);
  };
  await stays('as it came');
  await call(page, 'set', 'display.polygon', false);
  await stays('by what does not matter');
  await call(page, 'undo');
  await call(page, 'undo');
  await stays('at the start');
  await call(page, 'redo');
  await stays('by the address\'s own step');
  await call(page, 'set', 'fitted.count', 9);
  await call(page, 'undo');
  await stays('by taking a step back');
  await call(page, 'set', 'fitted.count', 9);
  await call(page, 'set', 'fitted.count', 7);
  await until(page, (name) => 'solved' in document.getElementById(`figure-${name}`).dataset, id);
});

pageTest('an address that a reader has gone on from counts what he does', copying, async (page) => {
  const id = 'seven-will-do';
  const address = page.url().split('#')[0];
  await arrive(page, `${address}#figure-${id}?curve.topology=closed&fitted.count=9`);
  await shows(page, id);
  await call(page, 'set', 'fitted.parameters', 'chordLength');
  await call(page, 'set', 'fitted.count', 7);
  await until(page, (name) => 'solved' in document.getElementById(`figure-${name}`).dataset, id);
});

pageTest('who wants no motion gets none from an address', { ...copying, reducedMotion: true }, async (page) => {
  await arrive(page, `${page.url().split('#')[0]}#figure-ten-locals?locals.count=8&animation.playing=true`);
  await shows(page, 'ten-locals');
  assert.equal((await parameter(page, 'animation.playing')).value, false);
});

// --- Signs beside headings -------------------------------------------------------------------------------------------

for (const [name, size] of [['desktop', [1440, 900]], ['narrow', [1040, 800]], ['phone', [390, 844]]]) {
  const touch = name === 'phone';
  const screen = { ...whole, size, touch };
  pageTest(`every heading has a sign that leads to it, and it takes no room: ${name}`, screen, async (page) => {
    const headings = page.locator('.prose :is(h1, h2)');
    const faults = await headings.evaluateAll((all) =>
      all.flatMap((heading) => {
        const sign = heading.querySelector('a.place');
        if (!sign) return [`none beside ${heading.textContent}`];
        const { left, right, width, height } = sign.getBoundingClientRect();
        const target = document.getElementById(sign.hash.slice(1));
        const wrong = target !== heading && target !== heading.parentElement;
        const away = left < 0 || right > heading.getBoundingClientRect().left || width < 16 || height < 24;
        const { textContent: words } = heading;
        return [wrong && `${sign.hash} beside ${words}`, away && `${left} to ${right}: ${words}`];
      }).filter(Boolean));
    assert.deepEqual(faults, []);
    assert.ok((await headings.count()) > 50);
    await scrollTo(page, '#the-weights');
    const sign = page.locator('#the-weights .place');
    const seen = async () => {
      await settled(page);
      return Number(await sign.evaluate((element) => getComputedStyle(element).opacity));
    };
    if (touch) return assert.ok((await seen()) > 0.4);
    assert.equal(await seen(), 0);
    await page.locator('#the-weights').hover();
    assert.equal(await seen(), 1);
    await page.mouse.move(1, 1);
    assert.equal(await seen(), 0);
    await sign.evaluate((element) => element.focus({ focusVisible: true }));
    assert.equal(await seen(), 1);
  });
}

pageTest('the sign beside a heading copies the address, and says so', copying, async (page) => {
  await arrive(page, page.url());
  await scrollTo(page, '#the-weights');
  await page.locator('#the-weights').hover();
  await clickOn(page, '#the-weights .place');
  await until(page, () => window.copied);
  assert.match(await page.evaluate(() => window.copied), /^http.*\/#the-weights$/);
  assert.equal(await page.evaluate(() => window.copied), page.url());
  assert.equal(await page.locator('.said').textContent(), 'The link has been copied.');
  assert.equal(await page.locator('#notice').textContent(), 'The link has been copied.');
  assert.ok((await placeOf(page, 'the-weights')) < 200);
  await page.evaluate(() => (window.copied = ''));
  await page.locator('#the-weights .place').focus();
  await page.keyboard.press('Enter');
  await until(page, () => window.copied);
});
