#include "web/main.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <cmath>
#include <memory>

#include "web/language.h"

// The page's wish to be told; see bridge.h.
// clang-format off
EM_JS(void, knotwork_frame_needed, (), {
  if (Module["onFrameNeeded"]) Module["onFrameNeeded"]();
});
EM_JS(void, knotwork_log, (const char* text), {
  console.error(UTF8ToString(text));
});
EM_JS(int, knotwork_language, (), {
  return Module["hear"] ? 2 : Module["say"] ? 1 : 0;
});
EM_JS(void, knotwork_say, (const char* english, char* words, int size), {
  stringToUTF8(Module["say"](UTF8ToString(english)), words, size);
});
EM_JS(void, knotwork_hear, (const char* words, int size), {
  Module["hear"](UTF8ToString(words, size));
});
// clang-format on

namespace knotwork::web {
namespace {

struct Platform {
  std::unique_ptr<App> app;
  std::string canvas;
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
};
Platform platform;  // NOLINT: the one global, at the platform's boundary

std::string attach() {
  if (emscripten_webgl_make_context_current(platform.context) != EMSCRIPTEN_RESULT_SUCCESS)
    return "WebGL2 is not available.";
  std::string log = platform.app->attach_context();
  if (!log.empty()) knotwork_log(log.c_str());
  return log;
}

/// A language other than English is the page's; what is longer than a kilobyte is cut between characters.
KNOTWORK_LATER std::string ask_page(const std::string& english) {
  std::string words(1024, '\0');
  knotwork_say(english.c_str(), words.data(), static_cast<int>(words.size()));
  words.resize(words.find('\0'));
  return words;
}

KNOTWORK_LATER void tell_page(std::string_view words) { knotwork_hear(words.data(), static_cast<int>(words.size())); }

}  // namespace

App* app() { return platform.app.get(); }

std::string start(const char* canvas_selector) {
  platform.canvas = canvas_selector;
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.minorVersion = 0;
  attributes.alpha = EM_FALSE;
  attributes.depth = EM_TRUE;
  attributes.stencil = EM_FALSE;
  attributes.antialias = EM_TRUE;
  attributes.enableExtensionsByDefault = EM_FALSE;
  platform.context = emscripten_webgl_create_context(platform.canvas.c_str(), &attributes);
  if (platform.context <= 0) return "WebGL2 is not available.";
  if (emscripten_webgl_make_context_current(platform.context) != EMSCRIPTEN_RESULT_SUCCESS)
    return "WebGL2 is not available.";
  if (const int kind = knotwork_language()) translate_by(ask_page, kind > 1 ? tell_page : nullptr);
  platform.app = std::make_unique<App>();
  return attach();
}

bool context_changed(bool present) {
  if (!platform.app) return false;
  if (!present) {
    platform.app->lose_context();
    return false;
  }
  if (!attach().empty()) return false;
  ask_for_frame();
  return true;
}

void resize(double css_width, double css_height, double pixel_ratio) {
  if (!platform.app || !(css_width > 0) || !(css_height > 0) || !(pixel_ratio > 0)) return;
  emscripten_set_canvas_element_size(platform.canvas.c_str(), static_cast<int>(std::lround(css_width * pixel_ratio)),
                                     static_cast<int>(std::lround(css_height * pixel_ratio)));
  platform.app->resize(css_width, css_height, pixel_ratio);
  ask_for_frame();
}

void ask_for_frame() {
  if (platform.app && platform.app->wants_frame()) knotwork_frame_needed();
}

}  // namespace knotwork::web

int main() { return 0; }
