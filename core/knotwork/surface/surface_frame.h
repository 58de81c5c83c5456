#pragma once

#include <Eigen/Core>

namespace knotwork {

/// What shading needs of a surface at a point: the point, its first partials and the unit normal of unit_normal().
struct SurfaceFrame {
  Eigen::Vector3d s, su, sv, normal;
};

}  // namespace knotwork
