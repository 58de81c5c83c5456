// Cut into the chapter "In code".
#include <numbers>

#include <doctest/doctest.h>

#include "knotwork/surface/blending_surface.h"

namespace knotwork::in_code_example {

TEST_CASE("example: a blending torus with one patch lifted stands where it should") {
  using std::numbers::pi;
  // [torus]
  const ModelSurface torus = torus_surface(1, 0.45, 0.45);  // radii of wheel and tube
  const KnotVector u = KnotVector::uniform(1, 6, Topology::closed, 0, 2 * pi).value();
  const KnotVector v = KnotVector::uniform(1, 4, Topology::closed, 0, 2 * pi).value();
  const BlendingFunction blending = BlendingFunction::make(BlendingKind::polynomial2).value();
  BlendingSurface surface =
      BlendingSurface::make(torus, u, v, blending, BlendingSurface::unmoved_locals(torus, u, v)).value();

  surface.set_local(2, 1, Eigen::Translation3d(0, 0, 0.5) * surface.local(2, 1));
  const SurfaceJet at = surface.evaluate(2.0, 1.5);  // the point, S_u, S_v and the second derivatives
  // [/torus]

  // At its own knots the patch decides alone; far from it the torus is as it was.
  const double own_u = u[3], own_v = v[2];
  CHECK((surface.evaluate(own_u, own_v).s - evaluate(torus, own_u, own_v).s - Eigen::Vector3d(0, 0, 0.5)).norm() <
        1e-13);
  CHECK((surface.evaluate(5.5, 5).s - evaluate(torus, 5.5, 5).s).norm() < 1e-13);
  const double h = 1e-5;
  const Eigen::Vector3d quotient = (surface.evaluate(2 + h, 1.5).s - surface.evaluate(2 - h, 1.5).s) / (2 * h);
  CHECK((at.su - quotient).norm() < 1e-8);
}

}  // namespace knotwork::in_code_example
