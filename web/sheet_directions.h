#pragma once

#include <glm/vec2.hpp>

#include "knotwork/surface/blending_surface.h"

namespace knotwork::web {

/// How the parameters of local patches go on where a direction of the surface ends.
struct SheetDirections {
  glm::ivec2 closed{0};  ///< 1 where the direction wraps
  glm::vec2 period{0};   ///< of the parameters in closed directions
  /// Local k of u becomes mirror.x - k where v goes round a twisted seam, of v mirror.y - k where u does; -1: no twist.
  glm::ivec2 mirror{-1};
};

inline SheetDirections sheet_directions(const BlendingSurface& surface) {
  const KnotVector &u = surface.knots_u(), &v = surface.knots_v();
  return {.closed = {u.closed() ? 1 : 0, v.closed() ? 1 : 0},
          .period = {static_cast<float>(u.period()), static_cast<float>(v.period())},
          .mirror = {surface.twist_v() ? surface.twist_v()->mirror : -1,
                     surface.twist_u() ? surface.twist_u()->mirror : -1}};
}

}  // namespace knotwork::web
