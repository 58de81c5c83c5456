#include "web/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace knotwork::web {
namespace {

constexpr float plot_head = 24, plot_foot = 22, left_gutter = 46;
constexpr float decade_room = 24;  // between names of decades, at least
constexpr float name_room = 26;    // between numbers under the axis, at least
constexpr float title_gap = 14;

struct LogAxes {
  Rect area;
  int first, last;
  Decades decades;

  float x_of(int number) const {
    const float share = last > first ? static_cast<float>(number - first) / static_cast<float>(last - first) : 0.5F;
    return area.x + area.width * share;
  }
  float y_of(double size) const {
    const double low = decades.low, high = decades.high;
    const double place = std::clamp((std::log10(size) - low) / (high - low), 0.0, 1.0);
    return area.y + area.height * static_cast<float>(1 - place);
  }
  int number_at(float x) const {
    const float share = std::clamp((x - area.x) / area.width, 0.0F, 1.0F);
    return first + static_cast<int>(std::lround(share * static_cast<float>(last - first)));
  }
};

/// "10" with its exponent small and high, the whole ending at x.
void power_of_ten(const Interface& ui, float x, float y, int exponent, ImU32 ink) {
  const std::string figures = exponent < 0 ? "−" + std::to_string(-exponent) : std::to_string(exponent);
  const Said raised = as_is(figures);
  const float width = text_width(ui, Face::small, raised);
  text(ui, Face::small, {x, y - 4}, ink, raised, Align::right);
  text(ui, Face::small, {x - width - 1, y + 1}, ink, as_is("10"), Align::right);
}

void draw_decades(const Interface& ui, const LogAxes& axes) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 line = colour(ui.theme.ink, 0.09F), ink = colour(ui.theme.ink_soft);
  for (int decade = axes.decades.low; decade <= axes.decades.high; decade += axes.decades.step) {
    const float y = axes.y_of(std::pow(10.0, decade));
    list.AddLine({axes.area.x - 4, y}, {axes.area.x + axes.area.width + 4, y}, line, 1);
    power_of_ten(ui, axes.area.x - 10, y, decade, ink);
  }
}

/// Numbers under the axis as far as there is room; the marked one always, in its place.
void draw_numbers(const Interface& ui, const LogAxes& axes, const LogPlot& plot) {
  const float y = axes.area.y + axes.area.height + plot_foot / 2 + 2;
  const int count = axes.last - axes.first;
  int step = 1;
  for (const int wider : {1, 2, 5, 10, 20}) {
    step = wider;
    if (count == 0 || axes.area.width * static_cast<float>(wider) / static_cast<float>(count) >= name_room) break;
  }
  const Sentence name = say("{} = {}", plot.number_name, plot.marked);
  const float half = text_width(ui, Face::bold, name) / 2;
  const float middle =
      std::clamp(axes.x_of(plot.marked), axes.area.x + half - 8, axes.area.x + axes.area.width - half + 8);
  for (int number = (axes.first + step - 1) / step * step; number <= axes.last; number += step) {
    if (std::abs(axes.x_of(number) - middle) < half + 12) continue;
    text(ui, Face::small, {axes.x_of(number), y}, colour(ui.theme.ink_soft), as_is(Words().add(number)), Align::centre);
  }
  text(ui, Face::bold, {middle, y}, colour(ui.theme.ink), name, Align::centre);
}

void draw_series(const LogAxes& axes, const LogSeries& series, double least, int marked) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = colour(series.ink);
  const auto at = [&](const std::pair<int, double>& value) {
    return ImVec2(axes.x_of(value.first), axes.y_of(std::max(value.second, least)));
  };
  for (const auto& value : series.values) list.PathLineTo(at(value));
  list.PathStroke(ink, 0, 1.6F);
  for (const auto& value : series.values) list.AddCircleFilled(at(value), value.first == marked ? 4.4F : 2.2F, ink);
}

/// The names of the series in their inks, at the head.
void draw_legend(Interface& ui, const LogAxes& axes, const LogPlot& plot) {
  float x = axes.area.x, wanted = 0;
  for (const LogSeries& series : plot.series) wanted += text_width(ui, Face::small, series.name);
  const float rest = static_cast<float>(plot.series.size()) * (11 + title_gap) - title_gap;
  const float share = std::min(1.0F, (axes.area.width + 8 - rest) / wanted);
  const float y = axes.area.y - plot_head + 9;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const LogSeries& series : plot.series) {
    const float room = share * text_width(ui, Face::small, series.name);
    list.AddCircleFilled({x + 3, y}, 3, colour(series.ink));
    fitted_text(ui, Face::small, {x + 11, y}, colour(as_text(ui.theme, series.ink)), series.name, room);
    x += 11 + room + title_gap;
  }
}

}  // namespace

Decades decades_of(std::span<const LogSeries> series, double least, int most) {
  double low = 1e300, high = least;
  for (const LogSeries& one : series) {
    for (const auto& [number, size] : one.values) {
      low = std::min(low, std::max(size, least));
      high = std::max(high, size);
    }
  }
  low = std::min(low, high);
  Decades decades{static_cast<int>(std::floor(std::log10(low) + 1e-9)),
                  static_cast<int>(std::ceil(std::log10(high) - 1e-9)), 1};
  if (decades.high <= decades.low) decades.high = decades.low + 1;
  while ((decades.high - decades.low) / decades.step + 1 > std::max(most, 2)) ++decades.step;
  return decades;
}

LogPlotEvent log_plot(Interface& ui, std::string_view id, const Rect& rect, const LogPlot& plot) {
  LogPlotEvent event;
  LogAxes axes{
      {rect.x + left_gutter, rect.y + plot_head, rect.width - left_gutter - 8, rect.height - plot_head - plot_foot},
      plot.marked,
      plot.marked,
      {}};
  for (const LogSeries& series : plot.series) {
    if (series.values.empty()) continue;
    axes.first = std::min(axes.first, series.values.front().first);
    axes.last = std::max(axes.last, series.values.back().first);
  }
  axes.decades = decades_of(plot.series, plot.least, 1 + static_cast<int>(axes.area.height / decade_room));

  bool lit = false;
  if (plot.movable) {
    const Press press =
        press_area(ui, id, {axes.area.x - 8, axes.area.y - 6, axes.area.width + 16, axes.area.height + plot_foot + 6});
    event.taken = press.taken;
    event.let_go = press.let_go;
    lit = press.hovered || press.held;
    if (press.held) event.number = axes.number_at(ImGui::GetIO().MousePos.x);
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_decades(ui, axes);
  const float x = axes.x_of(plot.marked);
  list.AddLine({x, axes.area.y - 6}, {x, axes.area.y + axes.area.height}, colour(ui.theme.ink, lit ? 1.0F : 0.75F),
               lit ? 2.0F : 1.4F);
  for (const LogSeries& series : plot.series) draw_series(axes, series, plot.least, plot.marked);
  draw_legend(ui, axes, plot);
  draw_numbers(ui, axes, plot);
  return event;
}

void bar_plot(Interface& ui, const Rect& rect, Said title, std::span<const double> sizes, Colour ink,
              std::optional<int> marked) {
  if (sizes.empty()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rect area{rect.x, rect.y + plot_head, rect.width, rect.height - plot_head - plot_foot};
  const double most = *std::max_element(sizes.begin(), sizes.end());
  // Data so many that bars would be thinner than a pixel are drawn as the greatest of each pixel.
  const std::size_t bars = std::min(sizes.size(), static_cast<std::size_t>(std::max(area.width, 1.0F)));
  const float pitch = area.width / static_cast<float>(bars);
  const float width = std::clamp(0.62F * pitch, 1.0F, 9.0F);
  for (std::size_t k = 0; k < bars; ++k) {
    const std::size_t from = k * sizes.size() / bars, to = (k + 1) * sizes.size() / bars;
    const double size = *std::max_element(sizes.begin() + static_cast<std::ptrdiff_t>(from),
                                          sizes.begin() + static_cast<std::ptrdiff_t>(to));
    const bool strong = marked && from <= static_cast<std::size_t>(*marked) && static_cast<std::size_t>(*marked) < to;
    const float height = most > 0 ? area.height * static_cast<float>(size / most) : 0;
    const float x = area.x + (static_cast<float>(k) + 0.5F) * pitch;
    list.AddRectFilled({x - width / 2, area.y + area.height - std::max(height, 1.0F)},
                       {x + width / 2, area.y + area.height}, colour(ink, strong || !marked ? 1.0F : 0.45F), 1.5F);
  }
  const float line = area.y + area.height;
  list.AddLine({area.x, line}, {area.x + area.width, line}, colour(ui.theme.ink_soft), 1.2F);
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.3g", most);
  const float y = rect.y + 9;
  const Sentence greatest = say("max {}", std::string(number.data()));
  fitted_text(ui, Face::small, {area.x, y}, colour(as_text(ui.theme, ink)), title,
              area.width - text_width(ui, Face::small, greatest) - title_gap);
  text(ui, Face::small, {area.x + area.width, y}, colour(ui.theme.ink_soft), greatest, Align::right);
}

}  // namespace knotwork::web
