#include "web/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace knotwork::web {
namespace {

constexpr float knot_width = 9;
constexpr int most_stacked = 4;
constexpr double usual_share = 0.95;  // of the values are no peaks
constexpr double peak = 2.5;          // times as large as usual: cut
constexpr double headroom = 1.08;

/// The value below which the share of the values lies.
double quantile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

PlotRange plot_range(std::span<const double> values) {
  std::vector<double> above, below;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    above.push_back(std::max(value, 0.0));
    below.push_back(std::max(-value, 0.0));
  }
  PlotRange range{0, 0};
  const auto reach = [](std::vector<double>& side, bool& cut) {
    if (side.empty()) return 0.0;
    const double most = *std::max_element(side.begin(), side.end());
    const double usual = quantile(side, usual_share);
    cut = usual > 0 && most > headroom * peak * usual;
    return headroom * (cut ? peak * usual : most);
  };
  range.low = -reach(below, range.low_cut);
  range.high = reach(above, range.high_cut);
  if (!(range.high - range.low > 1e-12)) range = {0, 1};
  return range;
}

std::string plot_number(double value) {
  std::array<char, 32> buffer{};
  // Thousands without an exponent.
  const bool large = std::abs(value) >= 999.5 && std::abs(value) < 1e6;
  std::snprintf(buffer.data(), buffer.size(), large ? "%.0f" : "%.3g", value);
  std::string text(buffer.data());
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

void plot_line(Interface& ui, const Plot& plot, std::span<const double> t, std::span<const double> values,
               const Colour& hue, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float column = 1 / std::max(ui.pixel_ratio, 1.0F);
  const auto place = [&](std::size_t k) { return plot.at(t[k], std::clamp(values[k], plot.low, plot.high)); };
  for (std::size_t k = 0; k < t.size();) {
    const ImVec2 first = place(k);
    ImVec2 top = first, foot = first, last = first;
    for (++k; k < t.size(); ++k) {
      const ImVec2 next = place(k);
      if (next.x >= first.x + column) break;
      if (next.y < top.y) top = next;
      if (next.y > foot.y) foot = next;
      last = next;
    }
    list.PathLineTo(first);
    if (foot.y - top.y > 0.25F) {
      list.PathLineTo(top);
      list.PathLineTo(foot);
      list.PathLineTo(last);
    }
  }
  list.PathStroke(colour(hue), 0, width);
}

void plot_bump(const Plot& plot, std::span<const double> t, std::span<const double> values, const Colour& hue,
               bool strong) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 face = colour(hue, strong ? 0.24F : 0.09F), line = colour(hue);
  const ImDrawListFlags flags = list.Flags;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    if ((values[k] <= 0 && values[k + 1] <= 0) || t[k + 1] <= t[k]) continue;
    list.Flags = flags & ~ImDrawListFlags_AntiAliasedFill;  // else the quads' soft edges would show as seams
    list.AddQuadFilled(plot.at(t[k], 0), plot.at(t[k], values[k]), plot.at(t[k + 1], values[k + 1]),
                       plot.at(t[k + 1], 0), face);
    list.Flags = flags;
  }
  bool open = false;
  const auto stroke = [&] {
    if (open) list.PathStroke(line, 0, strong ? 2.4F : 1.6F);
    open = false;
  };
  for (std::size_t k = 0; k < t.size(); ++k) {
    const bool alive = values[k] > 0 || (k > 0 && values[k - 1] > 0) || (k + 1 < t.size() && values[k + 1] > 0);
    if (!alive) {
      stroke();
      continue;
    }
    // Where an interval begins, the last one has already been: a line of no length would show as a blot.
    const bool again = open && t[k] <= t[k - 1] && values[k] == values[k - 1];
    if (!again) list.PathLineTo(plot.at(t[k], values[k]));
    open = true;
  }
  stroke();
}

void plot_ground(Interface& ui, const Plot& plot) {
  ImGui::GetWindowDrawList()->AddLine(plot.at(plot.start, 0), plot.at(plot.end, 0), colour(ui.theme.ink_soft), 1.2F);
}

void plot_axis(Interface& ui, const Plot& plot) {
  plot_ground(ui, plot);
  const ImU32 ink = colour(ui.theme.ink_soft);
  const auto mark = [&](double value, std::string_view sign = {}) {
    const float y = plot.y_of(value);
    ImGui::GetWindowDrawList()->AddLine({plot.area.x - 5, y}, {plot.area.x, y}, ink, 1.2F);
    text(ui, Face::small, {plot.area.x - 8, y}, ink, as_is(std::string(sign) + plot_number(value)), Align::right);
  };
  if (plot.high > 0) mark(plot.high, plot.high_cut ? "≥ " : "");
  if (plot.low < 0) mark(plot.low, plot.low_cut ? "≤ " : "");
  const bool room = plot.y_of(0) - plot.area.y > 12 && (plot.low >= 0 || plot.y_of(plot.low) - plot.y_of(0) > 12);
  if (room) mark(0);
}

void plot_level(Interface& ui, const Plot& plot, double value, double from, double to, Said words) {
  const ImU32 ink = colour(ui.theme.ink_soft);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = plot.y_of(value), end = plot.x_of(to);
  for (float x = plot.x_of(from); x < end; x += 6) list.AddLine({x, y}, {std::min(x + 2, end), y}, ink, 1.2F);
  text(ui, Face::small, {plot.x_of(plot.end), y - 9}, ink, words, Align::right);
}

float plot_legend(Interface& ui, ImVec2 at, Said words, const Colour& hue) {
  ImGui::GetWindowDrawList()->AddLine(at, {at.x + 12, at.y}, colour(hue), 2);
  text(ui, Face::small, {at.x + 17, at.y}, colour(as_text(ui.theme, hue)), words);
  return at.x + 17 + text_width(ui, Face::small, words) + 16;
}

void plot_parameter(Interface& ui, const Plot& plot, double t) {
  const float x = plot.x_of(t);
  ImGui::GetWindowDrawList()->AddLine({x, plot.area.y - 6}, {x, plot.area.y + plot.area.height}, colour(ui.theme.ink),
                                      1.4F);
}

void plot_dot(const Plot& plot, double t, double value, const Colour& hue) {
  ImGui::GetWindowDrawList()->AddCircleFilled(plot.at(t, std::clamp(value, plot.low, plot.high)), 3.6F, colour(hue));
}

PlotPress plot_press(Interface& ui, const Plot& plot, std::string_view label) {
  constexpr float margin = 8;
  const Press press =
      press_area(ui, label, {plot.area.x - margin, plot.area.y, plot.area.width + 2 * margin, plot.area.height});
  PlotPress result{press.taken, press.let_go, {}};
  if (press.held) result.t = std::clamp(plot.t_of(ImGui::GetIO().MousePos.x), plot.start, plot.end);
  return result;
}

void plot_knot(Interface& ui, const Plot& plot, double t, int multiplicity, bool movable, bool hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour& ink = ui.theme.accent;
  const ImU32 face = movable ? colour(ink) : colour(mixed(ui.theme.stage, ink, 0.5F));
  const float x = plot.x_of(t), half = (hovered ? 1.25F : 1.0F) * knot_width / 2;
  float y = plot.area.y + plot.area.height + 6;
  for (int k = 0; k < std::min(multiplicity, most_stacked); ++k) {
    list.AddTriangleFilled({x - half, y + half * 1.5F}, {x, y}, {x + half, y + half * 1.5F}, face);
    y += 6;
  }
}

void plot_knot_name(Interface& ui, const Plot& plot, double t, Said name, float& taken) {
  const float width = text_width(ui, Face::small, name), x = plot.x_of(t);
  if (x - width / 2 < taken + 6) return;
  text(ui, Face::small, {x, plot.area.y + plot.area.height + plot_knot_foot - 5}, colour(ui.theme.ink_soft), name,
       Align::centre);
  taken = x + width / 2;
}

}  // namespace knotwork::web
