#pragma once

#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// Unit normal N = S_u x S_v / |S_u x S_v|, oriented by the parameterisation. Where the cross product vanishes
/// (below 1e-12 |S_u||S_v|), the limit as u or v grows, given by the second partials, is used; where that vanishes too,
/// the second partials' own cross products; and where these do, the result is the unit z-vector. Never NaN for a finite
/// jet; always of unit length.
Eigen::Vector3d unit_normal(const SurfaceJet& jet);

/// Gaussian and mean curvature, principal curvatures k_max >= k_min. Source: THEORY 2.9. At a degenerate point
/// (no tangent plane) all are 0 and `regular` is false.
struct SurfaceCurvature {
  double gaussian = 0, mean = 0, k_max = 0, k_min = 0;
  bool regular = false;
};
SurfaceCurvature curvature(const SurfaceJet& jet);

/// The first fundamental form E du^2 + 2F du dv + G dv^2, the square of a length on the surface, E = S_u.S_u,
/// F = S_u.S_v, G = S_v.S_v; and the second, e du^2 + 2f du dv + g dv^2, twice the height above the tangent plane,
/// e = N.S_uu, f = N.S_uv, g = N.S_vv with N = unit_normal(jet), hence with its stand-ins at degenerate points.
/// Partials between 1e-150 and 1e150, or 0. Source: THEORY 2.9.
struct FundamentalForms {
  double E, F, G;
  double e, f, g;
};
FundamentalForms fundamental_forms(const SurfaceJet& jet);

/// The unit tangents along which the surface bends most and least: k_max belongs to `max`, k_min to `min`, which is N
/// x max. They are orthogonal, and their sign means nothing. At an umbilic, where all directions bend alike (k_max and
/// k_min differ by less than 1e-12 of the terms they are made of), `max` is along S_u. At a degenerate point both are
/// stand-ins across unit_normal(jet), `max` as near to S_u as can be, and `regular` is false.
struct PrincipalDirections {
  Eigen::Vector3d max, min;
  bool regular = false;
};
PrincipalDirections principal_directions(const SurfaceJet& jet);

}  // namespace knotwork
