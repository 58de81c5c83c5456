"""SciPy as a rival: rivals.py SAMPLES [--check]. One line of JSON each, as knotwork_contest_wasm prints them."""

import json
import sys
import time

import numpy as np
from scipy import interpolate

TOLERANCE = 1e-12


def report(name, items, error, run, check, tolerance=TOLERANCE):
    right = bool(error <= tolerance)
    seconds = []
    if right and not check:
        run()
        while len(seconds) < 5 or sum(seconds) < 0.5:
            start = time.perf_counter()
            run()
            seconds.append(time.perf_counter() - start)
    ns = 1e9 * float(np.median(seconds)) / items if seconds else 0
    print(json.dumps({"name": name, "ns": ns, "error": float(error), "right": right}), flush=True)


def difference(actual, expected):
    actual, expected = np.asarray(actual), np.asarray(expected)
    return np.linalg.norm(actual - expected, axis=-1).max() / np.linalg.norm(expected, axis=-1).max()


def parameters(count):
    return (np.arange(count) + 0.37) / count


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        works = json.load(file)
    check = "--check" in sys.argv
    count = 20000 if check else 1000000
    for points, work in works["curves"].items():
        spline = interpolate.BSpline(np.array(work["knots"]), np.array(work["points"]), 3)
        slopes = [spline.derivative(1), spline.derivative(2)]
        at = [sample[0] for sample in work["samples"]]
        error = difference(spline(at), [sample[1] for sample in work["samples"]])
        t = parameters(count)
        shuffled = t[np.arange(count) * 1009 % count]
        report(f"W1 curve, position, {points} points | SciPy", count, error, lambda: spline(t), check)
        report(f"W1 curve, position, {points} points, shuffled | SciPy", count, error, lambda: spline(shuffled), check)
        report(f"W1 curve, two derivatives, {points} points | SciPy", count, error,
               lambda: [spline(t)] + [slope(t) for slope in slopes], check)

    # Separable: the basis as sparse matrices once for each direction, and two products.
    work = works["surface"]
    knots, net = np.array(work["knots"]), np.array(work["points"]).reshape(32, 32, 3)
    side = 100 if check else 1000
    t = parameters(side)

    def grid(u, v, order_u, order_v):
        along_u = interpolate.BSpline(knots, net, 3)
        rows = (along_u.derivative(order_u) if order_u else along_u)(u)
        along_v = interpolate.BSpline(knots, rows.transpose(1, 0, 2), 3)
        return (along_v.derivative(order_v) if order_v else along_v)(v)

    samples = work["samples"]
    actual = [grid([u], [v], 0, 0)[0, 0] for u, v, *_ in samples]
    error = difference(actual, [sample[2] for sample in samples])
    report("W2 surface, position | SciPy", side * side, error, lambda: grid(t, t, 0, 0), check)
    report("W2 surface, partials and normal | SciPy, no normal", side * side, error,
           lambda: [grid(t, t, 0, 0), grid(t, t, 1, 0), grid(t, t, 0, 1)], check)

    # The data of W3: points of the spline itself, which the fit must bring back.
    work = works["curves"]["1000"]
    knots, points = np.array(work["knots"]), np.array(work["points"])
    x = parameters(100000)
    data = interpolate.BSpline(knots, points, 3)(x)
    fitted = interpolate.make_lsq_spline(x, data, knots, 3)
    # Normal equations: the square of the condition number is what the control points may lose.
    report("W3 least squares | SciPy", 1, difference(fitted.c, points),
           lambda: interpolate.make_lsq_spline(x, data, knots, 3), check, tolerance=1e-10)


main()
