#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knotwork/scene/commands.h"
#include "knotwork/scene/surface_builder.h"
#include "web/camera.h"
#include "web/gizmo.h"
#include "web/input.h"
#include "web/patch_drag.h"

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

/// What an interaction looks at. Nothing in here is changed by it but the net, which is made when first needed: it costs
/// as much as a mesh. The document is up to date (the commands of the last outcome are applied before the next event);
/// surface, net, view and handles are those of the last frame.
struct Stage {
  const scene::Document& document;
  const BlendingSurface& surface;
  std::optional<scene::PickNet>& net;
  const View& view;
  std::span<const Handle> handles;

  std::optional<scene::SurfaceHit> pick(const scene::Ray& ray) const {
    if (!net) net.emplace(surface);
    return net->pick(surface, ray);
  }
};

/// What the reader holds, hovers over and has selected.
struct InteractionState {
  std::optional<scene::PatchIndex> selected, hovered;
  std::optional<scene::PatchIndex> selected_before;  ///< the present drag; a pinch that it turns out to be restores it
  std::optional<GizmoPart> hovered_part;
  /// The surface point under the resting pointer, for the probe; on touch, the point tapped last.
  std::optional<glm::dvec2> probe;  ///< (u, v)

  struct Pointer {
    PointerDevice device;
    glm::dvec2 position, start;
    double start_time;
    bool moved;  ///< farther than a tap may
  };
  std::map<int, Pointer> pointers;  ///< those that are down
  std::optional<glm::dvec2> last_tap;
  double last_tap_time = 0;

  /// `rest`: pointers are down that do nothing any more until all are up (after a pinch, after Escape).
  enum class Drag : unsigned char { none, handle, gizmo, orbit, pan, pinch, rest };
  Drag drag = Drag::none;
  int drag_pointer = -1, second_pointer = -1;  ///< the second of a pinch
  GizmoPart drag_part = GizmoPart::turn_normal;
  PatchDrag held;             ///< of a handle or gizmo drag
  bool gesture_open = false;  ///< the drag has begun its history entry
  double gesture_time = 0;    ///< when it did
  bool nudging = false;       ///< an arrow key is held down and its history entry open
};

/// What one event comes to, to be carried out in the order of the members: begin the gesture, perform the commands, end
/// or cancel the gesture, then the rest.
struct Outcome {
  bool begin_gesture = false;
  std::vector<scene::Command> commands;  ///< in order
  bool end_gesture = false, cancel_gesture = false;
  bool undo = false, redo = false, toggle_play = false;
  bool frame_all = false;  ///< double click: bring the whole surface into view
  bool redraw = false;
  bool used = false;   ///< the page should not act on the event too
  std::string notice;  ///< for the live region: "Patch 2, 1 selected"
};

Outcome pointer(InteractionState& state, const Stage& stage, const PointerEvent& event);
/// Only with Ctrl or Meta held: zooms about the pointer. A plain wheel belongs to the page.
Outcome wheel(InteractionState& state, const Stage& stage, const WheelEvent& event);
/// Arrows move the selected patch a little in the view plane (Shift: finer; Page Up/Down along the normal), `[` and `]`
/// select the neighbour, Delete resets the selected patch, Escape cancels a drag or the selection, + - zoom, 0 or Home
/// frames, Space plays and pauses, Ctrl+Z / Ctrl+Shift+Z / Ctrl+Y undo and redo. Tab is never used.
Outcome key(InteractionState& state, const Stage& stage, const KeyEvent& event);

/// For a frame of the animation: what is held stays under the resting pointer while its patch moves.
Outcome hold(const InteractionState& state, const Stage& stage);
/// The stage lost the focus: keys that are down will not be seen going up.
Outcome blur(InteractionState& state);
/// Selects a handle or (nothing) none, as by a click; used by the page's own controls.
Outcome select(InteractionState& state, const Stage& stage, std::optional<scene::PatchIndex> patch);

/// A CSS cursor for the present state.
const char* cursor(const InteractionState& state);

}  // namespace knotwork::web
