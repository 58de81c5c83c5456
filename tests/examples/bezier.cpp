// Cut into the chapter on Bezier curves.
#include "knotwork/curve/bezier_curve.h"

#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

namespace knotwork::bezier_example {
namespace {

// [de-casteljau]
Eigen::Vector3d de_casteljau(std::vector<Eigen::Vector3d> points, double t) {
  for (std::size_t left = points.size() - 1; left > 0; --left) {
    for (std::size_t k = 0; k < left; ++k) points[k] = (1 - t) * points[k] + t * points[k + 1];
  }
  return points.front();
}
// [/de-casteljau]

}  // namespace

TEST_CASE("example: de Casteljau's algorithm as the chapter has it gives the curve's points") {
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 3, 0}, {4.2, 3.6, 0}, {5.5, 0.4, 0}};
  const BezierCurve curve = BezierCurve::make(points).value();
  for (int k = 0; k <= 10; ++k) {
    const double t = k / 10.0;
    CHECK((de_casteljau(points, t) - curve(t)).norm() < 1e-14);
  }
}

}  // namespace knotwork::bezier_example
