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

/// Whether distances from a point can be squared: finite coordinates up to 1e100. Error path: `point`.
inline Status check_distant_point(const Eigen::Vector3d& point) {
  for (const double coordinate : point) {
    if (!std::isfinite(coordinate) || std::abs(coordinate) > 1e100)
      return Error{"point", "A point must have finite coordinates of reasonable size."};
  }
  return success();
}

}  // namespace knotwork
