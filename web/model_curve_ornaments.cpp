#include "web/model_curve_ornaments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "web/curve_ornaments.h"
#include "web/curve_path.h"
#include "web/curve_tools.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr float curve_ink = 3.6F, dense_ink = 1.8F, arrow_ink = 2.4F;  // widths, CSS pixels
constexpr double arrow_length = 58, frame_barb_length = 9, frame_barb_width = 4.5, label_gap = 13;
constexpr float paleness = 0.42F;    // of the farthest part
constexpr std::size_t dense = 3000;  // samples: a curve of so many turns would run together

const Colour& curve_hue(const Theme& theme) { return theme.local[0]; }

struct FrameArrow {
  const char* name;
  glm::dvec3 tip;
  Colour hue;
};

std::array<FrameArrow, 3> arrows_of(const scene::ModelCurveFigure& figure, const View& view, const Theme& theme) {
  const glm::dvec3 foot = to_glm(figure.point);
  const double length = arrow_length * view.pixel_size(foot);
  return {{{"T", foot + length * to_glm(figure.frame.tangent), theme.local[1]},
           {"N", foot + length * to_glm(figure.frame.normal), bend_hue(theme)},
           {"B", foot + length * to_glm(figure.frame.binormal), twist_hue(theme)}}};
}

void add_arrow(Picture& picture, glm::dvec3 foot, const FrameArrow& arrow) {
  const double pixel = picture.view.pixel_size(foot);
  const glm::dvec3 along = glm::normalize(arrow.tip - foot);
  const glm::dvec3 across = glm::cross(along, picture.view.forward);
  const double width = glm::length(across);
  const glm::dvec3 side = width > 1e-6 ? across / width : picture.view.right;
  const glm::dvec3 neck = arrow.tip - frame_barb_length * pixel * along;
  const auto line = [&](glm::dvec3 from, glm::dvec3 to) {
    picture.ribbons.push_back({glm::vec3(from), glm::vec3(to), to_glm(arrow.hue, 1), arrow_ink});
  };
  line(foot, arrow.tip);
  line(arrow.tip, neck + frame_barb_width * pixel * side);
  line(arrow.tip, neck - frame_barb_width * pixel * side);
}

void add_circle(Picture& picture, const scene::ModelCurveFigure& figure) {
  if (!figure.circle) return;
  add_osculating_circle(picture, to_glm(figure.circle->centre), figure.circle->radius, to_glm(figure.frame.tangent),
                        to_glm(figure.frame.normal), 2 * figure.size);
}

}  // namespace

const Colour& bend_hue(const Theme& theme) { return theme.local[2]; }
const Colour& twist_hue(const Theme& theme) { return theme.local[3]; }

void add_to_picture(Picture& picture, const scene::ModelCurveFigure& figure, const Look& look) {
  const View& view = picture.view;
  if (picture.display.construction) add_circle(picture, figure);
  // Far parts first and paler: what passes over what is seen.
  const std::size_t count = figure.samples.size() - 1;
  std::vector<float> depths(count);
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 middle = 0.5 * (to_glm(figure.samples[k].point) + to_glm(figure.samples[k + 1].point));
    depths[k] = static_cast<float>(glm::dot(middle - view.eye, view.forward));
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depths[a] > depths[b]; });
  const float far = depths[order.front()], near = depths[order.back()];
  // A flat curve seen from above is all near.
  const float range = std::max(far - near, static_cast<float>(figure.size));
  const float width = count > dense ? dense_ink : curve_ink;
  CurvePath path(view, curve_view(figure.model), figure.samples);
  for (const std::size_t k : order) {
    const float share = paleness * (depths[k] - near) / range;
    const Colour ink = mixed(curve_hue(picture.theme), picture.theme.stage, share);
    add_stretch(picture.ribbons, path.stretch(k), to_glm(ink, 1), width);
  }
  if (picture.display.frames)
    for (const FrameArrow& arrow : arrows_of(figure, view, picture.theme))
      add_arrow(picture, to_glm(figure.point), arrow);
  if (picture.display.handles) add_points(picture, look.handles, look.state);
}

std::vector<StageLabel> labels_of(const scene::ModelCurveFigure& figure, std::span<const Handle>, const View& view,
                                  const Theme& theme, const Obstacles&) {
  std::vector<StageLabel> labels;
  const std::optional<glm::dvec3> foot = view.project(to_glm(figure.point));
  if (!foot) return labels;
  for (const FrameArrow& arrow : arrows_of(figure, view, theme)) {
    const std::optional<glm::dvec3> tip = view.project(arrow.tip);
    if (!tip) continue;
    const glm::dvec2 way = glm::dvec2(*tip) - glm::dvec2(*foot);
    const double length = glm::length(way);
    // An arrow that points at the reader has no free side.
    if (length > 12) labels.push_back({arrow.name, glm::dvec2(*tip) + label_gap / length * way, arrow.hue});
  }
  return labels;
}

}  // namespace knotwork::web
