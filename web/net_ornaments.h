#pragma once

#include <vector>

#include "web/figure_picture.h"

namespace knotwork::web {

// A B-spline surface's figure as plain values added to a picture.

/// The surface, its net in front of it and faintly behind, the support of the held or hovered point, handles in their
/// hues, and the place where a press would add a row or a column.
void add_to_picture(Picture& picture, const NetSurfaceFigure& figure, const Look& look);
inline std::vector<StageLabel> labels_of(const NetSurfaceFigure&, std::span<const Handle>, const View&, const Theme&,
                                         const Obstacles&) {
  return {};
}

/// OKLab of the hue of each control point of the surface that stands on the stage, a ghost's that of what it is a ghost of.
std::vector<glm::vec3> net_hues(const scene::NetFigure& figure, const scene::BSplineSurfaceObject& object, bool dark);

}  // namespace knotwork::web
