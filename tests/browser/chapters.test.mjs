// The chapters: every figure comes to the stage, every phrase does what it says, exercises notice that they are solved.
import assert from 'node:assert/strict';
import { pullPatch } from './examples/pull_patch.mjs';
import { pageTest } from './page_test.mjs';
import {
  call, documentOf, drag, handlesOf, nextUndo, parameter, plus, scrollTo, settled, shownFigure, stageRect, until,
} from './stage.mjs';

const whole = { followed: true, full: true, scale: 0.5 };

/// What an element's data say about the figure's start.
const figures = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('[data-figure]')].map(({ dataset }) => ({
      id: dataset.figure,
      start: dataset.start,
      values: [...new URLSearchParams(dataset.values)],
      goal: dataset.goal ?? null,
    })),
  );

/// What the prose asks for so that the reader sees it refused.
const refused = new Set(['set?fitted.count=11']);

const same = (now, said) => String(now) === said || Number(now) === Number(said);

pageTest('every figure comes to the stage as it is declared, and no exercise is solved at its start', whole, async (page) => {
  const all = await figures(page);
  assert.ok(all.length > 30, `${all.length} figures`);
  for (const { id, start, values, goal } of all) {
    await scrollTo(page, `#figure-${id}`);
    await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
    for (const [name, value] of values) {
      const { value: now } = await parameter(page, name);
      assert.ok(same(now, value), `${id}: ${name} is ${now}, not ${value}`);
    }
    if (start !== 'file') {
      const own = await page.evaluate((chapter) => window.knotwork.chapters().some((row) => row.id === chapter), start);
      assert.ok(own, `${id} starts from ${start}`);
    }
    if (goal) {
      const solved = await page.evaluate((name) => document.getElementById(`figure-${name}`).dataset.solved, id);
      assert.equal(solved, undefined, `${id} is solved before anything is done`);
    }
    const undo = page.locator('#undo');
    assert.equal(await undo.getAttribute('aria-disabled'), 'true', `${id}: there is something to undo`);
  }
});

// The second is a small one, with its browser's bars in view.
for (const size of [[390, 844], [360, 640]]) {
  const phone = { ...whole, size, touch: true, scale: 0.5 };
  pageTest(`on a phone of ${size.join(' by ')} every handle of every figure is in reach`, phone, async (page) => {
    const covered = [];
    let seen = 0;
    for (const { id } of await figures(page)) {
      await scrollTo(page, `#figure-${id}`);
      await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
      if ((await documentOf(page)).animation.playing) await call(page, 'pause');
      await settled(page);
      const [stage, widgets, handles] = [await stageRect(page), await call(page, 'widgets'), await handlesOf(page)];
      for (const { id: handle, screen } of handles) {
        ++seen;
        const inside = ([x, y, w, h]) => screen[0] > x && screen[0] < x + w && screen[1] > y && screen[1] < y + h;
        const above = widgets.filter(({ rect }) => screen && inside(rect)).map(({ label }) => label);
        if (!screen || !inside([stage.x, stage.y, stage.width, stage.height])) above.push('the edge of the stage');
        if (above.length > 0) covered.push(`${id}: ${handle} lies under ${above.join(', ')}`);
      }
    }
    assert.ok(seen > 500, `${seen} handles`);
    assert.deepEqual(covered, []);
  });
}

pageTest('every phrase does to its figure what it says', whole, async (page) => {
  const phrases = page.locator('.prose [data-run]');
  const count = await phrases.count();
  assert.ok(count > 60, `${count} phrases`);
  for (let k = 0; k < count; ++k) {
    const phrase = phrases.nth(k);
    const words = `${await phrase.textContent()} (${await phrase.getAttribute('data-run')})`;
    const [name, query = ''] = (await phrase.getAttribute('data-run')).split('?');
    await phrase.evaluate((element) => element.scrollIntoView({ block: 'center', behavior: 'instant' }));
    await phrase.click();
    // Of one parameter set twice the last value counts.
    const wanted = name === 'set' ? Object.fromEntries(new URLSearchParams(query)) : { 'animation.playing': `${name === 'play'}` };
    if (refused.has(await phrase.getAttribute('data-run'))) {
      await page.waitForFunction(() => /b₅|basis function/.test(document.getElementById('notice').textContent));
      continue;
    }
    await page.waitForFunction(
      (pairs) => {
        const rows = new Map(window.knotwork.parameters().map((row) => [row.id, row.value]));
        return Object.entries(pairs).every(
          ([id, value]) => String(rows.get(id)) === value || Number(rows.get(id)) === Number(value),
        );
      },
      wanted,
      { timeout: 5000 },
    ).catch(() => assert.fail(`${words} does not do what it says`));
    if (wanted['animation.playing'] === 'true') await call(page, 'pause');
  }
});

for (const [name, size] of [['desktop', [1440, 900]], ['tablet', [1024, 768]], ['phone', [390, 844]]]) {
  pageTest(`no formula and no code is wider than its column: ${name}`, { size }, async (page) => {
    const wide = await page.evaluate(() =>
      [...document.querySelectorAll('.formula, .code, .prose table')]
        .filter((element) => {
          const room = element.closest('article').getBoundingClientRect();
          const parts = [element, ...element.querySelectorAll('.katex-html, .base')];
          return parts.some((part) => part.getBoundingClientRect().right > room.right + 1);
        })
        .map((element) => `${element.closest('article').id}: ${element.textContent.slice(0, 60)}`),
    );
    assert.deepEqual(wide, []);
  });
}

pageTest('a control beside the prose is of its own figure', { ...whole, size: [1440, 2600], scale: 0.25 }, async (page) => {
  await scrollTo(page, '#figure-three-rounds');
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'three-rounds');
  await page.locator('#figure-squeezed-span [data-show]').click();
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'squeezed-span');
  await settled(page);
  const other = await documentOf(page);
  const slider = await page.locator('#figure-three-rounds ~ .controls input[type=range]').first().boundingBox();
  await page.mouse.move(slider.x + 0.3 * slider.width, slider.y + slider.height / 2);
  await page.mouse.down();
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'three-rounds');
  for (const share of [0.5, 0.7, 0.8]) await page.mouse.move(slider.x + share * slider.width, slider.y + slider.height / 2);
  await page.mouse.up();
  await settled(page);
  const { start, end } = await page.evaluate(() => {
    const { min, max } = window.knotwork.parameters().find(({ id }) => id === 'curve.parameter');
    return { start: min, end: max };
  });
  const t = (await call(page, 'parameters')).find(({ id }) => id === 'curve.parameter').value;
  assert.ok(Math.abs(t - (start + 0.8 * (end - start))) < 0.05 * (end - start), `t is ${t}`);
  // All of the drag is one step, and nothing of it happened to the other figure.
  await call(page, 'undo');
  await settled(page);
  assert.ok((await call(page, 'parameters')).find(({ id }) => id === 'curve.parameter').value < t - 0.1);
  await page.locator('#figure-squeezed-span [data-show]').click();
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'squeezed-span');
  assert.deepEqual((await documentOf(page)).objects, other.objects);
});

pageTest('hats and bars stand over their letters', { size: [1440, 900] }, async (page) => {
  const accents = await page.evaluate(() =>
    [...document.querySelectorAll('.katex-html .accent')].map((accent) => {
      const middle = (element) => {
        const { left, right } = element.getBoundingClientRect();
        return (left + right) / 2;
      };
      const letter = accent.querySelector('.mord');
      const aside = middle(accent.querySelector('.accent-body .mord')) - middle(letter);
      return { formula: accent.textContent, aside: aside / letter.getBoundingClientRect().width };
    }),
  );
  assert.ok(accents.length > 10);
  assert.deepEqual(accents.filter(({ aside }) => Math.abs(aside) > 0.3), []);
});

pageTest('the stage goes with the reader, and what was done to a figure is there again', whole, async (page) => {
  const start = await shownFigure(page);
  await scrollTo(page, '#figure-de-casteljau');
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'de-casteljau');
  await settled(page);
  const [first] = await handlesOf(page);
  await drag(page, first.screen, plus(first.screen, [20, -25]));
  const edited = await documentOf(page);
  await scrollTo(page, '#figure-circle-six');
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'circle-six');
  assert.notEqual((await documentOf(page)).objects[0].kind, edited.objects[0].kind);
  assert.match(await page.locator('canvas').getAttribute('aria-describedby'), /^caption-circle-six /);
  await scrollTo(page, '#figure-de-casteljau');
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'de-casteljau');
  assert.deepEqual((await documentOf(page)).objects, edited.objects);
  // Its history is its own: one step back, and no more.
  await call(page, 'undo');
  const undone = await documentOf(page);
  assert.notDeepEqual(undone.objects, edited.objects);
  assert.match(await nextUndo(page), /true/);
  await call(page, 'redo');
  await page.locator('#figure-de-casteljau [data-again]').click();
  assert.deepEqual((await documentOf(page)).objects, undone.objects);
  assert.equal(start, 'hold-it');
});

pageTest('the script of the chapter "In code" does what the chapter says', { followed: true }, async (page) => {
  const at = await page.evaluate(`(${pullPatch})(window.knotwork)`);
  assert.deepEqual(Object.keys(at), ['S', 'Su', 'Sv']);
  const [surface] = (await documentOf(page)).objects;
  assert.equal(surface.locals.u, 8);
  assert.deepEqual(surface.patches.map(({ i, j, translation }) => [i, j, ...translation]), [[3, 0, 0, 0, 0.4]]);
});

pageTest('a link into a far chapter leads there, and the page does not move on', whole, async (page) => {
  const address = page.url();
  await page.goto('about:blank');
  await page.goto(`${address}#figure-circle-six`);
  const place = () => page.locator('#figure-circle-six').evaluate((element) => element.getBoundingClientRect().top);
  await page.waitForFunction(() => !document.documentElement.classList.contains('arriving'));
  const arrived = await place();
  assert.ok(arrived >= 0 && arrived < 400, `the figure is at ${arrived}`);
  await page.evaluate(() => window.knotwork.ready);
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'circle-six');
  await settled(page);
  assert.equal(await place(), arrived);
});

pageTest('what a script puts on the stage stays there until a figure is asked for', whole, async (page) => {
  const first = await documentOf(page);
  await call(page, 'open', 'tensor-surface');
  await settled(page);
  const own = await documentOf(page);
  assert.equal(await shownFigure(page), null);
  // The figure that had to give way is what it was.
  await page.locator('#figure-hold-it [data-show]').click();
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'hold-it');
  assert.deepEqual((await documentOf(page)).objects, first.objects);
  assert.match(await nextUndo(page), /true/);
  await assert.rejects(call(page, 'load', { nonsense: true }));
  assert.equal(await shownFigure(page), 'hold-it');
  await call(page, 'load', own);
  await scrollTo(page, '#figure-circle-six');
  await settled(page);
  assert.deepEqual((await documentOf(page)).objects, own.objects);
  await page.locator('#figure-circle-six [data-show]').click();
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'circle-six');
  assert.equal((await documentOf(page)).objects[0].kind, 'fittedCurve');
});

pageTest('an exercise is solved by hand, said, kept and forgotten', whole, async (page) => {
  await scrollTo(page, '#figure-seven-will-do');
  await until(page, () => document.querySelector('[data-shown]')?.dataset.figure === 'seven-will-do');
  const exercise = page.locator('#figure-seven-will-do');
  assert.equal(await exercise.getAttribute('data-solved'), null);
  const goal = await exercise.getAttribute('data-goal');
  assert.match(goal, /fitted\.count/);
  await call(page, 'set', 'curve.topology', 'closed');
  await call(page, 'set', 'fitted.count', 7);
  await call(page, 'set', 'fitted.parameters', 'chordLength');
  await until(page, () => document.getElementById('figure-seven-will-do').dataset.solved === '');
  assert.ok(await exercise.locator('.exercise-done').isVisible());
  assert.match(await page.locator('#notice').textContent(), /^Solved\./);
  await page.reload();
  await page.evaluate(() => window.knotwork.ready);
  assert.equal(await page.locator('#figure-seven-will-do').getAttribute('data-solved'), '');
  await page.locator('#contents summary').click();
  assert.match(await page.locator('[data-progress="fitting"]').textContent(), /^1 \/ \d/);
  await page.locator('#forget').click();
  assert.equal(await page.locator('#figure-seven-will-do').getAttribute('data-solved'), null);
});

pageTest('the list of chapters opens, leads on and closes', {}, async (page) => {
  const contents = page.locator('#contents');
  await contents.locator('summary').click();
  await contents.getByRole('link', { name: 'Fitting' }).first().click();
  assert.equal(await contents.getAttribute('open'), null);
  assert.match(page.url(), /#fitting$/);
  await until(page, () => document.querySelector('#contents a[aria-current]')?.hash === '#fitting');
  await contents.locator('summary').click();
  await page.keyboard.press('Escape');
  assert.equal(await contents.getAttribute('open'), null);
});
