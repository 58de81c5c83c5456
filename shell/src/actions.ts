import type { Bridge } from './bridge';
import { parseValue, type Value } from './goals';
import type { Parameter } from './knotwork';

/// What a phrase of the prose does: `set?id=value&id=value`, `play`, `pause`, `open?id=chapter`.
export type Action =
  | { kind: 'set'; values: [id: string, value: Value][] }
  | { kind: 'play' | 'pause' }
  | { kind: 'open'; chapter: string };

export function parseAction(text: string): Action {
  const [name, query = ''] = text.split('?');
  const pairs = [...new URLSearchParams(query)];
  if (name === 'play' || name === 'pause') return { kind: name };
  if (name === 'open' && pairs[0]?.[0] === 'id') return { kind: 'open', chapter: pairs[0][1] };
  if (name === 'set' && pairs.length > 0) return { kind: 'set', values: pairs.map(([id, value]) => [id, parseValue(value)]) };
  throw new Error(`a phrase cannot do "${text}"`);
}

export function run(action: Action, bridge: Bridge): void {
  switch (action.kind) {
    case 'set':
      for (const [id, value] of action.values) bridge.set(id, value);
      break;
    case 'play':
    case 'pause':
      bridge.play(action.kind === 'play');
      break;
    case 'open':
      bridge.open(action.chapter);
      break;
  }
}

/// Whether what is on the stage has the parameters that the action is about.
export function applies(action: Action, parameters: ReadonlyMap<string, Parameter>): boolean {
  if (action.kind === 'open') return true;
  return action.kind === 'set' ? action.values.every(([id]) => parameters.has(id)) : parameters.has('animation.playing');
}

/// Whether the action has nothing left to do.
export function fulfilled(action: Action, parameters: ReadonlyMap<string, Parameter>): boolean {
  if (action.kind === 'set') return action.values.every(([id, value]) => parameters.get(id)?.value === value);
  if (action.kind === 'open') return false;
  return parameters.get('animation.playing')?.value === (action.kind === 'play');
}
