const letters: Readonly<Record<string, string>> = {
  a: 'á', e: 'é', i: 'í', o: 'ó', u: 'ú', y: 'ý', c: 'ç', n: 'ñ', A: 'Á', E: 'É', I: 'Í', O: 'Ó', U: 'Ú', C: 'Ç', N: 'Ñ',
};

/// English in a disguise that can be read: accents on the letters, and two fifths longer, as other languages are, by
/// twelve dots at most. Where the page of a pseudo-language shows a word without, the word cannot be translated. Single
/// letters, numbers and what has no letters stay.
export function pseudo(text: string): string {
  if (!/[A-Za-z]{2}/.test(text)) return text;
  const [, before = '', words = '', after = ''] = /^(\s*)([\s\S]*?)(\s*)$/.exec(text) ?? [];
  const accented = words.replace(/\{\}|[A-Za-z]/g, (letter) => letters[letter] ?? letter);
  const longer = Math.round(0.4 * words.length);
  return `${before}${accented}${longer > 0 ? ` ${'·'.repeat(Math.min(longer, 12))}` : ''}${after}`;
}
