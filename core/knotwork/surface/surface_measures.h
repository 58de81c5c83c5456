#pragma once

#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// Unit normal N = S_u x S_v / |S_u x S_v|, oriented by the parameterisation. Where the cross product vanishes
/// (below 1e-12 |S_u||S_v|), the limit as u or v grows, given by the second partials, is used; where that vanishes too,
/// the second partials' own cross products; and where these do, the result is the unit z-vector. Never NaN for a finite jet; always of unit length.
Eigen::Vector3d unit_normal(const SurfaceJet& jet);

/// Gaussian and mean curvature, principal curvatures k_max >= k_min. Source: THEORY 2.9. At a degenerate point
/// (no tangent plane) all are 0 and `regular` is false.
struct SurfaceCurvature {
  double gaussian = 0, mean = 0, k_max = 0, k_min = 0;
  bool regular = false;
};
SurfaceCurvature curvature(const SurfaceJet& jet);

}  // namespace knotwork
