// Runs what tests/benchmark/compare has built, one program after the other, and prints one table: work, place, best rival,
// ours, ratio, and whether the target of works.json is met. Fails where a result is wrong, never because one is slow.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const build = resolve(here, '../../build');
const check = process.argv.includes('--check');
const { works } = JSON.parse(readFileSync(join(here, 'works.json'), 'utf8'));
const folder = mkdtempSync(join(tmpdir(), 'knotwork-'));

/// [{work, who, ns, right}] of lines of JSON as wasm_main.cpp, rivals.mjs and rivals.py print them.
const results = (lines) =>
  lines
    .split('\n')
    .filter((line) => line.startsWith('{'))
    .map((line) => JSON.parse(line))
    .map(({ name, ns, right, error }) => ({ work: name.split(' | ')[0], who: name.split(' | ')[1], ns, right, error }));

function lines(command, ...given) {
  const { stdout, status, error } = spawnSync(command, given, { encoding: 'utf8', maxBuffer: 1 << 26 });
  if (error) throw error;
  if (status !== 0) {
    console.error(`${command} ${given.join(' ')} ended with ${status}`);
    process.exitCode = 1;
  }
  return stdout;
}

/// A program of Google Benchmark: medians of some repetitions.
function native(preset) {
  const program = join(build, preset, 'tests/knotwork_contest');
  if (check) {
    execFileSync(program, ['--check'], { stdio: ['ignore', 'inherit', 'ignore'] });
    return [];
  }
  const report = JSON.parse(
    lines(program, '--benchmark_format=json', '--benchmark_min_time=0.1', '--benchmark_repetitions=5',
          '--benchmark_report_aggregates_only=true'));
  return report.benchmarks
    .filter((row) => row.aggregate_name === 'median')
    .map(({ run_name, each }) => ({ work: run_name.split(' | ')[0], who: run_name.split(' | ')[1], ns: 1e9 * each, right: true }));
}

async function chromium() {
  const require = createRequire(resolve(here, '../browser/package.json'));
  const { chromium: browser } = require('playwright-core');
  const script = readFileSync(join(build, 'benchmark-web/tests/knotwork_contest.js'), 'utf8');
  const running = await browser.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] });
  try {
    const page = await running.newPage();
    const printed = [];
    const ended = new Promise((done, failed) => {
      page.on('console', (message) => printed.push(message.text()));
      page.on('pageerror', failed);
      page.exposeFunction('contestEnded', done);
    });
    await page.setContent('<title>Contest</title>');
    await page.evaluate(() => (window.Module = { onExit: () => window.contestEnded() }));
    await page.addScriptTag({ content: script });
    await ended;
    return results(printed.join('\n'));
  } finally {
    await running.close();
  }
}

function processorHas(feature) {
  try {
    return readFileSync('/proc/cpuinfo', 'utf8').includes(` ${feature} `);
  } catch {
    return false;
  }
}

const flag = check ? ['--check'] : [];
execFileSync(join(build, 'native-release/tests/knotwork_contest_samples'), [folder]);
const python = ['python3', '/usr/bin/python3'].find((name) => spawnSync(name, ['-c', 'import scipy']).status === 0);

const nativeRivals = [
  ...native('native-release'),
  ...(python ? results(lines(python, join(here, 'rivals.py'), folder, ...flag)) : []),
];
const javaScriptRivals = results(lines('node', join(here, 'rivals.mjs'), folder, ...flag));
const contest = join(build, 'benchmark-web/tests/knotwork_contest.js');
const places = [
  { place: 'native, baseline', kind: 'native', ours: nativeRivals, rivals: nativeRivals },
  { place: 'wasm, Node.js', kind: 'wasm', ours: results(lines('node', contest, ...flag)), rivals: javaScriptRivals },
];
if (!check) {
  if (processorHas('avx2'))
    places.push({ place: 'native, AVX2', kind: 'native', ours: native('benchmark-avx2'), rivals: nativeRivals });
  if (processorHas('avx512vl'))
    places.push({ place: 'native, AVX-512', kind: 'native', ours: native('benchmark-avx512'), rivals: nativeRivals });
  places.push({ place: 'wasm, Chromium', kind: 'wasm', ours: await chromium(), rivals: javaScriptRivals });
}
rmSync(folder, { recursive: true });

const wrong = [...new Set(places.flatMap(({ ours, rivals }) => [...ours, ...rivals]))].filter(({ right }) => !right);
for (const { work, who, error } of wrong) console.error(`wrong: ${work} | ${who} differs by ${error}`);

if (check) {
  const counted = nativeRivals.length + javaScriptRivals.length + places[1].ours.length;
  console.log(`${counted} contenders in other languages compared, ${wrong.length} wrong`);
} else {
  const ours = ({ who }) => who === 'Knotwork';
  console.log('| work | where | best rival | rival | ours | ahead | target | met |\n|---|---|---|---|---|---|---|---|');
  for (const { name, unit = 'ns', native, wasm } of works) {
    const scale = unit === 'ms' ? 1e-6 : 1;
    const shown = (ns) => `${(ns * scale).toPrecision(3)} ${unit}`;
    for (const { place, kind, ours: own, rivals } of places) {
      const target = kind === 'native' ? native : wasm;
      const mine = own.find((row) => row.work === name && ours(row));
      // The fastest of this build and of the common ones: what is compiled with us, Eigen's headers and our own
      // readable forms (they stand in where no rival does the work), gains by AVX too.
      const field = [...own, ...rivals].filter(
        (row) => row.work === name && row.right && !row.who.startsWith('Knotwork'));
      const best = field.sort((a, b) => a.ns - b.ns)[0];
      const ahead = best && best.ns / mine.ns;
      const fast = mine.ns * scale <= target.most;
      const farAhead = !target.ahead || !best || ahead >= target.ahead;
      const wish = `${target.most} ${unit}${target.ahead ? `, ${target.ahead} times` : ''}`;
      const verdict = farAhead && fast ? 'yes' : farAhead && target.ahead ? 'ratio' : fast ? 'time' : 'no';
      console.log(
        `| ${name} | ${place} | ${best ? best.who : ''} | ${best ? shown(best.ns) : ''} | ${shown(mine.ns)} | ` +
          `${best ? ahead.toFixed(1) : ''} | ${wish} | ${verdict} |`);
    }
  }
}
// A rival that is wrong (by more than rounding) is told of and left out; only our own fail the run.
if (wrong.some(({ who }) => who.startsWith('Knotwork'))) process.exitCode = 1;
