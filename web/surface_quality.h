#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "knotwork/later.h"
#include "knotwork/scene/document.h"
#include "knotwork/surface/surface_joints.h"

namespace knotwork::web {

/// What is not smooth at the lines where pieces of a surface meet: the first of these that is to be seen.
enum class SurfaceFault : std::uint8_t { none, kink, bend };

/// What the shading of a surface says in numbers.
struct SurfaceQuality {
  scene::Shading shading = scene::Shading::lit;
  bool known = false;  ///< the numbers below; until then they are looked for
  double scale = 1;    ///< where the colours of a curvature end
  SurfaceFault fault = SurfaceFault::none;
  SurfaceJoint worst;  ///< the line where it is largest
  int others = 0;      ///< lines that have it, too
  std::string words;   ///< all this, as fault_text() says it; of a surface that is no pieces nothing
};

/// The fault of a surface whose box has a diagonal of `size`. A kink is seen from 0.05 degrees on, a jump of curvature
/// from a fiftieth of the curvature of a ball of radius `size`.
KNOTWORK_LAST void find_fault(SurfaceQuality& quality, const std::vector<SurfaceJoint>& joints, double size);

/// "kinks at 8 knots, the largest 12.5° at u = 0.25": the fault in words.
KNOTWORK_LAST std::string fault_text(const SurfaceQuality& quality);

}  // namespace knotwork::web
