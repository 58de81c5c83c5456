import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { checkNames, renderChapter, slug, type Chapter } from '../plugins/chapter';
import { Mathematics } from '../plugins/mathematics';

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
  assert.match(mathematics.stylesheet(html), /\.mx0\.mx0[^{]*\{[^}]*height:/);
  assert.doesNotMatch(mathematics.stylesheet(html), /@font-face|\.mathbb/);
  assert.match(mathematics.stylesheet(html), /\.katex \.mfrac/);
  // A sign over a letter takes no room beside it, though nothing on the page is .accent-full.
  const hat = mathematics.render(String.raw`\hat c`, false);
  assert.match(mathematics.stylesheet(hat), /\.accent-body:not\(\.accent-full\)\{width:0\}/);
  assert.ok([...'sijab'].every((letter) => mathematics.characters('KaTeX_Math').includes(letter)));
  assert.ok(mathematics.uses('mfrac') && !mathematics.uses('mathbb'));
});

test('punctuation stays on the line of its formula', () => {
  assert.match(render('If $a$, then.'), /<span class="math">(<!--tex-->)?<span class="katex">.*<\/span>(<!--\/tex-->)?,<\/span> then\./);
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

test('a figure has its caption, its start and its tools; a number that is checked is plain text', () => {
  const chapter = renderChapter(
    `${head}::: figure knots bspline-curve curve.parameter=0.4&display.polygon=false\nSeven *points*, [0.017](fact:x).\n:::\n`,
    new Mathematics(),
  );
  assert.deepEqual(chapter.figures, [
    { id: 'knots', start: 'bspline-curve', values: 'curve.parameter=0.4&display.polygon=false' },
  ]);
  assert.match(chapter.html, /<figure [^>]*data-figure="knots" data-start="bspline-curve"/);
  assert.match(chapter.html, /data-values="curve\.parameter=0\.4&amp;display\.polygon=false"/);
  assert.match(chapter.html, /<em>points<\/em>, 0\.017\.<\/p>/);
  assert.match(chapter.html, /data-show disabled/);
  assert.throws(() => render('::: figure knots\n:::'), /a name and a start/);
});

test('an exercise has a goal that can be checked, a hint and a last word', () => {
  const lines = ['::: exercise near least-squares fitted.count=4', 'Come *near*.', 'goal: fit.rms < 0.02'];
  const end = ['hint: More $n$.', 'done: It falls.', ':::'];
  const html = render([...lines, ...end].join('\n'));
  assert.match(html, /data-goal="fit\.rms &lt; 0\.02"|data-goal="fit\.rms < 0\.02"/);
  assert.match(html, /<p>Come <em>near<\/em>\.<\/p>/);
  assert.match(html, /<summary>Hint<\/summary><p>More <span class="math">/);
  assert.match(html, /class="exercise-done" hidden>It falls\./);
  assert.throws(() => render([...lines, ':::'].join('\n')), /needs a line "hint:"/);
  assert.throws(() => render(['::: exercise x y', 'goal: much', ...end].join('\n')), /list of comparisons/);
  assert.throws(() => render([...lines, 'And on.', ...end].join('\n')), /ends with its lines/);
});

test('a phrase that nothing can do, and two things of one name, stop the build', () => {
  assert.throws(() => render('[go](knotwork:dance)'), /cannot do "dance"/);
  const chapter = (id: string, section: string): Chapter => ({
    id, title: id, summary: id, html: '', sections: [{ id: section, title: section }], figures: [],
  });
  assert.doesNotThrow(() => checkNames([chapter('a', 'b'), chapter('c', 'd')]));
  assert.throws(() => checkNames([chapter('a', 'b'), chapter('c', 'b')]), /called "b"/);
});

test('every chapter of the page renders, and each of its figures starts from something', () => {
  const names = readdirSync('chapters').filter((name) => name.endsWith('.md'));
  assert.ok(names.length > 0);
  const scenes = readdirSync('scenes').map((name) => name.replace(/\.json$/, ''));
  const table = readFileSync('../core/knotwork/scene/chapters.cpp', 'utf8');
  const chapters = names.map((name) => renderChapter(readFileSync(join('chapters', name), 'utf8'), new Mathematics()));
  checkNames(chapters);
  const figures = chapters.flatMap((chapter) => chapter.figures);
  for (const { id, start } of figures) {
    if (start === 'file') assert.ok(scenes.includes(id), `there is no shell/scenes/${id}.json`);
    else assert.ok(table.includes(`{"${start}",`), `"${start}" of figure "${id}" is no start document`);
  }
  const files = figures.filter(({ start }) => start === 'file').map(({ id }) => id);
  assert.deepEqual(scenes.filter((scene) => !files.includes(scene)), [], 'scenes that no figure shows');
});

test('exercises are numbered, and a link that leads nowhere is named', () => {
  const exercise = (id: string): string =>
    `::: exercise ${id} bezier-curve\nDo it.\ngoal: points.moved = 1\nhint: Try.\ndone: Well.\n:::\n\n`;
  const { html } = renderChapter(head + exercise('one') + exercise('two'), new Mathematics(), 4);
  assert.match(html, /Exercise <span>4\.1<[\s\S]*Exercise <span>4\.2</);
  const linked = (to: string): Chapter => renderChapter(`${head}[there](#${to})\n\n## A place`, new Mathematics());
  checkNames([linked('a-place')]);
  assert.throws(() => checkNames([linked('no-place')]), /"#no-place"/);
});
