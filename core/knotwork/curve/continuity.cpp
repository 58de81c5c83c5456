#include "knotwork/curve/continuity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "knotwork/curve/curve_measures.h"

namespace knotwork {
namespace {

using Side = std::array<Eigen::Vector3d, 4>;

}  // namespace

Continuity continuity_at(const CurveView& curve, double t, int order, double tolerance) {
  assert(order >= 1 && order <= 3);
  const bool seam = t <= curve.start || t >= curve.end;
  const std::vector<double> ends = piece_ends(curve.start, curve.end, curve.breaks);
  const double before = seam ? curve.end : t, behind = seam ? curve.start : t;
  // The pieces that meet, by their other ends.
  const double left = *std::prev(std::lower_bound(ends.begin(), ends.end(), before));
  const double right = *std::upper_bound(ends.begin(), ends.end(), behind);
  const double h = std::min(before - left, right - behind);

  // Curvature takes second derivatives, whatever is compared.
  const auto count = static_cast<std::size_t>(std::max(order, 2)) + 1;
  Side from, to;
  from.fill(Eigen::Vector3d::Zero());
  to.fill(Eigen::Vector3d::Zero());
  curve.evaluate(just_before(before), std::span(from).first(count));
  curve.evaluate(behind, std::span(to).first(count));

  double size = 0;
  for (std::size_t k = 0; k < 3; ++k)
    size = std::max(size, std::pow(h, static_cast<double>(k)) * std::max(from[k].norm(), to[k].norm()));
  std::array<double, 4> slack{};
  for (std::size_t k = 0; k < count; ++k)
    slack[k] = tolerance * (std::max(from[k].norm(), to[k].norm()) + size / std::pow(h, static_cast<double>(k)));

  Continuity found{t};
  found.velocity_gap = (from[1] - to[1]).norm();
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order) && (from[k] - to[k]).norm() <= slack[k]; ++k)
    found.parametric = static_cast<int>(k);
  if (found.parametric < 0) return found;
  found.geometric = 0;
  const double speed = std::min(from[1].norm(), to[1].norm());
  if (speed <= slack[1]) return found;
  if ((from[1].normalized() - to[1].normalized()).norm() > 2 * slack[1] / speed) return found;
  found.geometric = 1;
  const double bend_slack = (slack[2] + std::max(from[2].norm(), to[2].norm()) * slack[1] / speed) / (speed * speed);
  if ((curvature_vector(from) - curvature_vector(to)).norm() <= 2 * bend_slack) found.geometric = 2;
  return found;
}

std::vector<Continuity> joints(const CurveView& curve, int order) {
  std::vector<Continuity> found;
  if (curve.closed()) found.push_back(continuity_at(curve, curve.start, order));
  const std::vector<double> ends = piece_ends(curve.start, curve.end, curve.breaks);
  for (std::size_t k = 1; k + 1 < ends.size(); ++k) found.push_back(continuity_at(curve, ends[k], order));
  return found;
}

}  // namespace knotwork
