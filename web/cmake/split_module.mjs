// Splits the page's module in three: what the first figure needs, what the first chapters need besides, and the rest.
// usage: split_module.mjs <binaryen's folder> <module.wasm> <later.wasm> <last.wasm> [wasm-opt option ...]
//
// `module.wasm` has function names and is replaced by the first part; all lose the names. Calls from one part into
// another go through the table, whose slots hold placeholders until the other part has been instantiated (see
// shell/src/loading.ts).
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [folder, module, later, last, ...options] = process.argv.slice(2);
// Functions that the first figure does without, by their names: marked ones; what is inside a marked maker of rows (its
// functions, that is, not the maker, even where it has a marked function as an argument); the catalogues' formulas;
// copying and comparing shapes and figures of any kind but the first; what stands for another surface than the blending
// one; what evaluates a curve; what our windows, which have no columns and no way with keys, never ask of ImGui; and
// what reads typefaces of another format than the page's.
const formulas = /__invoke(<[^()]*>)?\(double const\*, knotwork::(Taylor|Mixed)[^)]*\)$/;
const otherSurfaces = /knotted_surface<(?!knotwork::BlendingSurface>)/;
const notFirst = [
  /^(?!.*\[abi:rows\]).*\[abi:la(ter|st)\]/,
  /\[abi:rows\].*\)::(\$_|'lambda)/,
  formulas,
  /__dispatcher<[1-9]\d*ul(, [1-9]\d*ul)?>.*(__traits|variant)<knotwork::(web::BlendingFigure|scene::BlendingSurfaceObject)/,
  otherSurfaces,
  /\bcurve_view(<.*>)?\(.*\)::(\$_|'lambda)/,
  /^(Table|Window)SettingsHandler_/,
  /^ImGui::(Scrollbar|EndColumns|RenderMouseCursor|NavUpdateWindowingOverlay|NavMoveRequestApplyResult|ScrollToRectEx)/,
  /^ImGui::(NavUpdateCreateWrappingRequest|NavProcessItemForTabbingRequest|NavUpdatePageUpPageDown)/,
  /^(stb_decompress|stbtt__(run_charstring|cid_get_glyph_subrs|GetGlyphInfoT2))/,
];
// Functions that Bezier curves do without as well, the second chapter's: marked ones, and what is about another kind of
// object. (Where a name has a variant in it, it is about all kinds.)
const notSoon = [
  /^(?!.*\[abi:rows\]).*\[abi:last\]/,
  /^(?!.*variant).*(Fit(Figure|Settings|tedCurve)|fit_|CurveFit|Subdivision|ModelCurve|ModelSurface|Catalogue)/,
  /^(?!.*variant).*(BlendingCurve|BSplineSurface|NetFigure|NetSurface|NetDirection)/,
  formulas,
  /__dispatcher<([2-9]|\d\d)ul(, [1-9]\d*ul)?>.*(__traits|variant)<knotwork::web::BlendingFigure/,
  /__dispatcher<([3-9]|\d\d)ul(, [1-9]\d*ul)?>.*(__traits|variant)<knotwork::scene::BlendingSurfaceObject/,
  otherSurfaces,
];
const plain = (name) => name.replace(/\\([0-9a-f]{2})/g, (_, code) => String.fromCharCode(Number.parseInt(code, 16)));
// What wasm-opt has made of several similar functions bears the name of any of them: it belongs to whoever calls it.
const merged = /^byn\$mgfn-shared\$/;
const isOneOf = (marks) => (name) =>
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
/// What is reached from outside without a function of which `isMarked` holds.
function reached(isMarked) {
  const found = new Set();
  const ahead = [...entries];
  while (ahead.length > 0) {
    const name = ahead.pop();
    if (found.has(name) || isMarked(name)) continue;
    found.add(name);
    ahead.push(...(calls.get(name) ?? []));
  }
  return found;
}
const first = reached(isOneOf(notFirst));
const soon = reached(isOneOf(notSoon));
const second = [...calls.keys()].filter((name) => !first.has(name) && soon.has(name));
const third = [...calls.keys()].filter((name) => !first.has(name) && !soon.has(name));
if (!first.has('malloc')) throw new Error('the call graph has not been understood');
for (const [part, marks] of [[second, notFirst], [third, notSoon]]) {
  if (!part.some(isOneOf(marks))) throw new Error('no function of a part is marked: has the module names?');
}

const list = `${later}.functions`;
const whole = `${module}.whole`;
const rest = `${module}.rest`;
function split(from, functions, part, name, prefix, remaining) {
  writeFileSync(list, functions.join('\n'));
  run('wasm-split', from, ...features, `--split-funcs=@${list}`, '--import-namespace=first',
      `--placeholder-namespace=${name}`, `--export-prefix=${prefix}`, '--symbolmap', '-o1', remaining, '-o2', part);
}
/// Rows `<number>:<name>` by name.
const numbers = (rows) =>
  new Map([...rows.matchAll(/^(\d+):(.*)$/gm)].map(([, number, name]) => [plain(name), number]));
run('wasm-opt', module, ...features, '-g', '-o', whole);
split(whole, third, last, 'last', '-', rest);
// Its exports have short names since nothing in it has a long one any more: functions go by their numbers.
const numberOf = numbers(readFileSync(`${rest}.symbols`, 'utf8'));
const names = run('wasm-opt', rest, ...features, '--print-function-map', '-o', '/dev/null');
const nameOf = new Map([...numbers(names)].map(([name, number]) => [number, name]));
split(rest, second.map((name) => nameOf.get(numberOf.get(plain(name)))), later, 'later', '.', module);
// The table has grown since `last` was cut off: what it says of the table's greatest size is no longer true.
const text = run('wasm-opt', last, ...features, '-S', '-o', '-');
const unlimited = text.replace(/^( \(import "first" .*\(table \S+ \d+) \d+ /m, '$1 ');
if (unlimited === text) throw new Error('the table of the last part has not been understood');
writeFileSync(`${last}.text`, unlimited);
run('wasm-opt', `${last}.text`, ...features, '-o', last);
for (const part of [module, later, last]) run('wasm-opt', part, ...options, '-o', part);
const symbols = [module, later, last, rest].map((part) => `${part}.symbols`);
for (const file of [list, whole, rest, `${last}.text`, ...symbols]) {
  rmSync(file, { force: true });
}
console.log(`first part ${statSync(module).size} bytes, second ${statSync(later).size}, third ${statSync(last).size}`);
