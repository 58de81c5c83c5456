#pragma once

#include "web/figure_picture.h"

namespace knotwork::web {

// What is measured has the hue of what it is measured by: curvature turns the tangent to the normal, torsion turns the
// binormal.
const Colour& bend_hue(const Theme& theme);
const Colour& twist_hue(const Theme& theme);

/// The curve in one hue, paler with the distance; at its parameter the Frenet frame as three arrows and the osculating
/// circle.
void add_to_picture(Picture& picture, const scene::ModelCurveFigure& figure, const Look& look);
/// "T", "N", "B" beside the arrows' tips.
std::vector<StageLabel> labels_of(const scene::ModelCurveFigure& figure, std::span<const Handle> handles,
                                  const View& view, const Theme& theme, const Obstacles&);

}  // namespace knotwork::web
