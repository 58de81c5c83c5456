// Cut into the chapter on blending splines.
#include "knotwork/curve/blending_curve.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <doctest/doctest.h>

namespace knotwork::blending_curve_example {

TEST_CASE("example: where a local curve is turned, the point stays and the tangent turns with it") {
  using std::numbers::pi;
  // [turn]
  // The model with its derivatives, each of which is a quarter turn ahead of the one before.
  const ModelCurve circle(0, 2 * pi, Topology::closed, 3, [](double t, std::span<Eigen::Vector3d> out) {
    for (Eigen::Vector3d& derivative : out) {
      derivative = Eigen::Vector3d(std::cos(t), std::sin(t), 0);
      t += pi / 2;
    }
  });
  const KnotVector knots = KnotVector::uniform(1, 6, Topology::closed, 0, 2 * pi).value();
  const BlendingFunction blending = BlendingFunction::make(BlendingKind::polynomial2).value();
  BlendingCurve curve =
      BlendingCurve::make(circle, knots, blending, {}, BlendingCurve::unmoved_locals(circle, knots)).value();

  // Turn local curve 1 about its own origin: the matrix goes behind the map.
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d::UnitZ());
  curve.set_local(1, curve.local(1) * turn);

  std::array<Eigen::Vector3d, 2> at;  // the point and the first derivative
  curve.evaluate(curve.centre(1), at);
  // [/turn]
  std::array<Eigen::Vector3d, 2> model;
  circle.evaluate(curve.centre(1), model);
  CHECK((at[0] - model[0]).norm() < 1e-13);
  CHECK((at[1] - turn * model[1]).norm() < 1e-13);
}

}  // namespace knotwork::blending_curve_example
