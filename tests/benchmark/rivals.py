"""SciPy as a rival: rivals.py FOLDER [--check], the folder of knotwork_contest_samples. One line of JSON each, as
wasm_main.cpp prints them. What is timed is first held to the exact values, all of its values at all of the samples."""

import json
import os
import sys
import time

import numpy as np
from scipy import interpolate

TOLERANCE = 1e-12


def difference(actual, expected):
    return np.linalg.norm(actual - expected, axis=-1).max() / np.linalg.norm(expected, axis=-1).max()


def report(name, items, run, at, expected, check, tolerance=TOLERANCE):
    """`run` gives lists of vectors, a list each for points and derivatives; `at` selects from each what is expected."""
    error = np.max([difference(values[at], exact) for values, exact in zip(run(), expected)])
    right = bool(error <= tolerance)
    seconds = []
    if right and not check:
        while len(seconds) < 5 or sum(seconds) < 0.5:
            start = time.perf_counter()
            run()
            seconds.append(time.perf_counter() - start)
    ns = 1e9 * float(np.median(seconds)) / items if seconds else 0
    # JSON has no NaN.
    shown = float(error) if np.isfinite(error) else None
    print(json.dumps({"name": name, "ns": ns, "error": shown, "right": right}), flush=True)


def parameters(count):
    return (np.arange(count) + 0.37) / count


def with_samples(count, known, check):
    """What is timed, `count` parameters of which every so many is known (or these alone), and which those are."""
    t = known if check else parameters(count)
    every = slice(None, None, len(t) // len(known))
    if not np.array_equal(t[every], known):
        sys.exit("the samples are of other parameters")
    return t, every


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "works.json"), encoding="utf-8") as file:
        works = json.load(file)
    check = "--check" in sys.argv
    for points, work in works["curves"].items():
        spline = interpolate.BSpline(np.array(work["knots"]), np.array(work["points"]), 3)
        slopes = [spline.derivative(1), spline.derivative(2)]
        rows = np.fromfile(os.path.join(folder, work["samples"])).reshape(-1, 10)
        exact = [rows[:, 1:4], rows[:, 4:7], rows[:, 7:10]]
        t, every = with_samples(1000000, rows[:, 0], check)
        count = len(t)
        order = np.arange(count) * 1009 % count
        shuffled = t[order]
        report(f"W1 curve, position, {points} points | SciPy", count, lambda: [spline(t)], every, exact[:1], check)
        report(f"W1 curve, position, {points} points, shuffled | SciPy", count, lambda: [spline(shuffled)],
               np.argsort(order)[every], exact[:1], check)
        report(f"W1 curve, two derivatives, {points} points | SciPy", count,
               lambda: [spline(t)] + [slope(t) for slope in slopes], every, exact, check)

    # Separable: the basis as sparse matrices once for each direction, and two products.
    work = works["surface"]
    knots, net = np.array(work["knots"]), np.array(work["points"]).reshape(32, 32, 3)
    rows = np.fromfile(os.path.join(folder, work["samples"])).reshape(-1, 11)
    side = round(len(rows) ** 0.5)
    rows = rows.reshape(side, side, 11)
    exact = [rows[..., 2:5], rows[..., 5:8], rows[..., 8:11]]
    # The same parameters in both directions.
    t, every = with_samples(1000, rows[:, 0, 0], check)

    def grid(order_u, order_v):
        along_u = interpolate.BSpline(knots, net, 3)
        across = (along_u.derivative(order_u) if order_u else along_u)(t)
        along_v = interpolate.BSpline(knots, across.transpose(1, 0, 2), 3)
        return (along_v.derivative(order_v) if order_v else along_v)(t).transpose(1, 0, 2)

    report("W2 surface, position | SciPy", len(t) ** 2, lambda: [grid(0, 0)], (every, every), exact[:1], check)
    report("W2 surface, partials and normal | SciPy, no normal", len(t) ** 2,
           lambda: [grid(0, 0), grid(1, 0), grid(0, 1)], (every, every), exact, check)

    # The data of W3: points of the spline itself, which the fit must bring back.
    work = works["curves"]["1000"]
    knots, points = np.array(work["knots"]), np.array(work["points"])
    x = parameters(100000)
    data = interpolate.BSpline(knots, points, 3)(x)
    # Normal equations: the square of the condition number is what the control points may lose.
    report("W3 least squares | SciPy", 1, lambda: [interpolate.make_lsq_spline(x, data, knots, 3).c], slice(None),
           [points], check, tolerance=1e-10)


main()
