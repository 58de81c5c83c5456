#include "knotwork/curve/bspline_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "unit/bspline_cases.h"

namespace knotwork::bspline_curve_test {
using namespace test;
namespace {

/// Every point of an oracle's case; the number of vectors compared.
int compare(const BSplineCurve& curve, const nlohmann::json& points) {
  int compared = 0;
  double size = 0;
  for (const Eigen::Vector3d& point : curve.points()) size = std::max(size, point.norm());
  for (const nlohmann::json& at : points) {
    const nlohmann::json& expected = at["derivatives"];
    std::vector<Eigen::Vector3d> actual(expected.size());
    curve.evaluate(at["t"].get<double>(), actual);
    for (std::size_t k = 0; k < actual.size(); ++k) {
      CAPTURE(at["t"].get<double>());
      CAPTURE(k);
      CHECK(close(actual[k], vector3(expected[k]), oracle_tolerance, size));
      ++compared;
    }
  }
  return compared;
}

}  // namespace

TEST_CASE("open B-spline curves meet oracle 01") {
  int compared = 0;
  for (const CurveOracle& oracle : curve_oracles(Topology::open)) {
    CAPTURE(oracle.name);
    compared += compare(oracle.curve, oracle.points);
  }
  CHECK(compared > 400);
}

TEST_CASE("closed B-spline curves meet oracle 02") {
  int compared = 0, met = 0;
  for (const CurveOracle& oracle : curve_oracles(Topology::closed)) {
    CAPTURE(oracle.name);
    const KnotVector& closed = oracle.curve.knots();
    const std::size_t degree = static_cast<std::size_t>(closed.degree());
    nlohmann::json inside = nlohmann::json::array();
    for (nlohmann::json at : oracle.points) {
      // At the end of the period the oracle looks back: what is the same from both sides is compared.
      nlohmann::json& derivatives = at["derivatives"];
      if (at["t"].get<double>() >= closed.end() && derivatives.size() > degree) derivatives.erase(degree);
      inside.push_back(at);
    }
    compared += compare(oracle.curve, inside);
    // The seam: position and p-1 derivatives go on as at every other knot.
    std::vector<Eigen::Vector3d> start(degree), end(degree);
    oracle.curve.evaluate(closed.start(), start);
    oracle.curve.evaluate(std::nextafter(closed.end(), 0), end);
    for (std::size_t k = 0; k < start.size(); ++k) CHECK(close(end[k], start[k], 1e-12, 60));
    // The oracle's own interpolation conditions.
    if (!oracle.inputs.contains("parameters")) continue;
    const std::vector<Eigen::Vector3d> through = vectors(oracle.inputs["points"]);
    for (std::size_t j = 0; j < through.size(); ++j, ++met) {
      CHECK(close(oracle.curve(oracle.inputs["parameters"][j].get<double>()), through[j], oracle_tolerance,
                  polygon_size(oracle.curve)));
    }
  }
  CHECK(compared > 450);
  CHECK(met == 21);
}

TEST_CASE("the triangle of matrix factors ends in the curve's point") {
  std::mt19937 random(7);
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 4, ends, random);
      for (int step = 0; step <= 30; ++step) {
        const double t = std::lerp(curve.knots().start(), curve.knots().end(), step / 30.0);
        const PointTriangle triangle = curve.de_boor(t);
        REQUIRE(triangle.size() == static_cast<std::size_t>(degree) + 1);
        CHECK(close(triangle.back().front(), curve(t), 1e-13, 5));
      }
    }
  }
}

TEST_CASE("inserting a knot keeps the curve, open and closed, at knots, between them and at the seam") {
  std::mt19937 random(8);
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      for (const int count : {std::max(2, degree), degree + 1, degree + 5}) {
        if (ends != Ends::closed && count <= degree) continue;
        const BSplineCurve curve = random_curve(degree, count, ends, random);
        const double start = curve.knots().start(), length = curve.knots().period();
        for (const double share : {0.0, 0.013, 0.5, 0.83, 0.999}) {
          const double t = start + share * length;
          const Result<BSplineCurve> refined = curve.with_knot(t);
          if (!refined) continue;  // a knot that is full; the refusal has its own test
          CAPTURE(degree);
          CAPTURE(count);
          CAPTURE(share);
          CHECK(refined.value().knots().count() == count + 1);
          CHECK(refined.value().knots().start() == start);
          for (int step = 0; step < 50; ++step) {
            const double x = start + length * step / 50;
            CHECK(close(refined.value()(x), curve(x), 1e-12, 5));
          }
        }
      }
    }
  }
}

TEST_CASE(
    "the blossom is affine, it is the curve and its derivatives on the diagonal, and control points are its values") {
  std::mt19937 random(12);
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 4, ends, random);
      const KnotVector& knots = curve.knots();
      const std::size_t p = static_cast<std::size_t>(degree);
      for (int span = degree; span <= knots.last_span(); ++span) {
        if (!(knots[span] < knots[span + 1])) continue;
        for (int i = span - degree; i <= span; ++i) {
          const std::span<const double> at = knots.knots().subspan(static_cast<std::size_t>(i) + 1, p);
          CHECK(curve.blossom(span, at) == curve.point(i));
        }
        const double from = knots[span], to = knots[span + 1];
        const double t = std::lerp(from, to, 0.4);
        CHECK(close(curve.blossom(span, std::vector<double>(p, t)), curve(t), 1e-13, polygon_size(curve)));
        // f(.., x, ..) with x between two arguments; neither need be a knot.
        std::vector<double> low, middle, high;
        for (std::size_t k = 0; k < p; ++k)
          low.push_back(std::lerp(from, to, 0.3 * static_cast<double>(k + 1) / degree));
        middle = high = low;
        middle.back() = std::lerp(from, to, 0.6);
        high.back() = to;
        const double share = (middle.back() - low.back()) / (high.back() - low.back());
        const Eigen::Vector3d mixed = (1 - share) * curve.blossom(span, low) + share * curve.blossom(span, high);
        CHECK(close(curve.blossom(span, middle), mixed, 1e-13, polygon_size(curve)));
        // Fewer arguments: derivatives.
        std::vector<Eigen::Vector3d> derivatives(p + 1);
        curve.evaluate(t, derivatives);
        for (std::size_t k = 0; k <= p; ++k) {
          CHECK(close(curve.blossom(span, std::vector<double>(p - k, t)), derivatives[k], 1e-13,
                      derivative_size(curve, t, static_cast<int>(k))));
        }
      }
    }
  }
}

TEST_CASE("a knot inserted p times brings a control point onto the curve") {
  std::mt19937 random(9);
  BSplineCurve curve =
      BSplineCurve::make(KnotVector::uniform(3, 9, Topology::closed, 2, 11).value(), random_points(9, random)).value();
  const Eigen::Vector3d there = curve(5.25);
  for (int times = 0; times < 3; ++times) curve = curve.with_knot(5.25).value();
  double least = 1e9;
  for (const Eigen::Vector3d& point : curve.points()) least = std::min(least, (point - there).norm());
  CHECK(least < 1e-13);
  const Result<BSplineCurve> once_more = curve.with_knot(5.25);
  REQUIRE_FALSE(once_more);
  CHECK(once_more.error().path == "t");
}

TEST_CASE("the Bezier pieces are the curve, interval by interval, with all its derivatives") {
  std::mt19937 random(11);
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 5, ends, random);
      const std::vector<BezierCurve> pieces = curve.bezier_pieces();
      REQUIRE_FALSE(pieces.empty());
      CHECK(pieces.front().start() == curve.knots().start());
      CHECK(pieces.back().end() == curve.knots().end());
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (k > 0) CHECK(pieces[k].start() == pieces[k - 1].end());
        CHECK(pieces[k].degree() == degree);
        for (const double share : {0.0, 0.3, 0.9}) {
          const double t = std::lerp(pieces[k].start(), pieces[k].end(), share);
          std::array<Eigen::Vector3d, 3> piece, whole;
          pieces[k].evaluate(t, piece);
          curve.evaluate(t, whole);
          const double width = pieces[k].end() - pieces[k].start();
          for (std::size_t m = 0; m < 3; ++m) {
            CAPTURE(degree);
            CAPTURE(m);
            CHECK(close(piece[m], whole[m], 1e-11, 10 * std::pow(degree / width, static_cast<double>(m))));
          }
        }
      }
    }
  }
}

TEST_CASE("a closed curve whose seam is a double knot: pieces and insertion keep it") {
  const KnotVector knots = KnotVector::make(2, Topology::closed, {-4, 0, 0, 1, 5, 5, 6, 10}).value();
  const BSplineCurve curve = BSplineCurve::make(knots, {{0, 0, 0}, {3, 1, 0}, {1, 4, 2}}).value();
  const std::vector<BezierCurve> pieces = curve.bezier_pieces();
  REQUIRE(pieces.size() == 2);
  const BSplineCurve refined = curve.with_knot(0.25).value();
  for (int step = 0; step < 40; ++step) {
    const double t = step / 8.0;
    CHECK(close(refined(t), curve(t), 1e-14, 4));
    CHECK(close(pieces[t < 1 ? 0 : 1](t), curve(t), 1e-14, 4));
  }
}

TEST_CASE("the multiplicity of a knot, open, closed and at the seam") {
  const KnotVector open = KnotVector::make(2, Topology::open, {0, 0, 0, 1, 1, 3, 4, 4, 4}).value();
  CHECK(open.multiplicity(0) == 3);
  CHECK(open.multiplicity(1) == 2);
  CHECK(open.multiplicity(2) == 0);
  CHECK(open.multiplicity(3) == 1);
  CHECK(open.multiplicity(9) == 3);  // clamped to the end
  const KnotVector closed = KnotVector::make(2, Topology::closed, {-4, 0, 0, 1, 5, 5, 6, 10}).value();
  CHECK(closed.count() == 3);
  CHECK(closed.multiplicity(0) == 2);
  CHECK(closed.multiplicity(5) == 2);
  CHECK(closed.multiplicity(1 + 5) == 1);
}

TEST_CASE("a straight line on the Greville abscissae is a straight line") {
  const KnotVector knots = KnotVector::make(3, Topology::open, {0, 0, 0, 0, 1, 1, 4, 5, 5, 5, 5}).value();
  const auto with = [&](const std::vector<Eigen::Vector3d>& points) {
    return BSplineCurve::make(knots, points).value();
  };
  std::vector<Eigen::Vector3d> points(7, Eigen::Vector3d::Zero());
  const std::vector<double> greville = with(points).greville_abscissae();
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = greville[i] * Eigen::Vector3d(1, -2, 0.5);
  for (const double t : {0.0, 0.4, 1.0, 3.7, 5.0})
    CHECK(close(with(points)(t), Eigen::Vector3d(t, -2 * t, t / 2), 1e-14));
}

TEST_CASE("a batch is the single evaluations, sorted or not") {
  std::mt19937 random(10);
  const BSplineCurve curve = random_curve(4, 12, Ends::clamped, random);
  std::vector<double> t;
  std::uniform_real_distribution<double> place(-1, 7);
  t.reserve(60);
  for (int k = 0; k < 60; ++k) t.push_back(place(random));
  for (const int order : {0, 2, 6}) {
    const std::size_t values = static_cast<std::size_t>(order) + 1;
    std::vector<Eigen::Vector3d> batch(values * t.size()), one(values);
    curve.evaluate(t, order, batch);
    for (std::size_t m = 0; m < t.size(); ++m) {
      curve.evaluate(t[m], one);
      for (std::size_t k = 0; k < values; ++k) CHECK(batch[m * values + k] == one[k]);
    }
  }
}

TEST_CASE("what is no B-spline curve is refused, with the place") {
  const KnotVector knots = KnotVector::uniform(3, 5, Topology::open, 0, 2).value();
  std::vector<Eigen::Vector3d> points(5, Eigen::Vector3d::Ones());
  CHECK(BSplineCurve::make(knots, points).has_value());
  points[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(BSplineCurve::make(knots, points).error().path == "points[3]");
  points.pop_back();
  CHECK(BSplineCurve::make(knots, points).error().path == "points");
  const BSplineCurve curve =
      BSplineCurve::make(knots, std::vector<Eigen::Vector3d>(5, Eigen::Vector3d::Ones())).value();
  for (const double t : {-0.1, 2.1, std::numeric_limits<double>::infinity()}) {
    CHECK(curve.with_knot(t).error().path == "t");
  }
  CHECK(curve.with_knot(0).error().path == "t");  // the end is full
}

}  // namespace knotwork::bspline_curve_test
