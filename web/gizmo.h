#pragma once

#include <optional>
#include <vector>

#include "knotwork/scene/surface_builder.h"
#include "web/camera.h"

namespace knotwork::web {

/// The parts of the gizmo round the selected handle: rings turn about the patch's own axes (u, v, normal), knobs scale
/// along u and v, the outer knob scales evenly, the arrow moves along the normal.
enum class GizmoPart : unsigned char { turn_u, turn_v, turn_normal, scale_u, scale_v, scale_all, move_normal };

/// The own axis that a part turns about, scales or moves along: 0 u, 1 v, 2 normal; scale_all has none and answers 2.
int gizmo_axis(GizmoPart part);
bool turns(GizmoPart part);
bool scales(GizmoPart part);

/// The gizmo as strokes for the renderer and targets for picking; its size is constant on the screen.
struct GizmoStroke {
  GizmoPart part;
  std::vector<glm::dvec3> points;  ///< a polyline in model space; a knob is a single point
  double radius = 0;               ///< of a knob, CSS pixels; 0 for a line
};
struct Gizmo {
  glm::dvec3 origin;
  glm::dmat3 axes;                   ///< columns: the patch's own u, v and normal direction as turned by its edit, unit
  double size;                       ///< ring radius in model units
  std::vector<GizmoStroke> strokes;  ///< none when the origin is behind the camera
};

inline constexpr double gizmo_radius = 46, knob_radius = 5;  ///< CSS pixels

/// The axes of a gizmo: those of the patch, turned by its edit.
glm::dmat3 gizmo_axes(const BlendingSurface& surface, const scene::BlendingSurfaceObject& object,
                      scene::PatchIndex patch);
/// The gizmo of a local patch or local curve. Three rings; everything else stands just outside of them, so that nothing lies over the
/// handle: knobs on short stems along u and v, the even knob on their diagonal, the arrow along the normal.
Gizmo make_gizmo(glm::dvec3 origin, const glm::dmat3& axes, const View& view);
/// That of one patch, where the surface has it.
Gizmo make_gizmo(const BlendingSurface& surface, const scene::BlendingSurfaceObject& object, scene::PatchIndex patch,
                 const View& view);
/// The part under a screen position, nearest first, within `reach` CSS pixels (larger for touch). Of parts that cross
/// on the screen the one in front wins, and a knob wins over a line.
std::optional<GizmoPart> pick_gizmo(const Gizmo& gizmo, const View& view, glm::dvec2 screen, double reach);

}  // namespace knotwork::web
