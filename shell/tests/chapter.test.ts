import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { renderChapter, slug } from '../plugins/chapter';
import { Mathematics } from '../plugins/mathematics';
import { parseAction } from '../src/actions';

const head = '---\nid: a-chapter\ntitle: A chapter\nsummary: About it.\n---\n';
const render = (text: string): string => renderChapter(head + text, new Mathematics()).html;

test('a chapter needs its head, whole', () => {
  assert.throws(() => renderChapter('# Text', new Mathematics()), /head/);
  assert.throws(() => renderChapter('---\nid: x\ntitle: X\n---\n', new Mathematics()), /"summary"/);
  assert.throws(() => renderChapter('---\nnonsense\n---\n', new Mathematics()), /key: value/);
  const chapter = renderChapter(`${head}\n## One thing\n\n## And *another*`, new Mathematics());
  assert.deepEqual([chapter.id, chapter.title, chapter.summary], ['a-chapter', 'A chapter', 'About it.']);
  assert.deepEqual(chapter.sections.map((section) => section.id), ['one-thing', 'and-another']);
  assert.match(chapter.html, /<h2 id="one-thing">/);
});

test('two sections of one name are refused: a link could not tell them apart', () => {
  assert.throws(() => render('## Twice\n\n## Twice'), /two sections/);
});

test('phrases that act become buttons, words in a hue become spans, links stay links', () => {
  const html = render('[go](knotwork:set?topology.v=open) [blue](hue:a) [there](https://example.org/)');
  assert.match(html, /<button type="button" class="act" data-run="set\?topology\.v=open" disabled>go<\/button>/);
  assert.match(html, /<span class="local-a">blue<\/span>/);
  assert.match(html, /<a href="https:\/\/example\.org\/">there<\/a>/);
});

test('punctuation stays on the line of its phrase', () => {
  const html = render('[go](knotwork:play): now, [stop](knotwork:pause) or [there](https://example.org/).');
  assert.match(html, /<span class="together"><button[^>]*>go<\/button>:<\/span> now/);
  assert.match(html, /now, <button[^>]*>stop<\/button> or/);
  assert.match(html, /<a href="https:\/\/example\.org\/">there<\/a>\./);
});

test('formulas are both HTML and MathML, and have no style attribute', () => {
  const mathematics = new Mathematics();
  const { html } = renderChapter(`${head}$\\htmlClass{local-b}{s_{i,j}}$, then\n\n$$\n\\frac{a}{b}\n$$\n`, mathematics);
  assert.match(html, /<math /);
  assert.match(html, /class="enclosing local-b"/);
  assert.doesNotMatch(html, /style=/);
  assert.match(html, /class="[^"]*\bmx0\b/);
  assert.match(mathematics.stylesheet(), /\.mx0\.mx0[^{]*\{[^}]*height:/);
  assert.doesNotMatch(mathematics.stylesheet(), /@font-face/);
  assert.ok([...'sijab'].every((letter) => mathematics.characters().includes(letter)));
  assert.ok(mathematics.uses('mfrac') && !mathematics.uses('mathbb'));
});

test('punctuation stays on the line of its formula', () => {
  assert.match(render('If $a$, then.'), /<span class="math"><span class="katex">.*<\/span>,<\/span> then\./);
});

test('a formula may have a second form for narrow columns', () => {
  assert.match(render('$$\na\n%% narrow\nb\n$$'), /<div class="wide">.*<div class="narrow">/s);
  assert.match(render('$$\na\n$$'), /<div class="any">/);
});

test('bad TeX, an open formula, an open block and an unknown block stop the build', () => {
  assert.throws(() => render('$\\nonsense$'), /nonsense/);
  assert.throws(() => render('costs $5'), /without an end/);
  assert.throws(() => render('::: try\nText'), /without an end/);
  assert.throws(() => render('::: dance\n:::'), /no block called "dance"/);
});

test('blocks hold Markdown, and rows of controls stand in the page before any script runs', () => {
  assert.match(render('::: try\nSome *text*.\n:::'), /<aside class="try".*<em>text<\/em>.*<\/aside>/s);
  const html = render('::: controls topology.u topology.v\n:::');
  assert.match(html, /data-parameter="topology\.u".*data-parameter="topology\.v"/);
});

test('a slug is made of small letters, digits and hyphens', () => {
  assert.equal(slug('Open and closed: again!'), 'open-and-closed-again');
});

test('every chapter of the page renders, and every phrase in it can be carried out', () => {
  const names = readdirSync('chapters').filter((name) => name.endsWith('.md'));
  assert.ok(names.length > 0);
  for (const name of names) {
    const { html } = renderChapter(readFileSync(join('chapters', name), 'utf8'), new Mathematics());
    for (const [, run] of html.matchAll(/data-run="([^"]*)"/g)) {
      assert.doesNotThrow(() => parseAction(run!.replaceAll('&amp;', '&')), `${name}: ${run}`);
    }
  }
});
