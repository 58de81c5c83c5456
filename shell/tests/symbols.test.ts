import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { markSymbols, type HeldKind } from '../plugins/symbols';

const of = (kind: HeldKind, tex: string): string => `{\\htmlClass{of-${kind}}{${tex}}}`;

test('letters are marked by what they denote, with their scripts', () => {
  const marked: [string, string][] = [
    ['c_0', of('point', 'c_0')],
    ['c_{i,j}', of('point', 'c_{i,j}')],
    ['c_k^*', of('point', 'c_k^*')],
    ["l_0'(t)", `${of('local', "l_0'")}(${of('parameter', 't')})`],
    ['t_{i+1}', of('knot', 't_{i+1}')],
    ['3t^2', `3${of('parameter', 't^2')}`],
    ['w_{3,k}(\\tau)', `w_{3,k}(${of('knot', '\\tau')})`],
    ['e^{1/t}', `e^{1/${of('parameter', 't')}}`],
    ['\\hat M_{i-1}', of('local', '\\hat M_{i-1}')],
    ['M_k\\,y', `${of('local', 'M_k')}\\,y`],
    ['\\partial_u s_{i,b}', `\\partial_u ${of('local', 's_{i,b}')}`],
    ['\\htmlClass{local-a}{c_0}', `\\htmlClass{local-a}{${of('point', 'c_0')}}`],
    ['\\int_0^t t\\,dt', `\\int_0^${of('parameter', 't')} ${of('parameter', 't')}\\,d${of('parameter', 't')}`],
    ['p_j - p', `${of('datum', 'p_j')} - p`],
  ];
  for (const [tex, expected] of marked) assert.equal(markSymbols(tex), expected);
});

test('what is called the same but is something else stays, and so do names', () => {
  const others = ['c', "c'", 'c^{(k)}', '\\hat c', '\\hat c_k', 'S_u', 'B_v', 'd_u', 'b_i', '\\bar w_{1,i}', '\\theta'];
  const names = ['A^{\\mathsf T}p', '\\begin{pmatrix} 1 \\end{pmatrix}', '\\text{at most}', '\\sum_k', '\\\\[4pt]'];
  for (const tex of [...others, ...names]) assert.equal(markSymbols(tex), tex);
});

test('the chapters have symbols of each kind', () => {
  const files = readdirSync('chapters').filter((name) => name.endsWith('.md'));
  const sources = files.map((name) => readFileSync(`chapters/${name}`, 'utf8')).join('\n');
  const formulas = [...sources.matchAll(/\$\$[\s\S]*?\$\$|\$[^$]*\$/g)].map(([tex]) => markSymbols(tex));
  for (const [kind, least] of Object.entries({ point: 30, datum: 20, knot: 30, parameter: 40, local: 30 })) {
    const count = formulas.join('').split(`{of-${kind}}`).length - 1;
    assert.ok(count > least, `${kind}: ${count}`);
  }
});
