#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace knotwork {

/// The intermediate points of a construction by repeated combination (de Casteljau, de Boor), for drawing it: row 0 are
/// the p+1 points it starts from, row k the p+1-k points after k rounds, row p the one point of the curve.
using PointTriangle = std::vector<std::vector<Eigen::Vector3d>>;

/// Rounds of row[k+1][j] = (1 - share(k, j)) row[k][j] + share(k, j) row[k][j+1] until one point is left.
template <class Share>
PointTriangle point_triangle(std::vector<Eigen::Vector3d> points, const Share& share) {
  PointTriangle triangle{std::move(points)};
  for (std::size_t k = 0; triangle[k].size() > 1; ++k) {
    const std::vector<Eigen::Vector3d>& row = triangle[k];
    std::vector<Eigen::Vector3d> next(row.size() - 1);
    for (std::size_t j = 0; j < next.size(); ++j) {
      const double w = share(static_cast<int>(k), static_cast<int>(j));
      next[j] = (1 - w) * row[j] + w * row[j + 1];
    }
    triangle.push_back(std::move(next));
  }
  return triangle;
}

}  // namespace knotwork
