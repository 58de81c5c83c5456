#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "web/interface_widgets.h"

namespace knotwork::web {

/// Sizes over whole numbers, as errors over the number of control points.
struct LogSeries {
  Said name;
  Colour ink;
  std::vector<std::pair<int, double>> values;  ///< (number, size), numbers increasing
};

struct LogPlot {
  std::span<const LogSeries> series;
  Said number_name;  ///< of the numbers, as `n`
  int marked = 0;    ///< the number that the stage shows
  /// Sizes below are drawn there: what is left is rounding.
  double least = 1e-15;
  bool movable = true;  ///< whether a hand may choose a number
};

/// What a hand did to the plot.
struct LogPlotEvent {
  bool taken = false, let_go = false;
  std::optional<int> number;  ///< the one under the pointer
};

/// The decades that an axis shows: 10^low to 10^high, a line and a name every `step`.
struct Decades {
  int low, high, step;
};
/// All sizes between them, `least` at the foot, and no more names than `most`.
Decades decades_of(std::span<const LogSeries> series, double least, int most);

/// Series as lines with dots over a logarithmic axis, the marked number as an upright line; a press or a drag chooses
/// another one. The rectangle includes the axes' names.
LogPlotEvent log_plot(Interface& ui, std::string_view id, const Rect& rect, const LogPlot& plot);

/// One bar for each datum from a common foot, sizes from 0 to the greatest; the marked one strong. Above them the title
/// and the greatest size.
void bar_plot(Interface& ui, const Rect& rect, Said title, std::span<const double> sizes, Colour ink,
              std::optional<int> marked);

}  // namespace knotwork::web
