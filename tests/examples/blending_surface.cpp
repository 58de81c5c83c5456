// Cut into the chapter on blending surfaces.
#include "knotwork/surface/blending_surface.h"

#include <numbers>

#include <doctest/doctest.h>

namespace knotwork::blending_surface_example {
namespace {

// [slope]
/// S_u as the product rule has it, in a cell that does not lie across a seam.
Eigen::Vector3d slope_u(const BlendingSurface& surface, double u, double v) {
  const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
  const int i = knots_u.span(u), j = knots_v.span(v);
  const BlendingValue bu = surface.blending()(translation_and_scaling(knots_u, 1, i, u));  // B, B', B'', B'''
  const BlendingValue bv = surface.blending()(translation_and_scaling(knots_v, 1, j, v));
  const double delta = 1 / (knots_u[i + 1] - knots_u[i]);
  const auto along_row = [&](int b) -> Eigen::Vector3d {
    const SurfaceJet first = surface.evaluate_local(i - 1, b, u, v), second = surface.evaluate_local(i, b, u, v);
    return (1 - bu[0]) * first.su + bu[0] * second.su + delta * bu[1] * (second.s - first.s);
  };
  return (1 - bv[0]) * along_row(j - 1) + bv[0] * along_row(j);
}
// [/slope]

}  // namespace

TEST_CASE("example: the slope as the chapter has it is the evaluator's and the difference quotient's") {
  // A torus with one patch lifted.
  const ModelSurface torus = torus_surface();
  const KnotVector knots = KnotVector::uniform(1, 4, Topology::closed, 0, 2 * std::numbers::pi).value();
  const BlendingFunction blending = BlendingFunction::make(BlendingKind::polynomial2).value();
  BlendingSurface surface =
      BlendingSurface::make(torus, knots, knots, blending, BlendingSurface::unmoved_locals(torus, knots, knots))
          .value();
  surface.set_local(1, 2, Eigen::Translation3d(0, 0, 0.5) * surface.local(1, 2));

  const double u = 1, v = 2.5, h = 1e-5;
  const Eigen::Vector3d slope = slope_u(surface, u, v);
  const Eigen::Vector3d quotient = (surface.evaluate(u + h, v).s - surface.evaluate(u - h, v).s) / (2 * h);
  CHECK((slope - surface.evaluate(u, v).su).norm() < 1e-13);
  CHECK((slope - quotient).norm() < 1e-8);
}

}  // namespace knotwork::blending_surface_example
