#include "web/curve_ornaments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "web/curve_path.h"
#include "web/vectors.h"
#include "web/words.h"

namespace knotwork::web {
namespace {

constexpr float band_width = 15, leg_width = 1.3F;
constexpr std::size_t most_labels = 24;
constexpr double label_distance = 19;     // CSS pixels from the point
constexpr double far_label = 30;          // the same where all sides are covered there: round a ring
constexpr int label_sides = 16;           // tried
constexpr glm::dvec2 label_reach(11, 9);  // CSS pixels from its middle to its edges

/// The points' hues mixed as the points are.
Colour mixture(const scene::CurveFigure& figure, std::size_t k, const std::vector<glm::vec3>& hues) {
  const std::size_t width = static_cast<std::size_t>(figure.curve.degree()) + 1;
  std::vector<float> weights(width);
  std::vector<glm::vec3> there(width);
  for (std::size_t j = 0; j < width; ++j) {
    weights[j] = static_cast<float>(figure.weights[k * width + j]);
    there[j] = hues[(static_cast<std::size_t>(figure.firsts[k]) + j) % hues.size()];
  }
  return mixed_hues(weights, there);
}

void add_line(std::vector<Ribbon>& ribbons, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
              const glm::vec4& colour, float width) {
  ribbons.push_back({glm::vec3(to_glm(from)), glm::vec3(to_glm(to)), colour, width});
}

/// Even and without seams, hence of one opaque colour.
void add_band(Picture& picture, const scene::CurveFigure& figure, int point) {
  const Colour hue = point_hue(point, picture.theme.dark);
  const glm::vec4 light = to_glm(mixed(picture.theme.stage, hue, picture.theme.dark ? 0.34F : 0.3F), 1);
  CurvePath path(picture.view, curve_view(figure.curve), figure.samples);
  for (std::size_t k = 0; k + 1 < figure.samples.size(); ++k)
    if (figure.weight(k, point) > 0 || figure.weight(k + 1, point) > 0)
      add_stretch(picture.ribbons, path.stretch(k), light, band_width);
}

/// Rows of the construction between the polygon and the point, from soft to strong.
void add_construction(Picture& picture, const scene::CurveFigure& figure) {
  const std::size_t rows = figure.construction.size();
  for (std::size_t row = 1; row + 1 < rows; ++row) {
    const float strength = 0.45F + 0.5F * static_cast<float>(row) / static_cast<float>(rows - 1);
    const Colour ink = mixed(picture.theme.stage, picture.theme.accent, strength);
    const std::vector<Eigen::Vector3d>& points = figure.construction[row];
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      add_line(picture.ribbons, points[k], points[k + 1], to_glm(ink, 1), 1.5F);
    for (const Eigen::Vector3d& point : points)
      picture.discs.push_back({glm::vec3(to_glm(point)), 3.4F, to_glm(ink, 1), to_glm(ink), 1});
  }
}

}  // namespace

void add_stretch(std::vector<Ribbon>& ribbons, std::span<const glm::vec3> stretch, const glm::vec4& colour,
                 float width) {
  for (std::size_t k = 0; k + 1 < stretch.size(); ++k) ribbons.push_back({stretch[k], stretch[k + 1], colour, width});
}

Colour point_hue(int i, bool dark) {
  // Without the two pale hues: they would be lost as lines on paper.
  constexpr std::array<int, 6> strong{0, 1, 2, 3, 4, 6};
  return scene::patch_hue(strong[static_cast<std::size_t>(i) % strong.size()], dark);
}

void add_polygon(Picture& picture, std::span<const Eigen::Vector3d> points, bool closed) {
  const std::size_t legs = points.size() - (closed ? 0 : 1);
  const glm::vec4 ink = to_glm(mixed(picture.theme.stage, picture.theme.ink_soft, 0.55F), 1);
  for (std::size_t k = 0; k < legs; ++k)
    add_line(picture.ribbons, points[k], points[(k + 1) % points.size()], ink, leg_width);
}

void add_hued_curve(Picture& picture, const scene::CurveFigure& figure, float width, float strength) {
  std::vector<glm::vec3> hues;
  hues.reserve(figure.curve.points().size());
  for (int i = 0; i < figure.curve.knots().count(); ++i) hues.push_back(oklab(point_hue(i, picture.theme.dark)));
  CurvePath path(picture.view, curve_view(figure.curve), figure.samples);
  for (std::size_t k = 0; k + 1 < figure.samples.size(); ++k) {
    const Colour ink = picture.display.patch_colours ? mixture(figure, k, hues) : picture.theme.ink;
    add_stretch(picture.ribbons, path.stretch(k), to_glm(mixed(picture.theme.stage, ink, strength), 1), width);
  }
}

/// On the curve, filled where two or more coincide; the ends of an open curve need no mark.
void add_knots(Picture& picture, const scene::CurveFigure& figure) {
  for (const scene::CurveFigure::Mark& mark : figure.marks) {
    if (!mark.inner) continue;
    const Colour& face = mark.last > mark.first ? picture.theme.accent : picture.theme.stage;
    picture.discs.push_back({glm::vec3(to_glm(mark.point)), 4.6F, to_glm(face, 1), to_glm(picture.theme.accent), 1.7F});
  }
}

Colour mixed_hues(std::span<const float> weights, std::span<const glm::vec3> hues) {
  glm::vec3 lab(0);
  float chroma = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    lab += weights[j] * hues[j];
    chroma += weights[j] * std::hypot(hues[j].y, hues[j].z);
  }
  const float left = std::hypot(lab.y, lab.z);
  const float gain = left > 0.01F ? std::min(std::lerp(1.0F, chroma / left, 0.7F), 2.2F) : 1.0F;
  return srgb({lab.x, gain * lab.y, gain * lab.z});
}

void add_curve(Picture& picture, const scene::CurveFigure& figure, const InteractionState& state) {
  const scene::Display& display = picture.display;
  const std::optional<HandleIndex> held = state.selected ? state.selected : state.hovered;
  if (display.polygon) add_polygon(picture, figure.curve.points(), figure.curve.knots().closed());
  if (held && *held != parameter_handle && held->first < figure.curve.knots().count())
    add_band(picture, figure, held->first);

  add_hued_curve(picture, figure);
  if (display.knot_lines) add_knots(picture, figure);
  if (display.construction) add_construction(picture, figure);
  if (state.insertion)
    picture.overlay_discs.push_back({glm::vec3(state.insertion->position), 6, to_glm(picture.theme.stage, 0.9F),
                                     to_glm(picture.theme.ink_soft), 1.6F});
}

void add_points(Picture& picture, std::span<const Handle> handles, const InteractionState& state) {
  add_points(picture, handles, state, [dark = picture.theme.dark](int i) { return point_hue(i, dark); });
}

void add_points(Picture& picture, std::span<const Handle> handles, const InteractionState& state,
                const std::function<Colour(int)>& hue_of) {
  const Theme& theme = picture.theme;
  const Colour white = theme.dark ? theme.stage : Colour{1, 1, 1};
  const float base = handles.size() > 200 ? 3.6F : handles.size() > 60 ? 5.2F : 7.0F;
  for (const Handle& handle : handles) {
    if (!handle.screen) continue;
    const bool selected = state.selected == handle.index, hovered = state.hovered == handle.index;
    if (handle.index == parameter_handle) {
      const Colour ink = selected ? theme.accent : theme.ink;
      picture.discs.push_back(
          {glm::vec3(handle.position), hovered || selected ? 7.5F : 6.0F, to_glm(ink, 1), to_glm(theme.stage), 1.4F});
      continue;
    }
    const Colour hue = hue_of(handle.index.first);
    Disc disc{glm::vec3(handle.position), base, to_glm(white, 1), to_glm(hue), std::min(2.6F, 0.4F * base)};
    if (hovered) disc.radius = 1.3F * base;
    if (selected) {
      disc.radius = 1.3F * base;
      disc.fill = to_glm(theme.accent, 1);
      disc.rim = to_glm(white);
      disc.rim_width = 2.4F;
    }
    picture.discs.push_back(disc);
  }
}

void add_to_picture(Picture& picture, const scene::CurveFigure& figure, const Look& look) {
  add_curve(picture, figure, look.state);
  if (picture.display.handles) add_points(picture, look.handles, look.state);
}

std::vector<StageLabel> labels_of(const scene::CurveFigure& figure, std::span<const Handle> handles, const View& view,
                                  const Theme& theme, const Obstacles& covered) {
  // What a label should keep clear of: the points, the polygon and the curve, as dots on the screen.
  std::vector<glm::dvec2> points, dots;
  for (const Handle& handle : handles) {
    if (handle.index == parameter_handle) continue;
    if (!handle.screen) return {};
    points.emplace_back(*handle.screen);
  }
  if (points.size() > most_labels) return {};
  const std::size_t n = points.size(), legs = n - (figure.curve.knots().closed() ? 0 : 1);
  for (std::size_t k = 0; k < legs; ++k)
    for (const double share : {0.0, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9})
      dots.push_back(glm::mix(points[k], points[(k + 1) % n], share));
  for (std::size_t k = 0; k < figure.samples.size(); k += 4)
    if (const auto screen = view.project(to_glm(figure.samples[k].point))) dots.emplace_back(*screen);

  std::vector<StageLabel> labels;
  for (std::size_t k = 0; k < n; ++k) {
    glm::dvec2 best(0);
    double most = -1e9;
    for (int side = 0; side < 2 * label_sides && (side < label_sides || most < 0); ++side) {
      const double angle = 2 * std::numbers::pi * side / label_sides;
      const double distance = side < label_sides ? label_distance : far_label;
      const glm::dvec2 place = points[k] + distance * glm::dvec2(std::cos(angle), std::sin(angle));
      double clear = 2 * label_distance;
      for (const glm::dvec2& dot : dots) clear = std::min(clear, glm::length(dot - place));
      for (std::size_t other = 0; other < n; ++other)
        if (other != k) clear = std::min(clear, 0.8 * glm::length(points[other] - place));
      for (const StageLabel& other : labels)
        if (const double gap = glm::length(other.place - place); gap < 2 * label_reach.x)
          clear = std::min(clear, gap / 2);
      if (!uncovered(place, label_reach, view.viewport, covered)) clear -= 4 * label_distance;
      if (clear <= most) continue;
      most = clear;
      best = place;
    }
    labels.push_back({"c" + subscript(static_cast<int>(k)), best, point_hue(static_cast<int>(k), theme.dark)});
  }
  return labels;
}

}  // namespace knotwork::web
