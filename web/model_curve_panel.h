#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// A model curve's part of the panel.

Sentence size_text(const Frame& frame, const scene::ModelCurveFigure& figure);
inline Tools tools_of(const Frame&, const scene::ModelCurveFigure&) { return {}; }
inline void draw_rows(Frame&, Column&, const scene::ModelCurveFigure&) {}
inline bool has_table(const scene::ModelCurveFigure&) { return false; }
inline void draw_table(Frame&, Column&, const scene::ModelCurveFigure&) {}
float strip_height(const Frame& frame, const scene::ModelCurveFigure& figure);
/// Curvature, and torsion unless it is 0 everywhere, against the parameter, which a press moves.
void draw_strip(Frame& frame, const Rect& place, const scene::ModelCurveFigure& figure);
void draw_readout(Frame& frame, float left, float y, const scene::ModelCurveFigure& figure);

}  // namespace knotwork::web
