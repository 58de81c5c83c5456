#include "knotwork/curve/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "knotwork/curve/interval_minimum.h"
#include "knotwork/curve/point_check.h"
#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

/// Values of c closer to each other than this, relative to the size of the points, are the same.
constexpr double same_point = 1e-14;

/// Half the square of the distance to a point.
struct SquaredDistance {
  const CurveView& curve;
  const Eigen::Vector3d& point;

  static ScalarJet at(const void* self, double t) {
    const SquaredDistance& d = *static_cast<const SquaredDistance*>(self);
    std::array<Eigen::Vector3d, 3> c;
    d.curve.evaluate(t, c);
    const Eigen::Vector3d offset = c[0] - d.point;
    return {offset.squaredNorm() / 2, offset.dot(c[1]), c[1].squaredNorm() + offset.dot(c[2])};
  }
};

/// A coordinate, or what it is below 0.
struct SignedCoordinate {
  const CurveView& curve;
  int axis;
  double sign;

  static ScalarJet at(const void* self, double t) {
    const SignedCoordinate& x = *static_cast<const SignedCoordinate*>(self);
    std::array<Eigen::Vector3d, 3> c;
    x.curve.evaluate(t, c);
    return {x.sign * c[0][x.axis], x.sign * c[1][x.axis], x.sign * c[2][x.axis]};
  }
};

/// The largest coordinate at the ends of the pieces and half-way between.
double size_of(const CurveView& curve, const std::vector<double>& ends) {
  double size = curve(ends.front()).cwiseAbs().maxCoeff();
  for (std::size_t k = 1; k < ends.size(); ++k) {
    for (const double t : {(ends[k - 1] + ends[k]) / 2, ends[k]}) size = std::max(size, curve(t).cwiseAbs().maxCoeff());
  }
  return size;
}

}  // namespace

Result<ClosestPoint> closest_point(const CurveView& curve, const Eigen::Vector3d& point) {
  if (Status status = check_distant_point(point); !status) return status.error();
  const std::vector<double> ends = piece_ends(curve.start, curve.end, curve.breaks);
  const double same = same_point * std::max(size_of(curve, ends), point.cwiseAbs().maxCoeff());
  const SquaredDistance distance{curve, point};
  // Distances d and d + same: d^2/2 differs by same d + same^2/2.
  const IntervalMinimum nearest =
      interval_minimum({&distance, SquaredDistance::at}, ends, curve.detail, same * same / 2, same * std::sqrt(2.0));
  const Eigen::Vector3d there = curve(nearest.t);
  return ClosestPoint{nearest.t, there, vector_length(there - point)};
}

Eigen::AlignedBox3d bounding_box(const CurveView& curve) {
  const std::vector<double> ends = piece_ends(curve.start, curve.end, curve.breaks);
  const double same = same_point * size_of(curve, ends);
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const SignedCoordinate coordinate{curve, axis, sign};
      const IntervalMinimum least = interval_minimum({&coordinate, SignedCoordinate::at}, ends, curve.detail, same, 0);
      (sign > 0 ? box.min() : box.max())[axis] = sign * least.value;
    }
  }
  return box;
}

}  // namespace knotwork
