#pragma once

#include <Eigen/Geometry>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// A point of a curve, seen from another point.
struct ClosestPoint {
  double t;
  Eigen::Vector3d point;
  double distance;
};

/// The point of the curve nearest to `point`: over the whole curve, its corners and ends too. Of several equally near
/// (within 1e-14 of the size of points and curve) the one with the smallest parameter, so that a closed curve answers
/// with its start and not its end. Where a stretch of the curve is equally near, the start of the stretch, within the
/// accuracy at which it is seen.
///
/// The distance is accurate to 1e-14 of that size; the parameter to where rounding of c.c' leaves its sign, 1e-15 of
/// the domain unless the point is near a centre of curvature. All minima are looked at, as interval_minimum.h says.
/// Error path: `point`, when not finite or beyond 1e100.
Result<ClosestPoint> closest_point(const CurveView& curve, const Eigen::Vector3d& point);

/// The smallest box along the axes that contains the curve, to 1e-13 of the size of its points; never smaller than the
/// curve by more. Empty in a direction across which the curve is flat.
Eigen::AlignedBox3d bounding_box(const CurveView& curve);

}  // namespace knotwork
