#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "web/interface_widgets.h"

namespace knotwork::web {

/// A rectangle of the interface as a plot: parameters from left to right, values upwards. What follows draws into it
/// with the current window's draw list; nothing is kept between frames.
struct Plot {
  Rect area;
  double start = 0, end = 1;               ///< parameters, start < end
  double low = 0, high = 1;                ///< values, low < high
  bool low_cut = false, high_cut = false;  ///< values beyond are drawn at the edge, and the axis says so

  float x_of(double t) const { return area.x + area.width * static_cast<float>((t - start) / (end - start)); }
  float y_of(double value) const { return area.y + area.height * static_cast<float>((high - value) / (high - low)); }
  ImVec2 at(double t, double value) const { return {x_of(t), y_of(value)}; }
  double t_of(float x) const { return start + (end - start) * static_cast<double>((x - area.x) / area.width); }
};

/// What values to show: 0 and all of them, but for rare peaks beside which the rest would be flat (a cusp's curvature).
/// Values that are not finite count for nothing.
struct PlotRange {
  double low = 0, high = 1;
  bool low_cut = false, high_cut = false;
};
PlotRange plot_range(std::span<const double> values);

/// A number as it stands at an axis: three figures, and the typographic minus.
std::string plot_number(double value);

/// Values over parameters as one line; what lies outside the plot is cut at its edge. Parameters ascend; of many in one
/// pixel only the least and the greatest value are drawn.
void plot_line(Interface& ui, const Plot& plot, std::span<const double> t, std::span<const double> values,
               const Colour& hue, float width = 1.8F);
/// The same with the ground below softly filled, where the value is not 0: a basis function, a weight.
void plot_bump(const Plot& plot, std::span<const double> t, std::span<const double> values, const Colour& hue,
               bool strong = false);

/// The line where values are 0, with the greatest and (where it is below 0) the least value at the left.
void plot_axis(Interface& ui, const Plot& plot);
/// The zero line alone.
void plot_ground(Interface& ui, const Plot& plot);
/// A dotted line at a value from `from` to `to`, with words at its right end: "sum 1".
void plot_level(Interface& ui, const Plot& plot, double value, double from, double to, Said words);
/// What the lines mean: words in their hues, from x to the right. Returns where the next ones may begin.
float plot_legend(Interface& ui, ImVec2 at, Said words, const Colour& hue);
/// Where the parameter is: a line through the whole plot, and dots on the lines.
void plot_parameter(Interface& ui, const Plot& plot, double t);
void plot_dot(const Plot& plot, double t, double value, const Colour& hue);

/// A press on the plot moves the parameter, which stays within the plot. `label` is the name of the item.
struct PlotPress {
  bool taken = false, let_go = false;
  std::optional<double> t;
};
PlotPress plot_press(Interface& ui, const Plot& plot, std::string_view label);

// Below the ground: knots.
inline constexpr float plot_knot_foot = 40;  ///< CSS pixels that triangles and names take

/// Triangles for a knot, stacked as often as it is multiple; paler where it cannot be moved.
void plot_knot(Interface& ui, const Plot& plot, double t, int multiplicity, bool movable, bool hovered);
/// Their names in a row, as far as they keep apart: call in ascending order with one `taken`, at first far to the left.
void plot_knot_name(Interface& ui, const Plot& plot, double t, Said name, float& taken);

}  // namespace knotwork::web
