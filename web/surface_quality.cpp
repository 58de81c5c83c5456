#include "web/surface_quality.h"

#include <algorithm>
#include <numbers>

#include "web/words.h"

namespace knotwork::web {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_kink = 0.05 * degree, least_bend = 0.02;  // the latter in terms of one over the size

}  // namespace

void find_fault(SurfaceQuality& quality, const std::vector<SurfaceJoint>& joints, double size) {
  const auto look = [&](SurfaceFault fault, double SurfaceJoint::*difference, double least) {
    const SurfaceJoint* worst = worst_joint(joints, difference);
    if (worst == nullptr || !(worst->*difference >= least)) return false;
    quality.fault = fault;
    quality.worst = *worst;
    quality.others =
        static_cast<int>(std::count_if(joints.begin(), joints.end(),
                                       [&](const SurfaceJoint& joint) { return joint.*difference >= least; })) -
        1;
    return true;
  };
  quality.fault = SurfaceFault::none;
  if (!look(SurfaceFault::kink, &SurfaceJoint::kink, least_kink))
    look(SurfaceFault::bend, &SurfaceJoint::bend, least_bend / size);
}

std::string fault_text(const SurfaceQuality& quality) {
  if (quality.fault == SurfaceFault::none) return "at knots: no jump up to curvature";
  const SurfaceJoint& worst = quality.worst;
  std::string text = quality.fault == SurfaceFault::kink ? "kink of " + text_of("%.1f", worst.kink / degree) + "°"
                                                         : "curvature jumps by " + text_of("%.2g", worst.bend);
  text += (worst.along_v ? " at u = " : " at v = ") + text_of("%.3g", worst.parameter);
  if (quality.others > 0)
    text += " and " + std::to_string(quality.others) + (quality.others > 1 ? " more knots" : " more knot");
  return text;
}

}  // namespace knotwork::web
