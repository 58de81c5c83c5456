#pragma once

#include <Eigen/Geometry>

#include "knotwork/scene/motion.h"

namespace knotwork::scene {

/// A local patch or local curve as a hand has it: where the model puts its centre, its own axes there, and what moves it
/// away.
struct LocalFrame {
  Eigen::Vector3d centre;  ///< on the model, model units
  Eigen::Matrix3d axes;    ///< F: orthonormal and right-handed, z the normal
  PatchEdit edit;
  PatchMotion motion;
};

/// M as PatchEdit says, with the motion. Unmoved it is a translation exactly, so that an unmoved surface or curve is the
/// model itself.
Eigen::Affine3d local_map(const LocalFrame& local);
/// M (0,0,0): where the handle is.
Eigen::Vector3d local_origin(const LocalFrame& local);
/// The axes, turned by the edit.
Eigen::Matrix3d turned_axes(const LocalFrame& local);

}  // namespace knotwork::scene
