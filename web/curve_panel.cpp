#include "web/curve_panel.h"

#include <algorithm>

#include "web/knot_strip.h"

namespace knotwork::web {
namespace {

constexpr std::string_view words_add = "Add a point after this one", words_remove = "Delete this point";

/// The curve's point that is selected.
std::optional<int> selected_point(const Frame& frame, const scene::CurveFigure& figure) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  const bool point = selected && *selected != parameter_handle && selected->first < figure.curve.knots().count();
  return point ? std::optional(selected->first) : std::nullopt;
}

}  // namespace

Sentence size_text(const Frame&, const scene::CurveFigure& figure) {
  return say("{} points", figure.curve.points().size());
}

Tools tools_of(const Frame& frame, const scene::CurveFigure& figure) {
  const bool point = selected_point(frame, figure).has_value();
  return {{"add", Icon::add, point, words_add, std::nullopt, "Insert"},
          {"remove", Icon::remove, point, words_remove, std::nullopt, "Delete"}};
}

float strip_height(const Frame& frame, const scene::CurveFigure&) {
  return std::clamp(0.24F * frame.stage.height, 128.0F, 200.0F);
}

void draw_strip(Frame& frame, const Rect& place, const scene::CurveFigure& figure) {
  const bool movable = std::holds_alternative<scene::BSplineCurveObject>(frame.shape());
  const StripEvent event =
      knot_strip(frame.ui, place, figure, movable, selected_point(frame, figure), frame.state.knot);
  if (event.taken) take_gesture(frame);
  if (event.t) frame.output.commands.emplace_back(scene::SetParameter{"curve.parameter", *event.t});
  if (event.knot) frame.output.commands.emplace_back(scene::SetKnot{event.knot->first, event.knot->second});
  if (event.let_go) end_gesture(frame);
}

/// The parameter under the pointer, or else that of the construction; its interval, and how smooth the curve is where
/// knots coincide.
void draw_readout(Frame& frame, float left, float y, const scene::CurveFigure& figure) {
  const Theme& theme = frame.input.theme;
  const KnotVector& knots = figure.curve.knots();
  const double t = frame.input.pointed ? frame.input.pointed->x : figure.t;
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), as_is("t " + text_of("%.2f", t)));
  text(frame.ui, Face::regular, {left + 74, y}, colour(theme.ink_soft), say("span {}", knots.span(knots.reduced(t))));
  for (const scene::CurveFigure::Mark& mark : figure.marks) {
    const int multiplicity = mark.last - mark.first + 1;
    if (!mark.inner || multiplicity < 2) continue;
    y += 20;
    text(frame.ui, Face::regular, {left, y}, colour(theme.accent),
         say("{} at t = {}", "C" + superscript(knots.degree() - multiplicity), text_of("%.2f", mark.t)));
  }
  frame.output.readouts.push_back({0, 0, left + 132.0, y + 12.0});
}

}  // namespace knotwork::web
