#include "knotwork/curve/closest_point.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "knotwork/curve/bezier_curve.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::closest_point_test {
using namespace test;
namespace {

BezierCurve bezier(std::vector<Eigen::Vector3d> points) { return BezierCurve::make(std::move(points)).value(); }

ClosestPoint nearest(const CurveView& curve, const Eigen::Vector3d& point) {
  return closest_point(curve, point).value();
}

}  // namespace

TEST_CASE("the closest point of a circle, a line, a parabola") {
  const WaveCurve ring = circle(2);
  for (int k = 0; k < 30; ++k) {
    const double t = 0.2 * k + 0.05, r = 0.3 * k + 0.01;
    const ClosestPoint found = nearest(ring.view(), {r * std::cos(t), r * std::sin(t), 1.5});
    CHECK(close(found.t, t, 1e-14, round));
    CHECK(close(found.distance, std::hypot(r - 2, 1.5), 1e-14));
    CHECK(close(found.point, {2 * std::cos(t), 2 * std::sin(t), 0}, 1e-13));
  }
  const BezierCurve line = bezier({{1, 0, 0}, {3, 0, 0}});
  CHECK(close(nearest(curve_view(line), {1.5, 7, 0}).t, 0.25, 1e-15));
  CHECK(nearest(curve_view(line), {-4, 7, 0}).t == 0);
  CHECK(nearest(curve_view(line), {4, 7, 0}).t == 1);
  CHECK(nearest(curve_view(line), {1, 0, 0}).distance == 0);
  // (t, t^2) on [-1,1] from (0, h): the vertex up to h = 1/2, then t^2 = h - 1/2, of two equal ones the first.
  const BezierCurve parabola = BezierCurve::make({{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}, -1, 1).value();
  CHECK(close(nearest(curve_view(parabola), {0, 0.3, 0}).t, 0, 1e-14, 1));
  CHECK(close(nearest(curve_view(parabola), {0, 0.75, 0}).t, -0.5, 1e-14));
  // h = 1/2 is the centre of curvature: the minimum is flat, and t known to the fourth root of rounding only.
  const ClosestPoint flat = nearest(curve_view(parabola), {0, 0.5, 0});
  CHECK(close(flat.t, 0, 1e-3, 1));
  CHECK(close(flat.distance, 0.5, 1e-14));
}

TEST_CASE("of equally near points the first counts, and a closed curve answers with its start") {
  const WaveCurve ring = circle(2);
  CHECK(nearest(ring.view(), {5, 0, 0}).t == 0);
  CHECK(nearest(ring.view(), {0, 0, 3}).t == 0);  // all of it
  const WaveCurve ellipse = helix(3, 1, 0, 1);
  CHECK(close(nearest(ellipse.view(), {0, 0, 1}).t, round / 4, 1e-14));
  const BSplineCurve square = BSplineCurve::make(KnotVector::uniform(1, 4, Topology::closed, 0, 4).value(),
                                                 {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}})
                                  .value();
  const double first = nearest(curve_view(square), {0, 0, 0}).t;
  CHECK(close(nearest(curve_view(square), {0, 0, 0}).distance, 1, 1e-15));
  CHECK(close(first, 0.5, 1e-14));
  CHECK(nearest(curve_view(square), square.point(0) * 3).t == 0);
  CHECK(nearest(curve_view(square), square(2) * 3).t == 2);
  // The seam of a closed spline.
  CHECK(nearest(curve_view(square), square(0)).t == 0);
  // A stretch of an arc about the point: its start.
  const BSplineCurve tie = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 2, 3, 3}).value(),
                                              {{0, 5, 0}, {1, 0, 0}, {1, 0, 0}, {0, -5, 0}})
                               .value();
  CHECK(close(nearest(curve_view(tie), {9, 0, 0}).t, 1, 1e-14));
}

TEST_CASE("a point of the curve is its own closest point") {
  std::mt19937 random(41);
  for (int degree = 1; degree <= 9; ++degree) {
    const BSplineCurve spline = random_spline(degree, degree + 6, Topology::open, random);
    for (int k = 0; k <= 20; ++k) {
      const double t = 6.0 * k / 20;
      const ClosestPoint found = nearest(curve_view(spline), spline(t));
      CHECK(found.distance <= 1e-13);
      CHECK(close(found.t, t, 1e-11, 6));
    }
  }
}

TEST_CASE("corners, cusps and pauses are found") {
  const BSplineCurve corner = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 3, 3}).value(),
                                                 {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}})
                                  .value();
  CHECK(nearest(curve_view(corner), {1, 5, 0}).t == 1);
  // A spike that is thinner than any sampling: degree 1 pieces know their ends.
  const BSplineCurve spike = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 1.0001, 2, 2}).value(),
                                                {{0, 0, 0}, {1, 9, 0}, {1, 0, 0}, {2, 0, 0}})
                                 .value();
  CHECK(close(nearest(curve_view(spike), {1, 10, 0}).t, 1, 1e-15));
  // (t^2, t^3) on [-1,1]: the cusp is nearest to all points on its far side.
  const BezierCurve cusp =
      BezierCurve::make({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}}, -1, 1).value();
  const ClosestPoint tip = nearest(curve_view(cusp), {-1, 0, 0});
  CHECK(close(tip.t, 0, 1e-7, 1));
  CHECK(close(tip.distance, 1, 1e-14));
  const Eigen::Vector3d here(1, 2, 3);
  const ClosestPoint point = nearest(curve_view(bezier({here, here, here})), {1, 2, 0});
  CHECK(point.t == 0);
  CHECK(close(point.distance, 3, 1e-15));
}

TEST_CASE("a point that is no point is refused") {
  const WaveCurve ring = circle(2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e101}) {
    CHECK(closest_point(ring.view(), {0, bad, 0}).error().path == "point");
    CHECK(closest_point(ring.view(), {bad, 0, 0}).error().path == "point");
  }
  CHECK(closest_point(ring.view(), {0, 0, 1e99}).has_value());
}

TEST_CASE("the box of a helix, an ellipse, a parabola, a point") {
  const WaveCurve coil = helix(3, 2, 0.25, 2);
  const Eigen::AlignedBox3d box = bounding_box(coil.view());
  CHECK(close(box.min(), {-3, -2, 0}, 1e-15));
  CHECK(close(box.max(), {3, 2, round / 2}, 1e-15));
  // (t, t^2 - t) on [0,1]: least -1/4.
  const Eigen::AlignedBox3d low = bounding_box(curve_view(bezier({{0, 0, 0}, {0.5, -0.5, 0}, {1, 0, 0}})));
  CHECK(close(low.min(), {0, -0.25, 0}, 1e-15));
  CHECK(close(low.max(), {1, 0, 0}, 1e-15));
  const Eigen::Vector3d here(1, 2, 3);
  const Eigen::AlignedBox3d point = bounding_box(curve_view(bezier({here, here, here})));
  CHECK(close(point.min(), here, 1e-15));
  CHECK(close(point.max(), here, 1e-15));
}

}  // namespace knotwork::closest_point_test
