#include "web/interaction.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "knotwork/scene/curve_edits.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

using Drag = InteractionState::Drag;

// CSS pixels and milliseconds. A finger covers what it points at, so it reaches farther than a mouse.
struct Reach {
  double handle, gizmo, moved, polygon, curve;
  double core;  ///< so near to the selected handle its gizmo's edge-on rings give way to it
};
constexpr Reach fine{12, 8, 3, 6, 14, 9}, coarse{24, 18, 6, 0, 24, 16};
constexpr double double_tap_time = 350, double_tap_reach = 24;
// A second finger within this time of the first movement means that a pinch was wanted all along.
constexpr double just_begun = 500;
constexpr double least_spread = 8;  // between two fingers; nearer, their quotient is noise
constexpr double nudge = 8, fine_nudge = 1;
constexpr double key_zoom = 1.2;

// A wheel's notch (100 pixels or more) zooms by exp(0.0022 delta); the small steps of a trackpad's pinch by the factor
// that browsers themselves use for it. Between them the exponent stands still, so that it never falls.
constexpr double wheel_rate = 0.0022, pinch_rate = 0.01, notch = 100, largest_exponent = 0.6;

const Reach& reach(PointerDevice device) { return device == PointerDevice::touch ? coarse : fine; }

/// No stage is a million pixels wide: such an event is as broken as one with a NaN.
bool usable(glm::dvec2 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::abs(v.x) < 1e6 && std::abs(v.y) < 1e6;
}

std::string name_of(const Stage& stage, HandleIndex index) { return handle_name(stage.shape(), index); }

const char* deed(const InteractionState& state) {
  if (state.drag != Drag::gizmo || state.drag_part == GizmoPart::move_normal) return " moved";
  return turns(state.drag_part) ? " turned" : " scaled";
}

bool holds_something(const InteractionState& state) { return state.drag == Drag::handle || state.drag == Drag::gizmo; }

/// The camera's view as the document has it now; several events may come between two frames.
View present_view(const Stage& stage) { return make_view(stage.document.camera, stage.view.viewport); }

void set_camera(Outcome& outcome, const Stage& stage, const scene::Camera& camera) {
  if (camera == stage.document.camera) return;
  outcome.commands.emplace_back(scene::SetCamera{camera});
  outcome.redraw = true;
}

void perform(Outcome& outcome, const Commands& commands) {
  outcome.commands.insert(outcome.commands.end(), commands.begin(), commands.end());
  outcome.redraw = outcome.redraw || !commands.empty();
}

void end_nudge(InteractionState& state, Outcome& outcome) {
  outcome.end_gesture = outcome.end_gesture || state.nudging;
  state.nudging = false;
}

/// Lets go of what is held: its gesture ends, or is taken back. The pointer may still be down.
void let_go(InteractionState& state, const Stage& stage, Outcome& outcome, bool cancelled) {
  if (state.gesture_open) {
    (cancelled ? outcome.cancel_gesture : outcome.end_gesture) = true;
    if (!cancelled) outcome.notice = name_of(stage, handle_of(state.held)) + deed(state);
  }
  state.gesture_open = false;
  outcome.redraw = true;
}

void stop_drawing(InteractionState& state, Outcome& outcome) {
  state.drawing = false;
  state.stroke.clear();
  outcome.redraw = true;
}

/// Handles may have gone since the last event, by another number of local surfaces or another document.
void forget_missing(InteractionState& state, const Stage& stage, Outcome& outcome) {
  if (holds_something(state) && !exists(stage, state.held)) {
    let_go(state, stage, outcome, false);
    outcome.notice.clear();
    state.drag = Drag::rest;
  }
  if (state.selected && !exists(stage, *state.selected)) {
    end_nudge(state, outcome);
    state.selected.reset();
    state.hovered_part.reset();
    outcome.redraw = true;
  }
  if (state.drawing && !takes_list(stage)) stop_drawing(state, outcome);
  if (state.hovered && !exists(stage, *state.hovered)) {
    state.hovered.reset();
    outcome.redraw = true;
  }
}

struct Target {
  std::optional<GizmoPart> part;
  std::optional<HandleIndex> handle;
  std::optional<Insertion> insertion;
};

std::optional<HandleIndex> nearest_handle(const Stage& stage, glm::dvec2 position, double within) {
  const Handle* nearest = nullptr;
  double best = 0;
  for (const Handle& handle : stage.handles) {
    if (!handle.screen || !exists(stage, handle.index)) continue;
    const double distance = glm::length(glm::dvec2(*handle.screen) - position);
    if (distance > within) continue;
    if (!nearest || handle.hidden < nearest->hidden || (handle.hidden == nearest->hidden && distance < best)) {
      nearest = &handle;
      best = distance;
    }
  }
  return nearest ? std::optional(nearest->index) : std::nullopt;
}

Target target(const InteractionState& state, const Stage& stage, glm::dvec2 position, PointerDevice device) {
  if (!stage.document.display.handles || state.drawing) return {};
  const Reach& within = reach(device);
  if (const auto gizmo = state.selected ? gizmo_of(stage, *state.selected) : std::nullopt) {
    const std::optional<glm::dvec3> centre = stage.view.project(gizmo->origin);
    if (centre && glm::length(glm::dvec2(*centre) - position) <= within.core) return {{}, state.selected, {}};
    if (const auto part = pick_gizmo(*gizmo, stage.view, position, within.gizmo)) return {part, {}, {}};
  }
  if (const auto handle = nearest_handle(stage, position, within.handle)) return {{}, handle, {}};
  // A finger that wants to turn the view would too often come upon the polygon.
  const bool adds = device != PointerDevice::touch && adds_on_polygon(stage) && stage.document.display.polygon;
  return {{}, {}, adds ? insertion_at(stage, position, within.polygon) : std::nullopt};
}

std::optional<glm::dvec2> probed(const Stage& stage, glm::dvec2 position, PointerDevice device) {
  if (!path_of(stage.figure).empty()) {
    const std::optional<double> t = curve_parameter_at(stage, position, reach(device).curve);
    return t ? std::optional(glm::dvec2(*t, 0)) : std::nullopt;
  }
  const std::optional<scene::SurfaceHit> hit = stage.pick(stage.view.ray(position));
  return hit ? std::optional(glm::dvec2(hit->u, hit->v)) : std::nullopt;
}

void set_hover(InteractionState& state, Outcome& outcome, const Target& under, std::optional<glm::dvec2> probe) {
  const bool no_insertion = !state.insertion && !under.insertion;
  if (state.hovered == under.handle && state.hovered_part == under.part && state.probe == probe && no_insertion) return;
  state.hovered = under.handle;
  state.hovered_part = under.part;
  state.insertion = under.insertion;
  state.probe = probe;
  outcome.redraw = true;
}

void hover(InteractionState& state, const Stage& stage, Outcome& outcome, const PointerEvent& event) {
  if (event.device == PointerDevice::touch) return;
  set_hover(state, outcome, target(state, stage, event.position, event.device),
            probed(stage, event.position, event.device));
}

void change_selection(InteractionState& state, const Stage& stage, Outcome& outcome,
                      std::optional<HandleIndex> handle) {
  if (state.selected == handle) return;
  end_nudge(state, outcome);
  outcome.notice = handle ? name_of(stage, *handle) + " selected" : name_of(stage, *state.selected) + " let go";
  state.selected = handle;
  state.hovered_part.reset();
  outcome.redraw = true;
}

/// A press and release without a movement, away from handles and gizmo.
void tap(InteractionState& state, const Stage& stage, Outcome& outcome, const InteractionState::Pointer& pressed,
         double time) {
  const double pause = pressed.start_time - state.last_tap_time;
  if (state.last_tap && pause >= 0 && pause <= double_tap_time &&
      glm::length(pressed.start - *state.last_tap) <= double_tap_reach) {
    state.last_tap.reset();
    outcome.frame_all = outcome.redraw = true;
    return;
  }
  state.last_tap = pressed.start;
  state.last_tap_time = time;
  change_selection(state, stage, outcome, std::nullopt);
  // Fingers do not hover; where they tap is where they want to know.
  if (pressed.device == PointerDevice::touch)
    set_hover(state, outcome, {}, probed(stage, pressed.position, pressed.device));
}

/// A press on the control polygon: a new point, already in the hand, as one step of the history.
void add_point(InteractionState& state, const Stage& stage, Outcome& outcome, const Insertion& insertion,
               const PointerEvent& event) {
  outcome.begin_gesture = state.gesture_open = true;
  state.gesture_time = event.time;
  perform(outcome, {insertion.command});
  state.selected_before = state.selected;
  const std::optional<Landing> start = landing(stage, insertion);
  if (!start) {  // the reader is told why when the command is refused
    state.drag = Drag::rest;
    return;
  }
  state.selected = start->handle;
  state.drag = Drag::handle;
  const std::optional<glm::dvec3> screen = stage.view.project(start->position);
  const glm::dvec2 offset = screen ? event.position - glm::dvec2(*screen) : glm::dvec2(0);
  state.held = PointDrag{*state.selected, start->position, offset, event.position};
  set_hover(state, outcome, {{}, state.selected, {}}, state.probe);
  outcome.notice = name_of(stage, *state.selected) + " added";
}

void begin_drag(InteractionState& state, const Stage& stage, Outcome& outcome, const PointerEvent& event) {
  state.drag_pointer = event.id;
  state.drag = Drag::rest;
  if (event.button == 1 || event.button == 2) state.drag = Drag::pan;
  if (event.button != 0) return;
  if (state.drawing) {
    state.drag = Drag::draw;
    state.stroke = {event.position};
    outcome.redraw = true;
    return;
  }

  const Target under = target(state, stage, event.position, event.device);
  if (under.insertion) {
    add_point(state, stage, outcome, *under.insertion, event);
    return;
  }
  if (!under.part && !under.handle) {
    state.drag = event.modifiers.shift ? Drag::pan : Drag::orbit;
    return;
  }
  state.last_tap.reset();
  state.selected_before = state.selected;
  if (under.handle) change_selection(state, stage, outcome, under.handle);
  state.drag = under.part ? Drag::gizmo : Drag::handle;
  state.drag_part = under.part.value_or(state.drag_part);
  state.held = take_hold(stage, *state.selected, under.part, event.position);
  set_hover(state, outcome, under, state.probe);
  outcome.redraw = true;
}

/// What one sees at a place of the stage: the surface, or what lies as deep as the target.
glm::dvec3 seen_at(const Stage& stage, const View& view, glm::dvec2 position) {
  const scene::Ray ray = view.ray(position);
  if (const auto hit = stage.pick(ray)) return to_glm(hit->jet.s);
  const glm::dvec3 way = to_glm(ray.direction);
  return view.eye + stage.document.camera.distance / glm::dot(way, view.forward) * way;
}

void begin_pinch(InteractionState& state, const Stage& stage, Outcome& outcome, int first, const PointerEvent& event) {
  if (holds_something(state)) {
    const bool was_meant = !state.gesture_open || event.time - state.gesture_time <= just_begun;
    let_go(state, stage, outcome, was_meant);
    if (was_meant && state.selected != state.selected_before) {
      change_selection(state, stage, outcome, state.selected_before);
      outcome.notice.clear();
    }
  }
  state.stroke.clear();
  state.drag = Drag::pinch;
  state.drag_pointer = first;
  state.second_pointer = event.id;
  state.pinched = seen_at(stage, present_view(stage), 0.5 * (state.pointers.at(first).position + event.position));
  state.last_tap.reset();
}

void continue_pinch(const InteractionState& state, const Stage& stage, Outcome& outcome, int moved, glm::dvec2 before) {
  const glm::dvec2 now = state.pointers.at(moved).position;
  const glm::dvec2 other =
      state.pointers.at(moved == state.drag_pointer ? state.second_pointer : state.drag_pointer).position;
  const double factor =
      std::max(glm::length(now - other), least_spread) / std::max(glm::length(before - other), least_spread);
  const scene::Camera zoomed = zoom(stage.document.camera, factor, state.pinched);
  set_camera(outcome, stage, pan(zoomed, 0.5 * (now - before), make_view(zoomed, stage.view.viewport), state.pinched));
}

void drag_held(InteractionState& state, const Stage& stage, Outcome& outcome, const PointerEvent& event) {
  if (!state.gesture_open) {
    outcome.begin_gesture = true;
    state.gesture_open = true;
    state.gesture_time = event.time;
  }
  perform(outcome, drag_to(state.held, stage, event.position, event.modifiers.shift));
}

void move(InteractionState& state, const Stage& stage, Outcome& outcome, const PointerEvent& event) {
  InteractionState::Pointer& pointer = state.pointers.at(event.id);
  glm::dvec2 before = pointer.position;
  pointer.position = event.position;
  if (!pointer.moved) {
    const double way = glm::length(event.position - pointer.start);
    const double slack = reach(pointer.device).moved;
    if (way > slack) {
      pointer.moved = true;
      // What a tap may wander is taken off a camera's drag, which so begins without a jerk; a pinch counts from the start.
      if (state.drag != Drag::pinch) before = pointer.start + slack / way * (event.position - pointer.start);
    }
  }

  if (state.drag == Drag::pinch) {
    if (event.id == state.drag_pointer || event.id == state.second_pointer) {
      continue_pinch(state, stage, outcome, event.id, before);
    }
    return;
  }
  if (event.id != state.drag_pointer || !pointer.moved) return;
  if (holds_something(state)) {
    drag_held(state, stage, outcome, event);
  } else if (state.drag == Drag::draw) {
    draw_on(state.stroke, event.position);
    outcome.redraw = true;
  } else if (state.drag == Drag::orbit || state.drag == Drag::pan) {
    state.last_tap.reset();
    set_hover(state, outcome, {}, std::nullopt);
    const glm::dvec2 way = event.position - before;
    set_camera(outcome, stage,
               state.drag == Drag::orbit ? orbit(stage.document.camera, way, stage.view.viewport)
                                         : pan(stage.document.camera, way, present_view(stage)));
  }
}

/// The line is drawn: its points take the place of those there were, as one step of the history.
KNOTWORK_LATER void finish_stroke(InteractionState& state, const Stage& stage, Outcome& outcome, bool cancelled) {
  const View view = present_view(stage);
  std::vector<Eigen::Vector3d> points =
      drawn_points(state.stroke, view, to_glm(stage.document.camera.target), scene::curve_points(stage.shape()));
  stop_drawing(state, outcome);
  if (cancelled || points.size() < 2) return;
  perform(outcome, {scene::SetPoints{std::move(points)}});
}

/// A pointer goes: up, cancelled, or replaced by a second press whose release was lost.
void release(InteractionState& state, const Stage& stage, Outcome& outcome, int id, std::optional<double> tap_time,
             bool cancelled) {
  const InteractionState::Pointer pointer = state.pointers.at(id);
  state.pointers.erase(id);
  const bool one_of_pinch = state.drag == Drag::pinch && (id == state.drag_pointer || id == state.second_pointer);
  if (one_of_pinch) {
    state.drag = Drag::rest;
  } else if (id == state.drag_pointer && state.drag != Drag::pinch) {
    if (holds_something(state)) let_go(state, stage, outcome, cancelled);
    if (state.drag == Drag::draw) finish_stroke(state, stage, outcome, cancelled);
    if (state.drag == Drag::orbit && !pointer.moved && tap_time) tap(state, stage, outcome, pointer, *tap_time);
    state.drag = Drag::rest;
  }
  if (state.pointers.empty()) {
    state.drag = Drag::none;
    state.drag_pointer = state.second_pointer = -1;
  }
}

void press(InteractionState& state, const Stage& stage, Outcome& outcome, const PointerEvent& event) {
  end_nudge(state, outcome);
  if (state.pointers.contains(event.id)) release(state, stage, outcome, event.id, std::nullopt, false);
  const auto other = std::find_if(state.pointers.begin(), state.pointers.end(),
                                  [](const auto& entry) { return entry.second.device == PointerDevice::touch; });
  const bool second_finger = event.device == PointerDevice::touch && other != state.pointers.end();
  const int first = second_finger ? other->first : -1;
  const bool alone = state.pointers.empty();
  state.pointers[event.id] = {event.device, event.position, event.position, event.time, false};
  if (alone) {
    begin_drag(state, stage, outcome, event);
  } else if (second_finger && state.drag != Drag::pinch) {
    begin_pinch(state, stage, outcome, first, event);
  }
}

struct NudgeKey {
  std::string_view key;
  glm::dvec3 direction;  ///< right, up, along the normal
};
constexpr NudgeKey nudge_keys[] = {
    {"ArrowLeft", {-1, 0, 0}}, {"ArrowRight", {1, 0, 0}}, {"ArrowUp", {0, 1, 0}},
    {"ArrowDown", {0, -1, 0}}, {"PageUp", {0, 0, 1}},     {"PageDown", {0, 0, -1}},
};
const NudgeKey* find_nudge(std::string_view key) {
  const auto* found =
      std::find_if(std::begin(nudge_keys), std::end(nudge_keys), [key](const NudgeKey& row) { return row.key == key; });
  return found == std::end(nudge_keys) ? nullptr : found;
}

void nudge_selected(InteractionState& state, const Stage& stage, Outcome& outcome, const NudgeKey& row, bool finer) {
  outcome.begin_gesture = !state.nudging;
  state.nudging = true;
  perform(outcome, nudged(stage, *state.selected, (finer ? fine_nudge : nudge) * row.direction));
  outcome.notice = name_of(stage, *state.selected) + " moved";
}

void remove_selected(InteractionState& state, const Stage& stage, Outcome& outcome) {
  end_nudge(state, outcome);
  perform(outcome, removed(stage, *state.selected));
  if (outcome.commands.empty() && !local_of(stage, *state.selected)) return;
  const char* done = local_of(stage, *state.selected) ? " reset" : " deleted";
  outcome.notice = name_of(stage, *state.selected) + (outcome.commands.empty() ? " is as it was" : done);
}

void add_after_selected(InteractionState& state, const Stage& stage, Outcome& outcome) {
  const std::optional<Insertion> place = insertion_after(stage, *state.selected);
  if (!place) return;
  end_nudge(state, outcome);
  perform(outcome, {place->command});
  state.selected = place->handle;
  outcome.notice = name_of(stage, *state.selected) + " added";
}

void select_neighbour(InteractionState& state, const Stage& stage, Outcome& outcome, int step) {
  const HandleIndex next = neighbour(stage, state.selected, step);
  if (exists(stage, next)) change_selection(state, stage, outcome, next);
}

void zoom_about_target(Outcome& outcome, const Stage& stage, double factor) {
  set_camera(outcome, stage,
             zoom(stage.document.camera, factor, free_area(stage.view.viewport).centre, present_view(stage)));
}

void escape(InteractionState& state, const Stage& stage, Outcome& outcome) {
  if (state.drag != Drag::none && state.drag != Drag::rest) {
    if (holds_something(state)) let_go(state, stage, outcome, true);
    if (state.drag == Drag::draw) stop_drawing(state, outcome);
    state.drag = Drag::rest;
    outcome.used = true;
  } else if (state.drawing) {
    stop_drawing(state, outcome);
    outcome.notice = "Not drawing";
    outcome.used = true;
  } else if (state.nudging) {
    outcome.cancel_gesture = outcome.redraw = outcome.used = true;
    state.nudging = false;
  } else if (state.selected) {
    change_selection(state, stage, outcome, std::nullopt);
    outcome.used = true;
  }
}

/// Undo and redo; other shortcuts are the browser's.
void shortcut(InteractionState& state, Outcome& outcome, std::string_view key, bool shift) {
  const bool z = key == "z" || key == "Z", y = key == "y" || key == "Y";
  if (!z && !y) return;
  outcome.used = true;
  if (holds_something(state)) return;
  end_nudge(state, outcome);
  (z && !shift ? outcome.undo : outcome.redo) = true;
}

/// Keys that act on the selected handle; without one they are the page's.
void handle_key(InteractionState& state, const Stage& stage, Outcome& outcome, const KeyEvent& event) {
  if (const NudgeKey* row = find_nudge(event.key)) {
    nudge_selected(state, stage, outcome, *row, event.modifiers.shift);
    outcome.used = true;
  } else if (event.key == "Delete" || event.key == "Backspace") {  // what a Mac's keyboard calls delete
    remove_selected(state, stage, outcome);
    outcome.used = true;
  } else if (event.key == "Insert" && has_polygon(stage)) {
    add_after_selected(state, stage, outcome);
    outcome.used = true;
  }
}

void stage_key(InteractionState& state, const Stage& stage, Outcome& outcome, std::string_view key) {
  outcome.used = true;
  if (key == "[") {
    select_neighbour(state, stage, outcome, -1);
  } else if (key == "]") {
    select_neighbour(state, stage, outcome, 1);
  } else if ((key == "d" || key == "D") && takes_list(stage)) {
    state.drawing = !state.drawing;
    outcome.notice = state.drawing ? "Draw the points: press and drag on the stage" : "Not drawing";
    outcome.redraw = true;
  } else if (key == "+" || key == "=") {
    zoom_about_target(outcome, stage, key_zoom);
  } else if (key == "-" || key == "_") {
    zoom_about_target(outcome, stage, 1 / key_zoom);
  } else if (key == "0" || key == "Home") {
    outcome.frame_all = outcome.redraw = true;
  } else if (key == " ") {
    outcome.toggle_play = outcome.redraw = true;
  } else {
    outcome.used = false;
  }
}

/// Who comes closer comes closer to what is under the pointer, not to something behind it.
scene::Camera zoomed_at(const Stage& stage, double factor, glm::dvec2 position) {
  const View view = present_view(stage);
  if (factor > 1) return zoom(stage.document.camera, factor, seen_at(stage, view, position));
  return zoom(stage.document.camera, factor, position, view);
}

}  // namespace

Outcome pointer(InteractionState& state, const Stage& stage, const PointerEvent& event) {
  Outcome outcome;
  forget_missing(state, stage, outcome);
  const bool usable_event = usable(event.position) && std::isfinite(event.time);
  const bool known = state.pointers.contains(event.id);
  // Even without a usable position a pointer that goes must not stay down for ever.
  if (!usable_event && !(known && (event.type == PointerType::up || event.type == PointerType::cancel))) {
    return outcome;
  }

  switch (event.type) {
    case PointerType::down:
      press(state, stage, outcome, event);
      outcome.used = true;
      break;
    case PointerType::move:
      if (known) move(state, stage, outcome, event);
      if (!known && state.pointers.empty()) hover(state, stage, outcome, event);
      outcome.used = known;
      break;
    case PointerType::up:
      if (!known) break;
      if (usable_event && event.position != state.pointers.at(event.id).position) move(state, stage, outcome, event);
      release(state, stage, outcome, event.id, usable_event ? std::optional(event.time) : std::nullopt, false);
      if (usable_event && state.pointers.empty()) hover(state, stage, outcome, event);
      outcome.used = true;
      break;
    case PointerType::cancel:
      if (!known) break;
      release(state, stage, outcome, event.id, std::nullopt, true);
      outcome.used = true;
      break;
    case PointerType::leave:
      if (state.pointers.empty() && event.device != PointerDevice::touch) set_hover(state, outcome, {}, std::nullopt);
      break;
  }
  return outcome;
}

Outcome wheel(InteractionState& state, const Stage& stage, const WheelEvent& event) {
  Outcome outcome;
  forget_missing(state, stage, outcome);
  if (!(event.modifiers.control || event.modifiers.meta)) return outcome;
  if (!usable(event.position) || !usable(event.delta)) return outcome;
  const double way = std::abs(event.delta.y);
  const double exponent =
      std::min(std::max(std::min(pinch_rate * way, wheel_rate * notch), wheel_rate * way), largest_exponent);
  const double factor = std::exp(std::copysign(exponent, -event.delta.y));
  set_camera(outcome, stage, zoomed_at(stage, factor, event.position));
  outcome.used = true;
  return outcome;
}

Outcome key(InteractionState& state, const Stage& stage, const KeyEvent& event) {
  Outcome outcome;
  forget_missing(state, stage, outcome);
  if (!event.down) {
    if (state.nudging && find_nudge(event.key)) {
      end_nudge(state, outcome);
      outcome.used = true;
    }
    return outcome;
  }
  if (event.modifiers.alt) return outcome;
  if (event.modifiers.control || event.modifiers.meta) {
    shortcut(state, outcome, event.key, event.modifiers.shift);
    return outcome;
  }
  if (event.key == "Escape") {
    escape(state, stage, outcome);
    return outcome;
  }
  if (holds_something(state) && event.key != " ") {
    // A hand is on the patch: keys that would act on it wait, and the page must not scroll away under it either.
    outcome.used = event.key != "Tab" && event.key != "Shift";
    return outcome;
  }
  if (state.selected) handle_key(state, stage, outcome, event);
  if (!outcome.used) stage_key(state, stage, outcome, event.key);
  return outcome;
}

Outcome hold(const InteractionState& state, const Stage& stage) {
  Outcome outcome;
  if (!holds_something(state) || !state.gesture_open || !exists(stage, state.held)) return outcome;
  perform(outcome, hold_still(state.held, stage));
  return outcome;
}

Outcome blur(InteractionState& state) {
  Outcome outcome;
  end_nudge(state, outcome);
  return outcome;
}

Outcome select(InteractionState& state, const Stage& stage, std::optional<HandleIndex> patch) {
  Outcome outcome;
  forget_missing(state, stage, outcome);
  if (holds_something(state) || (patch && !exists(stage, *patch))) return outcome;
  change_selection(state, stage, outcome, patch);
  return outcome;
}

const char* cursor(const InteractionState& state) {
  switch (state.drag) {
    case Drag::handle:
    case Drag::gizmo:
    case Drag::orbit:
      return "grabbing";
    case Drag::pan:
    case Drag::pinch:
      return "move";
    case Drag::draw:
      return "crosshair";
    case Drag::none:
    case Drag::rest:
      break;
  }
  if (state.drawing) return "crosshair";
  return state.hovered || state.hovered_part ? "grab" : "default";
}

}  // namespace knotwork::web
