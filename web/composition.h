#pragma once

#include <array>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "web/camera.h"

namespace knotwork::web {

/// Where the camera stands and which part of the stage the picture is centred in.
struct Composition {
  scene::Camera camera;
  Viewport viewport;  ///< with insets
};

/// What covers the stage: x y width height in CSS pixels.
struct Obstacles {
  std::span<const std::array<double, 4>> regions;   ///< take pointers: a handle below them is out of reach
  std::span<const std::array<double, 4>> readouts;  ///< words that hide, but take no pointers
};

/// Whether a box about a screen position, `reach` CSS pixels to each side, lies on the stage beside every obstacle.
bool uncovered(glm::dvec2 place, glm::dvec2 reach, const Viewport& stage, const Obstacles& obstacles);

/// What the picture shows. Handles may be among the points.
struct Motif {
  std::span<const glm::dvec3> points;
  std::span<const glm::dvec3> handles;
};

/// The largest picture of the motif that keeps clear of the stage's edges and of the obstacles (panel, clock), seen
/// from the camera's direction. The camera turns about the middle of the points. Where that leaves little room, the
/// obstacles are given up one after another, as far as it makes the picture larger: first points may lie below
/// readouts, then handles too, then points below regions; last, and only where nothing else is left, handles.
Composition compose(const scene::Camera& direction, const Motif& motif, const Viewport& viewport,
                    const Obstacles& obstacles);

}  // namespace knotwork::web
