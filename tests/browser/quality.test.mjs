// What shows how good a surface or a curve is: colours of curvature, stripes, and what stands beside them. Pixels are
// held against the script interface's own derivatives.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, cross, documentOf, dot, grid, handlesOf, luminance, minus, picture, pixel, settled, stageRect,
} from './stage.mjs';

const options = { drawn: true, size: [1200, 800] };

/// K = (e g - f^2) / (E G - F^2).
function gaussian({ Su, Sv, Suu, Suv, Svv }) {
  const n = cross(Su, Sv);
  const size = Math.hypot(...n);
  const [e, f, g] = [Suu, Suv, Svv].map((second) => dot(second, n) / size);
  return (e * g - f * f) / (dot(Su, Su) * dot(Sv, Sv) - dot(Su, Sv) ** 2);
}

/// The handles of the torus that face the reader, each with the curvature of the surface there and its place in a
/// picture of the stage.
async function places(page) {
  const [handles, { camera }] = [await handlesOf(page), await documentOf(page)];
  const { u, v } = await grid(page);
  const eye = [
    Math.cos(camera.elevation) * Math.cos(camera.azimuth),
    Math.cos(camera.elevation) * Math.sin(camera.azimuth),
    Math.sin(camera.elevation),
  ].map((c, k) => camera.target[k] + camera.distance * c);
  const stage = await stageRect(page);
  const found = [];
  for (const { id, position, screen } of handles) {
    const [i, j] = id.split('-').slice(1).map(Number);
    const jet = await call(page, 'evaluate', 'surface', [u.centre(i), v.centre(j)], 2);
    assert.ok(Math.hypot(...minus(jet.S, position)) < 1e-6, `${id} is not at its knots`);
    const towards = minus(eye, position);
    const normal = cross(jet.Su, jet.Sv);
    const facing = dot(normal, towards) / (Math.hypot(...normal) * Math.hypot(...towards));
    if (screen && facing > 0.35) found.push({ k: gaussian(jet), at: [screen[0] - stage.x, screen[1] - stage.y] });
  }
  return found;
}

pageTest('domes are orange and saddles blue; the legend says how much', options, async (page) => {
  await call(page, 'open', 'blending-surface');
  await call(page, 'set', 'display.shading', 'gaussian');
  for (const id of ['handles', 'knots']) await call(page, 'set', `display.${id}`, false);
  await settled(page);
  const seen = await picture(page);
  const all = await places(page);
  const [domes, saddles] = [all.filter(({ k }) => k > 0.5), all.filter(({ k }) => k < -0.5)];
  assert.ok(domes.length > 1 && saddles.length > 0, `${domes.length} domes, ${saddles.length} saddles`);
  for (const { k, at } of domes) {
    const [r, , b] = pixel(seen, ...at);
    assert.ok(r > b + 12, `K = ${k}: ${pixel(seen, ...at)}`);
  }
  for (const { k, at } of saddles) {
    const [r, , b] = pixel(seen, ...at);
    assert.ok(b > r + 12, `K = ${k}: ${pixel(seen, ...at)}`);
  }
  // The bar of the legend, above the clock at the left.
  const bar = (x) => pixel(seen, x, seen.height - 109);
  assert.ok(bar(28)[2] > bar(28)[0] + 60, `the scale's lower end is ${bar(28)}`);
  assert.ok(bar(192)[0] > bar(192)[2] + 60, `the scale's upper end is ${bar(192)}`);
  assert.ok(Math.min(...bar(107)) > 200, `the scale's middle is ${bar(107)}`);
});

/// How often light and dark take turns along the surface's middle row.
async function turns(page) {
  const seen = await picture(page);
  let count = 0;
  let last = null;
  for (let x = 0; x < seen.width; ++x) {
    const light = luminance(pixel(seen, x, 0.62 * seen.height));
    const side = light < 0.12 ? 'dark' : light > 0.5 ? 'light' : null;
    if (side && last && side !== last) ++count;
    last = side ?? last;
  }
  return count;
}

pageTest('zebra stripes are stripes, and a body in the light has none', options, async (page) => {
  await call(page, 'open', 'blending-surface');
  for (const id of ['handles', 'knots', 'colours']) await call(page, 'set', `display.${id}`, false);
  await settled(page);
  assert.ok((await turns(page)) < 4);
  await call(page, 'set', 'display.shading', 'zebra');
  await settled(page);
  assert.ok((await turns(page)) > 8);
});
