import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { HtmlTagDescriptor, Plugin } from 'vite';
import { card } from './card';
import { checkNames, figureTools, placeLink, renderChapter, type Chapter } from './chapter';
import { makeFonts } from './fonts';
import { Language } from './language';
import { Mathematics } from './mathematics';
import { Stills, withStills } from './stills';

export interface PageOptions {
  root: string;             ///< the shell's folder
  moduleDirectory: string;  ///< where knotwork.js, knotwork.wasm, later.wasm, last.wasm and knotwork_stills.js are
  policy: string;           ///< content security policy of the built page
  sourceUrl: string;        ///< where the source can be read; '' for no link
  siteAddress: string;      ///< where the page will stand, as https://host/path/; '' where that is not known
  language: string;         ///< of the page: see language.ts
}

interface PageChapter extends Chapter {
  foreign: boolean;  ///< in English on a page of another language
}

/// Writes the chapters into index.html as real HTML, makes the fonts and the mathematics' stylesheet, and has the
/// figures' still pictures drawn.
export function page(options: PageOptions): Plugin {
  const generated = join(options.root, 'generated');
  const chapterDirectory = join(options.root, 'chapters');
  const sceneDirectory = join(options.root, 'scenes');
  const language = new Language(options.root, options.language);
  let chapters: PageChapter[] = [];
  let stills: Stills | undefined;

  const prepare = async (): Promise<void> => {
    const mathematics = new Mathematics();
    chapters = readdirSync(chapterDirectory)
      .filter((name) => name.endsWith('.md'))
      .sort()
      .map((name) => {
        try {
          const { source, own } = language.chapter(name);
          const chapter = renderChapter(source, mathematics, Number.parseInt(name, 10));
          return { ...chapter, html: withStills(chapter.html, chapter.figures), foreign: !own };
        } catch (error) {
          throw new Error(`chapters/${name}: ${error instanceof Error ? error.message : String(error)}`);
        }
      });
    checkNames(chapters);
    mkdirSync(generated, { recursive: true });
    stills ??= await Stills.make(options.moduleDirectory, sceneDirectory);
    stills.write(join(generated, 'stills'), chapters.flatMap(({ figures }) => figures));
    const page = chapters.map(({ html }) => html).join('');
    writeFileSync(join(generated, 'mathematics.css'), mathematics.stylesheet(page));
    const words = chapters.map(({ html, foreign }) => (foreign ? html : language.html(html)).replace(typeset, ''));
    const text = words.join('').replace(/<[^>]*>/g, '');
    const italic = words.flatMap((html) => [...html.matchAll(/<em>(.*?)<\/em>/gs)].map((match) => match[1]!));
    const frame = language.html(readFileSync(join(options.root, 'index.html'), 'utf8')) + language.letters();
    await makeFonts(generated, text + frame, italic.join('').replace(/<[^>]*>/g, ''), mathematics);
  };

  return {
    name: 'knotwork-page',

    async buildStart() {
      for (const file of ['knotwork.js', 'knotwork.wasm', 'later.wasm', 'last.wasm']) {
        const path = join(options.moduleDirectory, file);
        if (existsSync(path)) continue;
        throw new Error(
          `${path} is missing: build the module first (cmake --workflow --preset web), or set KNOTWORK_MODULE_DIR`,
        );
      }
      await prepare();
    },

    config: () => ({
      define: {
        __WASM_BYTES__: JSON.stringify(sizeOf(join(options.moduleDirectory, 'knotwork.wasm'))),
        __WORDS__: JSON.stringify(language.words),
      },
    }),

    async handleHotUpdate({ file, server }) {
      if (!file.startsWith(chapterDirectory) && !file.startsWith(sceneDirectory)) return;
      await prepare();
      server.ws.send({ type: 'full-reload' });
    },

    transformIndexHtml: {
      order: 'pre',
      handler: (html) => {
        const whole = html
          .replace('<!--sections-->', () => sectionMarks(chapters))
          .replace('<!--contents-->', () => contents(chapters))
          .replace('<!--chapters-->', () => chapters.map((_, index) => article(chapters, index)).join('\n'))
          .replace('<!--source-->', () => sourceLink(options.sourceUrl))
          .replace('<!--card-->', () => card(options.siteAddress))
          .replaceAll('%SUMMARY%', () => chapters[0]?.summary ?? '');
        return language
          .html(whole)
          .replace(/<!--\/?(?:tex|foreign)-->/g, '')
          .replace('<html lang="en">', `<html lang="${language.tag}">`);
      },
    },
  };
}

/// The policy, and hints for what the first visit needs: known only when the bundle is.
export function head(options: PageOptions): Plugin {
  return {
    name: 'knotwork-head',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler: (html, context) => {
        const tags: HtmlTagDescriptor[] = [];
        const preload = (file: string, attributes: Record<string, string | boolean>): void => {
          tags.push({ tag: 'link', attrs: { href: `./${file}`, ...attributes }, injectTo: 'head' });
        };
        const files = Object.keys(context.bundle ?? {});
        // In the order of their lines. The module is the longest to arrive and the figure waits for it; then come the
        // faces that the first screen shows, or its text would move when one comes late.
        for (const file of files.filter((name) => /\/knotwork-[\w-]+\.wasm$/.test(name)))
          preload(file, { rel: 'preload', as: 'fetch', crossorigin: true });
        for (const file of files.filter((name) => /\/knotwork-[\w-]+\.js$/.test(name)))
          preload(file, { rel: 'modulepreload', crossorigin: true });
        for (const face of ['serif', 'stage-400', 'stage-600'])
          for (const file of files.filter((name) => new RegExp(`/${face}-[\\w-]{8}\\.(woff2|ttf)$`).test(name)))
            preload(file, { rel: 'preload', as: 'font', type: `font/${file.split('.').at(-1)}`, crossorigin: true });
        const meta = `<meta http-equiv="Content-Security-Policy" content="${options.policy}">`;
        return { html: html.replace(/(<meta charset="[^"]*">)/, `$1\n    ${meta}`), tags };
      },
    },
  };
}

/// What is typeset in mathematics' own faces; see chapter.ts.
const typeset = /<!--tex-->[\s\S]*?<!--\/tex-->/g;

function sizeOf(path: string): number {
  return existsSync(path) ? statSync(path).size : 0;
}

function article(chapters: readonly PageChapter[], index: number): string {
  const chapter = chapters[index]!;
  const neighbour = (other: Chapter | undefined, relation: 'prev' | 'next', word: string): string =>
    other ? `<a rel="${relation}" href="#${other.id}"><span>${word}</span> ${other.title}</a>` : '';
  const turn =
    chapters.length > 1
      ? `<nav class="turn" aria-label="Before and after: ${chapter.title}">` +
        `${neighbour(chapters[index - 1], 'prev', 'Before')}${neighbour(chapters[index + 1], 'next', 'Next')}</nav>\n`
      : '';
  // What the scripts go on to say in the page's language begins in it.
  const tools = chapter.foreign ? `<!--/foreign-->${figureTools}<!--foreign-->` : figureTools;
  const text = `<h1>${chapter.title}${placeLink(chapter.id)}</h1>\n${chapter.html.replaceAll(figureTools, tools)}`;
  return (
    `<article class="chapter" id="${chapter.id}" data-chapter="${chapter.id}"${chapter.foreign ? ' lang="en"' : ''}>\n` +
    `${chapter.foreign ? `<!--foreign-->${text}<!--/foreign-->` : text}${turn}</article>`
  );
}

/// The chapters, with the progress of their exercises, which a script fills in.
function contents(chapters: readonly Chapter[]): string {
  const rows = chapters.map(
    ({ id, title }) => `<li><a href="#${id}">${title}</a><span class="progress-of" data-progress="${id}"></span></li>`,
  );
  return (
    `<details class="contents" id="contents"><summary>Chapters</summary><div><ol>${rows.join('')}</ol>` +
    '<button type="button" class="tool-word" id="forget" hidden>Forget my progress</button></div></details>'
  );
}

/// One mark for each section; those of the chapter being read are shown.
function sectionMarks(chapters: readonly Chapter[]): string {
  return chapters
    .map(({ id, title, sections }) => {
      const marks = sections.map(
        (section) =>
          `<li><a href="#${section.id}" title="${section.title}"><span class="hidden">${section.title}</span></a></li>`,
      );
      return `<ol class="marks" aria-label="Sections: ${title}" data-marks="${id}">${marks.join('')}</ol>`;
    })
    .join('');
}

function sourceLink(url: string): string {
  return url ? `<a class="quiet" href="${url}">Source</a>` : '';
}
