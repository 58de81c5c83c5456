// The JavaScript rivals: node rivals.mjs SAMPLES. One line of JSON each, as knotwork_contest_wasm prints them; a rival whose
// points are not the samples' is reported as wrong and not timed.
import { readFileSync } from 'node:fs';
import { Bezier } from 'bezier-js';
import nurbs from 'nurbs';
import { Vector3, Vector4 } from 'three';
import { NURBSCurve } from 'three/addons/curves/NURBSCurve.js';
import { calcNURBSDerivatives } from 'three/addons/curves/NURBSUtils.js';
import { NURBSSurface } from 'three/addons/curves/NURBSSurface.js';

// Verb expects a browser's global object, and workers that are not used here.
globalThis.window ??= globalThis;
const { default: verb } = await import('verb-nurbs');

const { curves, surface } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const check = process.argv.includes('--check');
const tolerance = 1e-12;
const call = 4096;
const out = new Float64Array(9 * call);

const sorted = (count) => Float64Array.from({ length: count }, (_, k) => (k + 0.37) / count);
const shuffled = (t) => t.map((_, k) => t[(k * 1009) % t.length]);

function median(numbers) {
  return numbers.sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

/// The largest difference of `actual` (a list of vectors) from `expected`, relative to the largest of these.
function difference(actual, expected) {
  const size = Math.max(...expected.map((p) => Math.hypot(...p)));
  return Math.max(...actual.map((p, k) => Math.hypot(...p.map((x, c) => x - expected[k][c])))) / size;
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

/// evaluate(t, to, place) writes a point, or a point and two derivatives.
function curveContender(work, contender, samples, t, values, evaluate) {
  const one = new Float64Array(9);
  const actual = samples.map(([at]) => {
    evaluate(at, one, 0);
    return [...one.subarray(0, 3)];
  });
  const run = () => {
    for (let k = 0; k < t.length; ++k) evaluate(t[k], out, 3 * values * (k % call));
  };
  report(`${work} | ${contender}`, t.length, difference(actual, samples.map((sample) => sample[1])), run);
}

for (const [points, { knots, points: net, pieces, samples }] of Object.entries(curves)) {
  const few = sorted(2000);
  const many = sorted(check ? 2000 : 200000);
  const spans = pieces.length;
  const beziers = pieces.map((piece) => new Bezier(piece.map(([x, y, z]) => ({ x, y, z }))));
  const spline = nurbs({ points: net, degree: 3, knots: [knots] });
  const [byFirst, bySecond] = [spline.evaluator(1), spline.evaluator(2)];
  const curve = new NURBSCurve(3, knots, net.map((p) => new Vector4(...p, 1)));
  const verbCurve = verb.geom.NurbsCurve.byKnotsControlPointsWeights(3, knots, net, net.map(() => 1));
  const vector = new Vector3();
  const scratch = [0, 0, 0];
  const put = (p, to, place) => {
    to[place] = p.x;
    to[place + 1] = p.y;
    to[place + 2] = p.z;
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
    const t = order === 'sorted' ? many : shuffled(many);
    const suffix = order === 'sorted' ? '' : ', shuffled';
    for (const [name, evaluate] of Object.entries(contenders))
      curveContender(`W1 curve, position, ${points} points${suffix}`, name, samples, t, 1, evaluate);
  }
  const derivatives = {
    'bezier-js, pieces': (t, to, place) => {
      const k = Math.min(Math.floor(t * spans), spans - 1);
      const w = t * spans - k;
      put(beziers[k].compute(w), to, place);
      put(beziers[k].derivative(w), to, place + 3);
      put(beziers[k].dderivative(w), to, place + 6);
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
  const { knots, points, samples } = surface;
  const rows = Array.from({ length: 32 }, (_, i) => points.slice(32 * i, 32 * (i + 1)));
  const spline = nurbs({ points: rows, degree: [3, 3], knots: [knots, knots] });
  const other = new NURBSSurface(3, 3, knots, knots, rows.map((row) => row.map((p) => new Vector4(...p, 1))));
  const verbSurface = verb.geom.NurbsSurface.byKnotsControlPointsWeights(3, 3, knots, knots, rows);
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
  const side = check ? 20 : 200;
  const t = sorted(side);
  for (const [name, evaluate] of Object.entries(contenders)) {
    const actual = samples.map(([u, v]) => [...evaluate(u, v)]);
    const run = () => {
      for (let a = 0; a < side; ++a) {
        for (let b = 0; b < side; ++b) {
          const p = evaluate(t[a], t[b]);
          const place = 3 * ((a * side + b) % call);
          out[place] = p[0];
          out[place + 1] = p[1];
          out[place + 2] = p[2];
        }
      }
    };
    report(`W2 surface, position | ${name}`, side * side, difference(actual, samples.map((sample) => sample[2])), run);
  }
}
