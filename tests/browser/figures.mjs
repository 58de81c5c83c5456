// Pictures of every figure of the page for people to look at: npm run figures -- FOLDER [word ...]
// In light and dark on three screens; where Python has Pillow, contact sheets of six beside them.
import { spawnSync } from 'node:child_process';
import { mkdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { closeShared, launch, openPage } from './site.mjs';
import { call, scrollTo, settled, until } from './stage.mjs';

const folder = resolve(process.argv[2] ?? 'figures');
const words = process.argv.slice(3);
const screens = [
  ['desktop', { size: [1440, 900] }],
  ['tablet', { size: [1024, 768] }],
  ['phone', { size: [390, 844], touch: true }],
];

const sheets = `
import sys
from PIL import Image
out, *names = sys.argv[1:]
pictures = [Image.open(name).convert('RGB') for name in names]
width, height = pictures[0].size
columns = 6 if height > width else 3
share = 330 / width if height > width else 660 / width
w, h = round(share * width), round(share * height)
sheet = Image.new('RGB', (columns * (w + 8), -(-len(pictures) // columns) * (h + 8)), 'white')
for k, picture in enumerate(pictures):
    sheet.paste(picture.resize((w, h), Image.LANCZOS), (k % columns * (w + 8), k // columns * (h + 8)))
sheet.save(out)
`;

/// Every figure and exercise, as it comes to the stage of one who reads down the page.
async function takeAll(page, title) {
  const ids = await page.evaluate(() => [...document.querySelectorAll('[data-figure]')].map(({ dataset }) => dataset.figure));
  const files = [];
  for (const [k, id] of ids.entries()) {
    const name = `${title}-${String(k + 1).padStart(2, '0')}-${id}`;
    if (words.length > 0 && !words.every((word) => name.includes(word))) continue;
    await scrollTo(page, `#figure-${id}`);
    await until(page, (name) => document.querySelector('[data-shown]')?.dataset.figure === name, id);
    if ((await call(page, 'document')).animation.playing) {
      await call(page, 'pause');
      await call(page, 'seek', 1.2);
    }
    await settled(page);
    files.push(join(folder, `${name}.png`));
    await page.screenshot({ path: files.at(-1) });
  }
  return files;
}

await mkdir(folder, { recursive: true });
const browser = await launch();
for (const [name, options] of screens) {
  for (const dark of [false, true]) {
    const title = `${name}-${dark ? 'dark' : 'light'}`;
    const { page, close, complaints } = await openPage({ browser, ...options, dark, full: true, smooth: true, followed: true });
    const files = await takeAll(page, title);
    for (const complaint of complaints()) console.error(`${title}: ${complaint}`);
    await close();
    for (let k = 0; k < files.length; k += 6) {
      const sheet = join(folder, `sheet-${title}-${String(k / 6 + 1).padStart(2, '0')}.png`);
      spawnSync('python3', ['-c', sheets, sheet, ...files.slice(k, k + 6)]);
    }
    console.log(`${title}: ${files.length} pictures`);
  }
}
await browser.close();
await closeShared();
