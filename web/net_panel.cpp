#include "web/net_panel.h"

#include <algorithm>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/palette.h"
#include "knotwork/surface/surface_measures.h"
#include "web/knot_strip.h"

namespace knotwork::web {
namespace {

using scene::NetDirection;

constexpr std::string_view words_at = "under the pointer", words_tap = "at the tap";
constexpr float strip_gap = 46;     // between the two strips
constexpr float strip_header = 26;  // over a strip: the direction and its buttons

const scene::BSplineSurfaceObject* object_on(const Frame& frame) {
  return std::get_if<scene::BSplineSurfaceObject>(&frame.shape());
}

std::optional<HandleIndex> selected_in(const Frame& frame, const scene::NetFigure& figure) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  const bool exists = selected && selected->first < figure.rows && selected->second < figure.columns;
  return exists ? selected : std::nullopt;
}

Colour hue_of(const Frame& frame, const scene::BSplineSurfaceObject& object, scene::PatchIndex point) {
  return scene::patch_hue(scene::patch_hue_index(object, point), frame.input.theme.dark);
}

/// The direction, how many lines it has, and the buttons that add one after the selected point's or delete that.
void line_buttons(Frame& frame, const Rect& place, const scene::BSplineSurfaceObject& object, NetDirection direction,
                  std::optional<int> selected) {
  const bool along_u = direction == NetDirection::u;
  const Theme& theme = frame.input.theme;
  const float middle = place.y + strip_header / 2, size = frame.ui.touch ? 36.0F : 26.0F;
  const int count = scene::line_count(object, direction);
  text(frame.ui, Face::bold, {place.x, middle}, colour(theme.ink), as_is(along_u ? "u" : "v"));
  // On a narrow phone the number has to do, before the buttons begin.
  Sentence lines = say(along_u ? "{} rows" : "{} columns", count);
  if (14 + text_width(frame.ui, Face::small, lines) > place.width - 2 * size + 8) lines = say("{}", count);
  text(frame.ui, Face::small, {place.x + 14, middle}, colour(theme.ink_soft), lines);
  const auto button = [&](int slot, std::string_view id, Icon icon, bool enabled, std::string_view hint) {
    const Rect rect{place.x + place.width - size * static_cast<float>(2 - slot), middle - size / 2, size, size};
    return icon_button(frame.ui, id, rect, icon, enabled, say(hint));
  };
  if (button(0, along_u ? "add row" : "add column", Icon::add, count < scene::max_net,
             along_u ? "Add a row: the surface stays as it is" : "Add a column: the surface stays as it is")) {
    const int after = selected.value_or((count - 1) / 2);
    frame.output.commands.emplace_back(scene::InsertNetLine{direction, scene::place_after(object, direction, after)});
  }
  if (button(1, along_u ? "delete row" : "delete column", Icon::remove, selected.has_value(),
             along_u ? "Delete the selected point's row" : "Delete the selected point's column"))
    frame.output.commands.emplace_back(scene::RemoveNetLine{direction, *selected});
}

void direction_strip(Frame& frame, const Rect& place, const scene::CurveFigure& basis,
                     const scene::BSplineSurfaceObject& object, NetDirection direction) {
  const bool along_u = direction == NetDirection::u;
  const std::optional<HandleIndex>& point = frame.input.selected;
  const int count = scene::line_count(object, direction);
  std::optional<int> held;
  if (point && (along_u ? point->first : point->second) < count) held = along_u ? point->first : point->second;
  // A bump has the hue of the point of its line that stands in the selected point's other line.
  const int across = scene::line_count(object, along_u ? NetDirection::v : NetDirection::u);
  const int other = point ? std::min(along_u ? point->second : point->first, across - 1) : 0;
  std::vector<Colour> hues;
  hues.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    hues.push_back(hue_of(frame, object, along_u ? scene::PatchIndex(k, other) : scene::PatchIndex(other, k)));

  StripOptions options{
      .letter = along_u ? "u" : "v", .prefix = along_u ? "u " : "v ", .hues = hues, .parameter = std::nullopt};
  if (frame.input.pointed) options.parameter = along_u ? frame.input.pointed->x : frame.input.pointed->y;
  ImGui::PushID(along_u ? "u" : "v");
  const StripEvent event =
      knot_strip(frame.ui, {place.x, place.y + strip_header - 6, place.width, place.height - strip_header + 6}, basis,
                 true, held, along_u ? frame.state.knot : frame.state.knot_v, options);
  line_buttons(frame, place, object, direction, held);
  ImGui::PopID();
  if (event.taken && event.knot) take_gesture(frame);
  if (event.knot)
    frame.output.commands.emplace_back(scene::SetNetKnot{direction, event.knot->first, event.knot->second});
  if (event.let_go) end_gesture(frame);
}

}  // namespace

Sentence size_text(const Frame&, const NetSurfaceFigure& figure) {
  return say("{} × {} points", figure.shown.rows, figure.shown.columns);
}

float strip_height(const Frame& frame, const NetSurfaceFigure&) {
  return std::clamp(0.24F * frame.stage.height, 132.0F, 190.0F);
}

void draw_strip(Frame& frame, const Rect& place, const NetSurfaceFigure& figure) {
  const scene::BSplineSurfaceObject* object = object_on(frame);
  if (object == nullptr) return;
  const float width = (place.width - strip_gap) / 2;
  direction_strip(frame, {place.x, place.y, width, place.height}, figure.shown.basis_u, *object, NetDirection::u);
  direction_strip(frame, {place.x + width + strip_gap, place.y, width, place.height}, figure.shown.basis_v, *object,
                  NetDirection::v);
}

void draw_readout(Frame& frame, float left, float y, const NetSurfaceFigure& figure) {
  const scene::BSplineSurfaceObject* object = object_on(frame);
  if (object == nullptr) return;
  const Theme& theme = frame.input.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::optional<HandleIndex> selected = selected_in(frame, figure.shown);
  if (selected) {
    list.AddCircleFilled({left + 5, y}, 5, colour(hue_of(frame, *object, *selected)));
    text(frame.ui, Face::bold, {left + 16, y}, colour(theme.ink),
         say("point {}, {}", selected->first, selected->second));
    y += 26;
  }
  if (!frame.input.pointed) return;
  if (selected) {
    text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft), say(frame.ui.touch ? words_tap : words_at));
    y += 18;
  }
  const BSplineSurface& surface = figure.shown.surface;
  const SurfaceJet jet = surface.evaluate(frame.input.pointed->x, frame.input.pointed->y);
  y = place_readout(frame, left, y, {frame.input.pointed->x, frame.input.pointed->y, jet.s, curvature(jet)}, 12);

  // The bar is the partition of unity: its parts are the weights of the points at work.
  const auto weights = [](const KnotVector& knots, double t) {
    std::vector<double> basis(static_cast<std::size_t>(knots.degree()) + 1);
    const int span = knots.span(knots.reduced(t));
    bspline_basis(knots, span, knots.reduced(t), 0, basis);
    return std::pair(span - knots.degree(), basis);
  };
  const auto [first_u, basis_u] = weights(surface.knots_u(), frame.input.pointed->x);
  const auto [first_v, basis_v] = weights(surface.knots_v(), frame.input.pointed->y);
  const float width = 148, height = 6;
  float x = left;
  for (std::size_t i = 0; i < basis_u.size(); ++i) {
    for (std::size_t j = 0; j < basis_v.size(); ++j) {
      const scene::PatchIndex point{(first_u + static_cast<int>(i)) % figure.shown.rows,
                                    (first_v + static_cast<int>(j)) % figure.shown.columns};
      const float part = width * static_cast<float>(basis_u[i] * basis_v[j]);
      if (part > 0.25F)
        list.AddRectFilled({x, y - height / 2}, {x + part, y + height / 2}, colour(hue_of(frame, *object, point)));
      x += part;
    }
  }
}

}  // namespace knotwork::web
