/// From English to a language, by its words. A sentence that has values in it by now is found by its key with "{}" in
/// their place; the values are said too where they have words. "{}" in a translation is the next value, "{2}" the second.
export function translation(words: Readonly<Record<string, string>>): (english: string) => string {
  const exact = new Map(Object.entries(words));
  const forms = Object.keys(words)
    .filter((key) => key.includes('{}') && /\p{L}/u.test(key))
    .sort((a, b) => b.length - a.length)  // what has more words of its own is meant more likely
    .map((key) => ({ key, pattern: new RegExp(`^${key.split('{}').map(escaped).join('(.+?)')}$`, 's') }));
  const composed = new Map<string, string>();

  function find(english: string): string {
    for (const { key, pattern } of forms) {
      const values = pattern.exec(english)?.slice(1);
      // What matches itself is a form, not a sentence made of it.
      if (values && !values.includes('{}')) return filled(words[key]!, values.map(say));
    }
    // A name with its indices, as "Patch 2, 1".
    const [, kind, indices] = /^(.*?)( \d+(?:, \d+)?)$/s.exec(english) ?? [];
    return kind === undefined ? english : (exact.get(kind) ?? kind) + indices;
  }
  function say(english: string): string {
    const known = exact.get(english) ?? composed.get(english);
    if (known !== undefined) return known;
    if (composed.size >= mostKept) composed.clear();
    const found = find(english);
    composed.set(english, found);
    return found;
  }
  return say;
}

/// A form with its values; those that are missing stay open.
export function filled(form: string, values: readonly (string | number)[]): string {
  let next = 0;
  return form.replace(/\{([1-9]?)\}/g, (place, number: string) => {
    const value = values[number ? Number(number) - 1 : next];
    next += 1;
    return value === undefined ? place : String(value);
  });
}

const mostKept = 500;
const escaped = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
