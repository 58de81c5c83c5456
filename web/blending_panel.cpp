#include "web/blending_panel.h"

#include <algorithm>
#include <array>

#include "knotwork/scene/palette.h"
#include "web/stage_ornaments.h"

namespace knotwork::web {
namespace {

constexpr std::string_view words_reset = "Put all patches back", words_domain = "domain", words_knots = "knots",
                           words_patches = "patches", words_locals = "locals", words_pointed = "under the pointer",
                           words_tapped = "at the tap";

const scene::BlendingSurfaceObject& object_of(const Frame& frame) {
  return scene::blending_surface(frame.input.document);
}

std::optional<Probe> probe_of(const Frame& frame, const BlendingFigure& figure) {
  if (!frame.input.pointed) return std::nullopt;
  return probe_at(figure.surface, frame.input.pointed->x, frame.input.pointed->y);
}

}  // namespace

Sentence size_text(const Frame& frame, const BlendingFigure&) {
  return say("{} × {}", object_of(frame).locals_u, object_of(frame).locals_v);
}

Tools tools_of(const Frame& frame, const BlendingFigure&) {
  return {{"reset", Icon::reset, !object_of(frame).edits.empty(), words_reset, scene::ResetPatches{}}};
}

void draw_rows(Frame& frame, Column& column, const BlendingFigure& figure) {
  const std::optional<Probe> probe = probe_of(frame, figure);
  const Theme& theme = frame.input.theme;
  draw_blending_function(frame, column, figure.surface.blending(),
                         probe ? std::optional(probe->blend_w_u) : std::nullopt, {theme.local[0], theme.local[1]});
}

void draw_blending_function(Frame& frame, Column& column, const BlendingFunction& blending, std::optional<double> w,
                            const std::array<Colour, 2>& hues) {
  const Theme& theme = frame.input.theme;
  const float middle = column.y + 9, centre = column.x + column.width / 2;
  const ImU32 first = colour(as_text(theme, hues[0])), second = colour(as_text(theme, hues[1]));
  std::string left = "1 − B", right = "B";
  if (w) {
    const double b = blending(*w)[0];
    left += "  " + text_of("%.2f", 1 - b);
    right = text_of("%.2f", b) + "  " + right;
    text(frame.ui, Face::small, {centre, middle}, colour(theme.ink_soft), as_is("w " + text_of("%.2f", *w)),
         Align::centre);
  } else {
    ImGui::GetWindowDrawList()->AddRectFilled({centre - 14, middle - 4}, {centre - 4, middle + 4},
                                              colour(theme.ink, 0.12F), 2);
    text(frame.ui, Face::small, {centre + 1, middle}, colour(theme.ink_soft), as_is("B′"));
  }
  text(frame.ui, Face::small, {column.x, middle}, first, as_is(left));
  text(frame.ui, Face::small, {column.x + column.width, middle}, second, as_is(right), Align::right);
  column.y += 18;
  blending_plot(frame.ui, {column.x, column.y, column.width, 64}, blending, w, hues);
  column.y += 68;
}

/// From the document, not from the surface: while a sheet rolls, the surface is a mixture of the two.
void draw_table(Frame& frame, Column& column, const BlendingFigure&) {
  const Theme& theme = frame.input.theme;
  const float line = 20, width = column.width;
  std::array<float, 4> ends{0.43F, 0.61F, 0.83F, 1};  // of the width
  const std::array<std::string_view, 4> heads{words_domain, words_knots, words_patches, words_locals};
  const float first = column.x + 20;
  // Longer heads have their columns move to the left, as far as the domains leave room.
  constexpr float least_gap = 6, most_moved = 0.2F;
  for (std::size_t k = 3; k > 1; --k)
    ends[k - 1] = std::clamp(ends[k] - (text_width(frame.ui, Face::small, say(heads[k])) + least_gap) / width,
                             (1 - most_moved) * ends[k - 1], ends[k - 1]);
  ends[0] = std::min(ends[0], ends[1] - (text_width(frame.ui, Face::small, say(heads[1])) + least_gap) / width);
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const float start = k == 0 ? first : column.x + ends[k - 1] * width + least_gap,
                end = column.x + ends[k] * width - (k == 0 ? least_gap : 0);
    fitted_text(frame.ui, Face::small, {k == 0 ? first : end, column.y + 8}, colour(theme.ink_soft), say(heads[k]),
                end - start, k == 0 ? Align::left : Align::right);
  }
  column.y += line;

  const auto row = [&](std::string_view letter, int locals, Topology topology) {
    const bool closed = topology == Topology::closed;
    // THEORY 2.8: n + 2 knots and n - 1 intervals, or n + 3 knots and n intervals.
    const std::array<int, 3> counts{locals + (closed ? 3 : 2), closed ? locals : locals - 1, locals};
    ImGui::GetWindowDrawList()->AddLine({column.x, column.y - 1.5F}, {column.x + width, column.y - 1.5F},
                                        colour(theme.rule, 0.8F));
    text(frame.ui, Face::bold, {column.x, column.y + 8}, colour(theme.ink), as_is(letter));
    text(frame.ui, Face::regular, {first, column.y + 8}, colour(theme.ink),
         as_is(Words()
                   .add("[")
                   .add(letter)
                   .below(1)
                   .add(", ")
                   .add(letter)
                   .below(closed ? locals + 1 : locals)
                   .add(closed ? ")" : "]")));
    for (std::size_t k = 0; k < counts.size(); ++k)
      text(frame.ui, Face::regular, {column.x + ends[k + 1] * width, column.y + 8}, colour(theme.ink),
           as_is(Words().add(counts[k])), Align::right);
    column.y += line;
  };
  row("u", object_of(frame).locals_u, object_of(frame).topology_u);
  row("v", object_of(frame).locals_v, object_of(frame).topology_v);
}

/// The patch that is selected; the point under the pointer with its curvatures, and the weights of the locals at work
/// there, in their hues.
void draw_readout(Frame& frame, float left, float y, const BlendingFigure& figure) {
  PanelState& state = frame.state;
  const Theme& theme = frame.input.theme;
  const scene::BlendingSurfaceObject& object = object_of(frame);
  const std::optional<Probe> probe = probe_of(frame, figure);
  if (probe) state.last_probe = probe;
  const float share = smooth(eased(frame.ui, state.probe_share, probe ? 1.0F : 0.0F));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (frame.input.selected) {
    const scene::PatchIndex patch = *frame.input.selected;
    const Colour hue = scene::patch_hue(scene::patch_hue_index(object, patch), theme.dark);
    list.AddCircleFilled({left + 5, y}, 5, colour(hue));
    text(frame.ui, Face::bold, {left + 16, y}, colour(theme.ink), say("patch {}, {}", patch.first, patch.second));
    y += 26;
  }
  if (share <= 0 || !state.last_probe) return;
  const Probe& point = *state.last_probe;
  // What is selected and what is pointed at are two things.
  if (frame.input.selected) {
    text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft, share),
         say(frame.ui.touch ? words_tapped : words_pointed));
    y += 18;
  }
  y = place_readout(frame, left, y, point.place, 34, share);

  // The bar is the partition of unity: its parts are the weights.
  const float width = 148, height = 6;
  float x = left, word = left;
  for (const BlendingSurface::Weight& weight : point.weights) {
    const Colour hue = scene::patch_hue(scene::patch_hue_index(object, {weight.i, weight.j}), theme.dark);
    const float part = width * static_cast<float>(std::clamp(weight.value, 0.0, 1.0));
    if (part > 0.25F) list.AddRectFilled({x, y - height / 2}, {x + part, y + height / 2}, colour(hue, share));
    x += part;
    text(frame.ui, Face::small, {word, y + 15}, colour(as_text(theme, hue), share),
         as_is(text_of("%.2f", weight.value)));
    word += 38;
  }
}

}  // namespace knotwork::web
