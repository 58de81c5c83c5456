#pragma once

#include <vector>

#include "web/figure_picture.h"

namespace knotwork::web {

// A B-spline surface's figure as plain values added to a picture.

/// The surface, its net in front of it and faintly behind, the support of the held or hovered point, handles in their
/// hues, and the place where a press would add a row or a column.
void add_to_picture(Picture& picture, const NetSurfaceFigure& figure, const Look& look);
inline std::vector<StageLabel> labels_of(const NetSurfaceFigure&, std::span<const Handle>, const View&, const Theme&) {
  return {};
}

/// OKLab 0 of each vertex of the sampled surface.
struct VertexColours {
  std::vector<float> texels;
  int columns, rows;
};
/// The hues of the control points mixed with the very basis functions that mix the points; the chroma that opposite hues
/// would cancel is kept up in part.
VertexColours vertex_colours(const scene::NetFigure& figure, const scene::BSplineSurfaceObject& object, int samples_u,
                             int samples_v, bool dark);

}  // namespace knotwork::web
