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
    // In a phone's drawer the row may lie below the foot.
    if (await hasWidget(page, 'blending.function')) await clickWidget(page, 'blending.function');
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
  fit: async (page) => call(page, 'open', 'least-squares'),
  'fit-6': async (page) => {
    await call(page, 'open', 'least-squares');
    await call(page, 'set', 'fitted.count', 6);
  },
  'fit-closed': async (page) => {
    await call(page, 'open', 'least-squares-closed');
    await settled(page);
    const { screen } = (await call(page, 'handles')).find((handle) => handle.id === 'point-3');
    await drag(page, screen, plus(screen, [40, -25]));
  },
  'fit-many': async (page) => {
    await call(page, 'open', 'least-squares');
    const document = await call(page, 'document');
    const round = (k) => 5 + 0.4 * Math.sin(9.7 * k) * Math.sin(k / 90);
    document.objects[0].points = Array.from({ length: 900 }, (_, k) =>
      [round(k) * Math.cos(k / 150), round(k) * Math.sin(k / 150), 0]);
    document.objects[0].count = 20;
    await call(page, 'load', document);
    await page.locator('canvas').focus();
    await page.keyboard.press('0');
  },
  subdivision: async (page) => call(page, 'open', 'subdivision'),
  'subdivision-split': async (page) => {
    await call(page, 'open', 'subdivision');
    await call(page, 'set', 'subdivision.step', 5);
  },
  'subdivision-way': async (page) => {
    await call(page, 'open', 'subdivision');
    await call(page, 'set', 'subdivision.step', 2);
    await call(page, 'set', 'subdivision.fraction', 0.4);
  },
  points: async (page) => {
    await call(page, 'open', 'least-squares');
    await page.locator('.points summary').click();
    await page.getByRole('button', { name: 'Write the present ones' }).click();
    await page.locator('.points').scrollIntoViewIfNeeded();
  },
  modelcurve: async (page) => call(page, 'open', 'model-curve'),
  flower: async (page) => {
    await call(page, 'open', 'model-curve');
    await call(page, 'set', 'curve.model', 'chrysanthemum');
  },
  butterfly: async (page) => {
    await call(page, 'open', 'model-curve');
    await call(page, 'set', 'curve.model', 'butterfly');
  },
  blendingcurve: async (page) => call(page, 'open', 'blending-curve'),
  local: async (page) => {
    await call(page, 'open', 'blending-curve');
    await settled(page);
    const { screen } = (await call(page, 'handles')).find((handle) => handle.id === 'local-7');
    await drag(page, screen, plus(screen, [30, -24]));
  },
  localplaying: async (page) => {
    await call(page, 'open', 'blending-curve');
    await call(page, 'seek', 1.2);
  },
  net: async (page) => call(page, 'open', 'tensor-surface'),
  netpoint: async (page) => {
    await call(page, 'open', 'tensor-surface');
    await settled(page);
    const { screen } = (await call(page, 'handles')).find((handle) => handle.id === 'point-3-2');
    await drag(page, screen, plus(screen, [20, -15]));
  },
  nettorus: async (page) => {
    await call(page, 'open', 'tensor-surface');
    await call(page, 'set', 'topology.u', 'closed');
    await call(page, 'set', 'topology.v', 'closed');
  },
  netnormals: async (page) => {
    await call(page, 'open', 'tensor-surface');
    await call(page, 'set', 'topology.u', 'closed');
    await call(page, 'set', 'display.normals', true);
    await call(page, 'set', 'display.wireframe', true);
  },
  model: async (page) => call(page, 'open', 'model-surface'),
  klein: async (page) => {
    await call(page, 'open', 'model-surface');
    await call(page, 'set', 'model', 'klein-bottle');
  },
  gallery: async (page) => {
    await call(page, 'open', 'model-surface');
    await settled(page);
    if (await hasWidget(page, 'controls')) {
      await clickWidget(page, 'controls');
      await settled(page);
    }
    await clickWidget(page, 'model');
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
      const { page, close, complaints } = await openPage({ browser, ...options, dark, full: true, smooth: true });
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
