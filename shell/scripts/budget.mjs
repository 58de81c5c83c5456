// What a first visit transfers, computed from dist: the page, everything that its entry loads (scripts, styles, fonts,
// module), its icons. Fails above the budget. The module's second part comes behind the first picture; it is listed and
// counted in the total, but not against the first figure's WebAssembly. Its last part comes with the chapter on B-splines
// (browser/page.test.mjs) and does not count.
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { dist } from './files.mjs';

const totalBudget = 450 * 1024;
const wasmBudget = 200 * 1024;

const json = async (file) => JSON.parse(await readFile(join(dist, file), 'utf8'));
const [manifest, sizes] = await Promise.all([json('manifest.json'), json('sizes.json')]);

// A figure's document is fetched when the figure is near: those up to the chapter on Bezier curves count.
const page = await readFile(join(dist, 'index.html'), 'utf8');
const near = page.slice(0, page.indexOf('id="bsplines"'));
const isFarScene = (key) => {
  const scene = /scenes\/([\w-]+)\.json/.exec(key)?.[1];
  return scene !== undefined && !near.includes(`data-figure="${scene}"`);
};

// Still pictures of figures are not fetched while the figures are alive (browser/page.test.mjs).
const stills = page.matchAll(/<img class="still" src="\.\/([^"]*)"[^>]* loading="lazy"/g);
const lazy = new Set([...stills].map(([, file]) => file));
const isLazy = (file) => lazy.has(file) || /\/last-[\w-]+\.wasm$/.test(file);

const loaded = new Set(['index.html', 'arriving.js', 'favicon.svg', 'manifest.webmanifest']);
function follow(key) {
  const chunk = manifest[key];
  if (!chunk || loaded.has(chunk.file)) return;
  loaded.add(chunk.file);
  for (const file of [...(chunk.css ?? []), ...(chunk.assets ?? [])]) if (!isLazy(file)) loaded.add(file);
  for (const next of [...(chunk.imports ?? []), ...(chunk.dynamicImports ?? [])]) if (!isFarScene(next)) follow(next);
}
follow('index.html');
// Fonts and other files that a style sheet names.
for (const file of [...loaded].filter((name) => name.endsWith('.css'))) {
  const css = await readFile(join(dist, file), 'utf8');
  for (const [, url] of css.matchAll(/url\(["']?(?:\.\/)?([^)"']+)["']?\)/g)) loaded.add(`assets/${url}`);
}

const transferred = (file) => {
  const size = sizes[file];
  if (!size) throw new Error(`${file} is loaded but is not in dist/sizes.json: run npm run build`);
  return Math.min(size.br ?? size.raw, size.raw);
};
let total = 0;
let wasm = 0;
for (const file of [...loaded].sort((a, b) => transferred(b) - transferred(a))) {
  const bytes = transferred(file);
  total += bytes;
  if (/\/knotwork-[\w-]+\.wasm$/.test(file)) wasm += bytes;
  console.log(`${(bytes / 1024).toFixed(1).padStart(8)} KB  ${file}`);
}
console.log(`${(total / 1024).toFixed(1).padStart(8)} KB  first visit, of ${totalBudget / 1024} KB`);
console.log(`${(wasm / 1024).toFixed(1).padStart(8)} KB  WebAssembly before the first figure, of ${wasmBudget / 1024} KB`);
if (wasm === 0) {
  console.error('no module among the files loaded: the calculation is wrong');
  process.exitCode = 1;
}
if (total > totalBudget || wasm > wasmBudget) {
  console.error('over the budget');
  process.exitCode = 1;
}
