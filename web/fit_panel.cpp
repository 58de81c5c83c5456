#include "web/fit_panel.h"

#include <algorithm>
#include <array>

#include "web/log_plot.h"

namespace knotwork::web {
namespace {

namespace fit_words {
constexpr std::string_view draw = "Draw the points by hand", add = "Add a point after this one",
                           remove = "Delete this point", drawing = "Draw: press and drag";
}  // namespace fit_words
constexpr float residuals_from = 620;  // pixels of the strip: wide enough for two plots
constexpr float plot_gap = 44;

std::optional<int> selected_datum(const Frame& frame, const scene::FitFigure& figure) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  const bool datum = selected && *selected != parameter_handle && selected->first >= 0 &&
                     static_cast<std::size_t>(selected->first) < figure.points.size();
  return datum ? std::optional(selected->first) : std::nullopt;
}

/// The nearest n that there is a fit for.
int possible(const scene::FitFigure& figure, int wanted) {
  const auto nearer = [&](const CurveFitError& a, const CurveFitError& b) {
    return std::abs(a.count - wanted) < std::abs(b.count - wanted);
  };
  const auto found = std::min_element(figure.errors.begin(), figure.errors.end(), nearer);
  return found == figure.errors.end() ? figure.count : found->count;
}

}  // namespace

Sentence size_text(const Frame&, const scene::FitFigure& figure) { return say("{} points", figure.points.size()); }

Tools tools_of(const Frame& frame, const scene::FitFigure& figure) {
  const bool datum = selected_datum(frame, figure).has_value();
  return {{"draw", Icon::pencil, true, fit_words::draw, std::nullopt, "d"},
          {"add", Icon::add, datum, fit_words::add, std::nullopt, "Insert"},
          {"remove", Icon::remove, datum, fit_words::remove, std::nullopt, "Delete"}};
}

float strip_height(const Frame& frame, const scene::FitFigure&) {
  return std::clamp(0.25F * frame.stage.height, 142.0F, 206.0F);
}

void draw_strip(Frame& frame, const Rect& place, const scene::FitFigure& figure) {
  const Theme& theme = frame.input.theme;
  // The axis's names stand in the margin that basis functions do without.
  Rect errors{place.x - 24, place.y, place.width + 24, place.height};
  const bool both = errors.width >= residuals_from;
  if (both) errors.width = 0.6F * (errors.width - plot_gap);

  std::array<LogSeries, 2> series{{{say("greatest residual"), mixed(theme.stage, theme.accent, 0.8F), {}},
                                   {say("root mean square"), theme.ink, {}}}};
  for (const CurveFitError& error : figure.errors) {
    series[0].values.emplace_back(error.count, error.maximum);
    series[1].values.emplace_back(error.count, error.rms);
  }
  // Interpolation leaves rounding errors, which would take up the axis.
  double greatest = 0;
  for (const CurveFitError& error : figure.errors) greatest = std::max(greatest, error.maximum);
  const double least = std::max(1e-15, 1e-6 * greatest);
  const LogPlotEvent event =
      log_plot(frame.ui, "errors", errors,
               {.series = series, .number_name = as_is("n"), .marked = figure.count, .least = least});
  if (event.taken) take_gesture(frame);
  if (event.number) {
    if (const int count = possible(figure, *event.number); count != figure.count)
      frame.output.commands.emplace_back(scene::SetParameter{"fitted.count", static_cast<double>(count)});
  }
  if (event.let_go) end_gesture(frame);
  if (both) {
    const float x = errors.x + errors.width + plot_gap;
    bar_plot(frame.ui, {x, place.y, place.x + place.width - x, place.height}, say("residuals along the data"),
             figure.residuals, mixed(theme.stage, theme.accent, 0.8F), selected_datum(frame, figure));
  }
}

void draw_readout(Frame& frame, float left, float y, const scene::FitFigure& figure) {
  const Theme& theme = frame.input.theme;
  // On a phone the figure needs the room more than the counts do.
  const bool counts = !frame.ui.touch;
  frame.output.readouts.push_back({0, 0, left + 190.0, y + (counts ? 32.0 : 12.0)});
  const Sentence rms = say("RMS {}", text_of("%.3g", figure.rms));
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), rms);
  text(frame.ui, Face::regular, {behind(frame.ui, Face::bold, left, rms, left + 104), y}, colour(theme.ink_soft),
       say("max {}", text_of("%.3g", figure.maximum)));
  y += 20;
  if (counts)
    text(frame.ui, Face::regular, {left, y}, colour(theme.ink_soft),
         say("{} points, {} control points", figure.points.size(), figure.count));
  if (!frame.input.drawing) return;
  if (counts) y += 22;
  text(frame.ui, Face::bold, {left, y}, colour(theme.accent), say(fit_words::drawing));
}

}  // namespace knotwork::web
