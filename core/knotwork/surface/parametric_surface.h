#pragma once

#include <span>

#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

class BlendingSurface;

/// Any parametric surface S(u,v) over `domain` as the measures (area, closest point) see it: a reference to the surface
/// and a function that evaluates it, as CurveView is for curves. It owns nothing: the surface and its breaks must
/// outlive it. Finite, with coordinates below 1e100.
struct SurfaceView {
  const void* surface;
  /// Point and partials of *surface at (u,v) in the domain.
  SurfaceJet (*function)(const void* surface, double u, double v);
  SurfaceDomain domain;
  /// Sorted parameters between which the surface is smooth, as knots; repeated ones and ones outside count for nothing.
  std::span<const double> breaks_u = {}, breaks_v = {};
  /// How many intervals of each smooth cell a search looks at first, in each direction.
  int detail = 16;

  SurfaceJet evaluate(double u, double v) const { return function(surface, u, v); }
};

/// The view of a surface that has evaluate(u, v); for other surfaces the function is written out.
template <class Surface>
SurfaceView surface_view(const Surface& surface, const SurfaceDomain& domain, std::span<const double> breaks_u = {},
                         std::span<const double> breaks_v = {}, int detail = 16) {
  const auto function = [](const void* self, double u, double v) {
    return static_cast<const Surface*>(self)->evaluate(u, v);
  };
  return {&surface, function, domain, breaks_u, breaks_v, detail};
}
SurfaceView surface_view(const ModelSurface& surface);
SurfaceView surface_view(const CatalogueSurface& surface);
SurfaceView surface_view(const BlendingSurface& surface);

}  // namespace knotwork
