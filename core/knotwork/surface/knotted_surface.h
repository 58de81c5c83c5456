#pragma once

#include <span>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// A surface over the domain of two knot vectors, whose knots are the lines that are drawn on it, as sampling and
/// picking see it: a reference and the functions that evaluate it. It owns nothing.
struct KnottedSurface {
  const void* surface;
  const KnotVector *knots_u, *knots_v;
  SurfaceJet (*point)(const void* surface, double u, double v);
  /// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]).
  void (*grid)(const void* surface, std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out);

  SurfaceJet evaluate(double u, double v) const { return point(surface, u, v); }
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out) const {
    grid(surface, u, v, out);
  }
};

/// Of any surface with knots_u(), knots_v(), evaluate(u, v) and evaluate_grid(u, v, out).
template <class Surface>
KnottedSurface knotted_surface(const Surface& surface) {
  const auto point = [](const void* self, double u, double v) {
    return static_cast<const Surface*>(self)->evaluate(u, v);
  };
  const auto grid = [](const void* self, std::span<const double> u, std::span<const double> v,
                       std::span<SurfaceJet> out) { static_cast<const Surface*>(self)->evaluate_grid(u, v, out); };
  return {&surface, &surface.knots_u(), &surface.knots_v(), point, grid};
}

}  // namespace knotwork
