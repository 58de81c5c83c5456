#pragma once

#include <span>
#include <vector>

#include "web/figure_picture.h"

namespace knotwork::web {

/// The fitted curve in the mixture of its control points' hues, its control polygon thin, the data in ink, and from each
/// a whisker to its place on the curve; the line that a hand is drawing.
void add_to_picture(Picture& picture, const scene::FitFigure& figure, const Look& look);
/// None: data are many.
inline std::vector<StageLabel> labels_of(const scene::FitFigure&, std::span<const Handle>, const View&, const Theme&,
                                         const Obstacles&) {
  return {};
}

/// The line that a hand is drawing, where it will lie.
void add_stroke(Picture& picture, const Look& look);

}  // namespace knotwork::web
