#include "web/gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web {
namespace {

using std::numbers::pi;
constexpr int ring_steps = 72;

// In ring radii.
constexpr double stem_start = 1.0, knob_at = 1.26, even_knob_at = 1.3;
constexpr double arrow_start = 1.1, arrow_end = 1.62, barb_length = 0.17, barb_width = 0.085;

// In CSS pixels, when parts compete for the pointer.
constexpr double knob_preference = 2, front_preference = 2;

GizmoStroke ring(GizmoPart part, const Gizmo& gizmo) {
  const int axis = gizmo_axis(part);
  const glm::dvec3 a = gizmo.size * gizmo.axes[(axis + 1) % 3];
  const glm::dvec3 b = gizmo.size * gizmo.axes[(axis + 2) % 3];
  GizmoStroke stroke{part, {}, 0};
  stroke.points.reserve(ring_steps + 1);
  for (int k = 0; k < ring_steps; ++k) {
    const double angle = 2 * pi * k / ring_steps;
    stroke.points.push_back(gizmo.origin + std::cos(angle) * a + std::sin(angle) * b);
  }
  stroke.points.push_back(stroke.points.front());
  return stroke;
}

/// Distance from a point to a segment on the screen, and the depth of the nearest point.
struct Nearness {
  double distance, depth;
};
Nearness nearness(glm::dvec2 p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec2 from(a), along = glm::dvec2(b) - from;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - from, along) / length2, 0.0, 1.0) : 0.0;
  return {glm::length(p - from - t * along), (1 - t) * a.z + t * b.z};
}

}  // namespace

int gizmo_axis(GizmoPart part) {
  switch (part) {
    case GizmoPart::turn_u:
    case GizmoPart::scale_u:
      return 0;
    case GizmoPart::turn_v:
    case GizmoPart::scale_v:
      return 1;
    case GizmoPart::turn_normal:
    case GizmoPart::scale_all:
    case GizmoPart::move_normal:
      break;
  }
  return 2;
}

bool turns(GizmoPart part) {
  return part == GizmoPart::turn_u || part == GizmoPart::turn_v || part == GizmoPart::turn_normal;
}

bool scales(GizmoPart part) {
  return part == GizmoPart::scale_u || part == GizmoPart::scale_v || part == GizmoPart::scale_all;
}

glm::dmat3 gizmo_axes(const BlendingSurface& surface, const scene::BlendingSurfaceObject& object,
                      scene::PatchIndex patch) {
  Eigen::Matrix3d axes = scene::patch_frame(surface, patch);
  if (const auto edit = object.edits.find(patch); edit != object.edits.end()) {
    axes = axes * edit->second.rotation.normalized().toRotationMatrix();
  }
  return to_glm_matrix(axes);
}

Gizmo make_gizmo(const BlendingSurface& surface, const scene::BlendingSurfaceObject& object, scene::PatchIndex patch,
                 const View& view) {
  return make_gizmo(to_glm(scene::patch_origin(surface, patch)), gizmo_axes(surface, object, patch), view);
}

Gizmo make_gizmo(glm::dvec3 origin, const glm::dmat3& axes, const View& view) {
  Gizmo gizmo{origin, axes, 0, {}};
  gizmo.size = gizmo_radius * view.pixel_size(gizmo.origin);
  if (!view.project(gizmo.origin)) return gizmo;

  const glm::dvec3 &o = gizmo.origin, &u = gizmo.axes[0], &v = gizmo.axes[1], &normal = gizmo.axes[2];
  const double r = gizmo.size;
  for (const GizmoPart part : {GizmoPart::turn_u, GizmoPart::turn_v, GizmoPart::turn_normal}) {
    gizmo.strokes.push_back(ring(part, gizmo));
  }

  const double knob = knob_radius / gizmo_radius;
  const auto knob_on_stem = [&](GizmoPart part, const glm::dvec3& axis, double at) {
    gizmo.strokes.push_back({part, {o + r * stem_start * axis, o + r * (at - knob) * axis}, 0});
    gizmo.strokes.push_back({part, {o + r * at * axis}, knob_radius});
  };
  knob_on_stem(GizmoPart::scale_u, u, knob_at);
  knob_on_stem(GizmoPart::scale_v, v, knob_at);
  gizmo.strokes.push_back({GizmoPart::scale_all, {o + r * even_knob_at * glm::normalize(u + v)}, knob_radius});

  const glm::dvec3 tip = o + r * arrow_end * normal;
  gizmo.strokes.push_back({GizmoPart::move_normal, {o + r * arrow_start * normal, tip}, 0});
  // The barbs lie across the line of sight, so that the head is a head from every side.
  const glm::dvec3 across = glm::cross(normal, view.forward);
  const double width = glm::length(across);
  const glm::dvec3 side = width > 1e-6 ? across / width : view.right;
  const glm::dvec3 neck = tip - r * barb_length * normal;
  gizmo.strokes.push_back(
      {GizmoPart::move_normal, {neck + r * barb_width * side, tip, neck - r * barb_width * side}, 0});
  return gizmo;
}

std::optional<GizmoPart> pick_gizmo(const Gizmo& gizmo, const View& view, glm::dvec2 screen, double reach) {
  std::optional<GizmoPart> picked;
  double best = 0;
  const double origin_depth = glm::dot(gizmo.origin - view.eye, view.forward);
  for (const GizmoStroke& stroke : gizmo.strokes) {
    std::optional<glm::dvec3> previous;
    for (const glm::dvec3& point : stroke.points) {
      const std::optional<glm::dvec3> projected = view.project(point);
      if (projected) {
        const Nearness near = nearness(screen, previous.value_or(*projected), *projected);
        const double distance = std::max(near.distance - stroke.radius, 0.0);
        const double behind = std::clamp((near.depth - origin_depth) / gizmo.size, -1.0, 1.0);
        const double score = distance + front_preference * behind - (stroke.radius > 0 ? knob_preference : 0.0);
        if (distance <= reach && (!picked || score < best)) {
          picked = stroke.part;
          best = score;
        }
      }
      previous = projected;
    }
  }
  return picked;
}

}  // namespace knotwork::web
