#include "web/panel_frame.h"

#include "web/figure_panel.h"

namespace knotwork::web {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav;

}  // namespace

float Frame::foot() const {
  const float strip = strip_height(*this);
  return strip + (has_clock() ? clock_height : ui.touch && strip > 0 ? 0.0F : tools_height);
}

void claim(Frame& frame, const Rect& rect) {
  frame.output.regions.push_back({rect.x, rect.y, rect.width, rect.height});
}

void begin(Frame& frame, const char* name, const Rect& rect, ImGuiWindowFlags flags) {
  if (!(flags & ImGuiWindowFlags_NoInputs)) claim(frame, rect);
  ImGui::SetNextWindowPos(rect.min());
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::Begin(name, nullptr, plain | flags);
  sharpen(frame.ui, *ImGui::GetWindowDrawList());
}

void take_gesture(Frame& frame) {
  frame.output.begin_gesture = true;
  frame.state.slider_held = true;
}

void end_gesture(Frame& frame) {
  if (!frame.state.slider_held) return;
  frame.output.end_gesture = true;
  frame.state.slider_held = false;
}

}  // namespace knotwork::web
