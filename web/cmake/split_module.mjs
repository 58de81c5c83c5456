// Splits the page's module in two: what the first figure needs, and what is reached through functions marked
// KNOTWORK_LATER alone. usage: split_module.mjs <binaryen's folder> <module.wasm> <later.wasm> [wasm-opt option ...]
//
// `module.wasm` has function names and is replaced by the first part; both lose the names. Calls from the first part
// into the second go through the table, whose slots hold placeholders until the second part has been instantiated
// (see shell/src/loading.ts).
import { execFileSync } from 'node:child_process';
import { rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [folder, module, later, ...options] = process.argv.slice(2);
// Functions of the second part by their names: marked ones; what is inside a marked maker of rows (its functions, that
// is, not the maker, even where it has a marked function as an argument); the catalogues' formulas; copying and
// comparing shapes and figures of any kind but the first; what stands for another surface than the blending one; and
// what evaluates a curve.
const marks = [
  /^(?!.*\[abi:rows\]).*\[abi:later\]/,
  /\[abi:rows\].*\)::(\$_|'lambda)/,
  /__invoke(<[^()]*>)?\(double const\*, knotwork::(Taylor|Mixed)[^)]*\)$/,
  /__dispatcher<[1-9]\d*ul(, [1-9]\d*ul)?>.*(__traits|variant)<knotwork::(web::BlendingFigure|scene::BlendingSurfaceObject)/,
  /knotted_surface<(?!knotwork::BlendingSurface>)/,
  /\bcurve_view(<.*>)?\(.*\)::(\$_|'lambda)/,
];
const plain = (name) => name.replace(/\\([0-9a-f]{2})/g, (_, code) => String.fromCharCode(Number.parseInt(code, 16)));
// What wasm-opt has made of several similar functions bears the name of any of them: it belongs to whoever calls it.
const merged = /^byn\$mgfn-shared\$/;
const isMarked = (name) =>
  !folded.has(name) && !merged.test(name) && marks.some((mark) => mark.test(plain(name)));
const run = (tool, ...args) => execFileSync(join(folder, tool), args, { encoding: 'utf8', maxBuffer: 1 << 28 });
const features = options.filter((option) => option.startsWith('--enable') || option === '-all');

/// Functions with their calls, and those that are called from outside: by an export or through the table.
function callGraph() {
  const calls = new Map();
  const entries = [];
  for (const line of run('wasm-opt', module, ...features, '--print-call-graph', '-o', '/dev/null').split('\n')) {
    const edge = /^ {2}"(.*)" -> "(.*)";/.exec(line);
    const node = /^ {2}"(.*)" \[style="filled(, rounded)?"(?:, fillcolor="(\w+)")?\]/.exec(line);
    if (edge) {
      if (!calls.has(edge[1])) calls.set(edge[1], []);
      calls.get(edge[1]).push(edge[2]);
    } else if (node && node[3] !== 'turquoise') {
      if (!calls.has(node[1])) calls.set(node[1], []);
      if (node[3] === 'gray' || node[2]) entries.push(node[1]);
    }
  }
  return { calls, entries };
}

/// Functions of one expression, `return false` say. The linker has folded all that are alike into one, whose name is that
/// of any of them: it tells nothing about who calls it.
function foldedFunctions() {
  const text = run('wasm-opt', module, ...features, '-S', '-o', '-');
  return new Set([...text.matchAll(/^ \(func \$(\S+).*\n {2}\(.*\)\n \)$/gm)].map((match) => match[1]));
}

const { calls, entries } = callGraph();
const folded = foldedFunctions();
const first = new Set();
const ahead = [...entries];
while (ahead.length > 0) {
  const name = ahead.pop();
  if (first.has(name) || isMarked(name)) continue;
  first.add(name);
  ahead.push(...(calls.get(name) ?? []));
}
const second = [...calls.keys()].filter((name) => !first.has(name));
if (!first.has('malloc')) throw new Error('the call graph has not been understood');
if (!second.some(isMarked)) throw new Error('no function is marked KNOTWORK_LATER: has the module names?');

const list = `${later}.functions`;
const whole = `${module}.whole`;
writeFileSync(list, second.join('\n'));
run('wasm-opt', module, ...features, '-g', '-o', whole);
run('wasm-split', whole, ...features, `--split-funcs=@${list}`, '--import-namespace=first',
    '--placeholder-namespace=later', '-o1', module, '-o2', later);
for (const part of [module, later]) run('wasm-opt', part, ...options, '-o', part);
for (const file of [list, whole]) rmSync(file);
console.log(`first part ${statSync(module).size} bytes, second part ${statSync(later).size} bytes`);
