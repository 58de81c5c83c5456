import type { Parameter } from './knotwork';
import { pseudo } from './pseudo';

/// What the page's scripts say, in the page's language: English as it stands in the source is the key. `{}` in a
/// sentence stands for a value. What has no translation is said in English.
export function say(english: string, ...values: readonly (string | number)[]): string {
  const words = translated(english);
  let next = 0;
  return values.length > 0 ? words.replace(/\{\}/g, () => String(values[next++])) : words;
}

/// A row of the parameter table with its words in the page's language.
export function sayRow(row: Parameter): Parameter {
  if (!__WORDS__) return row;
  const choices = row.choices.map(({ id, label, refused }) => ({ id, label: say(label), refused: say(refused) }));
  const [label, group, unit, disabled] = [say(row.label), say(row.group), say(row.unit), say(row.disabled)];
  return { ...row, label, group, unit, disabled, choices };
}

/// The name of a handle, as "Patch 2, 1": its indices are no words.
export function sayName(name: string): string {
  const [, kind = '', indices = ''] = /^(.*?)((?: \d+(?:, \d+)?)?)$/.exec(name) ?? [];
  return say(kind) + indices;
}

function translated(english: string): string {
  if (!__WORDS__) return english;
  return __WORDS__ === 'pseudo' ? pseudo(english) : (__WORDS__[english] ?? english);
}
