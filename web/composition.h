#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>

#include "web/camera.h"

namespace knotwork::web {

/// Where the camera stands and which part of the stage the picture is centred in.
struct Composition {
  scene::Camera camera;
  Viewport viewport;  ///< with insets
};

/// The largest picture of `points` that keeps clear of the stage's edges and of the obstacles (panel, clock; x y width
/// height in CSS pixels), seen from the camera's direction. The camera turns about the middle of the points. With no
/// room beside the obstacles, they are allowed to cover a part of it.
Composition compose(const scene::Camera& direction, std::span<const glm::dvec3> points, const Viewport& viewport,
                    std::span<const std::array<double, 4>> obstacles);

}  // namespace knotwork::web
