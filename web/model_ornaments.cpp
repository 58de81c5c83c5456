#include "web/model_ornaments.h"

#include "web/stage_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {

void add_to_picture(Picture& picture, const ModelSurfaceFigure& figure, const Look&) {
  picture.surface = true;
  picture.one_sided = figure.shown.one_sided();
  if (picture.display.normals) add_normals(picture, knotted_surface(figure.shown));
}

glm::vec3 model_hue(const Theme& theme) {
  const glm::vec3 hue = oklab(theme.local[0]);
  return {theme.dark ? 0.66F : 0.72F, 0.42F * hue.y, 0.42F * hue.z};
}

}  // namespace knotwork::web
