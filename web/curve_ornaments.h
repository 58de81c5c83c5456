#pragma once

#include <vector>

#include "web/interaction.h"
#include "web/panels.h"
#include "web/renderer.h"

namespace knotwork::web {

// A curve's figure as plain ribbons and discs added to a picture, and the names of its points.

/// The hue of control point i: neighbours differ.
Colour point_hue(int i, bool dark);

/// The control polygon, the curve in the mixture of its points' hues with the weights that mix their places, the stretch
/// that the held or hovered point has a say in, knots, construction, and the place where a press would add a point.
void add_curve(Picture& picture, const scene::CurveFigure& figure, const InteractionState& state);

/// Handles: white discs with a rim in the point's hue, the selected one in accent; the parameter's is a dot in ink.
void add_points(Picture& picture, const std::vector<Handle>& handles, const InteractionState& state);

/// "c₀" .. beside the control points, on the side that polygon and curve leave free; none where they would crowd.
std::vector<StageLabel> point_labels(const std::vector<Handle>& handles, const scene::CurveFigure& figure,
                                     const View& view, const Theme& theme);

}  // namespace knotwork::web
