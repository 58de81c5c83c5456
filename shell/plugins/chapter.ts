import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import createMarkdown, { type MarkdownIt } from 'markdown-it';
import { parseAction } from '../src/actions';
import { parseGoal } from '../src/goals';
import type { Mathematics } from './mathematics';
import { markSymbols } from './symbols';

/// A chapter file is Markdown with a head of `key: value` lines between two `---`, and with these additions:
///
///     $tex$ and $$tex$$               mathematics; in a block, a line `%% narrow` starts the form for narrow columns
///     [words](knotwork:set?id=value)  a phrase that acts (see src/actions.ts) on the figure before it
///     [words](hue:a)                  words in a local patch's hue, a to d
///     [0.017](fact:name)              a number that a test computes anew (tests/unit/facts_test.cpp)
///     ::: name arguments ... :::      a block: lead, try, note, sources; controls id id ..., report, patches, settings;
///                                     code path#region, cut out of a source that is compiled and tested;
///                                     figure id start [id=value&...], its text the caption; exercise id start
///                                     [id=value&...], its last lines `goal:`, `hint:` and `done:`
///     ## Title                        a section; its id is made from the title
///
/// A figure's start is a start document of the core's table (core/knotwork/scene/chapters.cpp), then the parameters are
/// set; or it is `file`, a whole document in shell/scenes/<id>.json.

export interface Chapter {
  id: string;
  title: string;
  summary: string;
  sections: { id: string; title: string }[];
  figures: FigureSource[];
  html: string;
}

/// What a figure or an exercise shows.
export interface FigureSource {
  id: string;
  start: string;   ///< the id of a start document, or `file`: scenes/<id>.json
  values: string;  ///< id=value of parameters to be set, joined by &
}

/// Exercises are numbered within the chapter, whose number is `number`.
export function renderChapter(source: string, mathematics: Mathematics, number = 0): Chapter {
  const head = /^---\n([\s\S]*?)\n---\n/.exec(source);
  if (!head) throw new Error('a chapter starts with a head between two lines of ---');
  const fields = new Map<string, string>();
  for (const line of (head[1] ?? '').split('\n')) {
    const colon = line.indexOf(':');
    if (colon < 0) throw new Error(`a chapter's head has lines of "key: value", not "${line}"`);
    fields.set(line.slice(0, colon).trim(), line.slice(colon + 1).trim());
  }
  const field = (name: string): string => {
    const value = fields.get(name);
    if (!value) throw new Error(`a chapter's head needs "${name}"`);
    return value;
  };
  const sections: Chapter['sections'] = [];
  const figures: FigureSource[] = [];
  const html = markdown(mathematics, sections, figures, number).render(source.slice(head[0].length));
  return { id: field('id'), title: field('title'), summary: field('summary'), sections, figures, html };
}

/// Sources are named from here; every npm script runs in the shell's folder.
const repository = '..';

/// Chapters stand on one page: no two things in them may have one name, and what a link leads to is there.
export function checkNames(chapters: readonly Chapter[]): void {
  const names = new Set<string>();
  const take = (name: string): void => {
    if (names.has(name)) throw new Error(`two things on the page are called "${name}"`);
    names.add(name);
  };
  for (const { id, sections, figures } of chapters) {
    take(id);
    sections.forEach((section) => take(section.id));
    figures.forEach((figure) => take(`figure-${figure.id}`));
  }
  for (const { id, html } of chapters)
    for (const [, name] of html.matchAll(/<a [^>]*href="#([^"]*)"/g))
      if (!names.has(name!)) throw new Error(`the chapter "${id}" links to "#${name}", which is not there`);
}

export function slug(title: string): string {
  return title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');
}

function markdown(
  mathematics: Mathematics,
  sections: Chapter['sections'],
  figures: FigureSource[],
  number: number,
): MarkdownIt {
  const md = createMarkdown({ typographer: false, html: false });
  md.validateLink = (link) => !/^(javascript|vbscript|data|file):/i.test(link);
  addMathematics(md, mathematics);
  addBlocks(md, figures, number);
  addLinks(md);
  md.renderer.rules['heading_open'] = (tokens, index, options, _env, self) => {
    const token = tokens[index]!;
    if (token.tag === 'h2') {
      const title = tokens[index + 1]!.content;
      const id = slug(title);
      if (sections.some((section) => section.id === id)) throw new Error(`two sections are called "${title}"`);
      sections.push({ id, title });
      token.attrSet('id', id);
    }
    return self.renderToken(tokens, index, options);
  };
  md.renderer.rules['heading_close'] = (tokens, index, options, _env, self) => {
    const id = tokens[index - 2]!.attrGet('id');
    return `${id ? placeLink(String(id)) : ''}${self.renderToken(tokens, index, options)}`;
  };
  return md;
}

/// The sign beside a heading that leads to it; a script copies its address (src/place_links.ts).
export function placeLink(id: string): string {
  return `<a class="place" href="#${id}" aria-label="Link to this place"></a>`;
}

/// Marked, as its letters are in faces of their own; and so are the symbols of what can be held.
function typeset(mathematics: Mathematics, tex: string, display: boolean): string {
  return `<!--tex-->${mathematics.render(markSymbols(tex), display)}<!--/tex-->`;
}

function addMathematics(md: MarkdownIt, mathematics: Mathematics): void {
  md.inline.ruler.before('escape', 'mathematics', (state, silent) => {
    if (state.src[state.pos] !== '$') return false;
    const end = state.src.indexOf('$', state.pos + 1);
    if (end < 0) throw new Error(`mathematics without an end: ${state.src.slice(state.pos)}`);
    if (!silent) state.push('math_inline', '', 0).content = state.src.slice(state.pos + 1, end);
    state.pos = end + 1;
    return true;
  });
  md.block.ruler.before('fence', 'mathematics', (state, start, last, silent) => {
    const line = (n: number): string => state.src.slice(state.bMarks[n]! + state.tShift[n]!, state.eMarks[n]);
    if (line(start).trim() !== '$$') return false;
    if (silent) return true;
    let end = start + 1;
    while (end < last && line(end).trim() !== '$$') ++end;
    const token = state.push('math_block', '', 0);
    token.content = state.getLines(start + 1, end, 0, false);
    token.map = [start, end + 1];
    state.line = end + 1;
    return true;
  });
  // Punctuation behind a formula or a phrase that acts stays on its line.
  md.core.ruler.push('punctuation', (state) => {
    for (const { children } of state.tokens) {
      let opened: (typeof state.tokens)[number] | undefined;
      children?.forEach((token, index) => {
        if (token.type === 'link_open') opened = token;
        const next = children[index + 1];
        const acts = token.type === 'link_close' && String(opened?.attrGet('href')).startsWith('knotwork:');
        if ((token.type !== 'math_inline' && !acts) || next?.type !== 'text') return;
        token.info = /^[.,:;!?)]+/.exec(next.content)?.[0] ?? '';
        next.content = next.content.slice(token.info.length);
        if (acts && token.info) opened!.meta = { together: true };
      });
    }
  });
  md.renderer.rules['math_inline'] = (tokens, index) => {
    const { content, info } = tokens[index]!;
    return `<span class="math">${typeset(mathematics, content, false)}${info}</span>`;
  };
  md.renderer.rules['math_block'] = (tokens, index) => {
    const [wide = '', narrow] = tokens[index]!.content.split(/^%% narrow$/m);
    const form = (tex: string, name: string): string =>
      `<div class="${name}">${typeset(mathematics, tex.trim(), true)}</div>`;
    const body = narrow === undefined ? form(wide, 'any') : form(wide, 'wide') + form(narrow, 'narrow');
    return `<div class="formula">${body}</div>\n`;
  };
}

/// What is shown on the stage when the reader comes by, and its tools.
function figure(words: string[], figures: FigureSource[]): FigureSource {
  const [id = '', start = '', values = ''] = words;
  if (!id || !start) throw new Error('a figure has a name and a start document');
  const source = { id, start, values };
  figures.push(source);
  return source;
}

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/// The lines between `// [region]` and `// [/region]` of a source, indented as little as may be.
export function excerpt(path: string, region: string): string {
  const lines = readFileSync(join(repository, path), 'utf8').split('\n');
  const at = (mark: string): number => lines.findIndex((line) => line.trim() === `// [${mark}]`);
  const [from, to] = [at(region), at(`/${region}`)];
  if (!region || from < 0 || to < from) throw new Error(`${path} has no region "${region}"`);
  const cut = lines.slice(from + 1, to);
  const indent = Math.min(...cut.filter((line) => line.trim()).map((line) => line.length - line.trimStart().length));
  return cut.map((line) => line.slice(indent)).join('\n');
}

const figureData = ({ id, start, values }: FigureSource): string =>
  `id="figure-${id}" data-figure="${id}" data-start="${escaped(start)}" data-values="${escaped(values)}"`;

const tool = (name: string, words: string): string =>
  `<button type="button" class="tool-word" data-${name} disabled>${words}</button>`;

/// Last the one that is not always there: no gap is left between the others.
export const figureTools = `${tool('show', 'Show')}${tool('copy', 'Copy link')}${tool('again', 'Start again')}`;

/// Control rows are written empty into the page at their final height, so that nothing moves when they are filled.
function block(
  name: string,
  words: string[],
  figures: FigureSource[],
  keyed: ReadonlyMap<string, string>,
): [open: string, close: string] {
  const row = (id: string): string => `<div class="control" data-parameter="${id}"></div>`;
  switch (name) {
    case 'lead':
      return ['<div class="lead">', '</div>'];
    case 'try':
      return ['<aside class="try" aria-label="Try it"><p class="try-title">Try it</p>', '</aside>'];
    case 'note':
      return ['<aside class="note" aria-label="About the report">', '</aside>'];
    case 'sources':
      return ['<aside class="sources" aria-label="Sources"><p class="sources-title">Sources</p>', '</aside>'];
    case 'figure': {
      const source = figure(words, figures);
      return [
        `<figure class="figure" ${figureData(source)}><figcaption><div id="caption-${source.id}">`,
        `</div><p class="figure-tools">${figureTools}</p></figcaption></figure>`,
      ];
    }
    case 'code': {
      const [path = '', region = ''] = (words[0] ?? '').split('#');
      return [`<pre class="code" data-source="${escaped(path)}"><code>${escaped(excerpt(path, region))}</code></pre>`, ''];
    }
    case 'exercise': {
      const source = figure(words, figures);
      const part = (key: string): string => {
        const text = keyed.get(key);
        if (!text) throw new Error(`the exercise "${source.id}" needs a line "${key}:"`);
        return text;
      };
      parseGoal(keyed.get('goal text') ?? '');
      return [
        `<section class="exercise" ${figureData(source)} data-goal="${escaped(keyed.get('goal text') ?? '')}"` +
          ` aria-labelledby="exercise-${source.id}">` +
          `<h3 id="exercise-${source.id}">Exercise <span>${part('number')}</span></h3>` +
          `<div id="caption-${source.id}">`,
        `</div><details class="hint"><summary>Hint</summary><p>${part('hint')}</p></details>` +
          `<p class="figure-tools">${figureTools}<span class="exercise-state"></span></p>` +
          `<p class="exercise-done" hidden>${part('done')}</p></section>`,
      ];
    }
    case 'controls':
      return [`<div class="controls">${words.map(row).join('')}`, '</div>'];
    case 'report':
      return ['<div class="report" data-report>', '</div>'];
    case 'patches':
      return ['<div class="controls"><div class="control" data-patches></div>', '</div>'];
    case 'settings':
      return ['<div class="settings" data-settings>', '</div>'];
    default:
      throw new Error(`there is no block called "${name}"`);
  }
}

/// The lines `key: text` at the end of an exercise.
const keyedLine = /^(goal|hint|done):\s+(.+)$/;

function addBlocks(md: MarkdownIt, figures: FigureSource[], number: number): void {
  let exercises = 0;
  md.block.ruler.before(
    'fence',
    'blocks',
    (state, start, last, silent) => {
      const line = (n: number): string => state.src.slice(state.bMarks[n]! + state.tShift[n]!, state.eMarks[n]).trim();
      const opening = /^:::\s*(\w.*)$/.exec(line(start));
      if (!opening) return false;
      if (silent) return true;
      let end = start + 1;
      while (end < last && line(end) !== ':::') ++end;
      if (end >= last) throw new Error(`a block without an end: ${line(start)}`);
      const [name = '', ...words] = opening[1]!.split(/\s+/);
      const keyed = new Map<string, string>();
      let bodyEnd = end;
      for (let n = start + 1; name === 'exercise' && n < end; ++n) {
        const [, key, text] = keyedLine.exec(line(n)) ?? [];
        if (!key || !text) {
          if (bodyEnd < end) throw new Error(`an exercise ends with its lines goal, hint and done, not: ${line(n)}`);
          continue;
        }
        bodyEnd = Math.min(bodyEnd, n);
        keyed.set(key, md.renderInline(text));
        keyed.set(`${key} text`, text);
      }
      if (name === 'exercise') keyed.set('number', `${number}.${++exercises}`);
      const [open, close] = block(name, words, figures, keyed);
      state.push('html_block', '', 0).content = `${open}\n`;
      const lineMax = state.lineMax;
      state.lineMax = bodyEnd;
      state.md.block.tokenize(state, start + 1, bodyEnd);
      state.lineMax = lineMax;
      state.push('html_block', '', 0).content = `${close}\n`;
      state.line = end + 1;
      return true;
    },
    { alt: ['paragraph', 'reference', 'blockquote', 'list'] },
  );
}

function addLinks(md: MarkdownIt): void {
  const closing: string[] = [];
  md.renderer.rules['link_open'] = (tokens, index, options, _env, self) => {
    const token = tokens[index]!;
    const href = String(token.attrGet('href') ?? '');
    if (href.startsWith('knotwork:')) {
      parseAction(href.slice(9));
      const together = Boolean(token.meta?.together);
      closing.push(together ? '</span>' : '', '</button>');
      return `${together ? '<span class="together">' : ''}<button type="button" class="act" data-run="${md.utils.escapeHtml(href.slice(9))}" disabled>`;
    }
    if (href.startsWith('fact:')) {
      closing.push('');
      return '';
    }
    if (href.startsWith('hue:')) {
      closing.push('</span>');
      return `<span class="local-${md.utils.escapeHtml(href.slice(4))}">`;
    }
    closing.push('</a>');
    return self.renderToken(tokens, index, options);
  };
  md.renderer.rules['link_close'] = (tokens, index) => {
    const close = closing.pop() ?? '';
    return close === '</button>' ? `${close}${tokens[index]!.info}${closing.pop() ?? ''}` : close;
  };
}
