#pragma once

#include <vector>

#include "knotwork/later.h"
#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/surface/knotted_surface.h"

namespace knotwork {

enum class CurvatureKind : unsigned char { gaussian, mean };

/// A curvature at the vertices of a grid, for colours.
struct CurvatureField {
  std::vector<double>
      values;  ///< vertex a * rows + b for (u[a], v[b]); 0 where there is no tangent plane, at most 1e30
  /// Where a scale of colours should end: 1, 2 or 5 times a power of ten, at least what the values stay within on nineteen
  /// twentieths of the area. Not less than 0.1 over the size of the surface (its box's diagonal), or over its square of
  /// K: on a plane or a minimal surface the rest is rounding.
  double scale = 1;
};

/// K or H of curvature(). On a grid that is parted at its knots both sides have their own values there.
KNOTWORK_LAST CurvatureField curvature_field(const KnottedSurface& surface, const SampleGrid& grid, CurvatureKind kind);

/// The least number of the form 1, 2 or 5 times a power of ten that is not less than x > 0, to rounding.
double round_up_to_125(double x);

}  // namespace knotwork
