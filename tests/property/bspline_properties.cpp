#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "knotwork/curve/bspline_refinement.h"
#include "knotwork/curve/spline_pieces.h"
#include "property/generators.h"

namespace knotwork::bspline_properties {
using namespace test;
namespace {

std::vector<Eigen::Vector3d> derivatives(const BSplineCurve& curve, double t, int order) {
  std::vector<Eigen::Vector3d> out(static_cast<std::size_t>(order) + 1);
  curve.evaluate(t, out);
  return out;
}

/// The two curves have the same derivatives at t up to their degree, relative to the terms that these are made of.
void expect_same(const BSplineCurve& a, const BSplineCurve& b, double t, double tolerance, const char* what) {
  const int order = a.degree();
  const std::vector<Eigen::Vector3d> left = derivatives(a, t, order), right = derivatives(b, t, order);
  for (int k = 0; k <= order; ++k) {
    const double size = std::max(derivative_size(a, t, k), derivative_size(b, t, k));
    expect(close(right[static_cast<std::size_t>(k)], left[static_cast<std::size_t>(k)], tolerance, size), what);
  }
}

/// Derivative k on a span, at one of its ends too, with the size of its terms.
struct Sided {
  Eigen::Vector3d value;
  double size;
};
Sided sided(const BSplineCurve& curve, int span, double t, int k) {
  const int p = curve.degree();
  const std::size_t width = static_cast<std::size_t>(p) + 1, row = static_cast<std::size_t>(k) * width;
  std::vector<double> basis(row + width);
  bspline_basis(curve.knots(), span, t, k, basis);
  Sided sum{Eigen::Vector3d::Zero(), 0};
  for (std::size_t j = 0; j < width; ++j) {
    const Eigen::Vector3d& point = curve.point(span - p + static_cast<int>(j));
    sum.value += basis[row + j] * point;
    sum.size += std::abs(basis[row + j]) * point.norm();
  }
  return sum;
}

BSplineCurve with_points(const BSplineCurve& curve, std::vector<Eigen::Vector3d> points) {
  return BSplineCurve::make(curve.knots(), std::move(points)).value();
}
std::vector<Eigen::Vector3d> copy(std::span<const Eigen::Vector3d> points) { return {points.begin(), points.end()}; }

int sign_changes(const std::vector<double>& values, double nothing) {
  int changes = 0;
  double before = 0;
  for (const double value : values) {
    if (std::abs(value) <= nothing) continue;
    if (before * value < 0) ++changes;
    before = value > 0 ? 1 : -1;
  }
  return changes;
}

}  // namespace

TEST_CASE("basis: not negative, sum 1, derivatives sum 0; columns are the same numbers") {
  CHECK(rc::check([] {
    const KnotVector knots = *knot_vectors();
    const double t = drawn_parameter(knots);
    const int span = knots.span(knots.reduced(t)), p = knots.degree();
    const std::size_t width = static_cast<std::size_t>(p) + 1;
    std::vector<double> rows(width * width), column(width);
    bspline_basis(knots, span, knots.reduced(t), p, rows);
    const double inside = knots.reduced(t);
    bspline_basis_columns(knots, span, {&inside, 1}, column);
    for (std::size_t k = 0; k < width; ++k) {
      double sum = 0, size = 0;
      for (std::size_t j = 0; j < width; ++j) {
        const double value = rows[k * width + j];
        if (k == 0) {
          holds(value >= 0);
          expect(close(column[j], value, 1e-14, 1e-300), "column");
        }
        sum += value, size += std::abs(value);
      }
      expect(close(sum, k == 0 ? 1 : 0, 1e-14 * static_cast<double>(p + 1), size), "sum");
    }
  }));
}

TEST_CASE("a control point moves the curve by its basis function, and nothing outside the support, bit for bit") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const int n = knots.count(), p = knots.degree();
    const int moved = *rc::gen::inRange(0, n);
    const Eigen::Vector3d by = drawn_point();
    std::vector<Eigen::Vector3d> points = copy(curve.points());
    points[static_cast<std::size_t>(moved)] += by;
    const BSplineCurve other = with_points(curve, points);
    const double t = drawn_parameter(knots);
    const double weight = weighted_basis_size(knots, t, 0, [&](int j) { return j % n == moved ? 1.0 : 0.0; });
    const Eigen::Vector3d step = other(t) - curve(t);
    if (weight == 0) holds(step == Eigen::Vector3d(0, 0, 0));
    expect(close(step, weight * by, 1e-14, polygon_size(curve) + by.norm()), "step");
    const double inside = knots.reduced(t);
    bool in_support = false;
    for (int i = moved; i <= knots.last_span() + p && i + p + 1 < static_cast<int>(knots.knots().size()); i += n) {
      in_support |= knots[i] <= inside && inside <= knots[i + p + 1];
      if (!knots.closed()) break;
    }
    if (!in_support) holds(weight == 0);
  }));
}

TEST_CASE("affine invariance: mapping the control points maps the curve and its derivatives") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const Eigen::Affine3d map = drawn_map();
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : curve.points()) points.emplace_back(map * point);
    const BSplineCurve mapped = with_points(curve, points);
    const double t = drawn_parameter(curve.knots());
    const auto before = derivatives(curve, t, curve.degree()), after = derivatives(mapped, t, curve.degree());
    for (std::size_t k = 0; k < before.size(); ++k) {
      const int order = static_cast<int>(k);
      const double size = map.linear().norm() * derivative_size(curve, t, order) +
                          map.translation().norm() * basis_size(curve.knots(), t, order);
      const Eigen::Vector3d expected = k == 0 ? map * before[k] : map.linear() * before[k];
      expect(close(after[k], expected, 1e-13, size), "derivative");
    }
  }));
}

TEST_CASE("a clamped curve begins in its first point and ends in its last, exactly, along its legs") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve({.ends = {Ends::clamped}});
    const KnotVector& knots = curve.knots();
    holds(curve(knots.start()) == curve.points().front());
    holds(curve(knots.end()) == curve.points().back());
    const int p = curve.degree(), n = knots.count();
    const double first = knots[p + 1] - knots.start(), last = knots.end() - knots[n - 1];
    const Eigen::Vector3d out = p * (curve.point(1) - curve.point(0)) / first;
    const Eigen::Vector3d in = p * (curve.point(n - 1) - curve.point(n - 2)) / last;
    expect(close(derivatives(curve, knots.start(), 1)[1], out, 1e-14, derivative_size(curve, knots.start(), 1)), "out");
    expect(close(derivatives(curve, knots.end(), 1)[1], in, 1e-14, derivative_size(curve, knots.end(), 1)), "in");
  }));
}

TEST_CASE("the derivative is the curve of one degree less through p (c_{i+1} - c_i) / (t_{i+p+1} - t_{i+1})") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve({.least_degree = 2, .spared = 1});
    const KnotVector& knots = curve.knots();
    const int p = curve.degree(), n = knots.count(), count = knots.closed() ? n : n - 1;
    std::vector<Eigen::Vector3d> legs;
    legs.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
      legs.emplace_back(p * (curve.point(i + 1) - curve.point(i)) / (knots[i + p + 1] - knots[i + 1]));
    const std::vector<double> inner(knots.knots().begin() + 1, knots.knots().end() - 1);
    const BSplineCurve hodograph =
        BSplineCurve::make(KnotVector::make(p - 1, knots.topology(), inner).value(), legs).value();
    const double t = drawn_parameter(knots);
    const auto of_curve = derivatives(curve, t, p), of_hodograph = derivatives(hodograph, t, p - 1);
    for (int k = 1; k <= p; ++k) {
      expect(close(of_curve[static_cast<std::size_t>(k)], of_hodograph[static_cast<std::size_t>(k) - 1], 1e-13,
                   derivative_size(curve, t, k)),
             "derivative");
    }
  }));
}

TEST_CASE("Greville abscissae: with them as control points an open curve is t itself") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve({.ends = {Ends::clamped, Ends::unclamped}});
    std::vector<Eigen::Vector3d> points;
    for (const double t : curve.greville_abscissae()) points.emplace_back(t, 1, 0);
    const BSplineCurve line = with_points(curve, points);
    const double t = drawn_parameter(curve.knots());
    expect(close(line(t).x(), t, 1e-14, derivative_size(line, t, 0)), "t");
    expect(close(derivatives(line, t, 1)[1].x(), 1, 1e-13, derivative_size(line, t, 1)), "speed");
  }));
}

TEST_CASE("parameters in another unit or in the other direction: the same curve") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const int exponent = *rc::gen::inRange(-20, 21), p = curve.degree();
    std::vector<double> scaled, reversed;
    for (const double t : knots.knots()) scaled.push_back(std::ldexp(t, exponent));
    for (const double t : knots.knots()) reversed.insert(reversed.begin(), -t);
    const BSplineCurve faster =
        BSplineCurve::make(KnotVector::make(p, knots.topology(), scaled).value(), copy(curve.points())).value();
    // Point j of the reversed curve belongs to the knots of point n-1-j (closed: of n+p-1-j).
    std::vector<Eigen::Vector3d> points;
    points.reserve(curve.points().size());
    const int last = knots.closed() ? knots.count() + p - 1 : knots.count() - 1;
    for (int j = 0; j < knots.count(); ++j) points.push_back(curve.point(last - j));
    const BSplineCurve back =
        BSplineCurve::make(KnotVector::make(p, knots.topology(), reversed).value(), points).value();
    const double t = drawn_inner_parameter(knots);
    const auto here = derivatives(curve, t, p), there = derivatives(faster, std::ldexp(t, exponent), p);
    const auto other = derivatives(back, -t, p);
    for (std::size_t k = 0; k < here.size(); ++k) {
      const int order = static_cast<int>(k);
      holds(Eigen::Vector3d(there[k] * std::ldexp(1.0, exponent * order)) == here[k]);
      expect(close(other[k] * (k % 2 == 0 ? 1 : -1), here[k], 1e-13, derivative_size(curve, t, order)), "reversed");
    }
  }));
}

TEST_CASE("the curve lies in the box of its p+1 points and crosses no plane more often than its polygon") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve({.ends = {Ends::clamped, Ends::unclamped}});
    const KnotVector& knots = curve.knots();
    const double t = drawn_parameter(knots), rounding = 1e-14 * (polygon_size(curve) + 1);
    Eigen::AlignedBox3d box;
    const int span = knots.span(t);
    for (int i = span - curve.degree(); i <= span; ++i) box.extend(curve.point(i));
    holds(box.exteriorDistance(curve(t)) <= rounding);
    const double height = drawn_point().x();
    std::vector<double> polygon, samples;
    for (const Eigen::Vector3d& point : curve.points()) polygon.push_back(point.x() - height);
    for (const int i : spans(knots)) {
      for (int k = 0; k <= 8; ++k) samples.push_back(curve(std::lerp(knots[i], knots[i + 1], k / 8.0)).x() - height);
    }
    holds(sign_changes(samples, rounding + 1e-14 * std::abs(height)) <= sign_changes(polygon, 0));
  }));
}

TEST_CASE("de Boor's triangle ends in the curve's point, and so does the blossom, which is affine in an argument") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const double t = drawn_parameter(knots), inside = knots.reduced(t), size = derivative_size(curve, t, 0);
    const int span = knots.span(inside);
    expect(close(curve.de_boor(t).back().front(), curve(t), 1e-14, size), "de Boor");
    std::vector<double> arguments(static_cast<std::size_t>(curve.degree()), inside);
    expect(close(curve.blossom(span, arguments), curve(t), 1e-14, size), "blossom");
    const auto at = [&](double share) {
      arguments.back() = std::lerp(inside, knots[span + 1], share);
      return curve.blossom(span, arguments);
    };
    expect(close(at(0.25), 0.75 * at(0) + 0.25 * at(1), 1e-13, polygon_size(curve)), "affine");
  }));
}

TEST_CASE("fast pieces and batches are the curve") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const SplinePieces pieces(curve);
    std::vector<double> t{drawn_parameter(curve.knots()), drawn_parameter(curve.knots())};
    std::sort(t.begin(), t.end());
    std::vector<Eigen::Vector3d> fast(6), batch(6);
    pieces.evaluate(t, 2, fast);
    curve.evaluate(t, 2, batch);
    for (std::size_t m = 0; m < t.size(); ++m) {
      const auto here = derivatives(curve, t[m], 2);
      for (std::size_t k = 0; k < 3; ++k) {
        holds(batch[3 * m + k] == here[k]);
        const double size = polygon_size(curve) * basis_size(curve.knots(), t[m], static_cast<int>(k));
        expect(close(fast[3 * m + k], here[k], 1e-13, size), "pieces");
      }
    }
  }));
}

TEST_CASE("inserting a knot keeps the curve, removing it gives the points back") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const double place = drawn_parameter(curve.knots());
    const Result<BSplineCurve> refined = curve.with_knot(place);
    if (!refined) {
      const std::span<const double> all = curve.knots().knots();
      const bool at_end = !curve.knots().closed() && (place == all.front() || place == all.back());
      holds(curve.knots().multiplicity(place) == curve.degree() + (at_end ? 1 : 0));
      holds(refined.error().path == "t");
      return;
    }
    holds(polygon_size(refined.value()) <= polygon_size(curve) * (1 + 1e-14));
    for (int k = 0; k < 4; ++k) expect_same(curve, refined.value(), drawn_parameter(curve.knots()), 1e-13, "refined");
    const Result<KnotRemoval> back = without_knot(refined.value(), place);
    if (!back) return;  // an end of an open curve
    const double size = polygon_size(curve);
    holds(back.value().deviation <= 1e-13 * size);
    for (std::size_t i = 0; i < curve.points().size(); ++i)
      expect(close(back.value().curve.points()[i], curve.points()[i], 1e-12, size), "point");
  }));
}

TEST_CASE("elevation keeps the curve; each distinct knot is there once more") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const BSplineCurve raised = elevated(curve).value();
    holds(raised.degree() == curve.degree() + 1);
    holds(polygon_size(raised) <= polygon_size(curve) * (1 + 1e-14));
    for (int k = 0; k < 4; ++k) {
      const double t = drawn_inner_parameter(curve.knots());
      expect_same(curve, raised, t, 1e-13, "raised");
    }
    for (const double t : curve.knots().knots()) {
      const bool inside = t > curve.knots().start() && t < curve.knots().end();
      if (inside) holds(raised.knots().multiplicity(t) == curve.knots().multiplicity(t) + 1);
    }
  }));
}

TEST_CASE("Bezier extraction: the pieces fill the domain, join, and are the curve") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const std::vector<BezierCurve> pieces = curve.bezier_pieces();
    const std::vector<int> intervals = spans(knots);
    holds(pieces.size() == intervals.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      holds(pieces[k].start() == knots[intervals[k]]);
      holds(pieces[k].end() == knots[intervals[k] + 1]);
      if (k > 0) holds(pieces[k].points().front() == pieces[k - 1].points().back());
    }
    if (knots.closed()) holds(pieces.back().points().back() == pieces.front().points().front());
    const std::size_t which = *rc::gen::inRange<std::size_t>(0, pieces.size());
    const double t = std::lerp(pieces[which].start(), pieces[which].end(), *rc::gen::inRange(0, 64) / 64.0);
    std::vector<Eigen::Vector3d> of_piece(static_cast<std::size_t>(curve.degree()) + 1);
    pieces[which].evaluate(t, of_piece);
    const auto here = derivatives(curve, t, curve.degree());
    for (std::size_t k = 0; k < here.size(); ++k) {
      const double size =
          polygon_size(curve) * std::max(basis_size(curve.knots(), t, static_cast<int>(k)),
                                         // The piece's own derivative of the k-th Bernstein polynomials.
                                         std::pow(2.0 * curve.degree() / (pieces[which].end() - pieces[which].start()),
                                                  static_cast<double>(k)));
      expect(close(of_piece[k], here[k], 1e-13, size), "piece");
    }
  }));
}

TEST_CASE("a curve is as smooth at its knots as their multiplicity says, the closed seam included") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const std::vector<int> intervals = spans(knots);
    for (std::size_t k = knots.closed() ? 0 : 1; k < intervals.size(); ++k) {
      const int right = intervals[k], left = k > 0 ? intervals[k - 1] : intervals.back();
      const int smooth = curve.degree() - knots.multiplicity(knots[right]);
      for (int order = 0; order <= smooth; ++order) {
        const Sided a = sided(curve, left, knots[left + 1], order), b = sided(curve, right, knots[right], order);
        expect(close(a.value, b.value, 1e-13, std::max(a.size, b.size)), "side");
      }
    }
    for (const KnotContinuity& at : continuity(curve)) {
      holds(at.smoothness == curve.degree() - knots.multiplicity(at.t));
      holds(at.measured >= at.smoothness);
    }
  }));
}

TEST_CASE("a closed curve repeats with its period, bit for bit; an open one stops at its ends") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const KnotVector& knots = curve.knots();
    const double t = drawn_parameter(knots);
    if (knots.closed()) {
      for (const int turns : {-2, 1, 3}) holds(curve(t + turns * knots.period()) == curve(t));
    } else {
      holds(curve(knots.end() + knots.period()) == curve(knots.end()));
      holds(curve(knots.start() - knots.period()) == curve(knots.start()));
    }
  }));
}

TEST_CASE("clamped, unclamped, cut open, closed again: the same curve") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve();
    const BSplineCurve open = clamped(curve).value();
    for (int k = 0; k < 3; ++k) expect_same(curve, open, drawn_inner_parameter(curve.knots()), 1e-13, "clamped");
    holds(open(open.knots().start()) == open.points().front());
    if (!curve.knots().closed()) return;
    const int seam = curve.knots().multiplicity(curve.knots().start());
    for (const BSplineCurve& cut : {open, unclamped(curve).value()}) {
      const Result<BSplineCurve> again = closed(cut, seam);
      holds(again.has_value());
      holds(again.value().knots().count() == curve.knots().count());
      for (int k = 0; k < 3; ++k) {
        const double t = drawn_inner_parameter(curve.knots());
        expect(close(again.value()(t), curve(t), 1e-12, polygon_size(curve)), "closed again");
      }
    }
  }));
}

}  // namespace knotwork::bspline_properties
