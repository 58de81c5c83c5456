#include "web/figure_panel.h"

#include <array>

#include "knotwork/scene/later.h"
#include "web/blending_curve_panel.h"
#include "web/blending_panel.h"
#include "web/curve_panel.h"
#include "web/fit_panel.h"
#include "web/model_curve_panel.h"
#include "web/model_panel.h"
#include "web/net_panel.h"
#include "web/subdivision_panel.h"

namespace knotwork::web {

float place_readout(Frame& frame, float left, float y, const SurfacePlace& place, float below, float share) {
  const Theme& theme = frame.input.theme;
  if (frame.ui.touch)
    ImGui::GetWindowDrawList()->AddRectFilled({left - 8, y - 14}, {left + 208, y + 4 * 20 - 6 + below},
                                              colour(theme.stage, 0.86F * share), 8);
  const auto pair = [&](Face face, const Colour& ink, const std::string& first, const std::string& second) {
    text(frame.ui, face, {left, y}, colour(ink, share), as_is(first));
    text(frame.ui, face, {left + 84, y}, colour(ink, share), as_is(second));
    y += 20;
  };
  pair(Face::bold, theme.ink, "u " + text_of("%.3f", place.u), "v " + text_of("%.3f", place.v));
  constexpr std::array<std::string_view, 3> axes{"x ", "y ", "z "};
  for (int axis = 0; axis < 3; ++axis)
    text(frame.ui, Face::regular, {left + 68 * static_cast<float>(axis), y}, colour(theme.ink_soft, share),
         as_is(std::string(axes[static_cast<std::size_t>(axis)]) + text_of("%.2f", place.point[axis])));
  y += 20;
  const SurfaceCurvature& curved = place.curved;
  pair(Face::regular, theme.ink_soft, "K " + text_of("%.3f", curved.gaussian), "H " + text_of("%.3f", curved.mean));
  pair(Face::regular, theme.ink_soft, "k₁ " + text_of("%.3f", curved.k_max), "k₂ " + text_of("%.3f", curved.k_min));
  return y + 2;
}

Sentence size_text(const Frame& frame) {
  return scene::visit_first([&](const auto& figure) { return size_text(frame, figure); }, frame.input.figure);
}

Tools tools_of(const Frame& frame) {
  return scene::visit_first([&](const auto& figure) { return tools_of(frame, figure); }, frame.input.figure);
}

void draw_rows(Frame& frame, Column& column) {
  scene::visit_first([&](const auto& figure) { draw_rows(frame, column, figure); }, frame.input.figure);
}

bool has_table(const Frame& frame) {
  return scene::visit_first([](const auto& figure) { return has_table(figure); }, frame.input.figure);
}

void draw_table(Frame& frame, Column& column) {
  scene::visit_first([&](const auto& figure) { draw_table(frame, column, figure); }, frame.input.figure);
}

float strip_height(const Frame& frame) {
  return scene::visit_first([&](const auto& figure) { return strip_height(frame, figure); }, frame.input.figure);
}

void draw_strip(Frame& frame, const Rect& place) {
  scene::visit_first([&](const auto& figure) { draw_strip(frame, place, figure); }, frame.input.figure);
}

void draw_readout(Frame& frame, float left, float y) {
  scene::visit_first([&](const auto& figure) { draw_readout(frame, left, y, figure); }, frame.input.figure);
}

}  // namespace knotwork::web
