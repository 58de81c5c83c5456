import type { Parameter } from './knotwork';
import { say } from './words';

/// Groups of rows that are not told: how what stands on the stage is drawn or moved, and the measures of its model.
const silent = ['Sampling', 'Motion', 'Model', 'Animation'];

/// What stands on the stage, for those who do not see it: "As it stands: curve open, degree 3, t 1.6. Shown: knots,
/// control polygon. Point 2 is selected." The rows are in the page's language; `selected` is a handle's name in English,
/// '' for none.
export function describe(rows: ReadonlyMap<string, Parameter>, selected: string): string {
  const told = [...rows.values()].filter(({ group }) => !silent.some((name) => group === say(name)));
  const facts = told
    .filter(({ group, kind }) => group !== say('Show') && kind !== 'toggle')
    .map((row) => `${row.label} ${valueOf(row)}`);
  const shown = told.filter(({ group, value }) => group === say('Show') && value === true).map(({ label }) => label);
  const sentences: string[] = [];
  if (facts.length > 0) sentences.push(say('As it stands: {}.', facts.join(', ')));
  if (shown.length > 0) sentences.push(say('Shown: {}.', shown.join(', ')));
  if (selected) sentences.push(say('{} is selected.', say(selected)));
  if (rows.get('animation.playing')?.value === true) sentences.push(say('It is moving.'));
  return sentences.join(' ');
}

function valueOf({ choices, kind, value, unit }: Parameter): string {
  if (typeof value === 'number')
    return `${kind === 'integer' ? value : Number(value.toPrecision(3))}${unit && ` ${unit}`}`;
  return choices.find(({ id }) => id === value)?.label ?? String(value);
}
