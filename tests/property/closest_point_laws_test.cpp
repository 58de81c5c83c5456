#include "knotwork/curve/closest_point.h"

#include <array>
#include <cmath>
#include <vector>

#include "knotwork/curve/bezier_curve.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::closest_point_laws_test {
using namespace test;
namespace {

/// The least distance to `count` points of each piece, the best of them improved by golden sections.
double brute_distance(const BSplineCurve& spline, const Eigen::Vector3d& point, int count) {
  const std::vector<double> ends = piece_ends(spline.knots().start(), spline.knots().end(), spline.knots().knots());
  const auto distance = [&](double t) { return (spline(t) - point).norm(); };
  double least = 1e300, low = 0, high = 0;
  for (std::size_t piece = 1; piece < ends.size(); ++piece) {
    const double from = ends[piece - 1], to = just_before(ends[piece]);
    for (int k = 0; k <= count; ++k) {
      const double here = distance(std::lerp(from, to, static_cast<double>(k) / count));
      if (here >= least) continue;
      least = here;
      low = std::lerp(from, to, std::max(0.0, k - 1.0) / count);
      high = std::lerp(from, to, std::min<double>(count, k + 1.0) / count);
    }
  }
  for (int k = 0; k < 60; ++k) {
    const double a = std::lerp(low, high, 0.382), b = std::lerp(low, high, 0.618);
    const double at_a = distance(a), at_b = distance(b);
    least = std::min({least, at_a, at_b});
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  return least;
}

}  // namespace

TEST_CASE("no point of thousands of random splines is nearer than the closest point") {
  std::mt19937 random(51);
  int compared = 0;
  for (int round_trip = 0; round_trip < 60; ++round_trip) {
    for (const Topology topology : {Topology::open, Topology::closed}) {
      for (int degree = 1; degree <= 9; ++degree) {
        const BSplineCurve spline = random_spline(degree, degree + 1 + round_trip % 5, topology, random);
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d point = random_point(random, 1 + 3 * k);
          const ClosestPoint found = closest_point(curve_view(spline), point).value();
          const double brute = brute_distance(spline, point, 100);
          CAPTURE(degree);
          CAPTURE(found.t);
          CHECK(found.distance <= brute + 1e-13);
          CHECK(close(found.point, spline(found.t), 0));
          CHECK(close((found.point - point).norm(), found.distance, 1e-15));
          ++compared;
          // At an inner minimum the way to the point stands across the curve.
          std::array<Eigen::Vector3d, 2> c;
          spline.evaluate(found.t, c);
          const bool inner = spline.knots().multiplicity(found.t) == 0;
          if (inner) CHECK(close((c[0] - point).dot(c[1]), 0, 1e-11, c[1].norm() * (c[0].norm() + point.norm())));
        }
      }
    }
  }
  CHECK(compared == 3240);
}

TEST_CASE("a box contains its curve and touches it at all six sides") {
  std::mt19937 random(52);
  for (int k = 0; k < 200; ++k) {
    const int degree = 1 + k % 9;
    const BSplineCurve spline =
        random_spline(degree, degree + 1 + k % 4, k % 2 == 0 ? Topology::open : Topology::closed, random);
    const Eigen::AlignedBox3d box = bounding_box(curve_view(spline));
    Eigen::AlignedBox3d sampled;
    const std::vector<double> ends = piece_ends(spline.knots().start(), spline.knots().end(), spline.knots().knots());
    for (std::size_t piece = 1; piece < ends.size(); ++piece) {
      for (int step = 0; step <= 500; ++step)
        sampled.extend(spline(std::lerp(ends[piece - 1], ends[piece], step / 500.0)));
    }
    CHECK((sampled.min() - box.min()).minCoeff() >= -1e-13);
    CHECK((box.max() - sampled.max()).minCoeff() >= -1e-13);
    CHECK((sampled.min() - box.min()).maxCoeff() <= 1e-3);
    CHECK((box.max() - sampled.max()).maxCoeff() <= 1e-3);
  }
}

TEST_CASE("the box of a cubic is that of the roots of its derivative") {
  std::mt19937 random(53);
  for (int k = 0; k < 500; ++k) {
    std::array<Eigen::Vector3d, 4> p;
    for (Eigen::Vector3d& point : p) point = random_point(random);
    const BezierCurve cubic = BezierCurve::make({p.begin(), p.end()}).value();
    const Eigen::AlignedBox3d box = bounding_box(curve_view(cubic));
    Eigen::AlignedBox3d expected;
    expected.extend(p[0]), expected.extend(p[3]);
    for (int axis = 0; axis < 3; ++axis) {
      const double a = p[1][axis] - p[0][axis], b = p[2][axis] - p[1][axis], c = p[3][axis] - p[2][axis];
      // a (1-t)^2 + 2 b t (1-t) + c t^2 = 0.
      const double root = b * b - a * c;
      if (root < 0) continue;
      for (const double q : {a - b + std::sqrt(root), a - b - std::sqrt(root)}) {
        const double t = q / (a - 2 * b + c);
        if (t > 0 && t < 1) {
          const double x = cubic(t)[axis];
          expected.min()[axis] = std::min(expected.min()[axis], x);
          expected.max()[axis] = std::max(expected.max()[axis], x);
        }
      }
    }
    CHECK(close(box.min(), expected.min(), 1e-13));
    CHECK(close(box.max(), expected.max(), 1e-13));
  }
}

}  // namespace knotwork::closest_point_laws_test
