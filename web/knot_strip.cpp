#include "web/knot_strip.h"

#include <algorithm>
#include <cmath>

#include "knotwork/basis/bspline_basis.h"
#include "web/curve_ornaments.h"
#include "web/panel_frame.h"
#include "web/plot.h"

namespace knotwork::web {
namespace {

constexpr float sum_row = 18;       // above the bumps: the sum
constexpr float snap = 7;           // CSS pixels
constexpr float first_move = 3;     // until a knot follows
constexpr double least_gap = 1e-3;  // of the shown parameters, between knots that must not coincide

/// The stretch of samples in which a point has a say, as one curve each (two, where a closed curve's bump goes round).
void bump(const Plot& plot, const scene::CurveFigure& figure, int point, const Colour& hue, bool strong) {
  std::vector<double> t, weights;
  t.reserve(figure.samples.size());
  weights.reserve(figure.samples.size());
  for (std::size_t k = 0; k < figure.samples.size(); ++k) {
    t.push_back(figure.samples[k].t);
    weights.push_back(figure.weight(k, point));
  }
  plot_bump(plot, t, weights, hue, strong);
}

/// Names of the knots under their triangles.
void draw_names(Interface& ui, const Plot& plot, const scene::CurveFigure& figure, std::string_view letter) {
  float taken = -1e9F;
  for (const scene::CurveFigure::Mark& mark : figure.marks) {
    const int count = mark.last - mark.first + 1;
    Words name = Words().add(letter).below(mark.first);
    if (count > 1) name.add(count == 2 ? " " : "–").add(letter).below(mark.last);
    plot_knot_name(ui, plot, mark.t, as_is(name), taken);
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
  return knot_strip(ui, rect, figure, movable, held, drag, {.prefix = {}, .hues = {}, .parameter = figure.t});
}

StripEvent knot_strip(Interface& ui, const Rect& rect, const scene::CurveFigure& figure, bool movable,
                      std::optional<int> held, KnotDrag& drag, const StripOptions& options) {
  const auto hue_of = [&](int point) {
    return options.hues.empty() ? point_hue(point, ui.theme.dark) : options.hues[static_cast<std::size_t>(point)];
  };
  StripEvent event;
  const KnotVector& knots = figure.curve.knots();
  const Plot plot{{rect.x, rect.y + sum_row, rect.width, rect.height - sum_row - plot_knot_foot},
                  figure.marks.front().t,
                  knots.closed() ? knots.end() : figure.marks.back().t};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pointer = ImGui::GetIO().MousePos.x;

  const PlotPress line = plot_press(ui, plot, "basis");
  event.taken = line.taken;
  event.let_go = line.let_go;
  if (line.t) event.t = std::clamp(*line.t, knots.start(), knots.end());

  const Rect row{plot.area.x - 14, plot.area.y + plot.area.height, plot.area.width + 28, plot_knot_foot};
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
        ui.record(std::string(options.prefix) + "knot " + std::to_string(mark.last),
                  {plot.x_of(mark.t) - 9, row.y + 2, 18, 18});
  }

  const auto where = [&](double t) { return plot.x_of(t); };
  if (held) {
    // The light behind the held point's support, as on the curve.
    const Colour hue = hue_of(*held);
    for (std::size_t k = 0; k + 1 < figure.samples.size(); ++k)
      if (figure.weight(k, *held) > 0 || figure.weight(k + 1, *held) > 0)
        list.AddRectFilled({where(figure.samples[k].t), plot.area.y},
                           {where(figure.samples[k + 1].t), plot.area.y + plot.area.height}, colour(hue, 0.1F));
  }
  for (int i = 0; i < knots.count(); ++i)
    if (held != i) bump(plot, figure, i, hue_of(i), false);
  if (held) bump(plot, figure, *held, hue_of(*held), true);

  plot_level(ui, plot, 1, knots.start(), knots.end(), say("sum {}", 1));
  plot_ground(ui, plot);
  if (options.parameter) {
    const double t = knots.reduced(*options.parameter);
    plot_parameter(ui, plot, t);
    std::vector<double> basis(static_cast<std::size_t>(knots.degree()) + 1);
    const int span = knots.span(t);
    bspline_basis(knots, span, t, 0, basis);
    for (std::size_t j = 0; j < basis.size(); ++j) {
      const int point = (span - knots.degree() + static_cast<int>(j)) % knots.count();
      plot_dot(plot, t, basis[j], hue_of(point));
    }
  }

  for (const scene::CurveFigure::Mark& mark : figure.marks)
    plot_knot(ui, plot, mark.t, mark.last - mark.first + 1, movable && mark.inner,
              under == &mark || (drag.held && mark.t == knots[drag.index]));
  draw_names(ui, plot, figure, options.letter);
  return event;
}

}  // namespace knotwork::web
