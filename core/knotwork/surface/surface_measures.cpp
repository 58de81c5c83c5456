#include "knotwork/surface/surface_measures.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

/// Shorter partials count as zero; keeps the squares of their inverses finite.
constexpr double least_length = 1e-100;
/// The sine of the angle between the partials below which they count as parallel.
constexpr double least_sine = 1e-12;

/// The jet in parameters stretched so that both first partials have length 1 (or are zero): the same surface, with
/// nothing left to overflow or underflow.
struct UnitJet {
  Eigen::Vector3d su, sv, suu, suv, svv;
  double length_u, length_v;
  bool regular;
};

UnitJet unit_jet(const SurfaceJet& jet) {
  const double lu = vector_length(jet.su), lv = vector_length(jet.sv);
  const bool has_u = lu > least_length, has_v = lv > least_length;
  const double a = has_u ? lu : 1, b = has_v ? lv : 1;
  UnitJet unit{has_u ? Eigen::Vector3d(jet.su / a) : Eigen::Vector3d::Zero(),
               has_v ? Eigen::Vector3d(jet.sv / b) : Eigen::Vector3d::Zero(),
               jet.suu / a / a,
               jet.suv / a / b,
               jet.svv / b / b,
               lu,
               lv,
               false};
  unit.regular = unit.su.cross(unit.sv).norm() > least_sine;
  return unit;
}

/// Unit vector along x, or zero where x is negligible against `scale`.
Eigen::Vector3d direction(const Eigen::Vector3d& x, double scale) {
  const double length = vector_length(x);
  return length > least_length && length > least_sine * scale ? Eigen::Vector3d(x / length) : Eigen::Vector3d::Zero();
}

}  // namespace

Eigen::Vector3d unit_normal(const SurfaceJet& jet) {
  const UnitJet j = unit_jet(jet);
  if (j.regular) return j.su.cross(j.sv).normalized();

  // S_u x S_v = h N' + O(h^2) along a direction of growing u or v; the larger N' decides.
  const Eigen::Vector3d along_u = j.suu.cross(j.sv) + j.su.cross(j.suv);
  const Eigen::Vector3d along_v = j.suv.cross(j.sv) + j.su.cross(j.svv);
  const double size = std::max({vector_length(j.suu), vector_length(j.suv), vector_length(j.svv)});
  const bool prefer_u = vector_length(along_u) >= vector_length(along_v);
  if (Eigen::Vector3d n = direction(prefer_u ? along_u : along_v, size); !n.isZero(0)) return n;

  // Both first-order terms vanish: second order along u, along v, along the diagonal.
  const Eigen::Vector3d uu = direction(j.suu, 0), uv = direction(j.suv, 0), vv = direction(j.svv, 0);
  for (const Eigen::Vector3d& candidate : {uu.cross(uv).eval(), uv.cross(vv).eval(), uu.cross(vv).eval()}) {
    if (Eigen::Vector3d n = direction(candidate, 1); !n.isZero(0)) return n;
  }
  return Eigen::Vector3d::UnitZ();
}

SurfaceCurvature curvature(const SurfaceJet& jet) {
  const UnitJet j = unit_jet(jet);
  if (!j.regular) return {};
  const Eigen::Vector3d n = j.su.cross(j.sv).normalized();
  // E = G = 1 in the stretched parameters; EG - F^2 as the square of the cross product does not cancel.
  const double f_metric = j.su.dot(j.sv), area2 = j.su.cross(j.sv).squaredNorm();
  const double e = n.dot(j.suu), f = n.dot(j.suv), g = n.dot(j.svv);
  SurfaceCurvature result;
  result.regular = true;
  result.gaussian = (e * g - f * f) / area2;
  result.mean = (e - 2 * f * f_metric + g) / (2 * area2);
  const double root = std::sqrt(std::max(0.0, result.mean * result.mean - result.gaussian));
  result.k_max = result.mean + root;
  result.k_min = result.mean - root;
  return result;
}

FundamentalForms fundamental_forms(const SurfaceJet& jet) {
  const Eigen::Vector3d n = unit_normal(jet);
  return {jet.su.dot(jet.su), jet.su.dot(jet.sv), jet.sv.dot(jet.sv), n.dot(jet.suu), n.dot(jet.suv), n.dot(jet.svv)};
}

PrincipalDirections principal_directions(const SurfaceJet& jet) {
  const Eigen::Vector3d n = unit_normal(jet);
  const UnitJet j = unit_jet(jet);
  const Eigen::Vector3d along = unit_across(n, j.su), across = n.cross(along);
  if (!j.regular) return {along, across, false};
  // The second form in the orthonormal basis of S_u and N x S_u, (a b; b c). Its axes stand at half the angle of
  // (a-c, 2b).
  const double cosine = j.su.dot(j.sv), sine = j.su.cross(j.sv).norm();
  const double a = n.dot(j.suu), f = n.dot(j.suv), g = n.dot(j.svv);
  const double b = (f - cosine * a) / sine, c = (g - 2 * cosine * f + cosine * cosine * a) / (sine * sine);
  const double rounding = least_sine * (j.suu.norm() + j.suv.norm() + j.svv.norm()) / (sine * sine);
  const bool umbilic = std::abs(b) <= rounding && std::abs(a - c) <= rounding;
  const double angle = umbilic ? 0 : std::atan2(2 * b, a - c) / 2;
  const Eigen::Vector3d max = std::cos(angle) * along + std::sin(angle) * across;
  return {max, n.cross(max), true};
}

}  // namespace knotwork
