#include "knotwork/curve/curve_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

/// Shorter first derivatives count as zero; keeps their inverse cubes finite.
constexpr double least_speed = 1e-60;
/// Shorter other vectors have no direction.
constexpr double least_vector = 1e-100;
/// The square of the relative size at which rounding has eaten a first derivative.
constexpr double pause = 1e-26;
/// The sine below which vectors are parallel.
constexpr double parallel = 1e-13;

Eigen::Vector3d derivative_or_zero(std::span<const Eigen::Vector3d> c, std::size_t k) {
  return k < c.size() ? c[k] : Eigen::Vector3d::Zero();
}

bool has_speed(std::span<const Eigen::Vector3d> c) {
  const double length = vector_length(c[1]);
  // Square roots: the products themselves may overflow.
  return length > least_speed &&
         length > std::sqrt(pause * vector_length(c[0])) * std::sqrt(vector_length(derivative_or_zero(c, 2)));
}

/// The derivatives by arc length were the parameter's acceleration 0: that of a parameter of speed 1 at this point.
/// Nothing in them can overflow.
struct UnitSpeed {
  Eigen::Vector3d tangent, second, third, across;  ///< across = T x c''
  double speed, bend;                              ///< bend = |across|, the curvature
  bool regular, straight;
};

UnitSpeed unit_speed(std::span<const Eigen::Vector3d> c, double least_curvature = 0) {
  assert(c.size() >= 3);
  UnitSpeed unit;
  unit.tangent = unit_tangent(c);
  unit.speed = vector_length(c[1]);
  unit.regular = has_speed(c);
  const double a = unit.regular ? unit.speed : 1;
  unit.second = c[2] / a / a;
  unit.third = derivative_or_zero(c, 3) / a / a / a;
  unit.across = unit.tangent.cross(unit.second);
  unit.bend = vector_length(unit.across);
  const double least = std::max({least_vector, least_curvature, parallel * vector_length(unit.second)});
  unit.straight = !unit.regular || unit.bend <= least;
  return unit;
}

double torsion_of(const UnitSpeed& unit) {
  if (unit.straight) return 0;
  const double twist = (unit.across / unit.bend).dot(unit.third);
  // A quotient beyond all numbers comes from a curvature that is one of rounding only.
  return std::abs(twist) * 1e-300 < unit.bend ? twist / unit.bend : 0;
}

}  // namespace

double speed(std::span<const Eigen::Vector3d> c) { return vector_length(c[1]); }

double curvature(std::span<const Eigen::Vector3d> c) {
  const UnitSpeed unit = unit_speed(c.first(3));
  return unit.regular ? unit.bend : 0;
}

Eigen::Vector3d curvature_vector(std::span<const Eigen::Vector3d> c) {
  if (!has_speed(c)) return Eigen::Vector3d::Zero();
  const double speed2 = c[1].squaredNorm();
  return (c[2] - c[2].dot(c[1]) / speed2 * c[1]) / speed2;
}

double signed_curvature(std::span<const Eigen::Vector3d> c, const Eigen::Vector3d& plane_normal) {
  const UnitSpeed unit = unit_speed(c.first(3));
  return unit.regular ? unit.across.dot(plane_normal) : 0;
}

double torsion(std::span<const Eigen::Vector3d> c) {
  assert(c.size() >= 4);
  return torsion_of(unit_speed(c));
}

FrenetFrame frenet_frame(std::span<const Eigen::Vector3d> c, double least_curvature) {
  const UnitSpeed unit = unit_speed(c, least_curvature);
  FrenetFrame frame;
  frame.tangent = unit.tangent;
  frame.normal = unit_across(unit.tangent, unit.straight ? unit.third : unit.second);
  frame.binormal = unit.tangent.cross(frame.normal);
  frame.speed = unit.speed;
  frame.curvature = unit.regular ? unit.bend : 0;
  frame.torsion = torsion_of(unit);
  frame.regular = unit.regular;
  frame.straight = unit.straight;
  return frame;
}

Eigen::Vector3d unit_tangent(std::span<const Eigen::Vector3d> c) {
  assert(c.size() >= 2);
  if (has_speed(c)) return c[1] / vector_length(c[1]);
  for (std::size_t k = 2; k < c.size(); ++k) {
    const double length = vector_length(c[k]);
    if (length > least_vector) return c[k] / length;
  }
  return Eigen::Vector3d::UnitX();
}

Eigen::Vector3d unit_across(const Eigen::Vector3d& tangent, const Eigen::Vector3d& wish) {
  const double length = vector_length(wish);
  if (length > least_vector) {
    const Eigen::Vector3d direction = wish / length, across = direction - tangent.dot(direction) * tangent;
    const double left = across.norm();
    if (left > parallel) {
      // Once more: the first time, the part along the tangent was known relative to the whole only.
      const Eigen::Vector3d unit = across / left;
      return (unit - tangent.dot(unit) * tangent).normalized();
    }
  }
  Eigen::Index axis = 0;
  tangent.cwiseAbs().minCoeff(&axis);
  return (Eigen::Vector3d::Unit(axis) - tangent[axis] * tangent).normalized();
}

}  // namespace knotwork
