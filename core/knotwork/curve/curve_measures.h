#pragma once

#include <span>

#include <Eigen/Core>

namespace knotwork {

/// Measures of a curve at one point, from its derivatives there: c[0] = c(t), c[1] = c'(t), .. Source: THEORY 2.9.
///
/// They depend on the curve's shape only: not on the speed of its parameter, not on where it lies; turned with it, and
/// scaled with it. Relative accuracy 1e-14 of the terms of which they are made, for derivatives of size up to 1e90.
/// Never NaN for finite derivatives. What has no value at a point is replaced as follows.
///
/// No speed (a cusp, or a parameter that pauses): |c'| below 1e-60, or |c'|^2 below 1e-26 |c||c''|, which is where
/// rounding of c leaves of c' not one digit. The tangent is its limit as t grows, along c'', or else c''', or else the
/// x-axis. Curvature and torsion, which may have no limit, are 0, and `regular` is false.
///
/// No curvature (an inflection, a straight line): the sine between c' and c'' below 1e-13. The curvature stays as it
/// is; torsion is 0. The normal is its limit as t grows, along the part of c''' across the tangent; where that vanishes
/// too, the part across the tangent of the coordinate axis that is farthest from it, the first of those equally far.

/// |c'|. Needs c'.
double speed(std::span<const Eigen::Vector3d> c);

/// |c' x c''| / |c'|^3 >= 0, 1 / length. Needs c''.
double curvature(std::span<const Eigen::Vector3d> c);

/// The curvature vector kappa N = (c'' across c') / |c'|^2, 1 / length: towards the centre of curvature, as long as the
/// curvature; 0 where there is no speed. Needs c''.
Eigen::Vector3d curvature_vector(std::span<const Eigen::Vector3d> c);

/// The curvature of a plane curve, positive where it turns left as seen from the tip of the plane's unit normal:
/// (c' x c'') . n / |c'|^3; of any other curve, that of its shadow along n were its speed kept. Needs c''.
double signed_curvature(std::span<const Eigen::Vector3d> c, const Eigen::Vector3d& plane_normal);

/// (c' x c'') . c''' / |c' x c''|^2, 1 / length: positive for a right-handed helix. Needs c'''.
double torsion(std::span<const Eigen::Vector3d> c);

/// The Frenet frame: tangent T, principal normal N, binormal B = T x N, right-handed and orthonormal to 1e-15.
struct FrenetFrame {
  Eigen::Vector3d tangent, normal, binormal;
  double speed = 0, curvature = 0, torsion = 0;
  bool regular = false;   ///< has speed: the tangent is no stand-in
  bool straight = false;  ///< has no curvature: normal and binormal are stand-ins
};
/// Needs c'', and takes c''' as 0 where it is not given. A curvature of at most `least_curvature` counts as none: with
/// 1e-12 / (size of the curve), straight lines whose c'' is nothing but rounding are straight.
FrenetFrame frenet_frame(std::span<const Eigen::Vector3d> c, double least_curvature = 0);

/// The unit tangent of the Frenet frame. Needs c'; c'' and c''' where they are given.
Eigen::Vector3d unit_tangent(std::span<const Eigen::Vector3d> c);

/// A unit vector across a unit vector: along the part of `wish` across it, or, where there is none (below 1e-13 of
/// |wish|, or of 1e-100), of the coordinate axis that is farthest from it, the first of those equally far.
Eigen::Vector3d unit_across(const Eigen::Vector3d& tangent, const Eigen::Vector3d& wish);

}  // namespace knotwork
