#include "knotwork/surface/surface_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

using Sides = std::array<double, 2>;

/// The parameters before and behind each line where pieces meet.
std::vector<Sides> joints_along(const KnotVector& knots, bool seam) {
  std::vector<Sides> found;
  const std::vector<Interval> intervals = knot_intervals(knots);
  for (std::size_t k = 1; k < intervals.size(); ++k)
    found.push_back({just_before(intervals[k].start), intervals[k].start});
  if (seam && knots.closed()) found.push_back({just_before(knots.end()), knots.start()});
  return found;
}

std::vector<double> places_between(const KnotVector& knots, int places) {
  std::vector<double> t;
  for (const Interval& interval : knot_intervals(knots))
    for (int k = 0; k < places; ++k) t.push_back(std::lerp(interval.start, interval.end, (k + 0.5) / places));
  return t;
}

/// The normal curvature across a line u = const, or v = const: both forms at S_u - r S_v with r = F/G, which is at right
/// angles to the line. Across v = const the parameters change places.
double bend_across(const SurfaceJet& jet, bool u) {
  const FundamentalForms forms = fundamental_forms(jet);
  const double along = u ? forms.G : forms.E, across = u ? forms.E : forms.G;
  const double e = u ? forms.e : forms.g, g = u ? forms.g : forms.e;
  const double r = forms.F / along, metric = across - r * forms.F;
  return metric > 0 ? (e - 2 * r * forms.f + r * r * g) / metric : 0;
}

void look(SurfaceJoint& joint, const SurfaceJet& before, const SurfaceJet& behind) {
  joint.gap = std::max(joint.gap, (before.s - behind.s).norm());
  if (!curvature(before).regular || !curvature(behind).regular) return;  // a pole has no tangent plane
  const Eigen::Vector3d a = unit_normal(before), b = unit_normal(behind);
  joint.kink = std::max(joint.kink, std::atan2(a.cross(b).norm(), a.dot(b)));
  const bool u = joint.along_v;
  joint.bend = std::max(joint.bend, std::abs(bend_across(before, u) - bend_across(behind, u)));
}

}  // namespace

std::vector<SurfaceJoint> surface_joints(const KnottedSurface& surface, int places, JointSeams seams) {
  std::vector<SurfaceJoint> found;
  const std::vector<double> along_u = places_between(*surface.knots_u, places);
  const std::vector<double> along_v = places_between(*surface.knots_v, places);
  std::vector<SurfaceJet> jets(2 * std::max(along_u.size(), along_v.size()));
  for (const Sides& sides : joints_along(*surface.knots_u, seams.u)) {
    surface.evaluate_grid(sides, along_v, std::span(jets).first(2 * along_v.size()));
    SurfaceJoint& joint = found.emplace_back(SurfaceJoint{.along_v = true, .parameter = sides[1]});
    for (std::size_t k = 0; k < along_v.size(); ++k) look(joint, jets[k], jets[along_v.size() + k]);
  }
  for (const Sides& sides : joints_along(*surface.knots_v, seams.v)) {
    surface.evaluate_grid(along_u, sides, std::span(jets).first(2 * along_u.size()));
    SurfaceJoint& joint = found.emplace_back(SurfaceJoint{.along_v = false, .parameter = sides[1]});
    for (std::size_t k = 0; k < along_u.size(); ++k) look(joint, jets[2 * k], jets[2 * k + 1]);
  }
  return found;
}

const SurfaceJoint* worst_joint(const std::vector<SurfaceJoint>& joints, double SurfaceJoint::*difference) {
  const auto worst = std::max_element(joints.begin(), joints.end(), [&](const SurfaceJoint& a, const SurfaceJoint& b) {
    return a.*difference < b.*difference;
  });
  return worst == joints.end() ? nullptr : &*worst;
}

}  // namespace knotwork
