#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/surface/surface_jet.h"

namespace knotwork::test {

/// The natural magnitudes of K and H at a point, for the comparison rule of oracle.h.
///
/// With e = N.S_uu and so on, K = (eg - f^2)/(EG - F^2) and H = (eG - 2fF + gE)/(2(EG - F^2)). Each second partial is
/// known relative to its length, not to its normal part, and N loses a factor c = |S_u||S_v|/|S_u x S_v| where the
/// partials are nearly parallel. To first order in the rounding the error of K is therefore relative to
/// c (|S_uu||S_vv| + |S_uv|^2)/|S_u x S_v|^2, of H to c (|S_uu|G + 2|S_uv||F| + |S_vv|E)/(2|S_u x S_v|^2); k_max and
/// k_min follow H.
/// `cancelled` is the length of terms that cancel in the second partials, where a flat piece has them at 0.
struct CurvatureScale {
  double gaussian, mean;
};
inline CurvatureScale curvature_scale(const SurfaceJet& jet, double cancelled = 0) {
  const double a = std::max(jet.suu.norm(), cancelled), b = std::max(jet.suv.norm(), cancelled);
  const double c = std::max(jet.svv.norm(), cancelled);
  const double e = jet.su.squaredNorm(), f = std::abs(jet.su.dot(jet.sv)), g = jet.sv.squaredNorm();
  const double area2 = jet.su.cross(jet.sv).squaredNorm(), parallel = std::sqrt(e * g / area2);
  return {parallel * (a * c + b * b) / area2, parallel * (a * g + 2 * b * f + c * e) / (2 * area2)};
}

}  // namespace knotwork::test
