// From navigation to a live figure, beside the least page of Dear ImGui on WebGL2, turn and turn about in one run:
//   cmake --build --preset web --target knotwork_empty_page && node tests/benchmark/loading.mjs
// Both are compressed with brotli, and come over an emulated line of 10 megabits a second with 40 ms of latency. A figure
// is there with the first triangles that a page hands to the GPU: what drawing takes from there is the GPU's affair, and
// in software it would be all that there is to see.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';
import { closeShared, sharedBrowser, siteAddress } from '../browser/site.mjs';
import { serve } from '../../shell/scripts/static.mjs';

const folder = resolve(dirname(fileURLToPath(import.meta.url)), '../../build/web/tests/gpu');
const runs = Number(process.argv[2] ?? 9);
for (const name of ['empty.html', 'empty_page.js', 'empty_page.wasm'])
  writeFileSync(join(folder, `${name}.br`), brotliCompressSync(readFileSync(join(folder, name))));

/// The page's own time, in milliseconds since navigation, at which it first draws.
async function load(address) {
  const context = await (await sharedBrowser()).newContext({ viewport: { width: 1200, height: 800 } });
  const page = await context.newPage();
  const line = await context.newCDPSession(page);
  await line.send('Network.enable');
  await line.send('Network.emulateNetworkConditions', {
    offline: false, latency: 40, downloadThroughput: 1.25e6, uploadThroughput: 1.25e6,
  });
  await page.addInitScript(() => {
    const draw = WebGL2RenderingContext.prototype.drawElements;
    WebGL2RenderingContext.prototype.drawElements = function (...values) {
      window.drawn ??= performance.now();
      return draw.apply(this, values);
    };
  });
  await page.goto(address, { waitUntil: 'commit' });
  const at = await page.waitForFunction(() => window.drawn, null, { polling: 50, timeout: 30000 });
  const time = await at.jsonValue();
  await context.close();
  return time;
}

const server = await serve(folder, 0);
const empty = `http://localhost:${server.address().port}/empty.html`;
const times = { ours: [], empty: [] };
for (let run = 0; run < runs; ++run) {
  times.empty.push(await load(empty));
  times.ours.push(await load(await siteAddress()));
}
const median = (list) => list.sort((a, b) => a - b)[list.length >> 1];
const ours = median(times.ours);
const least = median(times.empty);
console.log(`a live figure after ${ours.toFixed(0)} ms, an empty page of Dear ImGui after ${least.toFixed(0)} ms: ` +
  `${(ours / least).toFixed(2)} times, at most 1.5: ${ours <= 1.5 * least ? 'yes' : 'NO'}`);
server.closeAllConnections();
server.close();
await closeShared();
