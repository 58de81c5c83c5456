#pragma once

#include <Eigen/Core>

namespace knotwork {

/// |v| for every finite v up to 1e308: no square overflows or underflows. (Eigen's stableNorm() does so too, but takes
/// the inverse of a denormal number, which overflows.)
inline double vector_length(const Eigen::Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? largest * Eigen::Vector3d(v / largest).norm() : 0;
}

}  // namespace knotwork
