#pragma once

#include <Eigen/Core>

namespace knotwork {

/// A surface point and its partial derivatives to order 2.
struct SurfaceJet {
  Eigen::Vector3d s = Eigen::Vector3d::Zero();
  Eigen::Vector3d su = Eigen::Vector3d::Zero(), sv = Eigen::Vector3d::Zero();
  Eigen::Vector3d suu = Eigen::Vector3d::Zero(), suv = Eigen::Vector3d::Zero(), svv = Eigen::Vector3d::Zero();
};

}  // namespace knotwork
