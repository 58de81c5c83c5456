#pragma once

#include <span>
#include <vector>

#include "web/figure_picture.h"

namespace knotwork::web {

/// The polygon at the start thin with its handles, the polygon of the present step strong with its vertices (in pairs
/// as rings round dots), and behind them, faintly, the limit curve in the mixture of its points' hues.
void add_to_picture(Picture& picture, const scene::SubdivisionFigure& figure, const Look& look);
/// None: vertices are many.
inline std::vector<StageLabel> labels_of(const scene::SubdivisionFigure&, std::span<const Handle>, const View&,
                                         const Theme&, const Obstacles&) {
  return {};
}

}  // namespace knotwork::web
