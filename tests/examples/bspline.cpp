// Cut into the chapter on B-splines.
#include "knotwork/curve/bspline_curve.h"

#include <vector>

#include <doctest/doctest.h>

namespace knotwork::bspline_example {
namespace {

// [cubic]
Eigen::Vector3d cubic(const BSplineCurve& curve, double t) {
  const KnotVector& knots = curve.knots();
  const int i = knots.span(t);
  Eigen::Matrix<double, 3, 4> c;
  for (int k = 0; k < 4; ++k) c.col(k) = curve.point(i - 3 + k);
  for (int d = 3; d > 0; --d) {
    for (int k = 0; k < d; ++k) {
      const double w = translation_and_scaling(knots, d, i - d + 1 + k, t);
      c.col(k) = (1 - w) * c.col(k) + w * c.col(k + 1);
    }
  }
  return c.col(0);
}
// [/cubic]

}  // namespace

TEST_CASE("example: the three rounds as the chapter has them give the curve's points") {
  const std::vector<Eigen::Vector3d> points{{-5, -2, 0},    {-4, 2.4, 0},  {-0.6, 3, 0}, {1.4, -1.2, 0},
                                            {3.2, -1.8, 0}, {4.6, 0.6, 0}, {5, 2.6, 0}};
  const KnotVector knots = KnotVector::make(3, Topology::open, {0, 0, 0, 0, 2, 3, 4, 5, 5, 5, 5}).value();
  const BSplineCurve curve = BSplineCurve::make(knots, points).value();
  for (int k = 0; k <= 20; ++k) {
    const double t = k / 4.0;
    CHECK((cubic(curve, t) - curve(t)).norm() < 1e-13);
  }
}

}  // namespace knotwork::bspline_example
