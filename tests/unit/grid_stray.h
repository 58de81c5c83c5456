#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/mesh/surface_sampling.h"

namespace knotwork::test {

/// The distance of x from the segment from a to b.
inline double off_segment(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp((x - a).dot(way) / square, 0.0, 1.0) : 0.0;
  return (x - a - share * way).norm();
}

using Triangle = std::array<Eigen::Vector3d, 3>;

/// The distance of x from the plane of a triangle; of one without a plane, as at a pole, from that of the triangle beside
/// it, which covers the place then; where neither has one, from the first's edges.
inline double off_triangle(const Eigen::Vector3d& x, const Triangle& triangle, const Triangle& beside) {
  for (const Triangle& corners : {triangle, beside}) {
    const auto& [a, b, c] = corners;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double size = normal.norm(), edge = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
    if (size > 1e-9 * edge * edge) return std::abs((x - a).dot(normal)) / size;
  }
  const auto& [a, b, c] = triangle;
  return std::min({off_segment(x, a, b), off_segment(x, a, c), off_segment(x, b, c)});
}

/// How far a surface strays from the grid's triangles, looked at inside each of them; and from their edges along the
/// grid's own lines, of which edges and drawn lines are made. `stray` is told each such distance with its place.
template <class Surface, class Stray>
void each_stray(const Surface& surface, const SampleGrid& grid, Stray stray) {
  constexpr std::array<std::array<double, 2>, 6> inside{
      {{0.5, 0.5}, {0.6, 0.3}, {0.7, 0.2}, {0.3, 0.6}, {0.2, 0.7}, {0.4, 0.2}}};
  const auto at = [&](double u, double v) { return surface.evaluate(u, v).s; };
  for (std::size_t a = 0; a + 1 < grid.u.size(); ++a) {
    for (std::size_t b = 0; b + 1 < grid.v.size(); ++b) {
      const double u0 = grid.u[a], u1 = grid.u[a + 1], v0 = grid.v[b], v1 = grid.v[b + 1];
      const Eigen::Vector3d v00 = at(u0, v0), v10 = at(u1, v0), v01 = at(u0, v1), v11 = at(u1, v1);
      const Triangle lower{v00, v10, v11}, upper{v00, v11, v01};
      for (const auto& [x, y] : inside) {
        const Eigen::Vector3d place = at(std::lerp(u0, u1, x), std::lerp(v0, v1, y));
        if (x >= y) stray(off_triangle(place, lower, upper), place);
        if (x <= y) stray(off_triangle(place, upper, lower), place);
      }
      const Eigen::Vector3d along_u = at(std::lerp(u0, u1, 0.5), v0), along_v = at(u0, std::lerp(v0, v1, 0.5));
      stray(off_segment(along_u, v00, v10), along_u);
      stray(off_segment(along_v, v00, v01), along_v);
    }
  }
}

template <class Surface>
double grid_stray(const Surface& surface, const SampleGrid& grid) {
  double most = 0;
  each_stray(surface, grid, [&most](double distance, const Eigen::Vector3d&) { most = std::max(most, distance); });
  return most;
}

/// The diagonal of the box about the grid's vertices.
template <class Surface>
double grid_size(const Surface& surface, const SampleGrid& grid) {
  Eigen::AlignedBox3d box;
  for (const double u : grid.u)
    for (const double v : grid.v) box.extend(surface.evaluate(u, v).s);
  return box.diagonal().norm();
}

}  // namespace knotwork::test
