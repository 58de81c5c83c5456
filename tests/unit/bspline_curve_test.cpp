#include "knotwork/curve/bspline_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "unit/oracle.h"

namespace knotwork::bspline_curve_test {
using namespace test;
namespace {

std::vector<Eigen::Vector3d> vectors(const nlohmann::json& list) {
  std::vector<Eigen::Vector3d> out;
  for (const nlohmann::json& item : list) out.push_back(vector3(item));
  return out;
}

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

/// A curve with random points; inner knots drawn from few places, so that many are repeated.
BSplineCurve random_curve(int degree, int count, Topology topology, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  if (topology == Topology::closed)
    return BSplineCurve::make(KnotVector::uniform(degree, count, topology, 2, 2 + count).value(), std::move(points))
        .value();
  std::uniform_int_distribution<int> place(1, 4);
  for (;;) {
    std::vector<double> inner;
    inner.reserve(static_cast<std::size_t>(count - degree - 1));
    for (int i = 0; i < count - degree - 1; ++i) inner.push_back(place(random) + (place(random) == 1 ? 0.5 : 0));
    std::sort(inner.begin(), inner.end());
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    knots.insert(knots.end(), inner.begin(), inner.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 6.0);
    const Result<KnotVector> vector = KnotVector::make(degree, topology, std::move(knots));
    if (vector) return BSplineCurve::make(vector.value(), std::move(points)).value();
  }
}

}  // namespace

TEST_CASE("open B-spline curves meet oracle 01") {
  const nlohmann::json oracle = load_oracle("01_bspline_clamped.json");
  REQUIRE(oracle.contains("cases"));
  int compared = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    const KnotVector knots =
        KnotVector::make(inputs["degree"].get<int>(), Topology::open, inputs["knots"].get<std::vector<double>>())
            .value();
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    compared += compare(BSplineCurve::make(knots, vectors(inputs["control_points"])).value(), entry["points"]);
  }
  CHECK(compared > 400);
}

TEST_CASE("closed B-spline curves meet oracle 02") {
  const nlohmann::json oracle = load_oracle("02_bspline_periodic.json");
  REQUIRE(oracle.contains("cases"));
  int compared = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    if (!inputs.contains("distinct_control_points")) continue;
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    const int degree = inputs["degree"].get<int>();
    std::vector<double> knots = inputs["knots"].get<std::vector<double>>();
    const KnotVector closed = KnotVector::make(degree, Topology::closed, std::move(knots)).value();
    const BSplineCurve curve = BSplineCurve::make(closed, vectors(inputs["distinct_control_points"])).value();
    nlohmann::json inside = nlohmann::json::array();
    for (const nlohmann::json& at : entry["points"]) {
      if (at["t"].get<double>() < closed.end()) inside.push_back(at);
    }
    compared += compare(curve, inside);
    // The seam: position and p-1 derivatives go on as at every other knot.
    std::vector<Eigen::Vector3d> start(static_cast<std::size_t>(degree)), end(start.size());
    curve.evaluate(closed.start(), start);
    curve.evaluate(std::nextafter(closed.end(), 0), end);
    for (std::size_t k = 0; k < start.size(); ++k) CHECK(close(end[k], start[k], 1e-12, 30));
  }
  CHECK(compared > 200);
}

TEST_CASE("the triangle of matrix factors ends in the curve's point") {
  std::mt19937 random(7);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 4, topology, random);
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
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      for (const int count : {std::max(2, degree), degree + 1, degree + 5}) {
        if (topology == Topology::open && count <= degree) continue;
        const BSplineCurve curve = random_curve(degree, count, topology, random);
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

TEST_CASE("a knot inserted p times brings a control point onto the curve") {
  std::mt19937 random(9);
  BSplineCurve curve = random_curve(3, 9, Topology::closed, random);
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
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 5, topology, random);
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
  const BSplineCurve curve = random_curve(4, 12, Topology::open, random);
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
