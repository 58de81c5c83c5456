#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knotwork/scene/commands.h"
#include "knotwork/scene/surface_builder.h"
#include "web/camera.h"
#include "web/gizmo.h"
#include "web/input.h"

namespace knotwork::web {

/// A handle as it stands on the stage: one a local patch, at its origin.
struct Handle {
  scene::PatchIndex patch;
  glm::dvec3 position;
  std::optional<glm::dvec3> screen;  ///< nothing when behind the camera
  bool hidden = false;               ///< something lies in front of it
};

/// "patch-2-1": the id of handles() in the script interface.
std::string handle_id(scene::PatchIndex patch);
std::optional<scene::PatchIndex> handle_patch(std::string_view id);

/// What an interaction looks at. Nothing in here is changed by it.
struct Stage {
  const scene::Document& document;
  const BlendingSurface& surface;
  const scene::PickNet& net;
  const View& view;
  std::span<const Handle> handles;
};

/// What the reader holds, hovers over and has selected.
struct InteractionState {
  std::optional<scene::PatchIndex> selected, hovered;
  std::optional<GizmoPart> hovered_part;
  /// The surface point under the resting pointer, for the probe.
  std::optional<glm::dvec2> probe;  ///< (u, v)

  struct Pointer {
    PointerDevice device;
    glm::dvec2 position, start;
    double start_time;
    bool moved;
  };
  std::map<int, Pointer> pointers;  ///< those that are down
  std::optional<glm::dvec2> last_tap;
  double last_tap_time = 0;

  enum class Drag : unsigned char { none, handle, gizmo, orbit, pan, pinch };
  Drag drag = Drag::none;
  int drag_pointer = -1;
  GizmoPart drag_part = GizmoPart::turn_normal;
  scene::PatchEdit edit_at_start;
  glm::dvec3 handle_at_start{0};
  glm::dvec2 grab_offset{0};  ///< from the handle's screen position to the pointer, so that nothing jumps
};

/// What one event comes to.
struct Outcome {
  std::vector<scene::Command> commands;  ///< in order
  bool begin_gesture = false, end_gesture = false, cancel_gesture = false;
  bool frame_all = false;  ///< double click: bring the whole surface into view
  bool redraw = false;
  bool used = false;       ///< the page should not act on the event too
  bool undo = false, redo = false, toggle_play = false;
  std::string notice;      ///< for the live region: "Patch 2, 1 selected"
};

Outcome pointer(InteractionState& state, const Stage& stage, const PointerEvent& event);
Outcome wheel(InteractionState& state, const Stage& stage, const WheelEvent& event);
/// Arrows move the selected patch a little in the view plane (Shift: finer; Page Up/Down along the normal), `[` and `]`
/// select the neighbour, Delete resets the selected patch, Escape cancels a drag or the selection, + - zoom, 0 or Home
/// frames, Space plays and pauses, Ctrl+Z / Ctrl+Shift+Z / Ctrl+Y undo and redo. Tab is never used.
Outcome key(InteractionState& state, const Stage& stage, const KeyEvent& event);

/// A CSS cursor for the present state.
const char* cursor(const InteractionState& state);

}  // namespace knotwork::web
