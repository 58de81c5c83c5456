import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import katex from 'katex';

/// KaTeX's families that hold what is not a variable's letter.
const families = ['Main', 'AMS', 'Caligraphic'].map((name) => `KaTeX_${name}`);
const largeFamilies = ['Main', 'Size1', 'Size2', 'Size3', 'Size4'].map((name) => `KaTeX_${name}`);

/// Typesets TeX at build time, as HTML for the eye and MathML for everyone else. `\htmlClass{local-a}{...}` colours a
/// symbol. KaTeX's style attributes become classes, so that the page's policy can forbid inline styles.
export class Mathematics {
  private readonly classes = new Map<string, string>();
  private readonly symbols = new Map<string, Set<string>>();
  private readonly used = new Set<string>();

  render(tex: string, display: boolean): string {
    const html = katex.renderToString(tex, {
      displayMode: display,
      output: 'htmlAndMathml',
      throwOnError: true,
      strict: (code: string) => (code === 'htmlExtension' ? 'ignore' : 'error'),
      trust: (context) => context.command === '\\htmlClass',
    });
    const visible = html.slice(html.indexOf('</math>'));
    this.collect(visible);
    for (const [, names] of visible.matchAll(/class="([^"]*)"/g)) {
      this.used.add(names ?? '');
    }
    // Without the TeX again, for nobody on this page, and without what HTML's parser knows.
    const lean = html.replace(/<annotation[\s\S]*?<\/annotation>|<\/?semantics>| xmlns="[^"]*"/g, '');
    return lean.replace(/<(\w+)((?:\s+[\w-]+="[^"]*")*)>/g, (tag, name: string, attributes: string) => {
      const style = /\sstyle="([^"]*)"/.exec(attributes)?.[1];
      if (style === undefined) return tag;
      const rest = attributes.replace(/\sstyle="[^"]*"/, '');
      const styled = this.className(style);
      return /\sclass="/.test(rest)
        ? `<${name}${rest.replace(/class="([^"]*)"/, `class="$1 ${styled}"`)}>`
        : `<${name}${rest} class="${styled}">`;
    });
  }

  /// KaTeX's rules without its font faces, those of classes that the page has, whatever they exclude by :not(), and the
  /// rules for the style attributes met so far. The doubled class wins over KaTeX's own rules as the attribute did.
  stylesheet(page: string): string {
    const source = readFileSync(createRequire(import.meta.url).resolve('katex/dist/katex.min.css'), 'utf8');
    const own = [...this.classes].map(([style, name]) => `.${name}.${name}.${name}.${name}{${style}}`).join('\n');
    const known = new Set([...page.matchAll(/class="([^"]*)"/g)].flatMap(([, names]) => (names ?? '').split(' ')));
    const used = (selector: string): boolean =>
      [...selector.replace(/:not\([^)]*\)/g, '').matchAll(/\.([\w-]+)/g)].every(([, name]) => known.has(name ?? ''));
    const rules = source.replace(/@font-face\s*\{[^}]*\}/g, '').replace(/([^{}]+)(\{[^{}]*\})/g, (_, selectors: string, body: string) => {
      const kept = selectors.split(',').filter(used);
      return kept.length > 0 ? kept.join(',') + body : '';
    });
    return `${rules}\n${own}\n`;
  }

  /// The characters typeset so far in one of KaTeX's families, for subsetting it.
  characters(family: string): string {
    return [...(this.symbols.get(family) ?? [])].join('');
  }

  /// Whether some typeset element has all of these classes: tells which of KaTeX's fonts are in use.
  uses(classes: string): boolean {
    const wanted = classes.split(' ');
    return [...this.used].some((names) => wanted.every((name) => names.split(' ').includes(name)));
  }

  /// Letters of variables are in the italic face; what stands in other spans may be in any of the others.
  private collect(visible: string): void {
    const add = (family: string, text: string): void => {
      const known = this.symbols.get(family) ?? new Set<string>();
      for (const symbol of text.replace(/&\w+;/g, '<>&')) known.add(symbol);
      this.symbols.set(family, known);
    };
    const rest = visible.replace(/<span class="[^"]*\bmathnormal\b[^"]*"[^>]*>([^<]*)<\/span>/g, (_, letters: string) => {
      add('KaTeX_Math', letters);
      return '';
    });
    // Large delimiters and operators have faces of their own.
    const small = rest.replace(/<span class="[^"]*\b(?:delim-?siz|op-symbol)[^"]*"[^>]*>([\s\S]*?)<\/span>/g, (_, signs: string) => {
      for (const family of largeFamilies) add(family, signs.replace(/<[^>]*>/g, ''));
      return '';
    });
    for (const family of families) add(family, small.replace(/<[^>]*>/g, ''));
  }

  private className(style: string): string {
    let name = this.classes.get(style);
    if (name === undefined) {
      name = `mx${this.classes.size.toString(36)}`;
      this.classes.set(style, name);
    }
    return name;
  }
}
