#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The part of the panel that fitted curves have.

Sentence size_text(const Frame& frame, const scene::FitFigure& figure);
/// Draw the points by hand; add and delete one.
Tools tools_of(const Frame& frame, const scene::FitFigure& figure);
inline void draw_rows(Frame&, Column&, const scene::FitFigure&) {}
inline bool has_table(const scene::FitFigure&) { return false; }
inline void draw_table(Frame&, Column&, const scene::FitFigure&) {}
/// Errors over the number of control points, where a hand chooses it, and where there is room the residuals.
float strip_height(const Frame& frame, const scene::FitFigure& figure);
void draw_strip(Frame& frame, const Rect& place, const scene::FitFigure& figure);
/// Root mean square and greatest residual; how many data and control points.
void draw_readout(Frame& frame, float left, float y, const scene::FitFigure& figure);

}  // namespace knotwork::web
