import type { Parameter } from './knotwork';
import { pseudo } from './pseudo';
import { filled, translation } from './translation';

/// What the page's scripts say, in the page's language: English as it stands in the source is the key. `{}` in a
/// sentence stands for a value; a sentence that came with its values, as the module's do, is found by its form all the
/// same. What has no translation is said in English.
export function say(english: string, ...values: readonly (string | number)[]): string {
  const words = translate ? translate(english) : english;
  return values.length > 0 ? filled(words, values) : words;
}

/// A row of the parameter table with its words in the page's language.
export function sayRow(row: Parameter): Parameter {
  if (!__WORDS__) return row;
  const choices = row.choices.map(({ id, label, refused }) => ({ id, label: say(label), refused: say(refused) }));
  const [label, group, unit, disabled] = [say(row.label), say(row.group), say(row.unit), say(row.disabled)];
  return { ...row, label, group, unit, disabled, choices };
}

const translate = __WORDS__ === 'pseudo' ? pseudo : __WORDS__ ? translation(__WORDS__) : null;
