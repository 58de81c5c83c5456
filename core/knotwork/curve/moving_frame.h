#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// A right-handed orthonormal frame at a point of a curve: binormal = tangent x normal.
struct MovingFrame {
  Eigen::Vector3d point, tangent, normal, binormal;
};

/// The turn about the axis, in (-pi, pi] radians and right-handed, that takes `from` to `to`, both across it.
double turn_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

struct MovingFrames {
  std::vector<MovingFrame> frames;
  /// Closed curves: the turn about the first tangent, in radians, that takes the first normal to the normal that has
  /// been carried once round. 0 for open ones.
  double mismatch = 0;
};

struct MovingFrameOptions {
  /// The first normal is its part across the first tangent, or a coordinate axis' as unit_across() says.
  Eigen::Vector3d first_normal = Eigen::Vector3d::Zero();
  /// Steps of the method from one parameter to the next.
  int steps = 1;
  /// Closed curves: turn the frames about their tangents, each by its share of the mismatch by length of the way, so
  /// that the frame meets itself. It is no longer free of rotation then, but turns evenly.
  bool spread_mismatch = false;
};

/// The rotation-minimising frames at t[0] < t[1] < .., in the domain (closed: less than one period): the first one
/// carried along so that it never turns about the tangent, N' parallel to T. Open curves: from t[0] on. Frenet's frame
/// turns by the torsion, and jumps at inflections; this one does neither.
///
/// Double reflection: a step of length h turns the frame wrong by O(h^5), a way of n steps by O(n^-4). Orthonormal to
/// 1e-14. At a corner (a break where the tangent jumps) the frame takes the shortest turn from tangent to tangent; at a
/// cusp, where the tangent reverses, the normal goes on. Tangents as unit_tangent() of curve_measures.h.
/// Error path: `t[i]`, not finite, not in the domain, or not behind t[i-1]; `t` when the last is a period behind the
/// first; `steps` below 1; `firstNormal` when not finite.
/// Source: Wang, Juettler, Zheng, Liu, Computation of rotation minimizing frames, ACM TOG 27(1), 2008.
Result<MovingFrames> rotation_minimising_frames(const CurveView& curve, std::span<const double> t,
                                                const MovingFrameOptions& options = {});

}  // namespace knotwork
