import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pseudo } from '../src/pseudo';

/// What the page's words become. English is what the sources are written in. Another language is a folder
/// languages/<tag>/ with the chapters that have been translated, under the names that they have in chapters/, and with
/// words.json, an object of English and its translation: the frame, the panels beside the prose, what scripts say.
/// "pseudo" is English in a disguise (src/pseudo.ts), for the tests.
export class Language {
  readonly tag: string;
  /// What scripts look words up in; null for English.
  readonly words: Readonly<Record<string, string>> | 'pseudo' | null;
  private readonly root: string;
  private readonly name: string;

  constructor(root: string, name: string) {
    this.root = root;
    this.name = name;
    this.tag = name === 'pseudo' ? 'en-XA' : name;
    if (name === 'en' || name === 'pseudo') {
      this.words = name === 'en' ? null : 'pseudo';
      return;
    }
    if (!/^[a-z]{2,3}(-[A-Za-z0-9]+)*$/.test(name))
      throw new Error(`KNOTWORK_LANGUAGE: "${name}" is not a language tag`);
    const file = this.file('words.json');
    if (!existsSync(file)) throw new Error(`KNOTWORK_LANGUAGE is ${name}: there is no languages/${name}/words.json`);
    const words: unknown = JSON.parse(readFileSync(file, 'utf8'));
    if (typeof words !== 'object' || words === null || Object.values(words).some((word) => typeof word !== 'string'))
      throw new Error(`languages/${name}/words.json is to hold an object of texts`);
    this.words = words as Record<string, string>;
  }

  /// The source of a chapter, and whether it is in this language.
  chapter(name: string): { source: string; own: boolean } {
    const translated = this.file(name);
    const own = this.name !== 'en' && existsSync(translated);
    const path = own ? translated : join(this.root, 'chapters', name);
    return { source: readFileSync(path, 'utf8'), own: own || this.name === 'en' || this.name === 'pseudo' };
  }

  /// HTML of ours with its texts and its spoken attributes in this language. Mathematics, code and scripts stay.
  html(html: string): string {
    if (!this.words) return html;
    return html.replace(parts, (whole, kept?: string, tag?: string) => {
      if (kept !== undefined) return whole;
      if (tag === undefined) return this.text(whole);
      return tag.replace(spoken, (_, name: string, text: string) => `${name}="${quoted(this.text(text))}"`);
    });
  }

  /// Letters that no text of the page may have, but its scripts may say.
  letters(): string {
    if (this.words === 'pseudo') return pseudo('abcdefghijklmnopqrstuvwxyz ABCDEFGHIJKLMNOPQRSTUVWXYZ');
    return this.words ? Object.values(this.words).join('') : '';
  }

  private text(text: string): string {
    if (this.words === 'pseudo')
      return text
        .split(/(&[#\w]+;)/)
        .map((part, k) => (k % 2 === 0 ? pseudo(part) : part))
        .join('');
    const [, before = '', words = '', after = ''] = /^(\s*)([\s\S]*?)(\s*)$/.exec(text) ?? [];
    const plain = words.replace(/\s+/g, ' ');
    const translation = (this.words as Record<string, string>)[plain];
    return translation === undefined ? text : `${before}${translation}${after}`;
  }

  private file(name: string): string {
    return join(this.root, 'languages', this.name, name);
  }
}

/// A translation may have quotation marks where English has none.
function quoted(text: string): string {
  return text.replaceAll('"', '&quot;');
}

/// What stays as it is; a chapter without a translation as a whole.
const untouched = [
  /<!--foreign-->[\s\S]*?<!--\/foreign-->/,
  /<!--tex-->[\s\S]*?<!--\/tex-->/,
  /<!--[\s\S]*?-->/,
  /<!doctype[^>]*>/,
  /<(?:script|style|pre|code)\b[\s\S]*?<\/(?:script|style|pre|code)>/,
  /<svg\b[\s\S]*?<\/svg>/,
];
/// What stays, a tag, or the text between tags.
const parts = new RegExp(`(${untouched.map(({ source }) => source).join('|')})|(<(?:"[^"]*"|[^">])*>)|[^<]+`, 'gi');
const spoken = /\b(aria-label|title|alt|placeholder)="([^"]*)"/g;
