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

/// A camera looking at a viewport: matrices for drawing, projection and rays for holding things. Screen positions are
/// CSS pixels from the upper left corner.
struct View {
  glm::dmat4 view, projection;
  glm::dvec3 eye, right, up, forward;  ///< unit directions of the screen in model space
  Viewport viewport;

  /// Screen position and depth along `forward`; nothing when the point is not in front of the eye.
  std::optional<glm::dvec3> project(glm::dvec3 point) const;
  scene::Ray ray(glm::dvec2 screen) const;
  /// Model units that one CSS pixel covers at a point.
  double pixel_size(glm::dvec3 point) const;
};

inline constexpr double field_of_view = 0.55;  ///< radians, vertical, of the free part of the stage

View make_view(const scene::Camera& camera, const Viewport& viewport);

// Each returns the camera after a gesture; angles, distance and target stay in the document's limits.
scene::Camera orbit(const scene::Camera& camera, glm::dvec2 pixels, const Viewport& viewport);
scene::Camera pan(const scene::Camera& camera, glm::dvec2 pixels, const View& view);
/// factor > 1 comes closer; the point under `anchor` at the target's depth stays there.
scene::Camera zoom(const scene::Camera& camera, double factor, glm::dvec2 anchor, const View& view);
/// Same direction, the ball of `radius` round `centre` fills the free part of the viewport.
scene::Camera frame(const scene::Camera& camera, glm::dvec3 centre, double radius, const Viewport& viewport);

/// Between two cameras, eased; share in [0,1].
scene::Camera between(const scene::Camera& from, const scene::Camera& to, double share);

}  // namespace knotwork::web
