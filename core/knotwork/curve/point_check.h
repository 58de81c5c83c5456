#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include <Eigen/Core>

#include "knotwork/result.h"

namespace knotwork {

/// Whether every coordinate is a finite number. Error path: `points[i]`. Raises no floating-point exception.
inline Status check_points(std::span<const Eigen::Vector3d> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double coordinate : points[i]) {
      if (!std::isfinite(coordinate))
        return Error{"points[" + std::to_string(i) + "]", "A point must have finite coordinates."};
    }
  }
  return success();
}

}  // namespace knotwork
