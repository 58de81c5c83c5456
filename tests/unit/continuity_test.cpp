#include "knotwork/curve/continuity.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/curve/model_curve.h"

namespace knotwork::continuity_test {
namespace {

/// Any points, but none in a special place.
std::vector<Eigen::Vector3d> scattered(int count) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    points.emplace_back(i + 0.3 * std::sin(5.0 * i), std::cos(3.0 * i), std::sin(7.0 * i));
  return points;
}

BSplineCurve spline(int degree, Topology topology, std::vector<double> knots, std::vector<Eigen::Vector3d> points) {
  return BSplineCurve::make(KnotVector::make(degree, topology, std::move(knots)).value(), std::move(points)).value();
}

TEST_CASE("a knot of multiplicity m leaves a spline of degree d C^(d-m), and no more") {
  for (int degree = 1; degree <= 3; ++degree) {
    for (int multiplicity = 1; multiplicity <= degree; ++multiplicity) {
      CAPTURE(degree);
      CAPTURE(multiplicity);
      std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
      knots.push_back(0.7);
      for (int k = 0; k < multiplicity; ++k) knots.push_back(1.5);
      for (int k = 0; k <= degree; ++k) knots.push_back(2.0);
      const int count = static_cast<int>(knots.size()) - degree - 1;
      const BSplineCurve curve = spline(degree, Topology::open, knots, scattered(count));
      const Continuity found = continuity_at(curve_view(curve), 1.5);
      CHECK(found.parametric == degree - multiplicity);
      CHECK(found.geometric == std::min(degree - multiplicity, 2));
      CHECK((found.velocity_gap > 1e-3) == (degree == multiplicity));
    }
  }
}

TEST_CASE("whatever the knots and the place, rounding breaks no joint") {
  for (const double stretch : {1e-6, 1.0, 1e6}) {
    for (const double away : {0.0, 1e3}) {
      CAPTURE(stretch);
      CAPTURE(away);
      std::vector<double> knots{0, 0, 0, 0, 1, 1.01, 5, 9, 9, 9, 9};
      for (double& t : knots) t *= stretch;
      std::vector<Eigen::Vector3d> points = scattered(7);
      for (Eigen::Vector3d& point : points) point += Eigen::Vector3d(away, -away, away);
      const BSplineCurve curve = spline(3, Topology::open, knots, points);
      const std::vector<Continuity> found = joints(curve_view(curve));
      REQUIRE(found.size() == 3);
      for (const Continuity& joint : found) {
        CHECK(joint.parametric == 2);
        CHECK(joint.geometric == 2);
      }
    }
  }
}

TEST_CASE("the seam of a closed curve is a joint as any other") {
  const BSplineCurve curve =
      BSplineCurve::make(KnotVector::uniform(3, 6, Topology::closed, 0, 6).value(), scattered(6)).value();
  const std::vector<Continuity> found = joints(curve_view(curve));
  REQUIRE(found.size() == 6);
  CHECK(found[0].t == curve_view(curve).start);
  for (const Continuity& joint : found) CHECK(joint.parametric == 2);
}

/// Two cubic Bezier pieces with the speeds 3 and 4.5 at their joint, on the x-axis with the same curvature there.
std::vector<Eigen::Vector3d> two_speeds() {
  return {{-3, -2.6, 0}, {-2, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {3, -2.25, 0}, {3.4, -4, 0}};
}

TEST_CASE("a joint may be G^2 and yet only C^0; with the knot in another place the same shape is C^2") {
  const BSplineCurve uneven = spline(3, Topology::open, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, two_speeds());
  const Continuity torn = continuity_at(curve_view(uneven), 1);
  CHECK(torn.parametric == 0);
  CHECK(torn.geometric == 2);
  CHECK(torn.velocity_gap == doctest::Approx(1.5));

  const BSplineCurve even = spline(3, Topology::open, {0, 0, 0, 0, 0.8, 0.8, 0.8, 2, 2, 2, 2}, two_speeds());
  const Continuity whole = continuity_at(curve_view(even), 0.8);
  CHECK(whole.parametric == 2);
  CHECK(whole.geometric == 2);
}

TEST_CASE("G^1 is not G^2, a corner is G^0, a cusp has no direction") {
  std::vector<Eigen::Vector3d> points = two_speeds();
  points[5] = {3, -1, 0};
  const auto knots = [] { return std::vector<double>{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}; };
  CHECK(continuity_at(curve_view(spline(3, Topology::open, knots(), points)), 1).geometric == 1);
  points[4] = {1.5, 0.01, 0};
  CHECK(continuity_at(curve_view(spline(3, Topology::open, knots(), points)), 1).geometric == 0);
  points[4] = points[2] = points[3];
  const Continuity cusp = continuity_at(curve_view(spline(3, Topology::open, knots(), points)), 1);
  CHECK(cusp.parametric == 1);  // both velocities are 0
  CHECK(cusp.geometric == 0);
}

TEST_CASE("a difference that one can see is not taken for rounding") {
  std::vector<Eigen::Vector3d> points = two_speeds();
  points[4].x() = 1.0 + 1e-6;  // the other side has 1
  const BSplineCurve curve = spline(3, Topology::open, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, points);
  CHECK(continuity_at(curve_view(curve), 1).parametric == 0);
}

}  // namespace
}  // namespace knotwork::continuity_test
