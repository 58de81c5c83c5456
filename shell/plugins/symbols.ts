/// What a hand can hold on the stage and a formula names: `point`, a control point; `datum`, a point that a curve is
/// made from; `knot`; `parameter`; `local`, a local curve or patch and its map. While it is held, its letters light up
/// (src/terms.ts). The letters are those of the glossary; without their subscript they denote something else.
export type HeldKind = 'point' | 'datum' | 'knot' | 'parameter' | 'local';

/// With a subscript, these letters denote what can be held.
const indexed: Readonly<Record<string, HeldKind>> = {
  c: 'point',
  p: 'datum',
  t: 'knot',
  u: 'knot',
  v: 'knot',
  l: 'local',
  s: 'local',
  L: 'local',
  M: 'local',
};
/// Without one, these do.
const bare: Readonly<Record<string, HeldKind>> = { t: 'parameter', '\\tau': 'knot' };

/// Ends of lines with a distance, names of environments and classes, and words; a sign over a letter with its letter,
/// as `\bar w`; a symbol, perhaps under a hat; any other command.
const token = new RegExp(
  [
    String.raw`\\\\(?:\[[^\]]*\])?`,
    String.raw`\\(?:begin|end|htmlClass|text|mathrm|operatorname)\s*\{[^}]*\}`,
    String.raw`\\(?:bar|tilde|vec|mathsf|mathcal)\s*[A-Za-z]`,
    String.raw`(\\hat\s*)?(\\tau(?![A-Za-z])|[A-Za-z])((?:'|[_^](?:\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|[^\\{}\s]))*)`,
    String.raw`\\(?:[A-Za-z]+|.)`,
  ].join('|'),
  'g',
);

/// TeX with `{\htmlClass{of-<kind>}{...}}` round each symbol of what can be held, its scripts included. The outer
/// braces make one thing of it: it can be a script or an argument, and the space behind it stays outside.
export function markSymbols(tex: string): string {
  return tex.replace(token, (whole: string, hat: string | undefined, letter: string | undefined, scripts = '') => {
    if (letter === undefined) return whole;
    const kind = /_/.test(scripts) ? indexed[letter] : hat ? undefined : bare[letter];
    // A model, as \hat c, is not held.
    if (!kind || (hat && kind !== 'local')) return hat || !scripts ? whole : letter + markScripts(scripts);
    return `{\\htmlClass{of-${kind}}{${whole}}}`;
  });
}

/// In the scripts of a symbol that cannot be held there may be one that can.
function markScripts(scripts: string): string {
  return scripts.replace(/\{((?:[^{}]|\{[^{}]*\})*)\}/g, (_, inner: string) => `{${markSymbols(inner)}}`);
}
