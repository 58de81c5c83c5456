#pragma once

#include <Eigen/Core>

namespace knotwork::scene {

/// A place of a drawn curve: one end of a straight stretch of it.
struct CurveSample {
  double t;
  Eigen::Vector3d point;  ///< c(t), model units
};

}  // namespace knotwork::scene
