#include "web/bridge.h"

#include <emscripten.h>

#include <array>
#include <string>

#include "web/main.h"
#include "web/script_interface.h"
#include "web/version.h"

using namespace knotwork;       // NOLINT: a border file that is nothing but calls
using namespace knotwork::web;  // NOLINT

namespace {

std::string last_answer;  // NOLINT: lives until the next call, as bridge.h says

const char* give(std::string answer) {
  last_answer = std::move(answer);
  ask_for_frame();
  return last_answer.c_str();
}

const char* no_app() { return give(R"({"error":{"message":"The stage has not been started.","path":""}})"); }

Modifiers modifiers_from(int bits) { return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0}; }

int used(bool event_used) {
  ask_for_frame();
  return event_used ? 1 : 0;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE bool knotwork_start(const char* canvas_selector) {
  const bool started = start(canvas_selector).empty();
  if (started) ask_for_frame();
  return started;
}

EMSCRIPTEN_KEEPALIVE void knotwork_font(const std::uint8_t* bytes, int size, int weight) {
  if (app() == nullptr || size <= 0) return;
  app()->set_font(weight, std::vector<std::uint8_t>(bytes, bytes + size));
  ask_for_frame();
}

EMSCRIPTEN_KEEPALIVE void knotwork_resize(double css_width, double css_height, double pixel_ratio) {
  resize(css_width, css_height, pixel_ratio);
}

EMSCRIPTEN_KEEPALIVE void knotwork_scheme(bool dark) {
  if (app() == nullptr) return;
  app()->set_scheme(dark);
  ask_for_frame();
}

EMSCRIPTEN_KEEPALIVE void knotwork_reduced_motion(bool reduced) {
  if (app() == nullptr) return;
  app()->set_reduced_motion(reduced);
  ask_for_frame();
}

EMSCRIPTEN_KEEPALIVE void knotwork_complete() {
  if (app() == nullptr) return;
  app()->allow_fitted_grids();
  ask_for_frame();
}

EMSCRIPTEN_KEEPALIVE bool knotwork_context(bool present) { return context_changed(present); }

EMSCRIPTEN_KEEPALIVE bool knotwork_frame(double now) { return app() != nullptr && app()->frame(now); }

EMSCRIPTEN_KEEPALIVE int knotwork_pointer(int type, int id, int device, double x, double y, int button, int modifiers,
                                          double time) {
  if (app() == nullptr || type < 0 || type > 4 || device < 0 || device > 2) return 0;
  return used(app()->pointer({static_cast<PointerType>(type),
                              id,
                              static_cast<PointerDevice>(device),
                              {x, y},
                              button,
                              modifiers_from(modifiers),
                              time}));
}

EMSCRIPTEN_KEEPALIVE int knotwork_wheel(double delta_x, double delta_y, double x, double y, int modifiers) {
  return app() == nullptr ? 0 : used(app()->wheel({{delta_x, delta_y}, {x, y}, modifiers_from(modifiers)}));
}

EMSCRIPTEN_KEEPALIVE int knotwork_key(bool down, const char* key, int modifiers) {
  return app() == nullptr ? 0 : used(app()->key({down, key, modifiers_from(modifiers)}));
}

EMSCRIPTEN_KEEPALIVE void knotwork_focus(bool focused) {
  if (app() == nullptr) return;
  app()->focus(focused);
  ask_for_frame();
}

EMSCRIPTEN_KEEPALIVE const char* knotwork_cursor() { return app() == nullptr ? "default" : app()->cursor(); }

EMSCRIPTEN_KEEPALIVE const char* knotwork_version() { return version; }

EMSCRIPTEN_KEEPALIVE const char* knotwork_document() {
  return app() == nullptr ? no_app() : give(answer_document(*app()));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_load(const char* json) {
  return app() == nullptr ? no_app() : give(answer_load(*app(), json));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_parameters() {
  return app() == nullptr ? no_app() : give(answer_parameters(*app()));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_set_number(const char* id, double value) {
  return app() == nullptr ? no_app() : give(answer_set(*app(), id, value));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_set_choice(const char* id, const char* value) {
  return app() == nullptr ? no_app() : give(answer_set(*app(), id, std::string(value)));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_set_toggle(const char* id, bool value) {
  return app() == nullptr ? no_app() : give(answer_set(*app(), id, value));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_handles() {
  return app() == nullptr ? no_app() : give(answer_handles(*app()));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_widgets() {
  return app() == nullptr ? no_app() : give(answer_widgets(*app()));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_evaluate_curve(const char* object, double t, int order) {
  return app() == nullptr ? no_app() : give(answer_evaluate(*app(), object, std::array{t}, order));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_evaluate_surface(const char* object, double u, double v, int order) {
  return app() == nullptr ? no_app() : give(answer_evaluate(*app(), object, std::array{u, v}, order));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_play(bool playing) {
  return app() == nullptr ? no_app() : give(answer_play(*app(), playing));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_seek(double seconds) {
  return app() == nullptr ? no_app() : give(answer_seek(*app(), seconds));
}
EMSCRIPTEN_KEEPALIVE void knotwork_gesture(bool open) {
  if (app() != nullptr) app()->gesture(open);
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_undo() { return app() == nullptr ? no_app() : give(answer_undo(*app())); }
EMSCRIPTEN_KEEPALIVE const char* knotwork_redo() { return app() == nullptr ? no_app() : give(answer_redo(*app())); }
EMSCRIPTEN_KEEPALIVE const char* knotwork_stats() { return app() == nullptr ? no_app() : give(answer_stats(*app())); }
EMSCRIPTEN_KEEPALIVE const char* knotwork_chapters() { return give(answer_chapters()); }
EMSCRIPTEN_KEEPALIVE const char* knotwork_open(const char* chapter) {
  return app() == nullptr ? no_app() : give(answer_open(*app(), chapter));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_state() { return app() == nullptr ? no_app() : give(answer_state(*app())); }
EMSCRIPTEN_KEEPALIVE double knotwork_revision() { return app() == nullptr ? 0 : app()->revision(); }
EMSCRIPTEN_KEEPALIVE const char* knotwork_select(const char* handle) {
  return app() == nullptr ? no_app() : give(answer_select(*app(), handle));
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_points(const char* text) {
  return app() == nullptr ? no_app() : give(answer_points(*app(), text));
}
EMSCRIPTEN_KEEPALIVE bool knotwork_enter_scene(const char* name) {
  const bool known = app() != nullptr && app()->enter_scene(name);
  ask_for_frame();
  return known;
}
EMSCRIPTEN_KEEPALIVE const char* knotwork_measure(const char* name) {
  return app() == nullptr ? no_app() : give(answer_measure(*app(), name));
}
EMSCRIPTEN_KEEPALIVE void knotwork_begin_scene(bool again) {
  if (app() != nullptr) app()->begin_scene(again);
}
}
