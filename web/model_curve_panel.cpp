#include "web/model_curve_panel.h"

#include <algorithm>
#include <array>

#include "web/model_curve_ornaments.h"
#include "web/plot.h"

namespace knotwork::web {

Sentence size_text(const Frame&, const scene::ModelCurveFigure& figure) {
  return {say(figure.topology == Topology::closed ? "closed" : "open"), {}};
}

float strip_height(const Frame& frame, const scene::ModelCurveFigure&) {
  return std::clamp(0.24F * frame.stage.height, 120.0F, 190.0F);
}

void draw_strip(Frame& frame, const Rect& rect, const scene::ModelCurveFigure& figure) {
  constexpr float legend = 22, ends = 20, labels = 48;
  Interface& ui = frame.ui;
  std::vector<double> all = figure.curvatures;
  if (!figure.flat) all.insert(all.end(), figure.torsions.begin(), figure.torsions.end());
  const PlotRange range = plot_range(all);
  const Plot plot{{rect.x + labels, rect.y + legend, rect.width - labels, rect.height - legend - ends},
                  figure.start,
                  figure.end,
                  range.low,
                  range.high,
                  range.low_cut,
                  range.high_cut};
  const PlotPress press = plot_press(ui, plot, "curvature");
  const Colour &bend = bend_hue(ui.theme), &twist = twist_hue(ui.theme);
  std::vector<double> t;
  t.reserve(figure.samples.size());
  for (const scene::CurveSample& sample : figure.samples) t.push_back(sample.t);
  plot_axis(ui, plot);
  if (!figure.flat) plot_line(ui, plot, t, figure.torsions, twist);
  plot_line(ui, plot, t, figure.curvatures, bend);
  plot_parameter(ui, plot, figure.t);
  if (!figure.flat) plot_dot(plot, figure.t, figure.frame.torsion, twist);
  plot_dot(plot, figure.t, figure.frame.curvature, bend);

  const float next = plot_legend(ui, {plot.area.x, rect.y + 9}, say("curvature"), bend);
  if (!figure.flat) plot_legend(ui, {next, rect.y + 9}, say("torsion"), twist);
  const float below = plot.area.y + plot.area.height + 11;
  const ImU32 ink = colour(ui.theme.ink_soft);
  text(ui, Face::small, {plot.area.x, below}, ink, as_is("t " + plot_number(figure.start)));
  text(ui, Face::small, {plot.area.x + plot.area.width, below}, ink, as_is(plot_number(figure.end)), Align::right);
  if (press.taken) take_gesture(frame);
  if (press.t) frame.output.commands.emplace_back(scene::SetParameter{"curve.parameter", *press.t});
  if (press.let_go) end_gesture(frame);
}

/// Parameter, curvature and torsion under the pointer, or else where the frame is.
void draw_readout(Frame& frame, float left, float y, const scene::ModelCurveFigure& figure) {
  const Theme& theme = frame.input.theme;
  frame.output.readouts.push_back({0, 0, left + 140.0, y + 52.0});
  const double t = frame.input.pointed ? frame.input.pointed->x : figure.t;
  std::array<Eigen::Vector3d, 4> jet;
  evaluate(figure.model, t, jet);
  const FrenetFrame here = frenet_frame(jet);
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), as_is("t " + text_of("%.2f", t)));
  const Said curvature = say("curvature"), torsion = say("torsion");
  const float values =
      behind(frame.ui, Face::regular, left, torsion, behind(frame.ui, Face::regular, left, curvature, left + 74));
  const auto row = [&](Said name, double value, const Colour& hue) {
    y += 20;
    text(frame.ui, Face::regular, {left, y}, colour(as_text(theme, hue)), name);
    text(frame.ui, Face::regular, {values, y}, colour(as_text(theme, hue)), as_is(plot_number(value)));
  };
  row(curvature, here.curvature, bend_hue(theme));
  if (!figure.flat) row(torsion, here.torsion, twist_hue(theme));
}

}  // namespace knotwork::web
