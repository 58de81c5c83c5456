#include "web/surface_quality.h"

#include <algorithm>
#include <numbers>

#include "web/language.h"
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
  if (quality.fault == SurfaceFault::none) return std::string(say("smooth at the knots, curvature too"));
  const SurfaceJoint& worst = quality.worst;
  const std::string place = (worst.along_v ? "u = " : "v = ") + text_of("%.3g", worst.parameter);
  const bool kink = quality.fault == SurfaceFault::kink;
  const std::string most = kink ? text_of("%.1f", worst.kink / degree) : text_of("%.2g", worst.bend);
  if (quality.others == 0)
    return std::string(kink ? say("kink of {}° at {}", most, place) : say("curvature jumps by {} at {}", most, place));
  const int all = quality.others + 1;
  return std::string(kink ? say("kinks at {} knots, the largest {}° at {}", all, most, place)
                          : say("curvature jumps at {} knots, most by {} at {}", all, most, place));
}

}  // namespace knotwork::web
