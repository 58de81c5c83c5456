#include "web/blending_curve_panel.h"

#include <algorithm>
#include <cmath>

#include "knotwork/scene/blending_curve_edits.h"
#include "web/blending_curve_ornaments.h"
#include "web/blending_panel.h"
#include "web/knot_strip.h"
#include "web/plot.h"

namespace knotwork::web {
namespace {

constexpr std::string_view words_reset_locals = "Put all local curves back";

std::optional<int> selected_local(const Frame& frame, const scene::BlendingCurveFigure& figure) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  const bool local = selected && *selected != parameter_handle && selected->first < figure.curve.knots().count();
  return local ? std::optional(selected->first) : std::nullopt;
}

}  // namespace

Sentence size_text(const Frame&, const scene::BlendingCurveFigure& figure) {
  return say("{} locals", figure.curve.knots().count());
}

Tools tools_of(const Frame& frame, const scene::BlendingCurveFigure&) {
  const auto* object = std::get_if<scene::BlendingCurveObject>(&frame.shape());
  return {{"reset", Icon::reset, object && !object->edits.empty(), words_reset_locals, scene::ResetLocals{}}};
}

void draw_rows(Frame& frame, Column& column, const scene::BlendingCurveFigure& figure) {
  const KnotVector& knots = figure.curve.knots();
  const double t = knots.reduced(frame.input.pointed ? frame.input.pointed->x : figure.t);
  const double w = translation_and_scaling(knots, 1, knots.span(t), t);
  // In the hues of the two locals at work, as everywhere else on the stage.
  const auto [first, second] = figure.curve.weights(t);
  const bool dark = frame.input.theme.dark;
  draw_blending_function(frame, column, figure.curve.blending(), w,
                         {local_hue(first.local, knots.count(), dark), local_hue(second.local, knots.count(), dark)});
}

float strip_height(const Frame& frame, const scene::BlendingCurveFigure&) {
  return std::clamp(0.22F * frame.stage.height, 108.0F, 190.0F);
}

void draw_strip(Frame& frame, const Rect& rect, const scene::BlendingCurveFigure& figure) {
  Interface& ui = frame.ui;
  KnotDrag& drag = frame.state.knot;
  const std::optional<int> held = selected_local(frame, figure);
  constexpr float sum_line = 18, least_way = 3;
  StripEvent event;
  const KnotVector& knots = figure.curve.knots();
  const Plot plot{
      {rect.x, rect.y + sum_line, rect.width, rect.height - sum_line - plot_knot_foot}, knots.start(), knots.end()};
  const float pointer = ImGui::GetIO().MousePos.x;
  const PlotPress press = plot_press(ui, plot, "weights");
  event.taken = press.taken;
  event.let_go = press.let_go;
  event.t = press.t;

  // Knots: the ends of the domain stay.
  const int last = knots.last_span() + 1;
  const auto movable = [&](int i) { return i > 1 && i < last; };
  const Rect row{plot.area.x - 14, plot.area.y + plot.area.height, plot.area.width + 28, plot_knot_foot};
  const Press on_knots = press_area(ui, "knots", row);
  int nearest = 1;
  for (int i = 1; i <= last; ++i)
    if (std::abs(plot.x_of(knots[i]) - pointer) < std::abs(plot.x_of(knots[nearest]) - pointer)) nearest = i;
  const bool reached = movable(nearest) && std::abs(plot.x_of(knots[nearest]) - pointer) <= (ui.touch ? 22 : 12);
  if (reached && on_knots.taken) drag = {true, false, nearest, nearest, nearest, pointer};
  if (on_knots.held && drag.held && movable(drag.index)) {
    if (!drag.moved && std::abs(pointer - drag.start) > least_way) drag.moved = event.taken = true;
    // A little more than the least gap, for what rounding takes.
    const double gap = 1.5 * scene::least_knot_gap * knots.period();
    const double t = std::clamp(plot.t_of(pointer), knots[drag.index - 1] + gap, knots[drag.index + 1] - gap);
    if (drag.moved) event.knot = {drag.index, t};
  }
  if (on_knots.let_go) {
    event.let_go = event.let_go || drag.moved;
    drag = {};
  }

  const int count = knots.count();
  std::vector<double> t, weights(figure.samples.size());
  for (const auto& sample : figure.samples) t.push_back(sample.t);
  const auto bump = [&](int k, bool strong) {
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = figure.weight(i, k);
    plot_bump(plot, t, weights, local_hue(k, count, ui.theme.dark), strong);
  };
  for (int k = 0; k < count; ++k)
    if (held != k) bump(k, false);
  if (held && *held < count) bump(*held, true);
  plot_level(ui, plot, 1, knots.start(), knots.end(), say("sum {}", 1));
  plot_ground(ui, plot);
  plot_parameter(ui, plot, figure.t);
  for (const BlendingCurve::Weight& weight : figure.weights)
    plot_dot(plot, figure.t, weight.value, local_hue(weight.local, count, ui.theme.dark));

  float taken = -1e9F;
  for (int i = 1; i <= last; ++i) {
    const bool hovered = (reached && nearest == i && on_knots.hovered) || (drag.held && drag.index == i);
    plot_knot(ui, plot, knots[i], 1, movable(i), hovered);
    plot_knot_name(ui, plot, knots[i], as_is("t" + subscript(i)), taken);
    if (movable(i)) ui.record("knot " + std::to_string(i), {plot.x_of(knots[i]) - 9, row.y + 2, 18, 18});
  }
  if (event.taken) take_gesture(frame);
  if (event.t) frame.output.commands.emplace_back(scene::SetParameter{"curve.parameter", *event.t});
  if (event.knot) frame.output.commands.emplace_back(scene::SetKnot{event.knot->first, event.knot->second});
  if (event.let_go) end_gesture(frame);
}

/// The parameter under the pointer, or else the curve's own; the locals at work there with their weights, in their hues.
void draw_readout(Frame& frame, float left, float y, const scene::BlendingCurveFigure& figure) {
  const Theme& theme = frame.input.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  frame.output.readouts.push_back({0, 0, left + 140.0, y + 52.0});
  const double t = frame.input.pointed ? frame.input.pointed->x : figure.t;
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), as_is("t " + text_of("%.2f", t)));
  // Figures are of one width, and the locals of few figures.
  const float values = behind(frame.ui, Face::regular, left + 16, say("local {}", 0), left + 74);
  for (const BlendingCurve::Weight& weight : figure.curve.weights(t)) {
    y += 20;
    const Colour hue = local_hue(weight.local, figure.curve.knots().count(), theme.dark);
    list.AddCircleFilled({left + 5, y}, 5, colour(hue));
    text(frame.ui, Face::regular, {left + 16, y}, colour(as_text(theme, hue)), say("local {}", weight.local));
    text(frame.ui, Face::regular, {values, y}, colour(as_text(theme, hue)), as_is(text_of("%.2f", weight.value)));
  }
}

}  // namespace knotwork::web
