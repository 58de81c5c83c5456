/// When an exercise is solved: comparisons joined by `and`, as `fit.rms < 0.02 and fitted.count <= 7`. A name is that of
/// a parameter or of a measure (core/knotwork/scene/measures.h).

export type Value = number | string | boolean;

export interface Comparison {
  name: string;
  sign: '<' | '<=' | '>' | '>=' | '=' | '!=';
  value: Value;
}

export function parseGoal(text: string): Comparison[] {
  return text.split(/\s+and\s+/).map((part) => {
    const [, name, sign, value] = /^\s*([a-z][\w.]*)\s*(<=|>=|!=|<|>|=)\s*(\S+)\s*$/.exec(part) ?? [];
    if (!name || !sign || !value) throw new Error(`a goal is a list of comparisons, not "${part}"`);
    const parsed = parseValue(value);
    if (/[<>]/.test(sign) && typeof parsed !== 'number') throw new Error(`"${part}" compares with no number`);
    return { name, sign: sign as Comparison['sign'], value: parsed };
  });
}

/// Whether all comparisons hold. What has no value now (a measure of another kind of figure) holds in none.
export function reached(goal: readonly Comparison[], look: (name: string) => Value | undefined): boolean {
  return goal.every(({ name, sign, value }) => {
    const now = look(name);
    if (now === undefined) return false;
    if (sign === '=') return now === value;
    if (sign === '!=') return now !== value;
    if (typeof now !== 'number' || typeof value !== 'number') return false;
    switch (sign) {
      case '<':
        return now < value;
      case '<=':
        return now <= value;
      case '>':
        return now > value;
      case '>=':
        return now >= value;
    }
  });
}

export function parseValue(text: string): Value {
  if (text === 'true' || text === 'false') return text === 'true';
  return text !== '' && Number.isFinite(Number(text)) ? Number(text) : text;
}
