#include "web/subdivision_ornaments.h"

#include "web/curve_ornaments.h"
#include "web/fit_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr float strong_width = 2, limit_strength = 0.5F, limit_width = 5;
constexpr std::size_t large_vertices = 120, small_vertices = 1500;  // up to so many; more are no longer told apart

void add_present_polygon(Picture& picture, const scene::SubdivisionFigure& figure) {
  const std::vector<Eigen::Vector3d>& polygon = figure.polygon;
  const glm::vec4 ink = to_glm(picture.theme.ink, 1);
  const std::size_t legs = polygon.size() - (figure.closed ? 0 : 1);
  for (std::size_t k = 0; k < legs; ++k) {
    const Eigen::Vector3d& next = polygon[(k + 1) % polygon.size()];
    if (polygon[k] == next) continue;
    picture.ribbons.push_back({glm::vec3(to_glm(polygon[k])), glm::vec3(to_glm(next)), ink, strong_width});
  }
  if (polygon.size() > small_vertices) return;
  const float radius = polygon.size() > large_vertices ? 2.0F : 3.1F;
  const std::size_t step = figure.doubled ? 2 : 1;
  for (std::size_t k = 0; k < polygon.size(); k += step) {
    const glm::vec3 place(to_glm(polygon[k]));
    if (figure.doubled)
      picture.discs.push_back({place, 1.9F * radius, to_glm(picture.theme.stage, 1), to_glm(picture.theme.ink), 1.4F});
    picture.discs.push_back({place, radius, ink, to_glm(picture.theme.ink), 0});
  }
}

}  // namespace

void add_to_picture(Picture& picture, const scene::SubdivisionFigure& figure, const Look& look) {
  if (figure.limit_shown) add_hued_curve(picture, figure.limit, limit_width, limit_strength);
  if (picture.display.polygon) add_polygon(picture, figure.points, figure.closed);
  // Handles below the vertices: before the first step they stand in one place.
  if (picture.display.handles) add_points(picture, look.handles, look.state);
  add_present_polygon(picture, figure);
  if (look.state.insertion)
    picture.overlay_discs.push_back({glm::vec3(look.state.insertion->position), 6, to_glm(picture.theme.stage, 1),
                                     to_glm(picture.theme.ink_soft), 1.6F});
  add_stroke(picture, look);
}

}  // namespace knotwork::web
