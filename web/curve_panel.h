#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The part of the panel that Bezier and B-spline curves have.

Sentence size_text(const Frame& frame, const scene::CurveFigure& figure);
Tools tools_of(const Frame& frame, const scene::CurveFigure& figure);
inline void draw_rows(Frame&, Column&, const scene::CurveFigure&) {}
inline bool has_table(const scene::CurveFigure&) { return false; }
inline void draw_table(Frame&, Column&, const scene::CurveFigure&) {}
/// Basis functions and knots.
float strip_height(const Frame& frame, const scene::CurveFigure& figure);
void draw_strip(Frame& frame, const Rect& place, const scene::CurveFigure& figure);
void draw_readout(Frame& frame, float left, float y, const scene::CurveFigure& figure);

}  // namespace knotwork::web
