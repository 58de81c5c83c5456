#include "web/knot_strip.h"

#include <algorithm>
#include <cmath>

#include "knotwork/basis/bspline_basis.h"
#include "web/curve_ornaments.h"

namespace knotwork::web {
namespace {

constexpr float head = 18;          // above them: the sum
constexpr float foot = 40;          // below the bumps: triangles and names
constexpr float triangle = 9;       // width
constexpr float snap = 7;           // CSS pixels
constexpr float first_move = 3;     // until a knot follows
constexpr double least_gap = 1e-3;  // of the shown parameters, between knots that must not coincide
constexpr int most_stacked = 4;

/// The strip's measures: parameters from left to right, weights upwards.
struct Plot {
  Rect area;  ///< of the bumps
  double start, end;

  ImVec2 at(double t, double weight) const { return {x_of(t), area.y + area.height * static_cast<float>(1 - weight)}; }
  float x_of(double t) const { return area.x + area.width * static_cast<float>((t - start) / (end - start)); }
  double t_of(float x) const { return start + (end - start) * static_cast<double>((x - area.x) / area.width); }
};

std::string subscripted(int number) {
  std::string words = "t";
  for (const char figure : std::to_string(number))
    words += std::string("\xE2\x82") + static_cast<char>(0x80 + (figure - '0'));
  return words;
}

/// The stretch of samples in which a point has a say, as one curve each (two, where a closed curve's bump goes round).
void bump(Interface& ui, const Plot& plot, const scene::CurveFigure& figure, int point, bool strong) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour hue = point_hue(point, ui.theme.dark);
  const ImU32 face = colour(hue, strong ? 0.24F : 0.09F), line = colour(hue);
  const ImDrawListFlags flags = list.Flags;
  for (std::size_t k = 0; k + 1 < figure.samples.size(); ++k) {
    const double a = figure.weight(k, point), b = figure.weight(k + 1, point);
    const double from = figure.samples[k].t, to = figure.samples[k + 1].t;
    if ((a <= 0 && b <= 0) || to <= from) continue;
    list.Flags = flags & ~ImDrawListFlags_AntiAliasedFill;  // else the quads' soft edges would show as seams
    list.AddQuadFilled(plot.at(from, 0), plot.at(from, a), plot.at(to, b), plot.at(to, 0), face);
    list.Flags = flags;
  }
  bool open = false;
  const auto stroke = [&] {
    if (open) list.PathStroke(line, 0, strong ? 2.4F : 1.6F);
    open = false;
  };
  for (std::size_t k = 0; k < figure.samples.size(); ++k) {
    const double weight = figure.weight(k, point);
    const bool alive = weight > 0 || (k > 0 && figure.weight(k - 1, point) > 0) ||
                       (k + 1 < figure.samples.size() && figure.weight(k + 1, point) > 0);
    if (!alive) {
      stroke();
      continue;
    }
    // Where an interval begins, the last one has already been: a line of no length would show as a blot.
    const bool again = open && figure.samples[k].t <= figure.samples[k - 1].t && weight == figure.weight(k - 1, point);
    if (!again) list.PathLineTo(plot.at(figure.samples[k].t, weight));
    open = true;
  }
  stroke();
}

void dotted(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 ink) {
  for (float x = from.x; x < to.x; x += 6) list.AddLine({x, from.y}, {std::min(x + 2, to.x), from.y}, ink, 1.2F);
}

/// The triangle of a knot; ends are paler, as they do not move.
void draw_mark(Interface& ui, const Plot& plot, const scene::CurveFigure::Mark& mark, bool movable, bool hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour& ink = ui.theme.accent;
  const ImU32 face = movable ? colour(ink) : colour(mixed(ui.theme.stage, ink, 0.5F));
  const float x = plot.x_of(mark.t), half = (hovered ? 1.25F : 1.0F) * triangle / 2;
  float y = plot.area.y + plot.area.height + 6;
  const int count = std::min(mark.last - mark.first + 1, most_stacked);
  for (int k = 0; k < count; ++k) {
    list.AddTriangleFilled({x - half, y + half * 1.5F}, {x, y}, {x + half, y + half * 1.5F}, face);
    y += 6;
  }
}

/// Names of the knots under their triangles, as far as they keep apart.
void draw_names(Interface& ui, const Plot& plot, const scene::CurveFigure& figure) {
  float taken = -1e9F;
  const float y = plot.area.y + plot.area.height + foot - 5;
  for (const scene::CurveFigure::Mark& mark : figure.marks) {
    const int count = mark.last - mark.first + 1;
    std::string name = subscripted(mark.first);
    if (count == 2) name += " " + subscripted(mark.last);
    if (count > 2) name += "–" + subscripted(mark.last);
    const float width = text_width(ui, Face::small, name), x = plot.x_of(mark.t);
    if (x - width / 2 < taken + 6) continue;
    text(ui, Face::small, {x, y}, colour(ui.theme.ink_soft), name, Align::centre);
    taken = x + width / 2;
  }
}

const scene::CurveFigure::Mark* nearest_mark(const Plot& plot, const scene::CurveFigure& figure, float x) {
  const auto gap = [&](const scene::CurveFigure::Mark& mark) { return std::abs(plot.x_of(mark.t) - x); };
  const auto nearest = std::min_element(figure.marks.begin(), figure.marks.end(),
                                        [&](const auto& a, const auto& b) { return gap(a) < gap(b); });
  return nearest == figure.marks.end() ? nullptr : &*nearest;
}

int multiplicity_at(const scene::CurveFigure& figure, double t, int without) {
  int count = 0;
  for (const scene::CurveFigure::Mark& mark : figure.marks)
    for (int i = mark.first; i <= mark.last; ++i) count += i != without && mark.t == t ? 1 : 0;
  return count;
}

/// Where knot `index` may go: between its neighbours, on one of them only while the degree allows the multiplicity.
double allowed(const Plot& plot, const scene::CurveFigure& figure, int index, double wanted) {
  const KnotVector& knots = figure.curve.knots();
  const double gap = least_gap * (plot.end - plot.start);
  const double reach = snap / static_cast<double>(plot.area.width) * (plot.end - plot.start);
  double t = wanted;
  for (const int side : {-1, 1}) {
    const int other = index + side;
    if (other < 0 || other >= static_cast<int>(knots.knots().size())) continue;
    const double limit = knots[other];
    const bool at_end = !knots.closed() && (limit <= knots.start() || limit >= knots.end());
    const int most = at_end ? knots.degree() + 1 : knots.degree();
    const bool room = multiplicity_at(figure, limit, index) < most;
    const bool beyond = side < 0 ? t < limit + reach : t > limit - reach;
    if (beyond && room) t = limit;
    if (!room) t = side < 0 ? std::max(t, limit + gap) : std::min(t, limit - gap);
  }
  return t;
}

}  // namespace

StripEvent knot_strip(Interface& ui, const Rect& rect, const scene::CurveFigure& figure, bool movable,
                      std::optional<int> held, KnotDrag& drag) {
  StripEvent event;
  const KnotVector& knots = figure.curve.knots();
  const Plot plot{{rect.x, rect.y + head, rect.width, rect.height - head - foot},
                  figure.marks.front().t,
                  knots.closed() ? knots.end() : figure.marks.back().t};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pointer = ImGui::GetIO().MousePos.x;

  const Press line = press_area(ui, "basis", {plot.area.x - 8, plot.area.y, plot.area.width + 16, plot.area.height});
  event.taken = line.taken;
  event.let_go = line.let_go;
  if (line.held) event.t = std::clamp(plot.t_of(pointer), knots.start(), knots.end());

  const Rect row{plot.area.x - 14, plot.area.y + plot.area.height, plot.area.width + 28, foot};
  const scene::CurveFigure::Mark* under = nullptr;
  if (movable) {
    const Press press = press_area(ui, "knots", row);
    const scene::CurveFigure::Mark* nearest = nearest_mark(plot, figure, pointer);
    const float reach = ui.touch ? 22 : 12;
    const auto may_move = [&](const scene::CurveFigure::Mark& mark) { return mark.inner; };
    if (nearest && may_move(*nearest) && std::abs(plot.x_of(nearest->t) - pointer) <= reach) {
      if (press.hovered || press.held) under = nearest;
      if (press.taken) drag = {true, false, nearest->first, nearest->last, nearest->first, pointer};
    }
    if (press.held && drag.held) {
      if (!drag.moved && std::abs(pointer - drag.start) > first_move) {
        drag.moved = event.taken = true;
        drag.index = pointer > drag.start ? drag.last : drag.first;
      }
      if (drag.moved) event.knot = {drag.index, allowed(plot, figure, drag.index, plot.t_of(pointer))};
    }
    if (press.let_go) {
      event.let_go = event.let_go || drag.moved;
      drag = {};
    }
    for (const scene::CurveFigure::Mark& mark : figure.marks)
      if (may_move(mark))
        ui.widgets.push_back({"knot " + std::to_string(mark.last), {plot.x_of(mark.t) - 9, row.y + 2, 18, 18}});
  }

  const auto where = [&](double t) { return plot.x_of(t); };
  if (held) {
    // The light behind the held point's support, as on the curve.
    const Colour hue = point_hue(*held, ui.theme.dark);
    for (std::size_t k = 0; k + 1 < figure.samples.size(); ++k)
      if (figure.weight(k, *held) > 0 || figure.weight(k + 1, *held) > 0)
        list.AddRectFilled({where(figure.samples[k].t), plot.area.y},
                           {where(figure.samples[k + 1].t), plot.area.y + plot.area.height}, colour(hue, 0.1F));
  }
  for (int i = 0; i < knots.count(); ++i)
    if (held != i) bump(ui, plot, figure, i, false);
  if (held) bump(ui, plot, figure, *held, true);

  dotted(list, plot.at(knots.start(), 1), plot.at(knots.end(), 1), colour(ui.theme.ink_soft));
  text(ui, Face::small, {plot.at(plot.end, 1).x, plot.at(plot.end, 1).y - 9}, colour(ui.theme.ink_soft), "sum 1",
       Align::right);
  list.AddLine(plot.at(plot.start, 0), plot.at(plot.end, 0), colour(ui.theme.ink_soft), 1.2F);

  list.AddLine({where(figure.t), plot.area.y - 6}, {where(figure.t), plot.area.y + plot.area.height},
               colour(ui.theme.ink), 1.4F);
  std::vector<double> basis(static_cast<std::size_t>(knots.degree()) + 1);
  const int span = knots.span(knots.reduced(figure.t));
  bspline_basis(knots, span, knots.reduced(figure.t), 0, basis);
  for (std::size_t j = 0; j < basis.size(); ++j) {
    const int point = (span - knots.degree() + static_cast<int>(j)) % knots.count();
    list.AddCircleFilled(plot.at(figure.t, basis[j]), 3.6F, colour(point_hue(point, ui.theme.dark)));
  }

  for (const scene::CurveFigure::Mark& mark : figure.marks)
    draw_mark(ui, plot, mark, movable && mark.inner, under == &mark || (drag.held && mark.t == knots[drag.index]));
  draw_names(ui, plot, figure);
  return event;
}

}  // namespace knotwork::web
