// The script interface: its names, its shapes, and the wall that bad input meets.
import assert from 'node:assert/strict';
import { pageTest } from './page_test.mjs';
import {
  call, difference, distance, documentOf, dot, drag, frontHandle, grid, handlesOf, parameter, picture, settled,
  stageRect, statsOf, surfaceOf,
} from './stage.mjs';

pageTest('ready resolves, and every name of the interface is there', {}, async (page) => {
  const kinds = await page.evaluate(() =>
    Object.fromEntries(Object.entries(Object.getOwnPropertyDescriptors(window.knotwork)).map(
      ([name]) => [name, typeof window.knotwork[name]],
    )),
  );
  const functions = [
    'document', 'load', 'parameters', 'set', 'handles', 'widgets', 'evaluate', 'play', 'pause', 'seek', 'undo', 'redo',
    'export', 'stats', 'chapters', 'open',
  ];
  assert.deepEqual(
    kinds,
    { ready: 'object', version: 'string', ...Object.fromEntries(functions.map((name) => [name, 'function'])) },
  );
  assert.equal(await page.evaluate(() => window.knotwork.ready instanceof Promise), true);
  assert.match(await page.evaluate(() => window.knotwork.version), /^\d+\.\d+\.\d+(-[\w.]+)?$/);
});

pageTest('parameters() has the rows of the table, each with a value in its range', {}, async (page) => {
  const rows = await call(page, 'parameters');
  const ids = rows.map((row) => row.id);
  for (const id of [
    'topology.u', 'topology.v', 'model', 'locals.u', 'locals.v', 'blending.function', 'blending.parameter',
    'samples.adaptive', 'samples.u', 'samples.v', 'display.surface', 'display.colours', 'display.knots', 'display.wireframe', 'display.locals',
    'display.frames', 'display.normals', 'display.handles', 'animation.playing', 'animation.time', 'animation.speed',
    'motion.kind', 'motion.amplitude', 'motion.translation', 'motion.rotation',
  ]) {
    assert.ok(ids.includes(id), `${id} is missing`);
  }
  assert.equal(new Set(ids).size, ids.length);
  for (const row of rows) {
    assert.ok(row.label.length > 0, `${row.id} has no label`);
    if (row.kind === 'number' || row.kind === 'integer') {
      assert.ok(row.min < row.max && row.min <= row.value && row.value <= row.max, `${row.id} is out of its range`);
      assert.equal(typeof row.unit, 'string');
    } else if (row.kind === 'choice') {
      assert.ok(row.choices.length > 1);
      assert.ok(row.choices.some((choice) => choice.id === row.value), `${row.id} has a value that is no choice`);
    } else {
      assert.equal(row.kind, 'toggle');
      assert.equal(typeof row.value, 'boolean');
    }
  }
  assert.equal(rows.find((row) => row.id === 'blending.function').choices.length, 11);
});

pageTest('every row of the table can be set to its ends and its choices', {}, async (page) => {
  const set = async (id, value) => {
    await call(page, 'set', id, value);
    assert.deepEqual((await parameter(page, id)).value, value, `${id} has not become ${value}`);
  };
  for (const row of await call(page, 'parameters')) {
    // Many samples have a test of their own; here they would only take time.
    if (row.disabled || row.id.startsWith('samples') || row.id === 'animation.playing') continue;
    if (row.kind === 'choice') {
      for (const choice of row.choices) if (!choice.refused) await set(row.id, choice.id);
    } else if (row.kind === 'toggle') {
      await set(row.id, !row.value);
    } else {
      await set(row.id, row.min);
      if (!row.id.startsWith('locals') && row.id !== 'animation.time') await set(row.id, row.max);
    }
    await set(row.id, row.value);
  }
  await settled(page);
});

pageTest('handles() stands on the surface, and evaluate() gives point and partials', {}, async (page) => {
  await settled(page);
  const handles = await handlesOf(page);
  const { id, u, v } = await grid(page);
  assert.equal(handles.length, u.locals * v.locals);
  for (const handle of handles) {
    const [i, j] = /^patch-(\d+)-(\d+)$/.exec(handle.id).slice(1).map(Number);
    assert.equal(handle.object, id);
    assert.equal(handle.selected, false);
    assert.ok(handle.label.length > 0);
    const { S } = await call(page, 'evaluate', id, [u.centre(i), v.centre(j)], 0);
    assert.ok(distance(S, handle.position) < 1e-12, `${handle.id} is off its surface point`);
  }

  const orders = [['S'], ['S', 'Su', 'Sv'], ['S', 'Su', 'Sv', 'Suu', 'Suv', 'Svv']];
  const at = [0.4, -0.7];
  for (const order of [0, 1, 2]) {
    const jet = await call(page, 'evaluate', id, at, order);
    assert.deepEqual(Object.keys(jet).sort(), [...orders[order]].sort());
    for (const vector of Object.values(jet)) assert.ok(vector.length === 3 && vector.every(Number.isFinite));
  }
  const h = 1e-5;
  const [jet, ahead, behind] = [
    await call(page, 'evaluate', id, at, 2),
    await call(page, 'evaluate', id, [at[0] + h, at[1]], 1),
    await call(page, 'evaluate', id, [at[0] - h, at[1]], 1),
  ];
  const central = (name) => ahead[name].map((x, k) => (x - behind[name][k]) / (2 * h));
  assert.ok(distance(central('S'), jet.Su) < 1e-7 * Math.sqrt(dot(jet.Su, jet.Su)));
  assert.ok(distance(central('Su'), jet.Suu) < 1e-6);
  assert.ok(distance(central('Sv'), jet.Suv) < 1e-6);
});

pageTest('a call that makes no sense throws an error and changes nothing', {}, async (page) => {
  const before = await documentOf(page);
  const id = before.objects[0].id;
  const refused = [
    ['set', 'no.such.row', 1],
    ['set', '', 1],
    ['set', 'locals.u', 0],
    ['set', 'locals.u', 1],
    ['set', 'locals.u', 1e9],
    ['set', 'locals.u', 4.5],
    ['set', 'locals.u', '6'],
    ['set', 'locals.u', true],
    ['set', 'locals.u', null],
    ['set', 'locals.u', [6]],
    ['set', 'samples.v', 4097],
    ['set', 'animation.speed', -1],
    ['set', 'motion.amplitude', 1e300],
    ['set', 'motion.kind', 'waltz'],
    ['set', 'topology.u', 'twisted'],
    ['set', 'topology.u', 0],
    ['set', 'display.wireframe', 'yes'],
    ['set', 'display.wireframe', 1],
    ['evaluate', 'no-such-object', [0, 0], 0],
    ['evaluate', id, [0], 0],
    ['evaluate', id, 0.5, 0],
    ['evaluate', id, ['a', 0], 0],
    ['evaluate', id, [0, 0], 3],
    ['evaluate', id, [0, 0], -1],
    ['evaluate', id, [0, 0], 0.5],
    ['open', 'no-such-chapter'],
    ['seek', 'later'],
    ['export', 'obj'],
    ['export', 'glb'],
    ['export', 'doc'],
  ];
  for (const [name, ...values] of refused) {
    const shown = `${name}(${values.map((value) => JSON.stringify(value)).join(', ')})`;
    await assert.rejects(call(page, name, ...values), (error) => {
      assert.ok(error.isError, `${shown} throws no Error`);
      assert.ok(error.message.length > 10, `${shown} throws without a reason`);
      return true;
    }, `${shown} is not refused`);
    assert.deepEqual(await documentOf(page), before, `${shown} has changed the document`);
  }
  // Values that do not survive the way to the page as JSON.
  const accepted = await page.evaluate((id) => {
    const k = window.knotwork;
    const calls = {
      'set NaN': () => k.set('locals.u', NaN),
      'set Infinity': () => k.set('motion.amplitude', Infinity),
      'set undefined': () => k.set('locals.u', undefined),
      'set nothing': () => k.set('locals.u'),
      'set without an id': () => k.set(),
      'set an object': () => k.set('locals.u', { valueOf: () => 6 }),
      'evaluate at NaN': () => k.evaluate(id, [NaN, 0], 0),
      'evaluate at Infinity': () => k.evaluate(id, [0, Infinity], 0),
      'evaluate nowhere': () => k.evaluate(id, undefined, 0),
      'evaluate nothing': () => k.evaluate(),
      'seek NaN': () => k.seek(NaN),
      'seek Infinity': () => k.seek(Infinity),
      'open nothing': () => k.open(),
      'export nothing': () => k.export(),
    };
    return Object.entries(calls).flatMap(([name, run]) => {
      try {
        run();
        return [`${name} is accepted`];
      } catch (error) {
        return error instanceof Error && error.message ? [] : [`${name} throws ${error}`];
      }
    });
  }, id);
  assert.deepEqual(accepted, []);
  assert.deepEqual(await documentOf(page), before);
});

/// What is wrong with each, as a change to a valid document, and the path that the error must name.
const badDocuments = [
  ['no locals', 'objects[0].locals.u', (d) => { d.objects[0].locals.u = 0; }],
  ['a thousand million locals', 'objects[0].locals.v', (d) => { d.objects[0].locals.v = 1e9; }],
  ['half a local', 'objects[0].locals.u', (d) => { d.objects[0].locals.u = 4.5; }],
  ['a number as text', 'objects[0].locals.u', (d) => { d.objects[0].locals.u = '6'; }],
  ['NaN as text', 'camera.distance', (d) => { d.camera.distance = 'NaN'; }],
  ['infinity as text', 'camera.target[1]', (d) => { d.camera.target[1] = 'Infinity'; }],
  ['null for a number', 'animation.speed', (d) => { d.animation.speed = null; }],
  ['a missing member', 'objects[0].samples', (d) => { delete d.objects[0].samples; }],
  ['a missing number', 'camera.azimuth', (d) => { delete d.camera.azimuth; }],
  ['an unknown member', 'objects[0].colour', (d) => { d.objects[0].colour = 'red'; }],
  ['an unknown choice', 'objects[0].blending.function', (d) => { d.objects[0].blending.function = 'cubic'; }],
  ['an unknown topology', 'objects[0].topology.v', (d) => { d.objects[0].topology.v = 'twisted'; }],
  ['an unknown model', 'objects[0].model.kind', (d) => { d.objects[0].model.kind = 'teapot'; }],
  ['an unknown kind of object', 'objects[0].kind', (d) => { d.objects[0].kind = 'teapot'; }],
  ['a later version', 'version', (d) => { d.version += 1; }],
  ['version 0', 'version', (d) => { d.version = 0; }],
  ['another format', 'format', (d) => { d.format = 'knitwork'; }],
  ['no object', 'objects', (d) => { d.objects = []; }],
  ['an object for a list', 'objects', (d) => { d.objects = { 0: d.objects[0] }; }],
  ['two objects of one id', 'objects[1].id', (d) => { d.objects.push(structuredClone(d.objects[0])); }],
  ['a camera beyond the pole', 'camera.elevation', (d) => { d.camera.elevation = 2; }],
  ['a number that is too large', 'animation.amplitude', (d) => { d.animation.amplitude = 1e308; }],
  ['a patch without length', 'objects[0].patches[0].rotation', (d) => {
    d.objects[0].patches = [{ i: 0, j: 0, translation: [0, 0, 0], rotation: [0, 0, 0, 0], scale: [1, 1, 1] }];
  }],
  ['a patch listed twice', 'objects[0].patches[1]', (d) => {
    const edit = { i: 0, j: 0, translation: [0, 0, 1], rotation: [0, 0, 0, 1], scale: [1, 1, 1] };
    d.objects[0].patches = [edit, { ...edit }];
  }],
  ['a patch in two dimensions', 'objects[0].patches[0].translation', (d) => {
    d.objects[0].patches = [{ i: 0, j: 0, translation: [0, 0], rotation: [0, 0, 0, 1], scale: [1, 1, 1] }];
  }],
  ['megabytes of junk in a label', '', (d) => { d.objects[0].label = 'junk '.repeat(2_000_000); }],
  ['a million patches', 'objects[0].patches[16384]', (d) => {
    d.objects[0].patches = Array.from({ length: 1_000_000 }, () => 0);
  }],
];

pageTest('load refuses every bad document and leaves document, history and picture alone', {}, async (page) => {
  const start = await documentOf(page);
  const handle = await frontHandle(page);
  await drag(page, handle.screen, [handle.screen[0] + 40, handle.screen[1] - 25]);
  await page.mouse.move(3, 3);
  await settled(page);
  const before = await documentOf(page);
  const seen = await picture(page);
  assert.notDeepEqual(before, start);

  const refuse = async (name, path, document) => {
    await assert.rejects(call(page, 'load', document), (error) => {
      assert.ok(error.isError, `${name}: no Error is thrown`);
      assert.equal(error.path, path, `${name}: the error is said to be at ${error.path}`);
      assert.ok(error.message.length > 8, `${name}: no reason is given`);
      return true;
    }, `${name} is loaded`);
    assert.deepEqual(await documentOf(page), before, `${name} has changed the document`);
  };
  for (const [name, path, change] of badDocuments) {
    const document = structuredClone(before);
    change(document);
    await refuse(name, path, document);
  }
  for (const [name, document] of [
    ['null', null], ['a number', 7], ['text', 'knotwork'], ['a list', []], ['nothing in it', {}],
  ]) {
    await refuse(name, name === 'nothing in it' ? 'format' : '', document);
  }

  const unwritable = await page.evaluate(() => {
    const valid = window.knotwork.document();
    const cyclic = { ...valid };
    cyclic.camera = cyclic;
    const trials = {
      cyclic,
      'a big integer': { ...valid, version: 1n },
      undefined,
      'a function': () => valid,
      'NaN itself': { ...valid, camera: { ...valid.camera, distance: NaN } },
      'minus infinity': { ...valid, camera: { ...valid.camera, azimuth: -Infinity } },
    };
    return Object.entries(trials).map(([name, document]) => {
      try {
        window.knotwork.load(document);
        return `${name}: loaded`;
      } catch (error) {
        if (error instanceof Error && error.message && typeof error.path === 'string') return '';
        return `${name}: ${error} without a path`;
      }
    });
  });
  assert.deepEqual(unwritable.filter((text) => text), []);
  assert.deepEqual(await documentOf(page), before);

  await settled(page);
  assert.equal(difference(seen, await picture(page), 0), 0, 'the picture has changed');
  await call(page, 'undo');
  assert.deepEqual((await documentOf(page)).objects, start.objects, 'undo does not take back what was done before');
  await call(page, 'redo');
  assert.deepEqual((await documentOf(page)).objects, before.objects);
});

pageTest('what document() gives, load() takes back exactly, and undo takes the loading back', {}, async (page) => {
  const start = await documentOf(page);
  const other = structuredClone(start);
  const object = other.objects[0];
  Object.assign(object.locals, { u: 7, v: 5 });
  object.blending.function = 'linear';
  object.topology.v = 'open';
  object.patches = [
    { i: 2, j: 1, translation: [0.1, 1 / 3, -0.2], rotation: [0, 0, Math.sin(0.3), Math.cos(0.3)], scale: [1, 0.5, 2] },
  ];
  other.camera.azimuth = 0.1 + 0.2;
  other.display.wireframe = true;
  await call(page, 'load', other);
  assert.deepEqual(await documentOf(page), other);
  assert.equal((await handlesOf(page)).length, 35);
  await settled(page);
  await call(page, 'undo');
  assert.deepEqual(await documentOf(page), start);
  await call(page, 'redo');
  assert.deepEqual(await documentOf(page), other);
});

pageTest('chapters() lists the chapters, and open() brings back their start', { full: true }, async (page) => {
  const start = await documentOf(page);
  const chapters = await call(page, 'chapters');
  assert.ok(chapters.length >= 1);
  for (const chapter of chapters) {
    await call(page, 'open', chapter.id);
    const rows = (await call(page, 'parameters')).map((row) => row.id);
    assert.match(chapter.id, /^[a-z][a-z0-9-]*$/);
    assert.ok(chapter.title.length > 0);
    assert.ok(chapter.parameters.length > 0);
    for (const id of chapter.parameters) assert.ok(rows.includes(id), `${chapter.id} is about ${id}, which is no row`);
  }
  await call(page, 'open', chapters[0].id);
  await call(page, 'set', 'locals.u', 9);
  await call(page, 'open', chapters[0].id);
  await settled(page);
  assert.deepEqual(await documentOf(page), start);
});

pageTest('stats() counts frames and bytes, and tells of the last frame', { drawn: true }, async (page) => {
  await settled(page);
  const before = await statsOf(page);
  const names = ['frames', 'drawCalls', 'stateChanges', 'vertices', 'uploadBytes', 'evaluateMs', 'frameMs', 'allocations'];
  for (const name of names) assert.ok(Number.isFinite(before[name]) && before[name] >= 0, `stats().${name}`);
  assert.ok(before.frames > 0 && before.drawCalls > 0 && before.vertices > 0 && before.uploadBytes > 0);

  const { object } = await grid(page);
  assert.ok(before.vertices >= object.samples.u * object.samples.v);
  await call(page, 'set', 'locals.u', (await surfaceOf(page)).locals.u + 1);
  await settled(page);
  const after = await statsOf(page);
  assert.ok(after.frames > before.frames && after.uploadBytes > before.uploadBytes);
});

pageTest('a grid fitted to the screen follows the view; who asks for samples gets them', { full: true }, async (page) => {
  const vertices = async () => {
    await settled(page);
    return (await statsOf(page)).vertices;
  };
  assert.equal(await page.evaluate(() => window.knotwork.document().display.adaptive), true);
  const zoom = async (turns) => {
    const stage = await stageRect(page);
    await page.mouse.move(stage.x + stage.width / 2, stage.y + stage.height / 2);
    await page.keyboard.down('Control');
    for (let k = 0; k < Math.abs(turns); ++k) await page.mouse.wheel(0, 200 * Math.sign(turns));
    await page.keyboard.up('Control');
  };
  const near = await vertices();
  await zoom(12);
  const far = await vertices();
  assert.ok(far < near / 4, `${far} vertices from afar, ${near} near by`);

  await call(page, 'set', 'samples.u', 96);
  assert.equal(await page.evaluate(() => window.knotwork.document().display.adaptive), false);
  const fixed = await vertices();
  assert.ok(fixed > far, `${fixed} vertices`);
  await zoom(-12);
  assert.equal(await vertices(), fixed);
  await call(page, 'set', 'samples.adaptive', true);
  assert.ok((await vertices()) !== fixed);
  await call(page, 'undo');
  assert.equal(await vertices(), fixed);
});

const costs = 'a frame of an animation uploads and allocates the same whatever the vertices; so does an edit of a net';
pageTest(costs, {}, async (page) => {
  /// What the fourth of five frames took.
  const frameCost = (change) =>
    page.evaluate(
      (change) =>
        new Promise((resolve) => {
          const { knotwork } = window;
          const document = knotwork.document();
          Object.assign(document.objects[0], change);
          document.display.adaptive = false;
          document.animation.playing = true;
          knotwork.load(document);
          const seen = [knotwork.stats()];
          const look = () => {
            const now = knotwork.stats();
            if (now.frames > seen.at(-1).frames) seen.push(now);
            if (seen.length > 9) {
              resolve({ bytes: seen[8].uploadBytes - seen[7].uploadBytes, allocations: seen[8].allocations });
            } else {
              requestAnimationFrame(look);
            }
          };
          requestAnimationFrame(look);
        }),
      change,
    );
  const locals = (await surfaceOf(page)).locals;
  for (const kind of ['sub-surface', 'bezier-hermite']) {
    const few = await frameCost({ samples: { u: 24, v: 24 }, locals: { ...locals, kind } });
    const many = await frameCost({ samples: { u: 400, v: 400 }, locals: { ...locals, kind } });
    assert.deepEqual(many, few, kind);
    assert.ok(few.bytes > 0 && few.bytes < 20000, `${few.bytes} bytes a frame`);
    assert.equal(few.allocations, 0, 'a steady frame asks for memory');
  }
  await call(page, 'pause');

  // A net of 250 000 vertices: a moved point uploads the net and what is drawn over it.
  await call(page, 'open', 'tensor-surface');
  await page.evaluate(() => {
    const document = window.knotwork.document();
    document.objects[0].samples = { u: 500, v: 500 };
    document.display.surface = document.display.adaptive = false;  // drawn in software, it would take all the time
    window.knotwork.load(document);
  });
  await settled(page);
  const before = await statsOf(page);
  const handle = (await handlesOf(page)).find(({ screen }) => screen);
  await drag(page, handle.screen, [handle.screen[0] + 24, handle.screen[1] + 10]);
  await settled(page);
  const after = await statsOf(page);
  const bytes = (after.uploadBytes - before.uploadBytes) / (after.frames - before.frames);
  assert.ok(bytes > 0 && bytes < 40000, `${bytes} bytes a frame`);
});

pageTest('the range of a parameter is the one that holds now, in the table and beside the prose', {}, async (page) => {
  const slider = page.locator('[data-parameter="blending.parameter"] input').first();
  for (const [family, min, max] of [['rational', 2, 16], ['polynomial_m', 0, 16]]) {
    await call(page, 'set', 'blending.function', family);
    await settled(page);
    const row = await parameter(page, 'blending.parameter');
    assert.equal(row.min, min, family);
    assert.ok(row.max <= max, `${family}: up to ${row.max}`);
    assert.equal(await slider.getAttribute('min'), String(min));
    await call(page, 'set', row.id, row.min);
    await assert.rejects(call(page, 'set', row.id, row.min - 1));
    await assert.rejects(call(page, 'set', row.id, row.max + 1));
  }
});

pageTest('every object of a document can be evaluated', {}, async (page) => {
  const document = await documentOf(page);
  const [first] = document.objects;
  document.objects.push({ ...structuredClone(first), id: 'second', topology: { u: 'open', v: 'open' } });
  await call(page, 'load', document);
  const at = (object, u, v) => call(page, 'evaluate', object, [u, v], 1).then(({ S }) => S);
  assert.ok(distance(await at(first.id, 0, 0.5), await at('second', 0, 0.5)) > 0.1, 'the second is the first again');
  await assert.rejects(at('third', 0, 0), /third/);
});
