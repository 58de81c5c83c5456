#include "knotwork/curve/bspline_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "unit/bspline_cases.h"

namespace knotwork::bspline_refinement_test {
using namespace test;
namespace {

constexpr Ends all_ends[] = {Ends::clamped, Ends::unclamped, Ends::closed};

/// Random parameters of the domain, off the knots with certainty for all that is tested here.
std::vector<double> parameters(const BSplineCurve& curve, int count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(curve.knots().start(), curve.knots().end());
  std::vector<double> t;
  t.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) t.push_back(place(random));
  return t;
}

/// The largest distance between two curves over a grid of their domain.
double distance(const BSplineCurve& a, const BSplineCurve& b) {
  double most = 0;
  for (int step = 0; step <= 120; ++step) {
    const double t = std::lerp(a.knots().start(), a.knots().end(), step / 120.0);
    most = std::max(most, (a(t) - b(t)).norm());
  }
  return most;
}

double distance_of_points(const BSplineCurve& a, const BSplineCurve& b) {
  REQUIRE(a.points().size() == b.points().size());
  double most = 0;
  for (std::size_t i = 0; i < a.points().size(); ++i) most = std::max(most, (a.points()[i] - b.points()[i]).norm());
  return most;
}

/// The curve moved by `by` in one control point.
BSplineCurve with_point_moved(const BSplineCurve& curve, std::size_t i, double by) {
  std::vector<Eigen::Vector3d> points(curve.points().begin(), curve.points().end());
  points[i].x() += by;
  return BSplineCurve::make(curve.knots(), std::move(points)).value();
}

BSplineCurve uniform_curve(int degree, int count, Topology topology, std::mt19937& random) {
  return BSplineCurve::make(KnotVector::uniform(degree, count, topology, 0, 6).value(),
                            random_points(static_cast<std::size_t>(count), random))
      .value();
}

}  // namespace

TEST_CASE("elevation keeps the oracles' curves with their derivatives") {
  int compared = 0;
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const CurveOracle& oracle : curve_oracles(topology)) {
      CAPTURE(oracle.name);
      const BSplineCurve once = elevated(oracle.curve).value(), twice = elevated(once).value();
      for (const nlohmann::json& at : oracle.points) {
        const double t = at["t"].get<double>();
        if (t >= once.knots().end() && topology == Topology::closed) continue;
        std::vector<Eigen::Vector3d> derivatives(at["derivatives"].size());
        for (const BSplineCurve* curve : {&once, &twice}) {
          curve->evaluate(t, derivatives);
          for (std::size_t k = 0; k < derivatives.size(); ++k, ++compared) {
            CHECK(close(derivatives[k], vector3(at["derivatives"][k]), oracle_tolerance,
                        derivative_size(*curve, t, static_cast<int>(k))));
          }
        }
      }
    }
  }
  CHECK(compared > 1500);
}

TEST_CASE("elevation keeps every curve and its derivatives; each distinct knot is there once more") {
  std::mt19937 random(21);
  for (const Ends ends : all_ends) {
    for (int degree = 1; degree <= 12; ++degree) {
      for (const int count : {degree + 1, degree + 4, 2 * degree + 7}) {
        const BSplineCurve curve = random_curve(degree, count, ends, random);
        const BSplineCurve raised = elevated(curve).value();
        CAPTURE(degree);
        CAPTURE(count);
        CHECK(raised.degree() == degree + 1);
        CHECK(raised.knots().start() == curve.knots().start());
        CHECK(raised.knots().end() == curve.knots().end());
        for (const double t : curve.knots().knots()) {
          const bool inside = t > curve.knots().start() && t < curve.knots().end();
          if (inside) CHECK(raised.knots().multiplicity(t) == curve.knots().multiplicity(t) + 1);
        }
        CHECK(polygon_size(raised) <= polygon_size(curve) * (1 + 1e-14));  // convex combinations
        for (const double t : parameters(curve, 8, random)) {
          CHECK(same_at(curve, raised, t, degree + 1, 1e-12));
        }
      }
    }
  }
}

TEST_CASE("the check of two curves' derivatives sees a point that is off by 1e-9") {
  std::mt19937 random(22);
  const BSplineCurve curve = random_curve(4, 9, Ends::clamped, random);
  const BSplineCurve raised = elevated(curve).value();
  const double t = 2.5;
  CHECK(same_at(curve, raised, t, 4, 1e-12));
  const int span = raised.knots().span(t);
  CHECK_FALSE(same_at(curve, with_point_moved(raised, static_cast<std::size_t>(span) - 2, 1e-9), t, 4, 1e-12));
}

TEST_CASE("a Bezier curve and a B-spline of one piece are elevated alike") {
  std::mt19937 random(23);
  const BSplineCurve curve = random_curve(5, 6, Ends::clamped, random);
  const BezierCurve expected = curve.bezier_pieces().front().elevated();
  const BSplineCurve raised = elevated(curve).value();
  REQUIRE(raised.points().size() == expected.points().size());
  for (std::size_t k = 0; k < expected.points().size(); ++k) {
    CHECK(close(raised.points()[k], expected.points()[k], 1e-14, 5));
  }
}

TEST_CASE("a knot that was inserted can be removed, and the curve is what it was") {
  std::mt19937 random(24);
  for (const Ends ends : all_ends) {
    for (int degree = 1; degree <= 9; ++degree) {
      for (const int count : {degree + 2, degree + 6}) {
        const BSplineCurve curve = random_curve(degree, count, ends, random);
        const KnotVector& knots = curve.knots();
        std::vector<double> places = parameters(curve, 3, random);
        places.insert(places.end(), knots.knots().begin(), knots.knots().end());
        for (const double place : places) {
          const double t = knots.reduced(place);
          if (!knots.closed() && (t == knots.start() || t == knots.end())) continue;
          const Result<BSplineCurve> refined = curve.with_knot(t);
          if (!refined) continue;
          CAPTURE(degree);
          CAPTURE(t);
          const KnotRemoval back = without_knot(refined.value(), t).value();
          const double size = polygon_size(curve);
          CHECK(back.deviation <= 1e-13 * size);
          CHECK(back.curve.knots().count() == count);
          CHECK(back.curve.knots().start() == knots.start());
          CHECK(distance(curve, back.curve) <= 1e-13 * size);
        }
      }
    }
  }
}

TEST_CASE("the deviation of a removal bounds the distance of the curves, and is met at degree 1") {
  std::mt19937 random(25);
  int removed = 0;
  for (const Ends ends : all_ends) {
    for (int degree = 1; degree <= 7; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 5, ends, random);
      for (const double t : curve.knots().knots()) {
        const Result<KnotRemoval> removal = without_knot(curve, t);
        if (!removal) continue;
        ++removed;
        const double deviation = removal.value().deviation, apart = distance(curve, removal.value().curve);
        CAPTURE(degree);
        CAPTURE(t);
        CHECK(removal.value().curve.knots().multiplicity(t) == curve.knots().multiplicity(t) - 1);
        CHECK(apart <= deviation * (1 + 1e-12));
        // A spline of degree p reaches more than 1/(p+1) somewhere.
        CHECK(apart >= deviation / (degree + 1));
        if (degree == 1) {
          const double there = (curve(t) - removal.value().curve(t)).norm();
          CHECK(close(there, deviation, 1e-13));
        }
      }
    }
  }
  CHECK(removed > 60);
}

TEST_CASE("a closed curve that loses the only knot at its start begins at the next") {
  const KnotVector knots = KnotVector::uniform(2, 5, Topology::closed, 0, 5).value();
  std::mt19937 random(26);
  const BSplineCurve curve = BSplineCurve::make(knots, random_points(5, random)).value();
  const KnotRemoval removal = without_knot(curve, 0).value();
  CHECK(removal.curve.knots().start() == 1);
  CHECK(removal.curve.knots().end() == 6);
  CHECK(removal.deviation > 0.01);
  CHECK(distance(curve, removal.curve) <= removal.deviation);

  // A removable one: the knot 5 put back, and the curve begun there by counting from another point.
  const BSplineCurve back = removal.curve.with_knot(5).value();
  const int turn = back.knots().span(5) - 2;
  std::vector<double> turned;
  std::vector<Eigen::Vector3d> points;
  for (int k = turn; k < turn + 10; ++k) {
    const int round = k / 5;
    turned.push_back(back.knots()[k - 5 * round] + 5.0 * round);
  }
  for (int k = turn; k < turn + 5; ++k) points.push_back(back.point(k));
  const BSplineCurve begun = BSplineCurve::make(KnotVector::make(2, Topology::closed, turned).value(), points).value();
  REQUIRE(begun.knots().start() == 5);
  CHECK(distance(begun, back) < 1e-14);
  const KnotRemoval again = without_knot(begun, 5).value();
  CHECK(again.deviation < 1e-14);
  CHECK(again.curve.knots().start() == 6);
  CHECK(distance(again.curve, removal.curve) < 1e-14);
}

TEST_CASE("what has no knot to lose is refused, with the place") {
  std::mt19937 random(27);
  const BSplineCurve open = uniform_curve(3, 7, Topology::open, random);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double t : {-1.0, 0.0, 0.1, 6.0, 7.0, nan, infinity}) CHECK(without_knot(open, t).error().path == "t");
  CHECK(without_knot(open, 1.5).has_value());
  const BSplineCurve closed = uniform_curve(3, 3, Topology::closed, random);
  CHECK(without_knot(closed, 2).error().path == "t");
  CHECK(without_knot(uniform_curve(1, 2, Topology::closed, random), 3).error().path == "t");
}

TEST_CASE("the smoothness at knots, as the knots say and as measured") {
  std::mt19937 random(28);
  for (const Ends ends : all_ends) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve curve = random_curve(degree, degree + 6, ends, random);
      const std::vector<KnotContinuity> list = continuity(curve);
      double before = -1;
      for (const KnotContinuity& at : list) {
        CAPTURE(degree);
        CAPTURE(at.t);
        CHECK(at.t > before);
        before = at.t;
        CHECK(at.multiplicity == curve.knots().multiplicity(at.t));
        CHECK(at.smoothness == degree - at.multiplicity);
        CHECK(at.measured == at.smoothness);  // random points: no more than that
      }
      CHECK((list.empty() || (list.front().t == curve.knots().start()) == (ends == Ends::closed)));

      // A knot put in between is one of multiplicity 1 where both sides are one polynomial.
      const double t = 5.9;
      const std::vector<KnotContinuity> more = continuity(curve.with_knot(t).value());
      REQUIRE(more.size() == list.size() + 1);
      CHECK(more.back().t == t);
      CHECK(more.back().smoothness == degree - 1);
      CHECK(more.back().measured == degree);
    }
  }
}

TEST_CASE("measured smoothness depends neither on units nor on the place in space") {
  std::mt19937 random(29);
  const BSplineCurve curve = elevated(uniform_curve(3, 8, Topology::closed, random)).value();
  const KnotVector narrow = [&] {
    std::vector<double> knots;
    for (const double t : curve.knots().knots()) knots.push_back(1e-7 * t);
    return KnotVector::make(4, Topology::closed, std::move(knots)).value();
  }();
  for (const double unit : {1e-6, 1.0, 1e6}) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : curve.points())
      points.emplace_back(unit * (point + Eigen::Vector3d(1e4, 0, 0)));
    for (const KnotContinuity& at : continuity(BSplineCurve::make(narrow, points).value())) {
      CHECK(at.multiplicity == 2);
      CHECK(at.smoothness == 2);
      CHECK(at.measured == 2);
    }
    // And a jump of 1e-6 of the curve's size is seen.
    points[3].x() += unit * 1e-5;
    bool seen = false;
    for (const KnotContinuity& at : continuity(BSplineCurve::make(narrow, points).value())) seen |= at.measured < 3;
    CHECK(seen);
  }
}

TEST_CASE("clamping keeps the oracles' curves, open and closed") {
  int compared = 0;
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const CurveOracle& oracle : curve_oracles(topology)) {
      CAPTURE(oracle.name);
      const BSplineCurve open = clamped(oracle.curve).value();
      CHECK_FALSE(open.knots().closed());
      CHECK(open.knots().multiplicity(open.knots().start()) == open.degree() + 1);
      CHECK(open.knots().multiplicity(open.knots().end()) == open.degree() + 1);
      CHECK(open(open.knots().start()) == open.points().front());
      for (const nlohmann::json& at : oracle.points) {
        const double t = at["t"].get<double>();
        std::vector<Eigen::Vector3d> derivatives(at["derivatives"].size());
        open.evaluate(t, derivatives);
        for (std::size_t k = 0; k < derivatives.size(); ++k, ++compared) {
          CHECK(close(derivatives[k], vector3(at["derivatives"][k]), oracle_tolerance,
                      derivative_size(open, t, static_cast<int>(k))));
        }
      }
    }
  }
  CHECK(compared > 900);
}

TEST_CASE("what is clamped already stays as it is") {
  std::mt19937 random(30);
  const BSplineCurve curve = random_curve(4, 10, Ends::clamped, random);
  const BSplineCurve again = clamped(curve).value();
  CHECK(std::equal(again.knots().knots().begin(), again.knots().knots().end(), curve.knots().knots().begin()));
  CHECK(distance_of_points(curve, again) == 0);
}

TEST_CASE("unclamping keeps the curve, and clamping gives back its points") {
  std::mt19937 random(31);
  for (int degree = 1; degree <= 9; ++degree) {
    const BSplineCurve curve = random_curve(degree, degree + 5, Ends::clamped, random);
    const BSplineCurve loose = unclamped(curve).value();
    CHECK(loose.knots().multiplicity(0) == 1);
    CHECK(loose.knots().multiplicity(6) == 1);
    CHECK(loose.knots().count() == curve.knots().count());
    // Rounding is that of the points, which lie far outside.
    CAPTURE(degree);
    for (const double t : parameters(curve, 20, random)) CHECK(close(loose(t), curve(t), 1e-13, polygon_size(loose)));
    const BSplineCurve back = clamped(loose).value();
    CHECK(distance_of_points(back, curve) <= 1e-13 * polygon_size(loose));

    const BSplineCurve around = random_curve(degree, degree + 5, Ends::closed, random);
    const BSplineCurve once = unclamped(around).value();
    CHECK_FALSE(once.knots().closed());
    for (const double t : parameters(around, 20, random)) CHECK(same_at(around, once, t, degree, 0));
  }
}

TEST_CASE("closed, cut open, closed again: the same curve") {
  std::mt19937 random(32);
  for (int degree = 1; degree <= 9; ++degree) {
    for (const int count : {degree + 1, degree + 6, 3 * degree + 4}) {
      const BSplineCurve curve = random_curve(degree, count, Ends::closed, random);
      const int seam = curve.knots().multiplicity(0);
      for (const BSplineCurve& open : {clamped(curve).value(), unclamped(curve).value()}) {
        CAPTURE(degree);
        CAPTURE(count);
        CAPTURE(seam);
        const Result<BSplineCurve> again = closed(open, seam);
        REQUIRE(again);
        CHECK(again.value().knots().closed());
        CHECK(again.value().knots().count() == count);
        CHECK(again.value().knots().multiplicity(0) == seam);
        CHECK(distance(curve, again.value()) <= 1e-13 * polygon_size(curve));
        for (const double t : parameters(curve, 10, random)) CHECK(same_at(curve, again.value(), t, 1, 1e-11));
      }
    }
  }
}

TEST_CASE("ends that do not meet smoothly enough are refused, with the first derivative that differs") {
  std::mt19937 random(33);
  const BSplineCurve around = uniform_curve(3, 8, Topology::closed, random);
  const BSplineCurve open = clamped(around).value();
  CHECK(closed(open).has_value());
  CHECK(closed(around).value().points().data() != nullptr);  // as it is
  const std::size_t last = open.points().size() - 1;
  const char* expected[] = {"same place", "order 1", "order 2"};
  for (std::size_t k = 0; k <= 2; ++k) {
    const BSplineCurve moved = with_point_moved(open, last - k, 1e-3);
    CAPTURE(k);
    const Result<BSplineCurve> result = closed(moved);
    REQUIRE_FALSE(result);
    CHECK(result.error().path == "points");
    CHECK(result.error().message.find(expected[k]) != std::string::npos);
    // A start of multiplicity m asks for p-m derivatives only.
    for (int seam = 1; seam <= 3; ++seam) CHECK(closed(moved, seam).has_value() == (static_cast<int>(k) > 3 - seam));
  }
}

TEST_CASE("errors of conversions and of elevation, with their paths") {
  std::mt19937 random(34);
  const BSplineCurve open = uniform_curve(3, 8, Topology::open, random);
  CHECK(closed(open, 0).error().path == "seam_multiplicity");
  CHECK(closed(open, 4).error().path == "seam_multiplicity");
  CHECK(closed(open, 1).error().path == "points");
  const BSplineCurve still = BSplineCurve::make(KnotVector::uniform(3, 5, Topology::open, 0, 2).value(),
                                                std::vector<Eigen::Vector3d>(5, Eigen::Vector3d::Ones()))
                                 .value();
  CHECK(closed(still).error().path == "count");
  CHECK(closed(still, 2).value().points().size() == 3);
  CHECK(elevated(uniform_curve(KnotVector::max_degree, 20, Topology::open, random)).error().path == "degree");

  const int most = KnotVector::max_count;
  const BSplineCurve longest = uniform_curve(2, most, Topology::closed, random);
  CHECK(elevated(longest).error().path == "count");
  CHECK(clamped(longest).error().path == "count");
  CHECK(unclamped(longest).error().path == "count");
  CHECK(elevated(uniform_curve(2, most, Topology::open, random)).error().path == "count");
}

}  // namespace knotwork::bspline_refinement_test
