#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The B-spline surface's part of the panel.

Sentence size_text(const Frame& frame, const NetSurfaceFigure& figure);
inline Tools tools_of(const Frame&, const NetSurfaceFigure&) { return {}; }
inline void draw_rows(Frame&, Column&, const NetSurfaceFigure&) {}
inline bool has_table(const NetSurfaceFigure&) { return false; }
inline void draw_table(Frame&, Column&, const NetSurfaceFigure&) {}
/// The basis functions of u and of v side by side, each with its knots and with buttons for a line more and a line less.
float strip_height(const Frame& frame, const NetSurfaceFigure& figure);
void draw_strip(Frame& frame, const Rect& place, const NetSurfaceFigure& figure);
/// The point that is selected; the place under the pointer with its curvatures and the weights at work there.
void draw_readout(Frame& frame, float left, float y, const NetSurfaceFigure& figure);

}  // namespace knotwork::web
