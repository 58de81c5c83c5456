#include "knotwork/surface/parametric_surface.h"

#include "knotwork/surface/blending_surface.h"

namespace knotwork {

SurfaceView surface_view(const ModelSurface& surface) {
  const auto function = [](const void* self, double u, double v) {
    return evaluate(*static_cast<const ModelSurface*>(self), u, v);
  };
  return {&surface, function, domain(surface)};
}

SurfaceView surface_view(const CatalogueSurface& surface) {
  const auto function = [](const void* self, double u, double v) {
    return evaluate(*static_cast<const CatalogueSurface*>(self), u, v);
  };
  return {&surface, function, domain(surface)};
}

SurfaceView surface_view(const BlendingSurface& surface) {
  const KnotVector &u = surface.knots_u(), &v = surface.knots_v();
  SurfaceDomain where{{u.start(), u.end()}, {v.start(), v.end()}, closure_of(u.topology()), closure_of(v.topology())};
  if (const auto& twist = surface.twist_u()) {
    where.closure_u = Closure::twisted;
    where.reflection_u = twist->reflection;
  }
  if (const auto& twist = surface.twist_v()) {
    where.closure_v = Closure::twisted;
    where.reflection_v = twist->reflection;
  }
  return surface_view<BlendingSurface>(surface, where, u.knots(), v.knots(), 8);
}

}  // namespace knotwork
