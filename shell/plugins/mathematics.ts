import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import katex from 'katex';

/// Typesets TeX at build time, as HTML for the eye and MathML for everyone else. `\htmlClass{local-a}{...}` colours a
/// symbol. KaTeX's style attributes become classes, so that the page's policy can forbid inline styles.
export class Mathematics {
  private readonly classes = new Map<string, string>();
  private readonly symbols = new Set<string>();
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
    for (const symbol of visible.replace(/<[^>]*>/g, '').replace(/&\w+;/g, '<>&')) this.symbols.add(symbol);
    for (const [, names] of visible.matchAll(/class="([^"]*)"/g)) {
      this.used.add(names ?? '');
    }
    return html.replace(/<(\w+)((?:\s+[\w-]+="[^"]*")*)>/g, (tag, name: string, attributes: string) => {
      const style = /\sstyle="([^"]*)"/.exec(attributes)?.[1];
      if (style === undefined) return tag;
      const rest = attributes.replace(/\sstyle="[^"]*"/, '');
      const styled = this.className(style);
      return /\sclass="/.test(rest)
        ? `<${name}${rest.replace(/class="([^"]*)"/, `class="$1 ${styled}"`)}>`
        : `<${name}${rest} class="${styled}">`;
    });
  }

  /// KaTeX's rules without its font faces, and the rules for the style attributes met so far. The doubled class wins
  /// over KaTeX's own rules as the attribute did.
  stylesheet(): string {
    const source = readFileSync(createRequire(import.meta.url).resolve('katex/dist/katex.min.css'), 'utf8');
    const own = [...this.classes].map(([style, name]) => `.${name}.${name}.${name}.${name}{${style}}`).join('\n');
    return `${source.replace(/@font-face\s*\{[^}]*\}/g, '')}\n${own}\n`;
  }

  /// Every character typeset so far, for subsetting KaTeX's fonts.
  characters(): string {
    return [...this.symbols].join('');
  }

  /// Whether some typeset element has all of these classes: tells which of KaTeX's fonts are in use.
  uses(classes: string): boolean {
    const wanted = classes.split(' ');
    return [...this.used].some((names) => wanted.every((name) => names.split(' ').includes(name)));
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
