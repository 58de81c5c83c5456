// The page around the stage: where it runs, what it says when it cannot, how it looks and who can read it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { pageTest } from './page_test.mjs';
import { launch, openPage, plainHost, siteAddress } from './site.mjs';
import {
  call, difference, distance, distinctColours, documentOf, drag, frontHandle, handlesOf, luminance, picture, pixel,
  plus, scrollTo, settled, stageRect, statsOf, until, widget,
} from './stage.mjs';

const axeSource = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

pageTest('the page loads without a complaint and shows its figure', { full: true }, async (page) => {
  assert.match(await page.title(), /Knotwork/);
  assert.equal(await page.getByRole('alert').isVisible(), false);
  assert.equal(await page.getByRole('progressbar').isVisible(), false);
  assert.ok((await statsOf(page)).frames > 0);
  assert.ok((await page.getByRole('main').innerText()).length > 2000);
});

pageTest('the pixels are a surface before a calm background', { full: true, size: [1200, 800] }, async (page) => {
  await settled(page);
  const stage = await stageRect(page);
  const seen = await picture(page);
  const on = (await handlesOf(page)).map(({ screen: [x, y] }) => [x - stage.x, y - stage.y]);
  const [xs, ys] = [on.map(([x]) => x), on.map(([, y]) => y)];
  const [x, y] = [Math.min(...xs), Math.min(...ys)];
  const box = { x, y, w: Math.max(...xs) - x, h: Math.max(...ys) - y };
  assert.ok(box.w > 150 && box.h > 80, 'the surface is small');
  assert.ok(distinctColours(seen, box) > 3000, `${distinctColours(seen, box)} colours where the surface is`);
  const corner = { x: 4, y: stage.height - 34, w: 30, h: 30 };
  assert.ok(distinctColours(seen, corner) < 60, `${distinctColours(seen, corner)} colours in an empty corner`);

  // Without its surface the same place is a good deal plainer.
  for (const id of ['surface', 'knots', 'handles']) await call(page, 'set', `display.${id}`, false);
  await settled(page);
  const empty = await picture(page);
  assert.ok(distinctColours(empty, box) < distinctColours(seen, box) / 4);
  assert.ok(difference(seen, empty) > 0.1);
});

pageTest('panel and clock are drawn: cards, words and buttons, not only places to press', { full: true, size: [1200, 800] }, async (page) => {
  const image = await picture(page, { x: 0, y: 0, width: 1200, height: 800 });
  const { centre } = await widget(page, 'play');
  const button = pixel(image, centre[0] - 14, centre[1]);
  assert.ok(luminance(button) < 0.1, `the play button is ${button}`);
  const { x, y, width, height } = await widget(page, 'topology.u: closed');
  const inks = new Set();
  for (let across = 0; across < width; across += 2) inks.add(luminance(pixel(image, x + across, y + height / 2)).toFixed(1));
  assert.ok(inks.size > 2, `the chosen word is ${[...inks]}`);
  assert.ok(luminance(pixel(image, x + width / 2, y - 6)) > 0.9, 'the card is not white');
});

pageTest('patch colours are clearly different hues', { full: true, size: [1200, 800] }, async (page) => {
  await call(page, 'set', 'display.handles', false);
  await call(page, 'set', 'display.knots', false);
  await call(page, 'set', 'topology.u', 'open');
  await call(page, 'set', 'topology.v', 'open');
  await settled(page);
  const stage = await stageRect(page);
  const seen = await picture(page);
  const hues = (await handlesOf(page))
    .map(({ screen: [x, y] }) => [x - stage.x, y - stage.y])
    .filter(([x, y]) => x > 0 && y > 0 && x < stage.width && y < stage.height)
    .map(([x, y]) => {
      const [r, g, b] = pixel(seen, x, y);
      return Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b);
    });
  const bins = new Set(hues.map((hue) => Math.round((hue + Math.PI) / (Math.PI / 4)) % 8));
  assert.ok(bins.size >= 3, `the handles' places have ${bins.size} kinds of hue`);
});

for (const scale of [1, 2, 3]) {
  const options = { full: true, scale, size: [760, 440] };
  pageTest(`at a pixel ratio of ${scale} the canvas has the screen's pixels`, options, async (page) => {
    await settled(page);
    const { width, height, box } = await page.evaluate(() => {
      const canvas = document.querySelector('canvas');
      const { width, height } = canvas.getBoundingClientRect();
      return { width: canvas.width, height: canvas.height, box: [width, height] };
    });
    assert.ok(Math.abs(width - scale * box[0]) <= 1 && Math.abs(height - scale * box[1]) <= 1, `${width} x ${height}`);
    assert.ok(distinctColours(await picture(page)) > 1000);
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, [20, 10]));
    const moved = (await handlesOf(page)).find(({ id }) => id === handle.id);
    assert.ok(distance(moved.screen, plus(handle.screen, [20, 10])) < 1.5);
  });
}

pageTest('the stage follows the size of the window', {}, async (page) => {
  await settled(page);
  await page.setViewportSize({ width: 1240, height: 700 });
  await page.waitForFunction(() => {
    const canvas = document.querySelector('canvas');
    return Math.abs(canvas.width - canvas.getBoundingClientRect().width * devicePixelRatio) <= 1;
  });
  await settled(page);
  const stage = await stageRect(page);
  assert.equal(Math.round(stage.height), 700);
  for (const { screen: [x, y] } of await handlesOf(page)) {
    assert.ok(x > stage.x && x < stage.x + stage.width && y > stage.y && y < stage.y + stage.height);
  }
  await page.setViewportSize({ width: 390, height: 760 });
  await page.waitForFunction(() => document.querySelector('canvas').getBoundingClientRect().width === 390);
  await settled(page);
  const small = await stageRect(page);
  assert.ok(small.height > 0.3 * 760 && small.height < 0.6 * 760);
  const pageWidth = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.equal(pageWidth, 390, 'the page is wider than the phone');
});

pageTest('stage and paper follow the system from light to dark', { scale: 1 }, async (page) => {
  await settled(page);
  const backgrounds = async () => {
    await settled(page);
    const stage = await stageRect(page);
    const seen = await picture(page);
    const paper = await picture(page, { x: 4, y: 4, width: 4, height: 4 });
    return [luminance(pixel(seen, 8, stage.height - 8)), luminance(pixel(paper, 1, 1))];
  };
  const light = await backgrounds();
  await page.emulateMedia({ colorScheme: 'dark' });
  const dark = await backgrounds();
  await page.emulateMedia({ colorScheme: 'light' });
  assert.ok(light.every((l) => l > 0.6), `light: ${light}`);
  assert.ok(dark.every((l) => l < 0.05), `dark: ${dark}`);
  assert.deepEqual(await backgrounds(), light);
});

// What stands in for the figure when it cannot be had.

async function assertTrouble(page, pattern) {
  const alert = page.getByRole('alert');
  await alert.waitFor({ state: 'visible' });
  assert.match(await alert.innerText(), pattern);
  assert.ok((await page.getByRole('main').innerText()).length > 2000, 'the prose is gone with the figure');
  return alert;
}

test('without WebGL the page says so', async () => {
  const browser = await launch(['--disable-3d-apis']);
  try {
    const { page, complaints } = await openPage({ browser, wait: false });
    await assertTrouble(page, /WebGL/);
    const reason = await page.evaluate(() => window.knotwork.ready.then(() => '', (error) => error.message));
    assert.match(reason, /WebGL/);
    assert.deepEqual(complaints(), []);
  } finally {
    await browser.close();
  }
});

/// The part of the module that the first figure needs, the one that the first chapters need, and the rest.
const moduleFile = /\/knotwork-[\w-]+\.wasm$/;
const secondPart = /\/later-[\w-]+\.wasm$/;
const lastPart = /\/last-[\w-]+\.wasm$/;

const drawn = (page) =>
  until(page, () => {
    try {
      return window.knotwork.stats().frames > 0;
    } catch {
      return false;
    }
  });

let letSecondPartCome;
pageTest(
  'the first figure is alive before the second part of the module has come',
  {
    wait: false,
    before: async (page) => {
      const later = new Promise((resolve) => (letSecondPartCome = resolve));
      await page.route(secondPart, async (route) => {
        await later;
        await route.continue();
      });
    },
  },
  async (page) => {
    let requests = 0;
    page.on('request', (request) => (requests += secondPart.test(request.url()) ? 1 : 0));
    await drawn(page);
    const asked = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
    const scripts = asked.filter((name) => name.endsWith('.js')).map((name) => name.split('/').at(-1));
    assert.deepEqual(scripts.map((name) => name.split(/[-.]/)[0]).sort(), ['arriving', 'index', 'knotwork'],
      'the first figure has waited for scripts of others');
    await settled(page);
    const start = await documentOf(page);
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, [40, -15]));
    await call(page, 'set', 'topology.u', 'open');
    await call(page, 'set', 'blending.function', 'linear');
    await call(page, 'set', 'locals.u', 5);
    await settled(page);
    for (let k = 0; k < 4; ++k) await call(page, 'undo');
    assert.deepEqual((await documentOf(page)).objects, start.objects);
    assert.ok(requests <= 1, 'the first figure has called for the second part');
    letSecondPartCome();
    await page.evaluate(() => window.knotwork.ready);
    await call(page, 'open', 'bspline-curve');
    assert.equal((await call(page, 'evaluate', 'curve', 1, 1)).length, 2);
    await call(page, 'load', start);
    await settled(page);
  },
);

pageTest(
  'what needs later parts before they have come fetches them on the spot',
  {
    wait: false,
    before: async (page) => {
      for (const part of [secondPart, lastPart]) {
        await page.route(part, (route) =>
          route.request().resourceType() === 'fetch' ? new Promise(() => {}) : route.continue(),
        );
      }
    },
  },
  async (page) => {
    await drawn(page);
    await call(page, 'open', 'bezier-curve');
    assert.equal((await call(page, 'evaluate', 'curve', 0.5, 1)).length, 2);
    await settled(page);
    assert.ok((await handlesOf(page)).length > 3);
    await call(page, 'open', 'least-squares');
    assert.ok((await call(page, 'parameters')).some(({ id }) => id === 'fitted.count'));
    await settled(page);
    assert.ok((await handlesOf(page)).length > 6);
  },
);

pageTest(
  'a reader of the first two chapters does without the last part of the module',
  { followed: true, full: true },
  async (page) => {
    const asked = () =>
      page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
    const chapters = page.locator('[data-chapter]');
    const figures = await page.locator('[data-chapter="bezier-curves"] [data-figure]').all();
    for (const figure of figures.slice(0, -1)) {
      await figure.scrollIntoViewIfNeeded();
      await scrollTo(page, `#${await figure.getAttribute('id')}`);
      await figure.and(page.locator('[data-shown]')).waitFor();
      const handle = (await handlesOf(page)).find(({ screen }) => screen);
      await drag(page, handle.screen, plus(handle.screen, [12, -9]));
    }
    assert.ok(!(await asked()).some((name) => lastPart.test(name)), 'the last part came too early');
    assert.ok((await chapters.count()) > 3);
    // By a jump over the chapter that needs it first.
    const coming = page.waitForResponse(lastPart);
    await scrollTo(page, '#blending-splines');
    await coming;
  },
);

pageTest(
  'later parts that fail to come are fetched again by who needs them, and the stage goes with the reader',
  {
    followed: true,
    full: true,
    expected: [/net::ERR_FAILED/],
    before: async (page) => {
      for (const part of [secondPart, lastPart]) {
        await page.route(part, (route) =>
          route.request().resourceType() === 'fetch' ? route.abort('failed') : route.continue(),
        );
      }
    },
  },
  async (page) => {
    await scrollTo(page, '#figure-circle-six');
    await page.locator('#figure-circle-six[data-shown]').waitFor();
    await settled(page);
    assert.ok((await call(page, 'parameters')).some(({ id }) => id === 'fitted.count'));
  },
);

pageTest(
  'without WebAssembly the page says so',
  { wait: false, before: (page) => page.addInitScript(() => delete window.WebAssembly) },
  async (page) => {
    await assertTrouble(page, /WebAssembly/);
    assert.notEqual(await page.evaluate(() => window.knotwork.ready.then(() => '', (error) => error.message)), '');
  },
);

for (const [what, path] of [['module', moduleFile], ['typeface', /\.ttf$/]])
  pageTest(
    `a download of the ${what} that breaks off is said, and trying again brings the figure`,
    {
      wait: false,
      expected: [/net::ERR_FAILED/],
      before: (page) => page.route(path, (route) => route.abort('failed')),
    },
    async (page) => {
      const alert = await assertTrouble(page, /arrive|download|connection/i);
      await page.unroute(path);
      await alert.getByRole('button').click();
      await page.evaluate(() => window.knotwork.ready);
      await call(page, 'pause');
      await settled(page);
      assert.equal(await alert.isVisible(), false);
      assert.ok((await handlesOf(page)).length > 0);
    },
  );

let letModuleCome;
pageTest(
  'what arrives after one download has failed does not hide the message',
  {
    wait: false,
    expected: [/net::ERR_FAILED/],
    before: async (page) => {
      const later = new Promise((resolve) => (letModuleCome = resolve));
      await page.route(/\.ttf$/, (route) => route.abort('failed'));
      await page.route(moduleFile, async (route) => {
        await later;
        await route.continue();
      });
    },
  },
  async (page) => {
    const alert = await assertTrouble(page, /arrive|download|connection/i);
    const arrived = page.waitForResponse(moduleFile);
    letModuleCome();
    await (await arrived).finished();
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
    assert.equal(await alert.isVisible(), true);
  },
);

pageTest(
  'a server that has lost the module is said too',
  {
    wait: false,
    expected: [/404/],
    before: (page) => page.route(moduleFile, (route) => route.fulfill({ status: 404, body: 'not found' })),
  },
  async (page) => {
    await assertTrouble(page, /arrive|download|connection|server/i);
  },
);

pageTest(
  'a module that is something else is said too',
  {
    wait: false,
    expected: [],
    before: (page) => page.route(moduleFile, (route) => route.fulfill({ status: 200, body: '<!doctype html>Sign in' })),
  },
  async (page) => {
    await assertTrouble(page, /./);
  },
);

pageTest('the download shows its progress', {
  wait: false,
  before: async (page) => {
    await page.route(moduleFile, async (route) => {
      await page.evaluate(() => new Promise((seen) => {
        // The module is asked for while the page is still being read.
        const look = () =>
          document.querySelector('progress')?.checkVisibility() ? seen() : requestAnimationFrame(look);
        look();
      }));
      await route.continue();
    });
  },
}, async (page) => {
  await page.evaluate(() => window.knotwork.ready);
  assert.equal(await page.getByRole('progressbar').isVisible(), false);
});

pageTest('without JavaScript the prose can be read', { scripts: false, wait: false }, async (page) => {
  const main = page.getByRole('main');
  assert.equal(await main.getByRole('heading', { level: 1 }).first().isVisible(), true);
  assert.ok((await main.innerText()).length > 2000);
  assert.ok((await main.locator('.katex').count()) > 10, 'the mathematics is not typeset');
  assert.match(await page.locator('noscript').first().innerText(), /script/);
});

pageTest('a lost graphics context comes back with the same picture', { full: true }, async (page) => {
  const handle = await frontHandle(page);
  await drag(page, handle.screen, plus(handle.screen, [40, -15]));
  await page.mouse.move(3, 3);
  await settled(page);
  const before = await documentOf(page);
  const seen = await picture(page);
  await page.evaluate(() => {
    const context = document.querySelector('canvas').getContext('webgl2');
    window.lost = context.getExtension('WEBGL_lose_context');
    window.lost.loseContext();
  });
  await page.getByRole('alert').waitFor({ state: 'visible' });
  await page.evaluate(() => window.lost.restoreContext());
  await page.getByRole('alert').waitFor({ state: 'hidden' });
  await settled(page);
  assert.deepEqual(await documentOf(page), before);
  assert.ok(difference(seen, await picture(page)) < 0.001, 'the picture is another');
  await call(page, 'set', 'topology.v', 'open');
  await settled(page);
  assert.ok(difference(seen, await picture(page)) > 0.02, 'the stage is frozen');
});

// Where it runs.

test('the site works on a plain host, under a path of its own', async () => {
  const host = await plainHost('/some/path/');
  try {
    const { page, complaints, close } = await openPage({ address: host.address, full: true });
    await settled(page);
    assert.ok(distinctColours(await picture(page)) > 1000);
    assert.deepEqual(complaints(), []);
    await close();
  } finally {
    await host.close();
  }
});

pageTest(
  'the page keeps to its policy, and fetches nothing from elsewhere',
  {
    expected: [/Content Security Policy/],
    before: (page) =>
      page.addInitScript(() => {
        window.violations = [];
        addEventListener('securitypolicyviolation', (event) => window.violations.push(event.violatedDirective));
      }),
  },
  async (page) => {
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, [30, 10]));
    await page.locator('#blending-surface').getByRole('button', { name: 'Open it', exact: true }).click();
    await settled(page);
    assert.deepEqual(await page.evaluate(() => window.violations), []);
    const policy = (await page.request.get(await siteAddress())).headers()['content-security-policy'];
    assert.match(policy, /wasm-unsafe-eval/);
    assert.doesNotMatch(policy, /'unsafe-eval'|'unsafe-inline'|https?:/);
    // The policy is in force: a script that is not the site's own does not run.
    await page.evaluate(() => {
      const script = document.createElement('script');
      script.textContent = 'window.stranger = true';
      document.head.append(script);
    });
    assert.equal(await page.evaluate(() => window.stranger), undefined);
    // The header's policy and the page's own say so, each for itself.
    assert.deepEqual(await page.evaluate(() => window.violations), ['script-src-elem', 'script-src-elem']);
  },
);

const devices = {
  desktop: { full: true, size: [1280, 800] },
  phone: { full: true, size: [390, 844], scale: 2, touch: true },
};

/// What axe calls serious or critical, with everything on the page unfolded: the last first, since the first is the menu,
/// which lies over the text on a phone.
async function seriousFindings(page) {
  const folded = page.locator('details:not([open]) > summary:visible');
  while ((await folded.count()) > 0) await folded.last().click();
  await page.evaluate(() => scrollTo(0, 0));
  // Through the debugger, since the page's policy lets no foreign script in.
  await page.evaluate(await readFile(axeSource, 'utf8'));
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ['violations'] });
    return violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html} ${failureSummary}`));
  });
}

for (const [name, options] of Object.entries(devices))
  pageTest(`the menu of chapters opens into view on a ${name}`, options, async (page) => {
    await settled(page);
    await page.locator('.contents summary').click();
    const box = await page.locator('.contents > div').boundingBox();
    assert.ok(box.height > 100);
    assert.ok(box.y >= 0 && box.y + box.height <= options.size[1], `the menu is at ${box.y}, ${box.height} high`);
    // Nobody has scrolled it there.
    assert.equal(await page.evaluate(() => scrollY), 0);
  });

for (const [name, options] of Object.entries(devices)) {
  pageTest(`nothing moves while the page arrives on a ${name}`, {
    ...options,
    before: (page) =>
      page.addInitScript(() => {
        window.shifts = 0;
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) window.shifts += entry.value;
        }).observe({ type: 'layout-shift', buffered: true });
      }),
  }, async (page) => {
    await settled(page);
    await page.evaluate(() => document.fonts.ready);
    const shifts = await page.evaluate(() => window.shifts);
    assert.ok(shifts < 0.02, `the layout has shifted by ${shifts}`);
  });

  for (const dark of [false, true]) {
    pageTest(`axe finds nothing serious: ${name}, ${dark ? 'dark' : 'light'}`, { ...options, dark }, async (page) => {
      await settled(page);
      assert.deepEqual(await seriousFindings(page), []);
    });
  }
}

// Its settings are others, and its points have a field for text.
pageTest('axe finds nothing serious with data on the stage', devices.desktop, async (page) => {
  await call(page, 'open', 'least-squares');
  await settled(page);
  assert.deepEqual(await seriousFindings(page), []);
  await page.getByRole('textbox', { name: /numbers on each line/ }).fill('1, 2\nx, 4');
  await page.getByRole('button', { name: 'Use these points' }).click();
  await page.locator('.points [role=status]', { hasText: /Line 2/ }).waitFor();
  assert.deepEqual(await seriousFindings(page), []);
});

pageTest('headings, landmarks and names are in order', {}, async (page) => {
  assert.equal(await page.getByRole('main').count(), 1);
  const chapters = await page.getByRole('article').count();
  assert.ok(chapters >= 10);
  assert.equal(await page.getByRole('heading', { level: 1 }).count(), chapters);
  assert.ok((await page.getByRole('heading', { level: 2 }).count()) >= 5);
  assert.equal(await page.getByRole('application', { name: /figure/ }).count(), 1);
  const links = await page.locator('a[href^="#"]').evaluateAll((all) => all.map((link) => link.getAttribute('href')));
  for (const link of links) assert.equal(await page.locator(link).count(), 1, `${link} leads nowhere`);
});

pageTest('a real selection of prose is possible', {}, async (page) => {
  await page.getByRole('main').locator('p').first().click({ clickCount: 3 });
  assert.ok((await page.evaluate(() => getSelection().toString())).length > 60);
});

/// How many clearly different colours a still picture shows where it lies on the page.
async function coloursOf(page, still) {
  await still.scrollIntoViewIfNeeded();
  await page.waitForFunction((image) => image.complete && image.naturalWidth > 0, await still.elementHandle());
  const { data } = PNG.sync.read(await still.screenshot());
  const colours = new Set();
  for (let k = 0; k < data.length; k += 4) colours.add(`${data[k] >> 4} ${data[k + 1] >> 4} ${data[k + 2] >> 4}`);
  return colours.size;
}

const onPaper = { dark: true, followed: true };

pageTest('on paper every figure has its still picture, and the stage is not there', onPaper, async (page) => {
  const figures = await page.locator('[data-figure]').count();
  const fetched = () =>
    page.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /svg$/.test(name)).length);
  // The page's icon, and the first figure until it is alive.
  assert.equal(await fetched(), 2, 'stills have been fetched while the figures are alive');
  await page.emulateMedia({ media: 'print', colorScheme: 'light' });
  assert.ok((await page.getByRole('main').boundingBox()).width > 500, 'the prose is narrow on paper');
  assert.equal(await page.locator('#stage').isVisible(), false);
  const stills = page.locator('[data-figure] .still');
  assert.equal(await stills.count(), figures);
  for (const still of await stills.all()) assert.equal(await still.isVisible(), true);
  assert.ok((await coloursOf(page, page.locator('#figure-one-patch-pulled .still'))) > 100, 'the torus is not there');
  await page.emulateMedia({ media: null });
  const paper = await page.pdf({ format: 'A4' });
  // Drawn, not written: a page of words alone has a hundredth of that.
  assert.ok(paper.length > 2e6, `the print has ${paper.length} bytes`);
});

const lacks = {
  JavaScript: { scripts: false, wait: false },
  WebGL: {
    wait: false,
    before: (page) => page.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null)),
    expected: [/WebGL/],
  },
};

for (const [name, options] of Object.entries(lacks)) {
  pageTest(`without ${name} every figure has its still picture`, options, async (page) => {
    if (name === 'WebGL') await until(page, () => document.getElementById('stage').dataset.state === 'trouble');
    for (const figure of await page.locator('[data-figure]').all()) {
      const still = figure.locator('.still');
      assert.equal(await still.isVisible(), true);
      assert.ok((await still.getAttribute('alt')).length > 15, await still.getAttribute('alt'));
      const id = await figure.getAttribute('data-figure');
      const few = id === 'two-points' ? 8 : 14;  // a segment alone
      const colours = await coloursOf(page, still);
      assert.ok(colours > few, `${id}: ${colours} colours`);
    }
  });
}

pageTest('the description of the stage follows its state', {}, async (page) => {
  const description = () =>
    page
      .locator('canvas')
      .evaluate((canvas) => canvas.ariaDescribedByElements.map(({ textContent }) => textContent).join(' '));
  assert.match(await description(), /u closed, v closed.*locals u 6.*Polynomial, order 2/);
  await call(page, 'set', 'locals.u', 5);
  await call(page, 'set', 'topology.v', 'open');
  await settled(page);  // a handle on its way is not where it was a moment ago
  const handle = await frontHandle(page);
  await page.mouse.click(...handle.screen);
  await settled(page);
  const said = await description();
  assert.match(said, /v open.*locals u 5/);
  assert.match(said, new RegExp(`${handle.label} is selected`));
  await call(page, 'open', 'bspline-curve');
  await call(page, 'set', 'display.polygon', false);
  assert.match(await description(), /curve open, degree 3.*t 1\.6.*Shown: (?!.*control polygon)/);
});

pageTest('the notice line tells what is held', {}, async (page) => {
  const handle = await frontHandle(page);
  await page.mouse.click(...handle.screen);
  await until(page, () => document.getElementById('notice').textContent.length > 3);
});
