#include "web/stage_ornaments.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "knotwork/scene/palette.h"
#include "knotwork/surface/surface_measures.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr int most_hairs = 2400;  // more are a fur that hides the surface

Colour part_colour(GizmoPart part, const Theme& theme) {
  switch (part) {
    case GizmoPart::turn_u:
    case GizmoPart::scale_u:
      return theme.local[0];
    case GizmoPart::turn_v:
    case GizmoPart::scale_v:
      return theme.local[2];
    case GizmoPart::turn_normal:
    case GizmoPart::move_normal:
      return theme.accent;
    case GizmoPart::scale_all:
      return theme.ink_soft;
  }
  return theme.ink;
}

}  // namespace

Disc handle_disc(const Handle& handle, const Colour& hue, float radius, const InteractionState& state,
                 const Theme& theme) {
  const Colour white = theme.dark ? Colour{0.93F, 0.92F, 0.90F} : Colour{1, 1, 1};
  const Colour rim = mixed(hue, Colour{0, 0, 0}, theme.dark ? 0.0F : 0.12F);
  Disc disc{.centre = glm::vec3(handle.position),
            .radius = radius,
            .fill = to_glm(white, 1),
            .rim = to_glm(rim),
            .rim_width = std::min(2.4F, 0.4F * radius)};
  if (state.hovered == handle.index) disc.radius = std::max(radius * 1.35F, 6.0F);
  if (state.selected == handle.index) {
    disc.radius = std::max(radius * 1.3F, 7.5F);
    disc.fill = to_glm(theme.accent, 1);
    disc.rim = to_glm(white);
    disc.rim_width = 2.4F;
  }
  return disc;
}

void add_handles(Picture& picture, std::span<const Handle> handles, const scene::BlendingSurfaceObject& object,
                 const InteractionState& state) {
  const Theme& theme = picture.theme;
  // Many handles are drawn smaller, so that the surface is not buried under them.
  const float base = handles.size() > 1200 ? 2.2F : handles.size() > 300 ? 3.6F : handles.size() > 80 ? 5.0F : 6.5F;
  for (const Handle& handle : handles) {
    if (!handle.screen) continue;
    const Colour hue = scene::patch_hue(scene::patch_hue_index(object, handle.index), theme.dark);
    picture.discs.push_back(handle_disc(handle, hue, base, state, theme));
  }
}

void add_gizmo(Picture& picture, const BlendingSurface& surface, const scene::BlendingSurfaceObject& object,
               const InteractionState& state) {
  add_gizmo_strokes(picture, make_gizmo(surface, object, *state.selected, picture.view), state);
}

void add_gizmo_strokes(Picture& picture, const Gizmo& gizmo, const InteractionState& state) {
  const bool dragging = state.drag == InteractionState::Drag::gizmo;
  for (const GizmoStroke& stroke : gizmo.strokes) {
    const bool strong = dragging ? state.drag_part == stroke.part : state.hovered_part == stroke.part;
    if (dragging && !strong) continue;
    const Colour colour = part_colour(stroke.part, picture.theme);
    if (stroke.points.size() == 1) {
      const auto radius = static_cast<float>(stroke.radius) * (strong ? 1.3F : 1.0F);
      const Colour face = strong ? colour : picture.theme.paper;
      picture.overlay_discs.push_back(
          {glm::vec3(stroke.points.front()), radius, to_glm(face, 1), to_glm(colour), std::max(1.6F, 0.32F * radius)});
      continue;
    }
    const bool is_arrow = stroke.part == GizmoPart::move_normal;
    const float width = strong ? 3.4F : is_arrow ? 2.2F : 1.7F;
    const auto segments = static_cast<double>(stroke.points.size() - 1);
    for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k) {
      const glm::dvec3 middle = 0.5 * (stroke.points[k] + stroke.points[k + 1]);
      // The far half of a ring steps back, so that its tilt can be seen.
      const double depth = glm::dot(middle - gizmo.origin, picture.view.forward) / std::max(gizmo.size, 1e-12);
      const bool ring = segments > 8;
      const double near = ring ? std::clamp(0.5 - 0.9 * depth, 0.0, 1.0) : 1.0;
      const auto alpha = static_cast<float>(strong ? 0.55 + 0.45 * near : 0.28 + 0.62 * near);
      picture.overlay_ribbons.push_back(
          {glm::vec3(stroke.points[k]), glm::vec3(stroke.points[k + 1]), to_glm(colour, alpha), width});
    }
  }
}

void add_patch_frames(Picture& picture, const BlendingSurface& surface, const scene::BlendingSurfaceObject& object) {
  const std::array<Colour, 3> colours{picture.theme.local[0], picture.theme.local[2], picture.theme.accent};
  for (int i = 0; i < object.locals_u; ++i) {
    for (int j = 0; j < object.locals_v; ++j) {
      const Eigen::Vector3d origin = scene::patch_origin(surface, {i, j});
      // What M_ij does to the patch's own axes is the frame that carries it, scale and turn included.
      const Eigen::Matrix3d axes = surface.local(i, j).linear() * scene::patch_frame(surface, {i, j});
      const double length = 34 * picture.view.pixel_size(to_glm(origin));
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d tip = origin + length * axes.col(axis);
        picture.ribbons.push_back({glm::vec3(to_glm(origin)), glm::vec3(to_glm(tip)),
                                   to_glm(colours[static_cast<std::size_t>(axis)], 0.95F), 2.2F});
      }
    }
  }
}

void add_normals(Picture& picture, const KnottedSurface& surface) {
  const int cells_u = surface.knots_u->interval_count(), cells_v = surface.knots_v->interval_count();
  const int steps =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(most_hairs) / (cells_u * cells_v))), 1, 5);
  const SampleGrid grid =
      sample_grid(*surface.knots_u, *surface.knots_v, steps * cells_u, steps * cells_v, Seam::joined);
  std::vector<SurfaceJet> jets(grid.u.size() * grid.v.size());
  surface.evaluate_grid(grid.u, grid.v, jets);
  const Colour colour = picture.theme.ink;
  for (const SurfaceJet& jet : jets) {
    const glm::dvec3 foot = to_glm(jet.s);
    const double length = 20 * picture.view.pixel_size(foot);
    const glm::dvec3 tip = foot + length * to_glm(unit_normal(jet));
    picture.ribbons.push_back({glm::vec3(foot), glm::vec3(tip), to_glm(colour, 0.6F), 1.1F});
  }
}

void add_to_picture(Picture& picture, const BlendingFigure& figure, const Look& look) {
  const BlendingSurface& surface = figure.surface;
  const scene::BlendingSurfaceObject& object = scene::blending_surface(look.document);
  picture.surface = true;
  picture.locals_u = surface.knots_u().count();
  picture.locals_v = surface.knots_v().count();
  picture.sheets = sheet_directions(surface);
  picture.held = look.state.selected;
  picture.knot_period = {surface.knots_u().closed() ? static_cast<float>(picture.locals_u) : 0.0F,
                         surface.knots_v().closed() ? static_cast<float>(picture.locals_v) : 0.0F};
  if (picture.held) {
    const glm::vec2 held(static_cast<float>(picture.held->first), static_cast<float>(picture.held->second));
    picture.support = glm::vec4(held.x - 1, held.x + 1, held.y - 1, held.y + 1);
  }
  if (picture.display.frames) add_patch_frames(picture, surface, object);
  if (picture.display.normals) add_normals(picture, knotted_surface(surface));
  if (!picture.display.handles) return;
  add_handles(picture, look.handles, object, look.state);
  if (look.state.selected && !look.rolling) add_gizmo(picture, surface, object, look.state);
}

void add_rings(Picture& picture) {
  const glm::vec4 hollow(0);
  for (const Eigen::Vector3d& ring : picture.display.rings) {
    const glm::vec3 place(to_glm(ring));
    picture.overlay_discs.push_back({place, ring_radius, hollow, to_glm(picture.theme.paper), 5.5F});
    picture.overlay_discs.push_back({place, 11, hollow, to_glm(picture.theme.accent), 2.5F});
  }
}

Probe probe_at(const BlendingSurface& surface, double u, double v) {
  const SurfaceJet jet = surface.evaluate(u, v);
  const int span = surface.knots_u().span(surface.knots_u().reduced(u));
  const double w = translation_and_scaling(surface.knots_u(), 1, span, surface.knots_u().reduced(u));
  return {{u, v, jet.s, curvature(jet)}, surface.weights(u, v), w};
}

}  // namespace knotwork::web
