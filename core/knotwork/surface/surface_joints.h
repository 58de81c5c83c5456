#pragma once

#include <vector>

#include "knotwork/later.h"
#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/knotted_surface.h"

namespace knotwork {

/// A line along which pieces of a surface meet, and what is left of smoothness there: the largest differences between
/// its sides.
struct SurfaceJoint {
  bool along_v = true;  ///< a line u = parameter; else v = parameter
  double parameter = 0;
  double gap = 0;   ///< between points, model units
  double kink = 0;  ///< between unit normals, radians in [0, pi]: pi where the surface is folded back
  double bend = 0;  ///< between normal curvatures in the direction across the line, 1 / model units
};

/// Which seams count. A twisted one meets itself reflected, so that points of the same parameters are not neighbours.
struct JointSeams {
  bool u = true, v = true;
};

/// All but twisted ones.
inline JointSeams untwisted_seams(const BlendingSurface& surface) {
  return {!surface.twist_u().has_value(), !surface.twist_v().has_value()};
}

/// Every inner knot line, u = const before v = const, each by its parameter; behind those of a closed direction its seam,
/// whose parameter is the domain's start. Looked at in `places` >= 1 places in each knot interval of the other direction,
/// evenly spread and none on a knot. Sides are told apart as in continuity_at(): by the last parameter before the knot.
/// Rounding leaves of a smooth surface about 1e-13 of its size in `gap`, 1e-8 in `kink`, and of curvatures as much as
/// their own rounding.
KNOTWORK_LAST std::vector<SurfaceJoint> surface_joints(const KnottedSurface& surface, int places,
                                                       JointSeams seams = {});

/// The joint where one difference, as &SurfaceJoint::kink, is largest; null of none.
KNOTWORK_LAST const SurfaceJoint* worst_joint(const std::vector<SurfaceJoint>& joints,
                                              double SurfaceJoint::*difference);

}  // namespace knotwork
