#include "web/net_ornaments.h"

#include <algorithm>
#include <cmath>

#include "knotwork/mesh/surface_tables.h"
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

/// Control points in place of the figure's: of ghosts, those of the lines that they are ghosts of.
template <class Value>
BSplineSurface with_points(const scene::NetFigure& figure, const Value& value) {
  const KnotVector &u = figure.surface.knots_u(), &v = figure.surface.knots_v();
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < u.count(); ++i)
    for (int j = 0; j < v.count(); ++j) points.push_back(value(i % figure.rows, j % figure.columns));
  return BSplineSurface::make(u, v, std::move(points)).value();
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

VertexColours vertex_colours(const scene::NetFigure& figure, const scene::BSplineSurfaceObject& object, int samples_u,
                             int samples_v, bool dark) {
  const auto lab = [&](int i, int j) -> Eigen::Vector3d {
    const glm::vec3 hue = oklab(scene::patch_hue(scene::patch_hue_index(object, {i, j}), dark));
    return {hue.x, hue.y, hue.z};
  };
  const BSplineSurface hues = with_points(figure, lab);
  const BSplineSurface chromas = with_points(figure, [&](int i, int j) -> Eigen::Vector3d {
    const Eigen::Vector3d hue = lab(i, j);
    return {std::hypot(hue.y(), hue.z()), 0, 0};
  });
  const SampleGrid grid = sample_grid(hues.knots_u(), hues.knots_v(), samples_u, samples_v, Seam::repeated);
  VertexColours colours{point_table(knotted_surface(hues), grid), static_cast<int>(grid.u.size()),
                        static_cast<int>(grid.v.size())};
  const std::vector<float> chroma = point_table(knotted_surface(chromas), grid);
  for (std::size_t k = 0; k < colours.texels.size(); k += 4) {
    // As the shader mixes the hues of a blending surface.
    const float kept = std::hypot(colours.texels[k + 1], colours.texels[k + 2]);
    const float x = std::clamp(kept / 0.06F, 0.0F, 1.0F);
    const float raised = std::lerp(kept, chroma[k], 0.4F * x * x * (3 - 2 * x));
    if (kept <= 1e-5F) continue;
    colours.texels[k + 1] *= raised / kept;
    colours.texels[k + 2] *= raised / kept;
  }
  return colours;
}

}  // namespace knotwork::web
