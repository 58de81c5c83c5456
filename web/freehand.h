#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/later.h"
#include "web/camera.h"

namespace knotwork::web {

/// A line drawn by hand on the stage: positions of the pointer, CSS pixels.
using Stroke = std::vector<glm::dvec2>;

/// The line goes on to the pointer, once that is far enough from its last point to say something.
void draw_on(Stroke& stroke, glm::dvec2 pointer);

/// Points at even steps along the stroke, however fast the hand was, with both its ends; at most 2000. They lie in the
/// plane of the present points where these have one height z and are seen from above or below, else in the plane through
/// the camera's target that is parallel to the screen. Empty when the plane is not before the eye.
KNOTWORK_LATER std::vector<Eigen::Vector3d> drawn_points(const Stroke& stroke, const View& view, glm::dvec3 target,
                                                         std::span<const Eigen::Vector3d> present);

}  // namespace knotwork::web
