#pragma once

#include "web/figure_picture.h"

namespace knotwork::web {

// A model surface's figure: the surface in one calm hue with its parameter lines.

void add_to_picture(Picture& picture, const ModelSurfaceFigure& figure, const Look& look);
inline std::vector<StageLabel> labels_of(const ModelSurfaceFigure&, std::span<const Handle>, const View&, const Theme&,
                                         const Obstacles&) {
  return {};
}

/// Its colour in OKLab.
glm::vec3 model_hue(const Theme& theme);

}  // namespace knotwork::web
