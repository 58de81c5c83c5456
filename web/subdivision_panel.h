#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The part of the panel that subdivision curves have.

Sentence size_text(const Frame& frame, const scene::SubdivisionFigure& figure);
/// Draw the polygon by hand; add and delete a point.
Tools tools_of(const Frame& frame, const scene::SubdivisionFigure& figure);
inline void draw_rows(Frame&, Column&, const scene::SubdivisionFigure&) {}
inline bool has_table(const scene::SubdivisionFigure&) { return false; }
inline void draw_table(Frame&, Column&, const scene::SubdivisionFigure&) {}
/// A step back, a step on, the walk; below them the distance to the limit over the levels, where a hand chooses one.
float strip_height(const Frame& frame, const scene::SubdivisionFigure& figure);
void draw_strip(Frame& frame, const Rect& place, const scene::SubdivisionFigure& figure);
/// Level and vertices.
void draw_readout(Frame& frame, float left, float y, const scene::SubdivisionFigure& figure);

}  // namespace knotwork::web
