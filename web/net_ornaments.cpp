#include "web/net_ornaments.h"

#include <algorithm>

#include "knotwork/scene/palette.h"
#include "web/stage_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr float leg_width = 1.5F, hidden_leg_width = 1.1F;

/// All legs of the net; to a closed direction's first line again. While a direction rolls, one leg leads to the ghost.
void add_net(Picture& picture, const scene::NetFigure& figure) {
  const BSplineSurface& surface = figure.surface;
  const int legs_u = surface.knots_u().closed() ? figure.rows : std::min(figure.rows, surface.knots_u().count() - 1);
  const int legs_v =
      surface.knots_v().closed() ? figure.columns : std::min(figure.columns, surface.knots_v().count() - 1);
  const glm::vec4 front = to_glm(picture.theme.ink, picture.theme.dark ? 0.62F : 0.5F);
  const glm::vec4 behind = to_glm(picture.theme.ink, picture.theme.dark ? 0.2F : 0.16F);
  const auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    picture.ribbons.push_back({glm::vec3(to_glm(a)), glm::vec3(to_glm(b)), front, leg_width});
    picture.hidden_ribbons.push_back({glm::vec3(to_glm(a)), glm::vec3(to_glm(b)), behind, hidden_leg_width});
  };
  const int rows = surface.knots_u().closed() ? figure.rows : legs_u + 1;
  const int columns = surface.knots_v().closed() ? figure.columns : legs_v + 1;
  for (int i = 0; i < legs_u; ++i)
    for (int j = 0; j < columns; ++j) add(surface.point(i, j), surface.point(i + 1, j));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < legs_v; ++j) add(surface.point(i, j), surface.point(i, j + 1));
}

void add_points(Picture& picture, std::span<const Handle> handles, const scene::BSplineSurfaceObject& object,
                const InteractionState& state) {
  const Theme& theme = picture.theme;
  const float base = handles.size() > 1200 ? 2.2F : handles.size() > 300 ? 3.4F : handles.size() > 80 ? 4.6F : 5.8F;
  for (const Handle& handle : handles) {
    if (!handle.screen) continue;
    const Colour hue = scene::patch_hue(scene::patch_hue_index(object, handle.index), theme.dark);
    picture.discs.push_back(handle_disc(handle, hue, base, state, theme));
  }
}

}  // namespace

void add_to_picture(Picture& picture, const NetSurfaceFigure& figure, const Look& look) {
  const scene::NetFigure& net = figure.shown;
  const BSplineSurface& surface = net.surface;
  picture.surface = true;
  const auto period = [](const KnotVector& knots) {
    return knots.closed() ? static_cast<float>(scene::cell_count(knots)) : 0.0F;
  };
  picture.knot_period = {period(surface.knots_u()), period(surface.knots_v())};
  const std::optional<HandleIndex> held = look.state.selected ? look.state.selected : look.state.hovered;
  if (held && !look.rolling && held->first < net.rows && held->second < net.columns) {
    const scene::CellRange u = scene::support_cells(surface.knots_u(), held->first);
    const scene::CellRange v = scene::support_cells(surface.knots_v(), held->second);
    picture.support = glm::vec4(u.start, u.end, v.start, v.end);
  }
  if (picture.display.normals) add_normals(picture, knotted_surface(surface));
  if (picture.display.polygon) add_net(picture, net);
  if (!picture.display.handles) return;
  if (const auto* object = std::get_if<scene::BSplineSurfaceObject>(&scene::stage_shape(look.document)))
    add_points(picture, look.handles, *object, look.state);
  if (look.state.insertion)
    picture.overlay_discs.push_back({glm::vec3(look.state.insertion->position), 6, to_glm(picture.theme.stage, 0.9F),
                                     to_glm(picture.theme.ink_soft), 1.6F});
}

std::vector<glm::vec3> net_hues(const scene::NetFigure& figure, const scene::BSplineSurfaceObject& object, bool dark) {
  std::vector<glm::vec3> hues;
  hues.reserve(figure.surface.points().size());
  for (int i = 0; i < figure.surface.knots_u().count(); ++i) {
    for (int j = 0; j < figure.surface.knots_v().count(); ++j)
      hues.push_back(
          oklab(scene::patch_hue(scene::patch_hue_index(object, {i % figure.rows, j % figure.columns}), dark)));
  }
  return hues;
}

}  // namespace knotwork::web
