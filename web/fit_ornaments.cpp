#include "web/fit_ornaments.h"

#include <algorithm>

#include "knotwork/scene/curve_edits.h"
#include "web/curve_ornaments.h"
#include "web/freehand.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr float whisker_width = 2, stroke_width = 2.6F, control_radius = 3.4F;

void add_whiskers(Picture& picture, const scene::FitFigure& figure) {
  const glm::vec4 ink = to_glm(mixed(picture.theme.stage, picture.theme.accent, 0.8F), 1);
  for (std::size_t j = 0; j < figure.points.size(); ++j)
    picture.ribbons.push_back(
        {glm::vec3(to_glm(figure.points[j])), glm::vec3(to_glm(figure.feet[j])), ink, whisker_width});
}

/// Not to be taken: they follow the data.
void add_control_points(Picture& picture, const scene::FitFigure& figure) {
  const std::span<const Eigen::Vector3d> points = figure.curve.curve.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Colour hue = point_hue(static_cast<int>(i), picture.theme.dark);
    picture.discs.push_back(
        {glm::vec3(to_glm(points[i])), control_radius, to_glm(hue, 1), to_glm(picture.theme.stage), 1});
  }
}

/// Data without handles; of very many the curve must still be seen between them.
void add_dots(Picture& picture, const scene::FitFigure& figure) {
  const bool many = figure.points.size() > 300;
  const float radius = figure.points.size() > 2000 ? 1.0F : many ? 1.3F : 2.6F;
  glm::vec4 ink = to_glm(picture.theme.ink, 1);
  if (many) ink.a = 0.6F;
  for (const Eigen::Vector3d& point : figure.points)
    picture.discs.push_back({glm::vec3(to_glm(point)), radius, ink, to_glm(picture.theme.ink), 0});
}

/// Data that a hand takes are rings in ink: no control point's hue is theirs.
void add_data_handles(Picture& picture, const Look& look) {
  const Theme& theme = picture.theme;
  const Colour face = theme.dark ? theme.stage : Colour{1, 1, 1};
  const float base = look.handles.size() > 60 ? 3.2F : 4.0F;
  for (const Handle& handle : look.handles) {
    if (!handle.screen) continue;
    const bool selected = look.state.selected == handle.index, hovered = look.state.hovered == handle.index;
    const float radius = (selected || hovered ? 1.35F : 1.0F) * base;
    if (selected)
      picture.discs.push_back({glm::vec3(handle.position), radius, to_glm(theme.accent, 1), to_glm(face), 2});
    else
      picture.discs.push_back({glm::vec3(handle.position), radius, to_glm(face, 1), to_glm(theme.ink), 1.6F});
  }
}

}  // namespace

void add_to_picture(Picture& picture, const scene::FitFigure& figure, const Look& look) {
  const scene::Display& display = picture.display;
  if (display.polygon) add_polygon(picture, figure.curve.curve.points(), figure.curve.curve.knots().closed());
  add_whiskers(picture, figure);
  add_hued_curve(picture, figure.curve);
  if (display.knot_lines) add_knots(picture, figure.curve);
  if (display.polygon) add_control_points(picture, figure);
  if (display.handles && !look.handles.empty())
    add_data_handles(picture, look);
  else
    add_dots(picture, figure);
  add_stroke(picture, look);
}

void add_stroke(Picture& picture, const Look& look) {
  const glm::vec4 ink = to_glm(picture.theme.accent, 1);
  const std::vector<Eigen::Vector3d> drawn =
      drawn_points(look.state.stroke, picture.view, to_glm(look.document.camera.target),
                   scene::curve_points(scene::stage_shape(look.document)));
  for (std::size_t k = 0; k + 1 < drawn.size(); ++k)
    picture.ribbons.push_back({glm::vec3(to_glm(drawn[k])), glm::vec3(to_glm(drawn[k + 1])), ink, stroke_width});
}

}  // namespace knotwork::web
