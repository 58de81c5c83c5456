// Spelling of the chapters, by hunspell's British dictionary and the words of chapters/spelling.txt. Prints each unknown
// word with its place and fails if there is one. usage: npm run spelling
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { join } from 'node:path';

const folder = fileURLToPath(new URL('../chapters', import.meta.url));
const own = join(folder, 'spelling.txt');

/// What is read as prose: titles and summaries too, but neither ids, mathematics, code, links' targets, block heads nor
/// goals. Lines stay where they are.
function prose(source) {
  const blank = (text) => text.replace(/[^\n]/g, ' ');
  return source
    .replace(/^---\n[\s\S]*?\n---\n/, (head) => head.replace(/^(id:.*|title:|summary:|---)/gm, blank))
    .replace(/\$\$[\s\S]*?\$\$|\$[^$]*\$|`[^`]*`/g, blank)
    .replace(/\]\([^)]*\)/g, (target) => ']' + blank(target.slice(1)))
    .replace(/^(:::.*|goal:.*)$/gm, blank)
    .replaceAll('’', "'");
}

function unknown(words) {
  const run = spawnSync('hunspell', ['-d', 'en_GB', '-p', own, '-l'], { input: words.join('\n'), encoding: 'utf8' });
  if (run.error) {
    const help = 'the spelling is checked by hunspell: install it with its British dictionary (hunspell-en-gb)';
    throw new Error(help, { cause: run.error });
  }
  if (run.status !== 0) throw new Error(`hunspell: ${run.stderr}`);
  return new Set(run.stdout.split('\n').filter(Boolean));
}

const words = [];
for (const name of readdirSync(folder).filter((file) => file.endsWith('.md')).sort()) {
  const lines = prose(readFileSync(join(folder, name), 'utf8')).split('\n');
  lines.forEach((line, at) => {
    for (const [word] of line.matchAll(/\p{L}+(?:'\p{L}+)?/gu)) words.push({ word, place: `chapters/${name}:${at + 1}` });
  });
}
// A dictionary that finds no fault in anything would pass for ever.
if (!unknown(['curve', 'qwertzish']).has('qwertzish')) throw new Error('hunspell finds no fault in "qwertzish"');
const wrong = unknown([...new Set(words.map(({ word }) => word))]);
const found = words.filter(({ word }) => wrong.has(word));
for (const { word, place } of found) console.log(`${place}: ${word}`);
if (words.length < 1000) throw new Error('the chapters have hardly a word: the reading is wrong');
console.log(`${words.length} words read, ${found.length} unknown`);
process.exitCode = found.length > 0 ? 1 : 0;
