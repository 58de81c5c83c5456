// The JavaScript rivals: node rivals.mjs FOLDER [--check], the folder of knotwork_contest_samples. One line of JSON
// each, as wasm_main.cpp prints them. All values of a rival, at every parameter at which it is timed, are held to the
// exact ones first; one that is wrong is reported so and not timed.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Bezier } from 'bezier-js';
import nurbs from 'nurbs';
import { Vector3, Vector4 } from 'three';
import { NURBSCurve } from 'three/addons/curves/NURBSCurve.js';
import { calcNURBSDerivatives } from 'three/addons/curves/NURBSUtils.js';
import { NURBSSurface } from 'three/addons/curves/NURBSSurface.js';

// Verb expects a browser's global object, and workers that are not used here.
globalThis.window ??= globalThis;
const { default: verb } = await import('verb-nurbs');

const folder = process.argv[2];
const { curves, surface } = JSON.parse(readFileSync(join(folder, 'works.json'), 'utf8'));
const check = process.argv.includes('--check');
const tolerance = 1e-12;
const call = 4096;
const out = new Float64Array(9 * call);

const every = (step, count) => Array.from({ length: Math.ceil(count / step) }, (_, k) => k * step);
const shuffled = (places) => places.map((_, k) => places[(k * 1009) % places.length]);

function median(numbers) {
  return numbers.sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

/// What knotwork_contest_samples wrote: rows of `given` parameters and `values` exact vectors.
function samplesOf(file, given, values) {
  const { buffer, byteOffset, length } = readFileSync(join(folder, file));
  const numbers = new Float64Array(buffer.slice(byteOffset, byteOffset + length));
  const width = given + 3 * values;
  return {
    count: numbers.length / width,
    parameter: (row, which = 0) => numbers[row * width + which],
    coordinate: (row, c) => numbers[row * width + given + c],
  };
}

/// The largest difference from the exact values in these rows: points are relative to the largest point, each
/// derivative to its largest. evaluate(row, to) writes so many values.
function difference(samples, rows, values, evaluate) {
  const actual = new Float64Array(3 * values);
  const error = new Array(values).fill(0);
  const size = new Array(values).fill(0);
  for (const row of rows) {
    evaluate(row, actual);
    for (let k = 0; k < values; ++k) {
      const expected = [0, 1, 2].map((c) => samples.coordinate(row, 3 * k + c));
      // Of a NaN there is nothing larger.
      error[k] = Math.max(error[k], Math.hypot(...expected.map((x, c) => actual[3 * k + c] - x)));
      size[k] = Math.max(size[k], Math.hypot(...expected));
    }
  }
  return Math.max(...error.map((e, k) => e / size[k]));
}

function report(name, items, error, run) {
  const right = error <= tolerance;
  const seconds = [];
  if (right && !check) {
    run(); // the compiler's turn
    for (let total = 0; seconds.length < 5 || total < 0.25; total += seconds.at(-1)) {
      const start = performance.now();
      run();
      seconds.push((performance.now() - start) / 1000);
    }
  }
  const ns = seconds.length ? (1e9 * median(seconds)) / items : 0;
  console.log(JSON.stringify({ name, ns, error, right }));
}

/// evaluate(t, to, place) writes a point, or a point and two derivatives; `rows` are in the order in which it is timed.
function curveContender(work, contender, samples, rows, values, evaluate) {
  const t = Float64Array.from(rows, (row) => samples.parameter(row));
  const error = difference(samples, rows, values, (row, to) => evaluate(samples.parameter(row), to, 0));
  const run = () => {
    for (let k = 0; k < t.length; ++k) evaluate(t[k], out, 3 * values * (k % call));
  };
  report(`${work} | ${contender}`, t.length, error, run);
}

for (const [points, { knots, points: net, pieces, samples: file }] of Object.entries(curves)) {
  const samples = samplesOf(file, 1, 3);
  const few = every(101, samples.count);
  const many = check ? few : every(1, samples.count);
  const spans = pieces.length;
  const beziers = pieces.map((piece) => new Bezier(piece.map(([x, y, z]) => ({ x, y, z }))));
  const spline = nurbs({ points: net, degree: 3, knots: [knots] });
  const [byFirst, bySecond] = [spline.evaluator(1), spline.evaluator(2)];
  const curve = new NURBSCurve(3, knots, net.map((p) => new Vector4(...p, 1)));
  const verbCurve = verb.geom.NurbsCurve.byKnotsControlPointsWeights(3, knots, net, net.map(() => 1));
  const vector = new Vector3();
  const scratch = [0, 0, 0];
  const put = (p, to, place, scale = 1) => {
    to[place] = scale * p.x;
    to[place + 1] = scale * p.y;
    to[place + 2] = scale * p.z;
  };
  const putList = (p, to, place) => {
    to[place] = p[0];
    to[place + 1] = p[1];
    to[place + 2] = p[2];
  };
  const contenders = {
    'bezier-js, pieces': (t, to, place) => {
      const k = Math.min(Math.floor(t * spans), spans - 1);
      put(beziers[k].compute(t * spans - k), to, place);
    },
    nurbs: (t, to, place) => putList(spline.evaluate(scratch, t), to, place),
    three: (t, to, place) => put(curve.getPoint(t, vector), to, place),
    verb: (t, to, place) => putList(verbCurve.point(t), to, place),
  };
  for (const order of ['sorted', 'shuffled']) {
    const rows = order === 'sorted' ? many : shuffled(many);
    const suffix = order === 'sorted' ? '' : ', shuffled';
    for (const [name, evaluate] of Object.entries(contenders))
      curveContender(`W1 curve, position, ${points} points${suffix}`, name, samples, rows, 1, evaluate);
  }
  const derivatives = {
    'bezier-js, pieces': (t, to, place) => {
      const k = Math.min(Math.floor(t * spans), spans - 1);
      const w = t * spans - k;
      put(beziers[k].compute(w), to, place);
      // By w: by t they are steeper.
      put(beziers[k].derivative(w), to, place + 3, spans);
      put(beziers[k].dderivative(w), to, place + 6, spans * spans);
    },
    nurbs: (t, to, place) => {
      putList(spline.evaluate(scratch, t), to, place);
      putList(byFirst(scratch, t), to, place + 3);
      putList(bySecond(scratch, t), to, place + 6);
    },
    three: (t, to, place) => {
      const all = calcNURBSDerivatives(3, knots, curve.controlPoints, t, 2);
      for (let k = 0; k < 3; ++k) put(all[k], to, place + 3 * k);
    },
    verb: (t, to, place) => {
      const all = verbCurve.derivatives(t, 2);
      for (let k = 0; k < 3; ++k) putList(all[k], to, place + 3 * k);
    },
  };
  for (const [name, evaluate] of Object.entries(derivatives)) {
    curveContender(`W1 curve, two derivatives, ${points} points`, name, samples, name === 'three' ? few : many, 3,
                   evaluate);
  }
}

{
  const { knots, points } = surface;
  const samples = samplesOf(surface.samples, 2, 3);
  const net = Array.from({ length: 32 }, (_, i) => points.slice(32 * i, 32 * (i + 1)));
  const spline = nurbs({ points: net, degree: [3, 3], knots: [knots, knots] });
  const other = new NURBSSurface(3, 3, knots, knots, net.map((row) => row.map((p) => new Vector4(...p, 1))));
  const verbSurface = verb.geom.NurbsSurface.byKnotsControlPointsWeights(3, 3, knots, knots, net);
  const vector = new Vector3();
  const scratch = [0, 0, 0];
  const contenders = {
    nurbs: (u, v) => spline.evaluate(scratch, u, v),
    three: (u, v) => {
      other.getPoint(u, v, vector);
      return [vector.x, vector.y, vector.z];
    },
    verb: (u, v) => verbSurface.point(u, v),
  };
  const side = Math.sqrt(samples.count);
  const rows = every(check ? 101 : 1, samples.count);
  const [u, v] = [every(side, samples.count).map((row) => samples.parameter(row, 0)),
    every(1, side).map((row) => samples.parameter(row, 1))];
  for (const [name, evaluate] of Object.entries(contenders)) {
    const error = difference(samples, rows, 1, (row, to) =>
      to.set(evaluate(samples.parameter(row, 0), samples.parameter(row, 1))));
    const run = () => {
      for (let a = 0; a < side; ++a) {
        for (let b = 0; b < side; ++b) {
          const p = evaluate(u[a], v[b]);
          const place = 3 * ((a * side + b) % call);
          out[place] = p[0];
          out[place + 1] = p[1];
          out[place + 2] = p[2];
        }
      }
    };
    report(`W2 surface, position | ${name}`, side * side, error, run);
  }
}
