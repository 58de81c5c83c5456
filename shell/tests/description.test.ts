import assert from 'node:assert/strict';
import { test } from 'node:test';
import { describe } from '../src/description';
import type { Parameter } from '../src/knotwork';

function rows(...given: Pick<Parameter, 'id' | 'label' | 'group' | 'kind' | 'value'>[]): Map<string, Parameter> {
  const rest = { min: null, max: null, softMin: null, softMax: null, step: null, unit: '', choices: [], disabled: '' };
  return new Map(given.map((row) => [row.id, { ...rest, ...row }]));
}

test('the stage is described by what stands there, not by how it is drawn or moved', () => {
  const told = rows(
    { id: 'curve.degree', label: 'degree', group: 'Curve', kind: 'integer', value: 3 },
    { id: 'curve.parameter', label: 't', group: 'Curve', kind: 'number', value: 1.60001 },
    { id: 'display.polygon', label: 'control polygon', group: 'Show', kind: 'toggle', value: true },
    { id: 'display.comb', label: 'curvature comb', group: 'Show', kind: 'toggle', value: false },
    { id: 'samples.u', label: 'samples u', group: 'Sampling', kind: 'integer', value: 100 },
    { id: 'animation.playing', label: 'playing', group: 'Animation', kind: 'toggle', value: true },
  );
  assert.equal(
    describe(told, 'Local curve 3'),
    'As it stands: degree 3, t 1.6. Shown: control polygon. Local curve 3 is selected. It is moving.',
  );
  assert.equal(describe(rows(), ''), '');
});
