#include <cmath>
#include <cstdio>
#include <numbers>

#include "knotwork/surface/blending_surface.h"

// A torus of 4 x 4 local patches, one of them lifted: the surface follows there and nowhere else.
int main() {
  using namespace knotwork;
  const ModelSurface torus = torus_surface();
  const auto knots = KnotVector::uniform(1, 4, Topology::closed, 0.0, 2 * std::numbers::pi);
  const auto blending = BlendingFunction::make(BlendingKind::polynomial2);
  if (!knots || !blending) return 1;

  auto surface = BlendingSurface::make(torus, knots.value(), knots.value(), blending.value(),
                                       BlendingSurface::unmoved_locals(torus, knots.value(), knots.value()));
  if (!surface) return 1;
  BlendingSurface& held = surface.value();

  const Eigen::Vector2d centre = held.centre(1, 2);
  const Eigen::Vector2d elsewhere = held.centre(3, 0);
  const Eigen::Vector3d before = held.evaluate(centre.x(), centre.y()).s;
  const Eigen::Vector3d still = held.evaluate(elsewhere.x(), elsewhere.y()).s;
  const Eigen::Vector3d lift(0, 0, 0.5);
  held.set_local(1, 2, Eigen::Translation3d(lift) * held.local(1, 2));
  const Eigen::Vector3d after = held.evaluate(centre.x(), centre.y()).s;

  std::printf("lifted by %g %g %g\n", after.x() - before.x(), after.y() - before.y(), after.z() - before.z());
  const bool followed = (after - before - lift).norm() < 1e-12;
  const bool stayed = (held.evaluate(elsewhere.x(), elsewhere.y()).s - still).norm() == 0;
  return followed && stayed ? 0 : 1;
}
