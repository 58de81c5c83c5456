#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "knotwork/later.h"
#include "knotwork/scene/commands.h"
#include "web/freehand.h"
#include "web/gizmo.h"
#include "web/holding.h"
#include "web/input.h"

namespace knotwork::web {

/// What the reader holds, hovers over and has selected.
struct InteractionState {
  std::optional<HandleIndex> selected, hovered;
  std::optional<HandleIndex> selected_before;  ///< the present drag; a pinch that it turns out to be restores it
  std::optional<GizmoPart> hovered_part;
  std::optional<Insertion> insertion;  ///< where a press would add a point to the control polygon
  /// The place under the resting pointer, for the probe; on touch, the place tapped last: (u, v), of a curve (t, 0).
  std::optional<glm::dvec2> probe;

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
  enum class Drag : unsigned char { none, handle, gizmo, orbit, pan, pinch, draw, rest };
  Drag drag = Drag::none;
  int drag_pointer = -1, second_pointer = -1;  ///< the second of a pinch
  glm::dvec3 pinched{0};                       ///< the place in the model that a pinch keeps between its fingers
  GizmoPart drag_part = GizmoPart::turn_normal;
  Held held;                  ///< of a handle or gizmo drag
  bool drawing = false;       ///< the next drag draws the figure's points
  Stroke stroke;              ///< of a draw drag
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
  bool frame_all = false;  ///< double click: bring the whole figure into view
  bool redraw = false;
  bool used = false;   ///< the page should not act on the event too
  std::string notice;  ///< for the live region: "Patch 2, 1 selected"
};

Outcome pointer(InteractionState& state, const Stage& stage, const PointerEvent& event);
/// Only with Ctrl or Meta held: zooms about the pointer. A plain wheel belongs to the page.
Outcome wheel(InteractionState& state, const Stage& stage, const WheelEvent& event);
/// Arrows move the selected handle a little in the view plane (Shift: finer; Page Up/Down along the patch's normal or z),
/// `[` and `]` select the neighbour, D makes the next drag draw the figure's points, Delete puts a patch back or deletes a point, Insert adds one after it, Escape cancels a drag or the selection, + - zoom, 0 or Home
/// frames, Space plays and pauses, Ctrl+Z / Ctrl+Shift+Z / Ctrl+Y undo and redo. Tab is never used.
KNOTWORK_LATER Outcome key(InteractionState& state, const Stage& stage, const KeyEvent& event);

/// For a frame of the animation: what is held stays under the resting pointer while its patch moves.
Outcome hold(const InteractionState& state, const Stage& stage);
/// The stage lost the focus: keys that are down will not be seen going up.
Outcome blur(InteractionState& state);
/// Selects a handle or (nothing) none, as by a click; used by the page's own controls.
Outcome select(InteractionState& state, const Stage& stage, std::optional<HandleIndex> patch);

/// A CSS cursor for the present state.
const char* cursor(const InteractionState& state);

}  // namespace knotwork::web
