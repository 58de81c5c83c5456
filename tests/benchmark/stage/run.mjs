// The benchmark page of the stage (index.html beside this): run.mjs prints its table as headless Chromium has it, with a
// real mouse for the rows that are dragged; run.mjs --serve serves it to other browsers. SIDES=100,316 chooses the
// resolutions. The page and the built site lie side by side in build/stage_benchmark, never in the site itself.
import { cpSync, existsSync, mkdirSync, rmSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../../shell/scripts/static.mjs';
import { closeShared, openPage, siteFolder } from '../../browser/site.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(here, '../../../build/stage_benchmark');
if (!existsSync(join(siteFolder, 'index.html'))) throw new Error('the site is not built: npm run build in shell/');
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
for (const file of ['index.html', 'stage.css', 'stage.js']) cpSync(join(here, file), join(folder, file));
cpSync(siteFolder, join(folder, 'site'), { recursive: true });

const server = await serve(folder, process.argv.includes('--serve') ? Number(process.env.PORT ?? 8081) : 0);
const address = `http://localhost:${server.address().port}/`;
if (process.argv.includes('--serve')) {
  console.log(`${address}  (Ctrl+C ends it)`);
} else {
  await run();
  await closeShared();
  server.closeAllConnections();
  server.close();
}

async function run() {
  const sides = process.env.SIDES ? `?sides=${process.env.SIDES}` : '';
  const { page, complaints } = await openPage({ address: address + sides, wait: false, size: [1240, 1000], scale: 0.5 });
  const widths = [56, 9, 10, 8, 8, 6, 8, 12, 2];
  const print = (cells) => console.log(cells.map((cell, k) => (k === 0 ? `${cell}`.padEnd(widths[0]) : `${cell}`.padStart(widths[k] ?? 0))).join('  '));
  print(['', 'vertices', 'evaluate', 'frame ms', 'kB', 'draws', 'changes', 'allocations', '']);
  for (let shown = 0, angle = 0, held = false; ; ) {
    const { rows, drag, done, idle } = await page.evaluate(() => window.results ?? { rows: [] });
    for (const cells of rows.slice(shown)) print(cells);
    shown = rows.length;
    if (drag) {
      const at = [drag[0] + 20 * Math.sin((angle += 0.1)), drag[1] + 20 * (1 - Math.cos(angle))];
      if (!held) {
        await page.mouse.move(...drag);
        await page.mouse.down();
        held = true;
      }
      await page.mouse.move(...at);
    } else if (held) {
      await page.mouse.up();
      held = false;
    } else {
      await new Promise((later) => setTimeout(later, 100));
    }
    if (complaints().length > 0) throw new Error(complaints().join('\n'));
    if (done) {
      console.log(`idle for two seconds: ${idle} frames`);
      return;
    }
  }
}
