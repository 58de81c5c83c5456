#include "web/figure_picture.h"

#include "knotwork/scene/later.h"
#include "web/blending_curve_ornaments.h"
#include "web/curve_ornaments.h"
#include "web/fit_ornaments.h"
#include "web/model_curve_ornaments.h"
#include "web/model_ornaments.h"
#include "web/net_ornaments.h"
#include "web/stage_ornaments.h"
#include "web/subdivision_ornaments.h"

namespace knotwork::web {

void add_to_picture(Picture& picture, const Figure& figure, const Look& look) {
  scene::visit_first([&](const auto& shown) { add_to_picture(picture, shown, look); }, figure);
}

bool shows_names(const Figure& figure, const scene::Display& display) {
  return std::holds_alternative<scene::ModelCurveFigure>(figure) ? display.frames : display.handles;
}

std::vector<StageLabel> labels_of(const Figure& figure, std::span<const Handle> handles, const View& view,
                                  const Theme& theme, const Obstacles& covered) {
  return scene::visit_first([&](const auto& shown) { return labels_of(shown, handles, view, theme, covered); }, figure);
}

}  // namespace knotwork::web
