// Instructions of each of our works, counted by Callgrind, beside those of instructions.json: unlike times, they are the
// same on every machine with the same compiler. Warns where one has grown by more than 5 %.
//   node instructions.mjs            after building knotwork_contest_once (preset native-release)
//   node instructions.mjs --write    renews the table
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const program = resolve(here, '../../build/native-release/tests/knotwork_contest_once');
const table = join(here, 'instructions.json');
const most = 1.05;

const folder = mkdtempSync(join(tmpdir(), 'knotwork-'));
const { stdout, status, error } = spawnSync(
  'valgrind',
  ['--tool=callgrind', '--toggle-collect=measured_run', '--dump-after=measured_run',
    `--callgrind-out-file=${join(folder, 'counts')}`, program],
  { encoding: 'utf8' });
if (error || status !== 0) throw error ?? new Error(`valgrind ended with ${status}`);
const names = stdout.trim().split('\n').map((line) => line.replace(' | Knotwork', ''));
const counts = {};
const dump = (k) => readdirSync(folder).find((file) => file.endsWith(`counts.${k + 1}`));
names.forEach((name, k) => {
  counts[name] = Number(readFileSync(join(folder, dump(k)), 'utf8').match(/^(?:totals|summary): (\d+)/m)[1]);
});
rmSync(folder, { recursive: true });

const compiler = spawnSync('c++', ['--version'], { encoding: 'utf8' }).stdout.split('\n')[0].replace(/\s*\(.*?\)/, '');
if (process.argv.includes('--write')) {
  writeFileSync(table, `${JSON.stringify({ compiler, counts }, null, 2)}\n`);
} else {
  const known = JSON.parse(readFileSync(table, 'utf8'));
  if (known.compiler !== compiler) console.log(`counted with ${compiler}, the table with ${known.compiler}: they differ`);
  let grown = 0;
  for (const [name, count] of Object.entries(counts)) {
    const ratio = count / known.counts[name];
    const warning = !(ratio <= most);
    grown += warning ? 1 : 0;
    console.log(`${name}: ${count} instructions, ${((ratio - 1) * 100).toFixed(1)} %${warning ? '  WARNING: grown' : ''}`);
  }
  console.log(`${Object.keys(counts).length} works counted, ${grown} grown by more than 5 %`);
}
