#include "web/surface_quality.h"

#include <numbers>
#include <vector>

#include <doctest/doctest.h>

namespace knotwork::web::surface_quality_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

SurfaceQuality quality_of(const std::vector<SurfaceJoint>& joints, double size) {
  SurfaceQuality quality;
  find_fault(quality, joints, size);
  return quality;
}

TEST_CASE("the worst kink is told with its line and the number of the others") {
  const std::vector<SurfaceJoint> joints{{.along_v = true, .parameter = 0.25, .kink = 3 * degree, .bend = 9},
                                         {.along_v = false, .parameter = 1.5, .kink = 12.34 * degree},
                                         {.along_v = false, .parameter = 2, .kink = 0.01 * degree, .bend = 1}};
  const SurfaceQuality quality = quality_of(joints, 1);
  CHECK(quality.fault == SurfaceFault::kink);
  CHECK(quality.others == 1);
  CHECK(fault_text(quality) == "kinks at 2 knots, the largest 12.3° at v = 1.5");
}

TEST_CASE("where no kink is to be seen, a jump of curvature is, by the size of the surface") {
  const std::vector<SurfaceJoint> joints{{.along_v = true, .parameter = -2, .kink = 0.04 * degree, .bend = 0.3}};
  CHECK(fault_text(quality_of(joints, 1)) == "curvature jumps by 0.3 at u = −2");
  CHECK(fault_text(quality_of(joints, 0.01)) == "smooth at the knots, curvature too");
}

TEST_CASE("a surface without joints, or with smooth ones, has no fault") {
  CHECK(quality_of({}, 1).fault == SurfaceFault::none);
  const SurfaceQuality smooth = quality_of({{.kink = 1e-9, .bend = 1e-7}}, 1);
  CHECK(smooth.fault == SurfaceFault::none);
  CHECK(fault_text(smooth) == "smooth at the knots, curvature too");
}

}  // namespace
}  // namespace knotwork::web::surface_quality_test
