#include "web/blending_curve_ornaments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "web/curve_ornaments.h"
#include "web/curve_path.h"
#include "web/stage_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr float blended_width = 4, strand_width = 2.4F, held_width = 3.4F, model_width = 1.2F;
constexpr float strand_strength = 0.72F, held_strength = 1, least_strength = 0.05F;
constexpr double frame_length = 34;  // CSS pixels

void add_segment(Picture& picture, const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Colour& ink,
                 float width) {
  picture.ribbons.push_back({glm::vec3(to_glm(from)), glm::vec3(to_glm(to)), to_glm(ink, 1), width});
}

int count_of(const scene::BlendingCurveFigure& figure) { return figure.curve.knots().count(); }

std::optional<int> held_local(const std::optional<HandleIndex>& handle, int count) {
  const bool is_local = handle && *handle != parameter_handle && handle->first < count;
  return is_local ? std::optional(handle->first) : std::nullopt;
}

void add_model(Picture& picture, const scene::BlendingCurveFigure& figure) {
  const Colour ink = mixed(picture.theme.stage, picture.theme.ink_soft, 0.4F);
  for (std::size_t i = 0; i + 1 < figure.samples.size(); ++i)
    add_segment(picture, figure.mixtures[i].model, figure.mixtures[i + 1].model, ink, model_width);
}

/// Strands fade into the stage by colour and not by opacity, which would show every joint; so faint pieces come first,
/// not to be drawn over strong ones.
void add_strands(Picture& picture, const scene::BlendingCurveFigure& figure, std::optional<int> held, bool all) {
  struct Piece {
    std::size_t local, place;
    float strength;
  };
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < figure.strands.size(); ++k) {
    const bool strong = held == static_cast<int>(k);
    if (!all && !strong) continue;
    const scene::BlendingCurveFigure::Strand& strand = figure.strands[k];
    for (std::size_t i = 0; i + 1 < strand.points.size(); ++i) {
      const auto weight = static_cast<float>(0.5 * (strand.weights[i] + strand.weights[i + 1]));
      const float strength = (strong ? held_strength : strand_strength) * std::pow(weight, 0.4F);
      if (strength > least_strength) pieces.push_back({k, i, strong ? 1 + strength : strength});
    }
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.strength < b.strength; });
  for (const Piece& piece : pieces) {
    const bool strong = piece.strength > 1;
    const Colour hue = local_hue(static_cast<int>(piece.local), count_of(figure), picture.theme.dark);
    const Colour ink = mixed(picture.theme.stage, hue, strong ? piece.strength - 1 : piece.strength);
    const scene::BlendingCurveFigure::Strand& strand = figure.strands[piece.local];
    add_segment(picture, strand.points[piece.place], strand.points[piece.place + 1], ink,
                strong ? held_width : strand_width);
  }
}

void add_blend(Picture& picture, const scene::BlendingCurveFigure& figure) {
  std::vector<glm::vec3> hues;
  hues.reserve(static_cast<std::size_t>(count_of(figure)));
  for (int k = 0; k < count_of(figure); ++k) hues.push_back(oklab(local_hue(k, count_of(figure), picture.theme.dark)));
  CurvePath path(picture.view, curve_view(figure.curve), figure.samples);
  for (std::size_t i = 0; i + 1 < figure.samples.size(); ++i) {
    if (figure.samples[i + 1].t <= figure.samples[i].t) continue;  // where one interval ends and the next begins
    const scene::BlendingCurveFigure::Mixture& mixture = figure.mixtures[i];
    const std::array<float, 2> weights{static_cast<float>(1 - mixture.weight), static_cast<float>(mixture.weight)};
    const std::array<glm::vec3, 2> pair{hues[static_cast<std::size_t>(mixture.first)],
                                        hues[static_cast<std::size_t>(mixture.second)]};
    const Colour ink = picture.display.patch_colours ? mixed_hues(weights, pair) : picture.theme.ink;
    add_stretch(picture.ribbons, path.stretch(i), to_glm(ink, 1), blended_width);
  }
}

/// At the knots inside the domain, where one local hands over to the next: there the curve is at a local's centre.
void add_marks(Picture& picture, const scene::BlendingCurveFigure& figure) {
  const KnotVector& knots = figure.curve.knots();
  for (int i = knots.closed() ? 1 : 2; i <= (knots.closed() ? knots.count() : knots.count() - 1); ++i)
    picture.discs.push_back({glm::vec3(to_glm(figure.curve(knots[i]))), 3.2F, to_glm(picture.theme.stage, 1),
                             to_glm(picture.theme.accent), 1.4F});
}

/// The curve's point divides the line between its two locals' points in the ratio of their weights.
void add_chord(Picture& picture, const scene::BlendingCurveFigure& figure) {
  const Colour line = mixed(picture.theme.stage, picture.theme.ink, 0.55F);
  add_segment(picture, figure.local_points[0], figure.local_points[1], line, 1.3F);
  for (std::size_t k = 0; k < 2; ++k) {
    const Colour hue = local_hue(figure.weights[k].local, count_of(figure), picture.theme.dark);
    picture.discs.push_back(
        {glm::vec3(to_glm(figure.local_points[k])), 4.2F, to_glm(hue, 1), to_glm(picture.theme.stage), 1.2F});
  }
}

void add_local_frames(Picture& picture, const scene::BlendingCurveFigure& figure) {
  const std::array<Colour, 3> colours{picture.theme.local[0], picture.theme.local[2], picture.theme.accent};
  for (int k = 0; k < count_of(figure); ++k) {
    const scene::LocalFrame& local = figure.locals[static_cast<std::size_t>(k)];
    const Eigen::Vector3d origin = scene::local_origin(local);
    const Eigen::Matrix3d axes = figure.curve.local(k).linear() * local.axes;
    const double length = frame_length * picture.view.pixel_size(to_glm(origin));
    for (int axis = 0; axis < 3; ++axis)
      add_segment(picture, origin, origin + length * axes.col(axis), colours[static_cast<std::size_t>(axis)], 2.2F);
  }
}

}  // namespace

Colour local_hue(int k, int count, bool dark) {
  constexpr int hues = 6;
  // The last local of a closed curve stands beside the first one.
  const bool meets_first = k == count - 1 && k > 0 && k % hues == 0;
  return point_hue(meets_first ? hues / 2 : k, dark);
}

void add_to_picture(Picture& picture, const scene::BlendingCurveFigure& figure, const Look& look) {
  const scene::Display& display = picture.display;
  const InteractionState& state = look.state;
  const int count = count_of(figure);
  const std::optional<int> held = held_local(state.selected ? state.selected : state.hovered, count);
  if (display.construction) add_model(picture, figure);
  add_strands(picture, figure, held, display.local_patches);
  add_blend(picture, figure);
  if (display.knot_lines) add_marks(picture, figure);
  if (display.construction) add_chord(picture, figure);
  if (display.frames) add_local_frames(picture, figure);
  if (!display.handles) return;
  add_points(picture, look.handles, state,
             [count, dark = picture.theme.dark](int k) { return local_hue(k, count, dark); });
  if (const std::optional<int> selected = held_local(state.selected, count)) {
    const scene::LocalFrame& local = figure.locals[static_cast<std::size_t>(*selected)];
    const glm::dvec3 origin = to_glm(scene::local_origin(local));
    add_gizmo_strokes(picture, make_gizmo(origin, to_glm_matrix(scene::turned_axes(local)), picture.view), state);
  }
}

}  // namespace knotwork::web
