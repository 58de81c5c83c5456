#pragma once

#include <vector>

#include <Eigen/Core>

namespace knotwork {

/// Four floats of a texture: x y z 0.
inline void append_texel(std::vector<float>& out, const Eigen::Vector3d& x) {
  out.insert(out.end(), {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]), 0.0F});
}

}  // namespace knotwork
