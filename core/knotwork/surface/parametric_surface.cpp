#include "knotwork/surface/parametric_surface.h"

#include "knotwork/surface/blending_surface.h"

namespace knotwork {

SurfaceView surface_view(const ModelSurface& surface) {
  const auto function = [](const void* self, double u, double v) {
    return evaluate(*static_cast<const ModelSurface*>(self), u, v);
  };
  return {&surface, function, domain(surface)};
}

SurfaceView surface_view(const BlendingSurface& surface) {
  const KnotVector &u = surface.knots_u(), &v = surface.knots_v();
  const SurfaceDomain where{{u.start(), u.end()}, {v.start(), v.end()}, u.topology(), v.topology()};
  return surface_view<BlendingSurface>(surface, where, u.knots(), v.knots(), 8);
}

}  // namespace knotwork
