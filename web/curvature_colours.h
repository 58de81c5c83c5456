#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "web/theme.h"

namespace knotwork::web {

/// The two ends of the scale of curvatures and its middle, OKLab: blue, paper, orange. Blue and orange differ for readers
/// with any common colour vision, and both are equally far from paper.
struct CurvatureColours {
  glm::vec3 least = oklab(Colour{0.16F, 0.40F, 0.72F});
  glm::vec3 zero = oklab(Colour{0.95F, 0.94F, 0.91F});
  glm::vec3 greatest = oklab(Colour{0.80F, 0.38F, 0.08F});

  /// OKLab of a curvature that is `share` of the scale's end, limited to [-1, 1].
  glm::vec3 at(float share) const {
    const float size = std::min(std::abs(share), 1.0F);
    return glm::mix(zero, share > 0 ? greatest : least, size);
  }
};

}  // namespace knotwork::web
