#pragma once

#include <optional>

#include "knotwork/scene/local_frame.h"
#include "web/camera.h"
#include "web/gizmo.h"

namespace knotwork::web {

/// What a drag looks at: the local patch or local curve as the document has it now, and the view.
struct LocalScene {
  scene::LocalFrame local;
  const View& view;
};

/// A local patch (i, j) or local curve (k, 0) held by its handle or by a part of its gizmo, and what the hold has come to so far.
struct PatchDrag {
  scene::PatchIndex patch{0, 0};
  std::optional<GizmoPart> part;  ///< nothing: the handle
  scene::PatchEdit edit_at_start;
  glm::dvec2 pointer_at_start{0}, pointer{0};

  // Moving: the handle's place, and the plane or line that it is moved in since the last change between the two.
  bool along_axis = false;
  bool axis_at_eye = false;  ///< the line runs into the eye: up and down on the screen stand for it
  glm::dvec3 axis{0, 0, 1}, anchor{0}, position{0};
  glm::dvec2 anchor_pointer{0};
  glm::dvec2 grab_offset{0};  ///< from the handle's screen position to the pointer, so that nothing jumps

  // Turning and scaling, in the gizmo's place at the start.
  glm::dvec3 origin{0};
  glm::dmat3 axes{1};
  double last_angle = 0, angle = 0;  ///< in the ring's plane; accumulated over full turns
  bool by_tangent = false;           ///< the ring is seen edge-on
  glm::dvec2 screen_axis{1, 0};      ///< unit; along which the pointer counts
  double screen_length = 1;          ///< CSS pixels: a radian of a ring, or from the origin to the pointer at the start
};

/// A hold that has not moved yet.
PatchDrag take_hold(const LocalScene& scene, scene::PatchIndex patch, std::optional<GizmoPart> part,
                    glm::dvec2 pointer);

/// The edit with the pointer there, the rest of it as the document has it. A handle moves in the plane through
/// it parallel to the screen, with Shift along the unturned normal; what the animation adds is made up for, so that the
/// handle stays under the pointer. Shift snaps turns to 15 degrees and scales to quarters. Where the pointer has no
/// meaning (beyond a vanishing point) the last place counts.
scene::PatchEdit drag_to(PatchDrag& drag, const LocalScene& scene, glm::dvec2 pointer, bool shift);

/// The edit with its handle moved by `offset` in model space; each coordinate stays in the document's limits.
scene::PatchEdit moved_by(const scene::LocalFrame& local, glm::dvec3 offset);

}  // namespace knotwork::web
