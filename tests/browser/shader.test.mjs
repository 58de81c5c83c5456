// The vertex shader beside the core, vertex by vertex (tests/gpu).
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join, resolve, dirname } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { serve } from '../../shell/scripts/static.mjs';
import { closeShared, openPage } from './site.mjs';

const folder = resolve(dirname(fileURLToPath(import.meta.url)), '../../build/web/tests/gpu');

// A float has 24 bits: 6e-8 a rounding, of which a point goes through some tens. Normals are compared down to partials
// that are a twentieth of a right angle apart, which makes twenty times as much of it.
const mostPoint = 1e-6;
const mostAngle = 5e-5;

let results;
before(async () => {
  assert.ok(existsSync(join(folder, 'shader_check.wasm')), 'the check is not built: cmake --build --preset web');
  const server = await serve(folder, 0);
  try {
    const { page, close, complaints } = await openPage({
      address: `http://localhost:${server.address().port}/`,
      wait: false,
    });
    await page.waitForFunction(() => window.results, null, { timeout: 60000 }).catch((error) => {
      throw new Error(`${error.message}\n${complaints().join('\n')}`);
    });
    results = await page.evaluate(() => window.results);
    assert.deepEqual(complaints(), []);
    await close();
  } finally {
    server.closeAllConnections();
    server.close();
  }
});
after(closeShared);

test('the shader draws blending and B-spline surfaces where the core has them, to float accuracy, normals included', () => {
  const held = results.filter((result) => !result.name.includes('a wrong map'));
  assert.equal(held.filter(({ name }) => !name.startsWith('sheets of')).length, 20);
  // Local patches by themselves, over seams, twisted ones too.
  assert.equal(held.filter(({ name }) => name.startsWith('sheets of')).length, 14);
  for (const { name, vertices, point, normals, angle, gl } of held) {
    assert.equal(gl, 0, `${name}: GL error ${gl}`);
    assert.ok(vertices > 2000, `${name}: ${vertices} vertices`);
    assert.ok(point < mostPoint, `${name}: points are off by ${point} of the size`);
    if (/^(sheets of )?klein-bottle/.test(name)) continue;  // its partials jump where its pieces meet
    assert.ok(normals > 0.9 * vertices, `${name}: ${normals} normals of ${vertices} vertices`);
    assert.ok(angle < mostAngle, `${name}: normals are off by ${angle} radians`);
  }
});

test('a map that is a ten-thousandth off is noticed', () => {
  for (const name of ['a wrong map', 'sheets of a wrong map']) {
    const wrong = results.find((result) => result.name === name);
    assert.ok(wrong.point > 10 * mostPoint, `${name}: off by ${wrong.point}`);
  }
});
