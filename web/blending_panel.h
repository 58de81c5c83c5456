#pragma once

#include "web/figure_panel.h"

namespace knotwork::web {

// The blending surface's part of the panel.

Sentence size_text(const Frame& frame, const BlendingFigure& figure);
Tools tools_of(const Frame& frame, const BlendingFigure& figure);
/// The plot of B with the weights under the pointer.
void draw_rows(Frame& frame, Column& column, const BlendingFigure& figure);
/// A blending function in a card; the legend names the weights 1 - B and B in their hues, and gives their values at w.
void draw_blending_function(Frame& frame, Column& column, const BlendingFunction& blending, std::optional<double> w,
                            const std::array<Colour, 2>& hues);
/// The report's table of domains and counts.
inline bool has_table(const BlendingFigure&) { return true; }
void draw_table(Frame& frame, Column& column, const BlendingFigure& figure);
inline float strip_height(const Frame&, const BlendingFigure&) { return 0; }
inline void draw_strip(Frame&, const Rect&, const BlendingFigure&) {}
void draw_readout(Frame& frame, float left, float y, const BlendingFigure& figure);

}  // namespace knotwork::web
