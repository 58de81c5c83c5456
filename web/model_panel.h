#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The model surface's part of the panel: whether its directions are closed, and the place under the pointer.

Sentence size_text(const Frame& frame, const ModelSurfaceFigure& figure);
inline Tools tools_of(const Frame&, const ModelSurfaceFigure&) { return {}; }
inline void draw_rows(Frame&, Column&, const ModelSurfaceFigure&) {}
inline bool has_table(const ModelSurfaceFigure&) { return false; }
inline void draw_table(Frame&, Column&, const ModelSurfaceFigure&) {}
inline float strip_height(const Frame&, const ModelSurfaceFigure&) { return 0; }
inline void draw_strip(Frame&, const Rect&, const ModelSurfaceFigure&) {}
void draw_readout(Frame& frame, float left, float y, const ModelSurfaceFigure& figure);

}  // namespace knotwork::web
