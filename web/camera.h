#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "knotwork/scene/document.h"
#include "knotwork/scene/picking.h"

namespace knotwork::web {

/// The stage in CSS pixels. The insets are what the interface covers (panel, clock); the picture is centred in the
/// rest.
struct Viewport {
  double width = 1, height = 1;
  double pixel_ratio = 1;
  double inset_left = 0, inset_top = 0, inset_right = 0, inset_bottom = 0;
};

/// What the insets leave free: its centre and size. Insets never take more than three quarters of a direction.
struct FreeArea {
  glm::dvec2 centre, size;
};
FreeArea free_area(const Viewport& viewport);

/// A camera looking at a viewport: matrices for drawing, projection and rays for holding things. Screen positions are
/// CSS pixels from the upper left corner.
struct View {
  glm::dmat4 view, projection;
  glm::dvec3 eye, right, up, forward;  ///< unit directions of the screen in model space
  Viewport viewport;

  /// Screen position and depth along `forward`; nothing when the point is not in front of the eye.
  std::optional<glm::dvec3> project(glm::dvec3 point) const;
  /// From the eye through a screen position, unit direction. Inverse to project() within 1e-9 CSS pixels.
  scene::Ray ray(glm::dvec2 screen) const;
  /// Model units that one CSS pixel covers at a point; behind the eye as much as right before it.
  double pixel_size(glm::dvec3 point) const;
};

/// Radians, across the shorter side of the free part of the stage: the height of a wide one, the width of a phone's.
inline constexpr double field_of_view = 0.55;
inline constexpr double min_distance = 0.05, max_distance = 1e4;  ///< model units
inline constexpr double max_elevation = 1.5533;                   ///< radians, 89 degrees

/// The target appears at the centre of the free area. Near and far follow the distance: at the default one a 24-bit
/// depth buffer tells 2e-5 model units apart at the target.
View make_view(const scene::Camera& camera, const Viewport& viewport);

// Each returns the camera after a gesture; angles, distance and target stay in these limits, or where a document has put
// them beyond. Where a gesture makes no sense (numbers that overflow), the camera stays as it is.

/// The shorter side of the free area turns by half a circle; the surface follows the pointer.
scene::Camera orbit(const scene::Camera& camera, glm::dvec2 pixels, const Viewport& viewport);
/// What lies at the target's depth follows the pointer.
scene::Camera pan(const scene::Camera& camera, glm::dvec2 pixels, const View& view);
/// The same with what lies as deep as a point.
scene::Camera pan(const scene::Camera& camera, glm::dvec2 pixels, const View& view, glm::dvec3 point);
/// factor > 1 comes closer; the point under `anchor` at the target's depth stays there.
scene::Camera zoom(const scene::Camera& camera, double factor, glm::dvec2 anchor, const View& view);
/// The same about a point of the stage, which stays where it is on the screen and is never passed.
scene::Camera zoom(const scene::Camera& camera, double factor, glm::dvec3 around);

/// 6x^5 - 15x^4 + 10x^3, x limited to [0,1]: what moves by itself starts and stops with it.
double ease(double x);
/// Between two cameras, eased; share in [0,1]. Turns the shorter way round.
scene::Camera between(const scene::Camera& from, const scene::Camera& to, double share);

}  // namespace knotwork::web
