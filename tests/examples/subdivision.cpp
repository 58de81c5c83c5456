// Cut into the chapter on subdivision.
#include "knotwork/curve/lane_riesenfeld.h"

#include <vector>

#include <doctest/doctest.h>

namespace knotwork::subdivision_example {
namespace {

// [level]
std::vector<Eigen::Vector3d> one_level(std::vector<Eigen::Vector3d> points, int degree) {
  points = split_points(points);
  for (int pass = 0; pass < degree; ++pass) points = averaged_points(points, Topology::closed);
  return points;
}
// [/level]

}  // namespace

TEST_CASE("example: a level by hand is a level of the library") {
  const std::vector<Eigen::Vector3d> points{{5, 2, 8}, {2, 9, 2}, {2, 3, 4}, {3, 4, 5},
                                            {3, 6, 0}, {1, 4, 0}, {5, 8, 3}};
  for (int degree = 1; degree <= 5; ++degree) {
    const std::vector<Eigen::Vector3d> expected = subdivide({degree, Topology::closed}, points, 1).value();
    CHECK((one_level(points, degree) == expected));
  }
}

}  // namespace knotwork::subdivision_example
