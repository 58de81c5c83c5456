import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import type { FigureSource } from './chapter';

interface StillModule {
  ccall(name: string, result: 'string', types: string[], values: (string | boolean)[]): string;
}

/// Still pictures of figures as SVG, drawn from their scenes by the program that the module's build makes beside it
/// (web/still_main.cpp).
export class Stills {
  private readonly module: StillModule;
  private readonly scenes: string;
  /// By what they were drawn from: while a chapter is being edited few figures change.
  private readonly drawn = new Map<string, string>();

  private constructor(module: StillModule, scenes: string) {
    this.module = module;
    this.scenes = scenes;
  }

  static async make(moduleDirectory: string, scenes: string): Promise<Stills> {
    const path = join(moduleDirectory, 'knotwork_stills.js');
    if (!existsSync(path))
      throw new Error(`${path} is missing: build it with the module (cmake --workflow --preset web)`);
    const create = createRequire(import.meta.url)(path) as () => Promise<StillModule>;
    return new Stills(await create(), scenes);
  }

  /// A coarse one takes half the bytes.
  picture({ id, start, values }: FigureSource, coarse = false): string {
    const scene = start === 'file' ? readFileSync(join(this.scenes, `${id}.json`), 'utf8') : '';
    const key = JSON.stringify([start, scene, values, coarse]);
    const known = this.drawn.get(key);
    if (known) return known;
    const types = ['string', 'string', 'string', 'boolean'];
    const svg = this.module.ccall('knotwork_still', 'string', types, [start, scene, values, coarse]);
    if (!svg.startsWith('<svg')) throw new Error(`the figure "${id}" has no still picture: ${svg}`);
    this.drawn.set(key, svg);
    return svg;
  }

  /// Into files <id>.svg of a folder, the first one also as hero.svg.
  write(folder: string, figures: readonly FigureSource[]): void {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    for (const figure of figures) writeFileSync(join(folder, `${figure.id}.svg`), this.picture(figure));
    if (figures[0]) writeFileSync(join(folder, 'hero.svg'), this.picture(figures[0], true));
  }
}

/// A chapter's HTML with each figure's still picture before its caption: shown without scripts, without WebGL and in
/// print (prose.css). What it says in words is the caption's first sentence.
export function withStills(html: string, figures: readonly FigureSource[]): string {
  return figures.reduce((chapter, { id }) => {
    const mark = `<div id="caption-${id}">`;
    const start = chapter.indexOf(mark);
    if (start < 0) throw new Error(`the figure "${id}" has no caption`);
    const end = chapter.indexOf('</div>', start);
    const alt = plain(chapter.slice(start + mark.length, end));
    const image =
      `<img class="still" src="./generated/stills/${id}.svg" width="720" height="440" loading="lazy" alt="${alt}">`;
    return `${chapter.slice(0, start)}${image}${chapter.slice(start)}`;
  }, html);
}

/// The first sentence, formulas left out.
function plain(caption: string): string {
  const text = caption
    .replace(/<!--tex-->[\s\S]*?<!--\/tex-->/g, '…')
    .replace(/<[^>]*>/g, '')
    .replace(/\s+/g, ' ')
    .replaceAll('"', '&quot;')
    .trim();
  return /^.{20,}?[.:](?= |$)/.exec(text)?.[0] ?? text;
}
