#pragma once

#include "web/figure_picture.h"

namespace knotwork::web {

/// The hue of local k of n: neighbours differ, over a closed seam too.
Colour local_hue(int k, int count, bool dark);

/// The model, faint; each local curve over its support in its hue, fading as its weight does, the held one strong; the
/// curve in the mixture of the two hues with the weights that mix the places; knots; at the parameter the two local
/// points that the curve's is a mixture of; handles, and the gizmo of the selected one.
void add_to_picture(Picture& picture, const scene::BlendingCurveFigure& figure, const Look& look);
/// None: the strip names the knots, and hues tell the locals apart.
inline std::vector<StageLabel> labels_of(const scene::BlendingCurveFigure&, std::span<const Handle>, const View&,
                                         const Theme&, const Obstacles&) {
  return {};
}

}  // namespace knotwork::web
