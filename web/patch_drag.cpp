#include "web/patch_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web {
namespace {

using std::numbers::pi;
constexpr double turn_step = pi / 12, scale_step = 0.25;
// Below this |cos| between a ring's axis and the line of sight, angles in the ring's plane are too foreshortened to
// follow a hand.
constexpr double least_facing = 0.3;
constexpr double least_ring_share = 0.5;  // nearer to the centre than this, an angle in the plane is all jitter
constexpr double least_scale_arm = 12;    // CSS pixels; a shorter lever would scale in jumps
constexpr double least_screen_axis = 6;   // CSS pixels
// sin^2 of the angle between an axis and the ray below which their nearest points say nothing (2.5 degrees).
constexpr double parallel = 0.002;
constexpr double longest_move = 100;  // times the eye's distance from the handle

Eigen::Vector3d limited(const Eigen::Vector3d& translation) {
  return translation.cwiseMax(-scene::max_coordinate).cwiseMin(scene::max_coordinate);
}

double rounded_to(double x, double step) { return std::round(x / step) * step; }

void anchor_move(PatchDrag& drag, const LocalScene& scene, bool along_axis) {
  drag.along_axis = along_axis;
  drag.anchor = drag.position;
  drag.anchor_pointer = drag.pointer;
  const std::optional<glm::dvec3> screen = scene.view.project(drag.anchor);
  drag.grab_offset = screen ? drag.pointer - glm::dvec2(*screen) : glm::dvec2(0);
  const double along_sight = glm::dot(drag.axis, glm::normalize(drag.anchor - scene.view.eye));
  drag.axis_at_eye = 1 - along_sight * along_sight < parallel;
}

/// The point of the plane through the anchor, parallel to the screen, that lies under a screen position.
std::optional<glm::dvec3> in_plane(const PatchDrag& drag, const View& view, glm::dvec2 screen) {
  const double depth = glm::dot(drag.anchor - view.eye, view.forward);
  const glm::dvec3 direction = to_glm(view.ray(screen).direction);
  if (depth <= 0) return std::nullopt;
  return view.eye + depth / glm::dot(direction, view.forward) * direction;
}

/// The point of the line through the anchor that comes nearest to the ray through a screen position.
std::optional<glm::dvec3> on_line(const PatchDrag& drag, const View& view, glm::dvec2 pointer) {
  if (drag.axis_at_eye) {
    return drag.anchor + (drag.anchor_pointer.y - pointer.y) * view.pixel_size(drag.anchor) * drag.axis;
  }
  const glm::dvec3 ray = to_glm(view.ray(pointer - drag.grab_offset).direction);
  const glm::dvec3 w = drag.anchor - view.eye;
  const double b = glm::dot(ray, drag.axis);
  if (1 - b * b < 1e-6) return std::nullopt;  // the pointer is at the line's vanishing point
  const double s = (b * glm::dot(ray, w) - glm::dot(drag.axis, w)) / (1 - b * b);
  const double along_ray = glm::dot(ray, w) + s * b;
  if (along_ray <= 0 || std::abs(s) > longest_move * glm::length(w)) return std::nullopt;
  return drag.anchor + s * drag.axis;
}

void move(PatchDrag& drag, const LocalScene& scene, glm::dvec2 pointer, bool along_axis) {
  // Anchored at the last pointer, so that pressing or releasing Shift alone moves nothing.
  if (along_axis != drag.along_axis) anchor_move(drag, scene, along_axis);
  const std::optional<glm::dvec3> place =
      along_axis ? on_line(drag, scene.view, pointer) : in_plane(drag, scene.view, pointer - drag.grab_offset);
  if (place) drag.position = *place;
}

/// The pointer in the plane of a ring, in the two other axes.
std::optional<glm::dvec2> on_ring_plane(const PatchDrag& drag, const View& view, int axis, glm::dvec2 pointer) {
  const glm::dvec3 ray = to_glm(view.ray(pointer).direction);
  const glm::dvec3& normal = drag.axes[axis];
  const double descent = glm::dot(ray, normal), height = glm::dot(drag.origin - view.eye, normal);
  // Beyond its horizon the plane is not under the pointer.
  if (descent * height <= 1e-9 * height * height / glm::length(drag.origin - view.eye)) return std::nullopt;
  const double t = height / descent;
  const glm::dvec3 d = view.eye + t * ray - drag.origin;
  return glm::dvec2(glm::dot(d, drag.axes[(axis + 1) % 3]), glm::dot(d, drag.axes[(axis + 2) % 3]));
}

/// Whether a ring was grabbed on its far half: the nearest point on the screen decides, the near half in doubt.
bool grabbed_behind(const PatchDrag& drag, const View& view, int axis, double size) {
  constexpr int steps = 72;
  double best = 0;
  bool found = false, behind = false;
  for (int k = 0; k < steps; ++k) {
    const double angle = 2 * pi * k / steps;
    const glm::dvec3 d = std::cos(angle) * drag.axes[(axis + 1) % 3] + std::sin(angle) * drag.axes[(axis + 2) % 3];
    const std::optional<glm::dvec3> screen = view.project(drag.origin + size * d);
    if (!screen) continue;
    const double depth = glm::dot(d, view.forward);
    const double score = glm::length(glm::dvec2(*screen) - drag.pointer) + 2 * depth;
    if (!found || score < best) {
      found = true;
      best = score;
      behind = depth > 0;
    }
  }
  return behind;
}

void hold_ring(PatchDrag& drag, const LocalScene& scene, int axis) {
  const View& view = scene.view;
  const glm::dvec3& normal = drag.axes[axis];
  const glm::dvec3 sight = glm::normalize(drag.origin - view.eye);
  const double size = gizmo_radius * view.pixel_size(drag.origin);
  const std::optional<glm::dvec2> in_ring = on_ring_plane(drag, view, axis, drag.pointer);
  const bool facing = std::abs(glm::dot(normal, sight)) >= least_facing;
  if (facing && in_ring && glm::length(*in_ring) > least_ring_share * size) {
    drag.last_angle = std::atan2(in_ring->y, in_ring->x);
    return;
  }
  drag.by_tangent = true;
  drag.screen_length = gizmo_radius;
  // Where the ring comes nearest to the eye it turns along normal x (towards the eye).
  const glm::dvec3 tangent = glm::cross(sight, normal);
  const glm::dvec2 on_screen{glm::dot(tangent, view.right), -glm::dot(tangent, view.up)};
  const double length = glm::length(on_screen);
  if (length > 1e-9) drag.screen_axis = on_screen / length;
  if (grabbed_behind(drag, view, axis, size)) drag.screen_axis = -drag.screen_axis;
}

void hold_knob(PatchDrag& drag, const LocalScene& scene, GizmoPart part) {
  const View& view = scene.view;
  const std::optional<glm::dvec3> origin = view.project(drag.origin);
  if (!origin) return;
  const glm::dvec3 axis =
      part == GizmoPart::scale_all ? glm::normalize(drag.axes[0] + drag.axes[1]) : drag.axes[gizmo_axis(part)];
  const std::optional<glm::dvec3> end = view.project(drag.origin + gizmo_radius * view.pixel_size(drag.origin) * axis);
  const glm::dvec2 arm = drag.pointer - glm::dvec2(*origin);
  glm::dvec2 along = end ? glm::dvec2(*end) - glm::dvec2(*origin) : arm;
  if (glm::length(along) < least_screen_axis) along = arm;
  if (glm::length(along) > 1e-9) drag.screen_axis = glm::normalize(along);
  drag.screen_length = std::max(glm::dot(arm, drag.screen_axis), least_scale_arm);
}

Eigen::Quaterniond turned(PatchDrag& drag, const LocalScene& scene, glm::dvec2 pointer, bool snap) {
  const int axis = gizmo_axis(*drag.part);
  if (drag.by_tangent) {
    drag.angle = glm::dot(pointer - drag.pointer_at_start, drag.screen_axis) / drag.screen_length;
  } else if (const auto in_ring = on_ring_plane(drag, scene.view, axis, pointer)) {
    const double angle = std::atan2(in_ring->y, in_ring->x);
    drag.angle += std::remainder(angle - drag.last_angle, 2 * pi);
    drag.last_angle = angle;
  }
  const double angle = snap ? rounded_to(drag.angle, turn_step) : drag.angle;
  const Eigen::AngleAxisd turn(std::remainder(angle, 2 * pi), Eigen::Vector3d::Unit(axis));
  return (drag.edit_at_start.rotation * turn).normalized();
}

Eigen::Vector3d scaled(const PatchDrag& drag, glm::dvec2 pointer, bool snap) {
  constexpr scene::Limits limits = scene::limits::scale;
  Eigen::Vector3d scale = drag.edit_at_start.scale;
  double factor = 1 + glm::dot(pointer - drag.pointer_at_start, drag.screen_axis) / drag.screen_length;
  if (*drag.part == GizmoPart::scale_all) {
    if (snap) factor = std::max(rounded_to(factor, scale_step), scale_step);
    // Stopped as soon as one axis meets its limit, so that the proportions stay.
    factor = std::clamp(factor, limits.min / scale.minCoeff(), limits.max / scale.maxCoeff());
    return (factor * scale).cwiseMax(limits.min).cwiseMin(limits.max);
  }
  double& own = scale[gizmo_axis(*drag.part)];
  own = std::clamp(factor * own, limits.min, limits.max);
  if (snap) own = std::max(rounded_to(own, scale_step), scale_step);
  return scale;
}

}  // namespace

PatchDrag take_hold(const LocalScene& scene, scene::PatchIndex patch, std::optional<GizmoPart> part,
                    glm::dvec2 pointer) {
  PatchDrag drag;
  drag.patch = patch;
  drag.part = part;
  drag.edit_at_start = scene.local.edit;
  drag.pointer_at_start = drag.pointer = pointer;
  drag.origin = drag.position = to_glm(scene::local_origin(scene.local));
  drag.axes = to_glm_matrix(scene::turned_axes(scene.local));
  // The arrow is drawn along the turned normal and moves along it; Shift goes out of the surface that is unmoved.
  drag.axis = part ? drag.axes[2] : to_glm_matrix(scene.local.axes)[2];
  anchor_move(drag, scene, part == GizmoPart::move_normal);
  if (part && turns(*part)) hold_ring(drag, scene, gizmo_axis(*part));
  if (part && scales(*part)) hold_knob(drag, scene, *part);
  return drag;
}

scene::PatchEdit drag_to(PatchDrag& drag, const LocalScene& scene, glm::dvec2 pointer, bool shift) {
  scene::PatchEdit edit = scene.local.edit;
  if (drag.part && turns(*drag.part)) {
    edit.rotation = turned(drag, scene, pointer, shift);
  } else if (drag.part && scales(*drag.part)) {
    edit.scale = scaled(drag, pointer, shift);
  } else {
    move(drag, scene, pointer, drag.part ? true : shift);
    edit = moved_by(scene.local, drag.position - to_glm(scene::local_origin(scene.local)));
  }
  drag.pointer = pointer;
  return edit;
}

scene::PatchEdit moved_by(const scene::LocalFrame& local, glm::dvec3 offset) {
  scene::PatchEdit edit = local.edit;
  edit.translation = limited(edit.translation + local.axes.transpose() * to_eigen(offset));
  return edit;
}

}  // namespace knotwork::web
