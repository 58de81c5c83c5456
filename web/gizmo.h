#pragma once

#include <optional>
#include <vector>

#include "knotwork/scene/surface_builder.h"
#include "web/camera.h"

namespace knotwork::web {

/// The parts of the gizmo round the selected handle: rings turn about the patch's own axes (u, v, normal), knobs scale
/// along u and v, the outer knob scales evenly, the arrow moves along the normal.
enum class GizmoPart : unsigned char { turn_u, turn_v, turn_normal, scale_u, scale_v, scale_all, move_normal };

/// The gizmo as strokes for the renderer and targets for picking; its size is constant on the screen.
struct GizmoStroke {
  GizmoPart part;
  std::vector<glm::dvec3> points;  ///< a polyline in model space; a knob is a single point
  double radius = 0;               ///< of a knob, CSS pixels; 0 for a line
};
struct Gizmo {
  glm::dvec3 origin;
  glm::dmat3 axes;  ///< columns: the patch's own u, v and normal direction as turned by its edit, unit
  double size;      ///< ring radius in model units
  std::vector<GizmoStroke> strokes;
};

/// The gizmo of one patch; ring radius about 46 CSS pixels.
Gizmo make_gizmo(const BlendingSurface& surface, const scene::BlendingSurfaceObject& object, scene::PatchIndex patch,
                 const View& view);
/// The part under a screen position, nearest first, within `reach` CSS pixels (larger for touch).
std::optional<GizmoPart> pick_gizmo(const Gizmo& gizmo, const View& view, glm::dvec2 screen, double reach);

}  // namespace knotwork::web
