#pragma once

#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "web/figure_picture.h"

namespace knotwork::web {

// A curve's figure as plain ribbons and discs added to a picture, and the names of its points.

/// The hue of control point i: neighbours differ.
Colour point_hue(int i, bool dark);

/// Hues (OKLab) mixed with weights that sum to 1. Mixtures of opposite hues are grey: some of the chroma lost is given
/// back.
Colour mixed_hues(std::span<const float> weights, std::span<const glm::vec3> hues);

/// The control polygon, the curve in the mixture of its points' hues with the weights that mix their places, the stretch
/// that the held or hovered point has a say in, knots, construction, and the place where a press would add a point.
void add_curve(Picture& picture, const scene::CurveFigure& figure, const InteractionState& state);

/// Straight pieces one after another.
void add_stretch(std::vector<Ribbon>& ribbons, std::span<const glm::vec3> stretch, const glm::vec4& colour,
                 float width);

// Their parts, for figures that have a curve among other things.
void add_polygon(Picture& picture, std::span<const Eigen::Vector3d> points, bool closed);
/// In the mixture of its points' hues; `strength` below 1 lets it fade into the stage.
void add_hued_curve(Picture& picture, const scene::CurveFigure& figure, float width = 3.6F, float strength = 1);
void add_knots(Picture& picture, const scene::CurveFigure& figure);

/// Handles: white discs with a rim in the point's hue, the selected one in accent; the parameter's is a dot in ink.
void add_points(Picture& picture, std::span<const Handle> handles, const InteractionState& state);
/// The same with other hues: hue(k) is that of handle (k, 0).
void add_points(Picture& picture, std::span<const Handle> handles, const InteractionState& state,
                const std::function<Colour(int)>& hue);

void add_to_picture(Picture& picture, const scene::CurveFigure& figure, const Look& look);

/// "c₀" .. beside the control points, on the side that polygon, curve, panels and the stage's edge leave free; none where they would crowd.
std::vector<StageLabel> labels_of(const scene::CurveFigure& figure, std::span<const Handle> handles, const View& view,
                                  const Theme& theme, const Obstacles& covered);

}  // namespace knotwork::web
