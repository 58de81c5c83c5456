#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// A blending curve's part of the panel.

Sentence size_text(const Frame& frame, const scene::BlendingCurveFigure& figure);
Tools tools_of(const Frame& frame, const scene::BlendingCurveFigure& figure);
/// The plot of B with the weights at the parameter.
void draw_rows(Frame& frame, Column& column, const scene::BlendingCurveFigure& figure);
inline bool has_table(const scene::BlendingCurveFigure&) { return false; }
inline void draw_table(Frame&, Column&, const scene::BlendingCurveFigure&) {}
float strip_height(const Frame& frame, const scene::BlendingCurveFigure& figure);
/// The weights over the parameter line as bumps in their locals' hues, their sum, the parameter, and the knots, which
/// are dragged between their neighbours.
void draw_strip(Frame& frame, const Rect& place, const scene::BlendingCurveFigure& figure);
void draw_readout(Frame& frame, float left, float y, const scene::BlendingCurveFigure& figure);

}  // namespace knotwork::web
