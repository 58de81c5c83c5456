// Pictures of the page for people to look at: npm run look -- FOLDER
import { mkdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { closeShared, launch, openPage } from './site.mjs';
import {
  call, clickWidget, drag, frontHandle, hasWidget, plus, settled, showMore, stageRect, until,
} from './stage.mjs';

const folder = resolve(process.argv[2] ?? 'look');
const screens = [
  ['desktop', { size: [1440, 900] }],
  ['tablet', { size: [1024, 768] }],
  ['phone', { size: [390, 844], scale: 2, touch: true }],
];

const states = {
  start: async () => {},
  held: async (page) => {
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, [46, -34]), { hold: true });
  },
  selected: async (page) => {
    const handle = await frontHandle(page);
    await drag(page, handle.screen, plus(handle.screen, [30, -26]));
    const stage = await stageRect(page);
    await page.mouse.move(stage.x + 5, stage.y + 5);
  },
  plane: async (page) => {
    await call(page, 'set', 'topology.u', 'open');
    await call(page, 'set', 'topology.v', 'open');
  },
  cylinder: async (page) => call(page, 'set', 'topology.v', 'open'),
  locals: async (page) => call(page, 'set', 'display.locals', true),
  wireframe: async (page) => call(page, 'set', 'display.wireframe', true),
  frames: async (page) => {
    await call(page, 'set', 'display.frames', true);
    await call(page, 'set', 'display.normals', true);
  },
  playing: async (page) => {
    await call(page, 'play');
    await until(page, () => window.knotwork.document().animation.time > 1.2);
    await call(page, 'pause');
  },
  probe: async (page) => {
    const handle = await frontHandle(page);
    await page.mouse.move(...plus(handle.screen, [18, 12]));
  },
  panel: async (page) => {
    if (await hasWidget(page, 'controls')) {
      await clickWidget(page, 'controls');
      await settled(page);
    }
    if (await hasWidget(page, 'more')) await showMore(page, 'display.wireframe');
  },
  list: async (page) => {
    if (await hasWidget(page, 'controls')) {
      await clickWidget(page, 'controls');
      await settled(page);
    }
    await clickWidget(page, 'blending.function');
  },
  prose: async (page) => page.evaluate(() => document.querySelectorAll('h2')[3].scrollIntoView()),
  table: async (page) => page.locator('[data-report]').scrollIntoViewIfNeeded(),
  controls: async (page) => page.locator('[data-parameter="motion.rotation"]').scrollIntoViewIfNeeded(),
  bezier: async (page) => call(page, 'open', 'bezier-curve'),
  bspline: async (page) => call(page, 'open', 'bspline-curve'),
  point: async (page) => {
    await call(page, 'open', 'bspline-curve');
    await settled(page);
    const { screen } = (await call(page, 'handles')).find((handle) => handle.id === 'point-3');
    await drag(page, screen, plus(screen, [20, -15]));
  },
  settings: async (page) => {
    await page.evaluate(() => document.querySelectorAll('details').forEach((details) => (details.open = true)));
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  },
};

await mkdir(folder, { recursive: true });
const only = process.argv.slice(3);
const browser = await launch();
for (const [name, options] of screens) {
  for (const dark of [false, true]) {
    for (const [state, prepare] of Object.entries(states)) {
      const title = `${name}-${dark ? 'dark' : 'light'}-${state}`;
      if (only.length > 0 && !only.every((word) => title.split('-').includes(word))) continue;
      const { page, close, complaints } = await openPage({ browser, ...options, dark, full: true });
      await settled(page);
      await prepare(page);
      await settled(page);
      await page.screenshot({ path: join(folder, `${title}.png`) });
      for (const complaint of complaints()) console.error(`${title}: ${complaint}`);
      console.log(title);
      await close();
    }
  }
}
await browser.close();
await closeShared();
