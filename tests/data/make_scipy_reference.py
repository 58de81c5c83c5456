#!/usr/bin/env python3
"""Writes scipy_reference.json: B-splines as SciPy computes them, for tests/unit/scipy_reference_test.cpp.

    make_scipy_reference.py           writes the file beside this script
    make_scipy_reference.py --check   computes it again and compares, to 1e-13 of each list's largest number

The inputs are drawn with a fixed seed, by the generator whose numbers NumPy promises never to change. Every number is
printed with so many digits that the double comes back as it was.
"""

import json
import pathlib
import sys

import numpy
from scipy.integrate import quad
from scipy.interpolate import BSpline, insert, make_lsq_spline

FILE = pathlib.Path(__file__).with_name("scipy_reference.json")


class Draw:
    """Random multiples of 1/64."""

    def __init__(self, seed):
        self.random = numpy.random.RandomState(seed)

    def whole(self, low, high):
        return int(self.random.randint(low, high + 1))

    def numbers(self, *shape):
        return self.random.randint(-320, 321, shape) / 64

    def breaks(self, count):
        """Increasing, from 0 on, with steps of 1/4 to 3."""
        return numpy.concatenate([[0.0], numpy.cumsum(self.random.randint(16, 193, count) / 64)])

    def inner_knots(self, degree, breaks):
        """The inner breaks, each repeated 1 to `degree` times; few more than once where the degree is high."""
        times = [1 + self.whole(0, degree - 1) * self.whole(0, 1) for _ in breaks[1:-1]]
        return numpy.repeat(breaks[1:-1], times) if len(times) else numpy.array([])

    def clamped_knots(self, degree, intervals):
        breaks = self.breaks(intervals)
        ends = numpy.ones(degree + 1)
        return numpy.concatenate([0 * ends, self.inner_knots(degree, breaks), breaks[-1] * ends])

    def parameters(self, knots, degree, count):
        """Inside the domain, on no knot (there SciPy takes the interval on the right, as the tests do, but its last)."""
        start, end = knots[degree], knots[-degree - 1]
        return numpy.sort(start + (end - start) * (self.random.randint(0, 997, count) * 2 + 1) / 1994)


def derivatives(spline, t, orders):
    """[[S(t), S'(t), ..], ..], one row for each parameter."""
    columns = [spline(t, nu=order) for order in orders]
    return numpy.stack(columns, axis=1)


def open_curve(draw, degree, clamped):
    if clamped:
        knots = draw.clamped_knots(degree, draw.whole(1, 5))
    else:
        knots = draw.breaks(2 * degree + draw.whole(1, 5))
    points = draw.numbers(len(knots) - degree - 1, 3)
    spline = BSpline(knots, points, degree)
    t = draw.parameters(knots, degree, 4)
    return {
        "degree": degree,
        "knots": knots,
        "points": points,
        "t": t,
        # Above order 4 the columns say little that is new.
        "derivatives": derivatives(spline, t, range(min(degree, 4) + 1)),
        # From the start of the domain to each parameter, of every coordinate.
        "integrals": [spline.antiderivative()(x) - spline.antiderivative()(knots[degree]) for x in t],
        "length": arc_length(spline, numpy.unique(knots[degree : len(knots) - degree])),
    }


def arc_length(spline, breaks):
    speed = spline.derivative()
    return sum(
        quad(lambda x: numpy.linalg.norm(speed(x)), a, b, epsabs=0, epsrel=1e-13, limit=200)[0]
        for a, b in zip(breaks[:-1], breaks[1:])
    )


def closed_curve(draw, degree):
    """Periodic by knots and points that go on one period later."""
    count = degree + draw.whole(2, 5)
    breaks = draw.breaks(count)
    period = breaks[-1]
    around = numpy.array([breaks[k % count] + period * (k // count) for k in range(-degree, count + degree + 1)])
    points = draw.numbers(count, 3)
    spline = BSpline(around, numpy.concatenate([points, points[:degree]]), degree)
    t = draw.parameters(around, degree, 4)
    return {
        "degree": degree,
        "knots": around,
        "points": points,
        "t": t,
        "derivatives": derivatives(spline, t, range(min(degree, 4) + 1)),
    }


def surface(draw, degree_u, degree_v):
    """SciPy 1.10 has no tensor splines: a spline in u whose values are the control points of one in v."""
    u = draw.clamped_knots(degree_u, draw.whole(1, 3))
    v = draw.clamped_knots(degree_v, draw.whole(1, 3))
    net = draw.numbers(len(u) - degree_u - 1, len(v) - degree_v - 1, 3)
    at_u = draw.parameters(u, degree_u, 3)
    at_v = draw.parameters(v, degree_v, 3)
    along_u = BSpline(u, net, degree_u)
    jets = []
    for x, y in zip(at_u, at_v):
        orders = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
        jets.append([BSpline(v, along_u(x, nu=a), degree_v)(y, nu=b) for a, b in orders])
    return {
        "degree_u": degree_u,
        "degree_v": degree_v,
        "knots_u": u,
        "knots_v": v,
        "net": net,
        "u": at_u,
        "v": at_v,
        "jets": jets,
    }


def least_squares(draw, degree):
    knots = draw.clamped_knots(degree, draw.whole(2, 5))
    ends = numpy.unique(knots)
    # degree + 2 data in each interval: well-conditioned, for SciPy solves the normal equations.
    share = (numpy.arange(degree + 2) + 0.5) / (degree + 2)
    x = numpy.concatenate([a + (b - a) * share for a, b in zip(ends[:-1], ends[1:])])
    data = draw.numbers(len(x), 3)
    weights = draw.random.randint(1, 5, len(x)) / 1.0
    # SciPy minimises sum (w_j r_j)^2, we sum w_j r_j^2.
    plain = make_lsq_spline(x, data, knots, degree)
    weighted = make_lsq_spline(x, data, knots, degree, w=numpy.sqrt(weights))
    return {
        "degree": degree,
        "knots": knots,
        "x": x,
        "data": data,
        "weights": weights,
        "points": plain.c,
        "weighted_points": weighted.c,
    }


def insertion(draw, degree):
    """FITPACK's: one coordinate at a time, up to degree 5."""
    knots = draw.clamped_knots(degree, draw.whole(2, 5))
    points = draw.numbers(len(knots) - degree - 1, 3)
    x = float(draw.parameters(knots, degree, 1)[0])
    refined = []
    for column in points.T:
        padded = numpy.concatenate([column, numpy.zeros(degree + 1)])
        new_knots, coefficients, _ = insert(x, (knots, padded, degree))
        refined.append(coefficients[: len(new_knots) - degree - 1])
    return {
        "degree": degree,
        "knots": knots,
        "points": points,
        "t": x,
        "new_knots": new_knots,
        "new_points": numpy.array(refined).T,
    }


def reference():
    draw = Draw(2026)
    return {
        "description": "B-splines computed by SciPy; made by make_scipy_reference.py",
        "open_curves": [open_curve(draw, degree, clamped) for degree in range(1, 10) for clamped in (True, False)],
        "closed_curves": [closed_curve(draw, degree) for degree in range(1, 10)],
        "surfaces": [surface(draw, p, q) for p, q in [(1, 1), (2, 3), (3, 2), (3, 3), (5, 1), (4, 6), (9, 2)]],
        "least_squares": [least_squares(draw, degree) for degree in range(1, 8)],
        "insertions": [insertion(draw, degree) for degree in range(1, 6)],
    }


def plain(value):
    """Lists and numbers that JSON knows."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, numpy.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return float(value) if isinstance(value, numpy.floating) else value


def differences(old, new, path=""):
    """Where two references differ; lists of numbers are compared as a whole, relative to their largest."""
    if isinstance(old, dict) and isinstance(new, dict) and old.keys() == new.keys():
        return [found for key in old for found in differences(old[key], new[key], f"{path}/{key}")]
    if isinstance(old, list) and isinstance(new, list) and old and isinstance(old[0], dict) and len(old) == len(new):
        return [found for k in range(len(old)) for found in differences(old[k], new[k], f"{path}[{k}]")]
    if isinstance(old, str) or isinstance(new, str):
        return [] if old == new else [f"{path}: {old!r} and {new!r}"]
    a, b = numpy.asarray(old, dtype=float), numpy.asarray(new, dtype=float)
    if a.shape != b.shape:
        return [f"{path}: of shape {a.shape} and {b.shape}"]
    # Each column of derivatives has a size of its own.
    largest = numpy.abs(a).max(axis=0) if a.ndim == 3 else numpy.abs(a).max()
    error = numpy.abs(a - b) - 1e-13 * largest
    return [] if (error <= 0).all() else [f"{path}: differs by {numpy.abs(a - b).max():.3g}"]


def main():
    made = plain(reference())
    if sys.argv[1:] == ["--check"]:
        found = differences(json.loads(FILE.read_text()), made)
        print("\n".join(found) if found else f"{FILE.name}: SciPy computes the same again")
        return 1 if found else 0
    FILE.write_text(json.dumps(made, separators=(",", ":")).replace('},{', '},\n{').replace('],"', '],\n"') + "\n")
    print(f"{FILE.name}: {FILE.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
