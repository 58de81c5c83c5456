#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "knotwork/scene/history.h"
#include "web/interaction.h"
#include "web/vectors.h"

namespace knotwork::web {

/// The edit of a patch in the document, the identity if it has none.
inline scene::PatchEdit edit_of(const scene::BlendingSurfaceObject& object, scene::PatchIndex patch) {
  const auto found = object.edits.find(patch);
  return found == object.edits.end() ? scene::PatchEdit{} : found->second;
}

/// A reader before the stage: sends events and lets their outcomes happen to a document, as the page does.
struct Reader {
  scene::Document document;
  scene::History history;
  InteractionState state;
  Viewport viewport{805, 900, 1, 0, 0, 300, 60};
  View view;
  mutable Figure figure;
  scene::Shape shown;  ///< what the figure was made from
  std::vector<Handle> handles;
  bool frame_each_event = true;  ///< false: events come faster than frames
  bool gesture_open = false;
  double now = 1000;
  PointerDevice device = PointerDevice::mouse;
  Modifiers modifiers;
  int undone = 0, redone = 0, framed = 0, play_toggled = 0;
  std::string notice;

  explicit Reader(scene::Document start = standard_document())
      : document(std::move(start)),
        view(make_view(document.camera, viewport)),
        figure(make_figure(scene::stage_shape(document), document.animation)) {
    draw();
  }

  static scene::Document standard_document() {
    scene::Document document;
    document.objects.push_back({"surface", "Blending surface", scene::BlendingSurfaceObject{}});
    return document;
  }

  BlendingSurface& surface() const { return std::get_if<BlendingFigure>(&figure)->surface; }
  scene::BlendingSurfaceObject& object() { return scene::blending_surface(document); }

  /// A frame: what follows from the document is made anew. The net stays: a pick is polished on the true surface.
  void draw() {
    view = make_view(document.camera, viewport);
    surface() = scene::build_surface(object(), document.animation);
    shown = scene::stage_shape(document);
    handles.clear();
    for (int i = 0; i < object().locals_u; ++i) {
      for (int j = 0; j < object().locals_v; ++j) {
        Handle handle{{i, j}, to_glm(scene::patch_origin(surface(), {i, j})), std::nullopt, false};
        handle.screen = view.project(handle.position);
        const glm::dvec3 normal = to_glm_matrix(scene::patch_frame(surface(), handle.index))[2];
        handle.hidden = glm::dot(normal, view.eye - handle.position) < 0;
        handles.push_back(handle);
      }
    }
  }

  Stage stage() const { return {document, figure, shown, view, handles}; }

  Outcome happen(Outcome outcome) {
    if (outcome.begin_gesture) {
      CHECK_FALSE(gesture_open);
      gesture_open = true;
      history.begin_gesture();
    }
    for (const scene::Command& command : outcome.commands) CHECK(history.perform(document, command).has_value());
    if (outcome.end_gesture || outcome.cancel_gesture) {
      CHECK(gesture_open);
      CHECK_FALSE((outcome.end_gesture && outcome.cancel_gesture));
      gesture_open = false;
      outcome.end_gesture ? history.end_gesture() : history.cancel_gesture(document);
    }
    if (outcome.undo) history.undo(document), ++undone;
    if (outcome.redo) history.redo(document), ++redone;
    framed += outcome.frame_all ? 1 : 0;
    play_toggled += outcome.toggle_play ? 1 : 0;
    if (!outcome.notice.empty()) notice = outcome.notice;
    if (frame_each_event) draw();
    return outcome;
  }

  Outcome send(PointerType type, glm::dvec2 at, int id = 1, int button = 0) {
    now += 8;
    return happen(pointer(state, stage(), {type, id, device, at, button, modifiers, now}));
  }
  Outcome down(glm::dvec2 at, int id = 1, int button = 0) { return send(PointerType::down, at, id, button); }
  Outcome move(glm::dvec2 at, int id = 1) { return send(PointerType::move, at, id, -1); }
  Outcome up(glm::dvec2 at, int id = 1) { return send(PointerType::up, at, id); }
  void tap(glm::dvec2 at) { down(at), up(at); }
  void drag(glm::dvec2 from, glm::dvec2 to, int steps = 10) {
    down(from);
    for (int k = 1; k <= steps; ++k) move(from + (to - from) * (1.0 * k / steps));
    up(to);
  }
  Outcome press(const std::string& name, bool is_down = true) {
    return happen(key(state, stage(), {is_down, name, modifiers}));
  }
  void type(const std::string& name) { press(name), press(name, false); }
  Outcome roll(double delta, glm::dvec2 at) { return happen(wheel(state, stage(), {{0, delta}, at, modifiers})); }

  /// Where the document has a handle now, whether or not a frame has come since.
  glm::dvec3 origin(scene::PatchIndex patch) {
    return to_glm(scene::patch_origin(scene::build_surface(object(), document.animation), patch));
  }
  glm::dvec2 at(scene::PatchIndex patch) {
    const auto screen = make_view(document.camera, viewport).project(origin(patch));
    REQUIRE(screen.has_value());
    return glm::dvec2(*screen);
  }
  bool selected(scene::PatchIndex patch) const { return state.selected == patch; }
  scene::PatchEdit edit(scene::PatchIndex patch) { return edit_of(object(), patch); }

  /// A visible handle well inside the free area.
  scene::PatchIndex visible_handle(int skip = 0) const {
    const FreeArea area = free_area(viewport);
    for (const Handle& handle : handles) {
      if (!handle.screen || handle.hidden) continue;
      const glm::dvec2 off = glm::abs(glm::dvec2(*handle.screen) - area.centre);
      if (off.x < 0.45 * area.size.x && off.y < 0.45 * area.size.y && skip-- == 0) return handle.index;
    }
    FAIL("no visible handle");
    return {0, 0};
  }
  /// A place on the stage without a handle, off the surface.
  glm::dvec2 empty_place() const { return {6, 6}; }
};

}  // namespace knotwork::web
