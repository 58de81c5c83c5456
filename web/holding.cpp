#include "web/holding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/knot_edits.h"
#include "knotwork/scene/later.h"
#include "knotwork/surface/surface_measures.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

const scene::BSplineSurfaceObject* net_of(const Stage& stage) {
  return std::get_if<scene::BSplineSurfaceObject>(&stage.shape());
}

glm::dvec3 point_of(const Stage& stage, HandleIndex index) {
  if (const auto* object = net_of(stage)) {
    const auto [i, j] = index;
    return to_glm(object->net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  }
  return to_glm(scene::curve_points(stage.shape())[static_cast<std::size_t>(index.first)]);
}

Commands set_edit(const Stage& stage, HandleIndex index, const scene::PatchEdit& edit) {
  if (edit == local_of(stage, index)->edit) return {};
  if (stage.surface()) return {scene::SetPatchEdit{index, edit}};
  return {scene::SetLocalEdit{index.first, edit}};
}

Commands set_point(const Stage& stage, HandleIndex index, glm::dvec3 position) {
  const double most = scene::limits::coordinate.max;
  const glm::dvec3 limited = glm::clamp(position, glm::dvec3(-most), glm::dvec3(most));
  if (limited == point_of(stage, index)) return {};
  if (net_of(stage)) return {scene::SetNetPoint{index, to_eigen(limited)}};
  return {scene::SetPoint{index.first, to_eigen(limited)}};
}

/// Where Shift moves a point along: z, or the normal of its surface where the point has its say.
KNOTWORK_LATER glm::dvec3 point_axis(const Stage& stage, HandleIndex index) {
  const auto* figure = std::get_if<NetSurfaceFigure>(&stage.figure);
  if (!figure || !net_of(stage)) return {0, 0, 1};
  const KnotVector &u = figure->shown.surface.knots_u(), &v = figure->shown.surface.knots_v();
  const double at_u = u.reduced(scene::greville(u, index.first)), at_v = v.reduced(scene::greville(v, index.second));
  return to_glm(unit_normal(figure->shown.surface.evaluate(at_u, at_v)));
}

/// The screen position of a point, or far away when it is behind the camera.
glm::dvec2 seen(const View& view, glm::dvec3 point) {
  const std::optional<glm::dvec3> screen = view.project(point);
  return screen ? glm::dvec2(*screen) : glm::dvec2(1e12);
}

/// The share in [0,1] of the segment from a to b that is nearest to p.
double nearest_share(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  const double length2 = glm::dot(b - a, b - a);
  return length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
}

/// The drawn curve's place that is nearest on the screen.
struct CurvePlace {
  double t, distance;  ///< CSS pixels
};
KNOTWORK_LATER CurvePlace nearest_place(const Stage& stage, glm::dvec2 pointer) {
  const std::span<const scene::CurveSample> path = path_of(stage.figure);
  CurvePlace best{path.front().t, std::numeric_limits<double>::max()};
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const glm::dvec2 a = seen(stage.view, to_glm(path[k].point));
    const glm::dvec2 b = seen(stage.view, to_glm(path[k + 1].point));
    const double share = nearest_share(a, b, pointer);
    const double distance = glm::length(a + share * (b - a) - pointer);
    if (distance < best.distance) best = {std::lerp(path[k].t, path[k + 1].t, share), distance};
  }
  return best;
}

Commands move_point(PointDrag& drag, const Stage& stage, glm::dvec2 pointer, bool along_axis) {
  drag.pointer = pointer;
  const glm::dvec2 target = pointer - drag.grab_offset;
  if (drag.index == parameter_handle) {
    return {scene::SetParameter{"curve.parameter", nearest_place(stage, target).t}};
  }
  const scene::Ray ray = stage.view.ray(target);
  const glm::dvec3 origin = to_glm(ray.origin), direction = to_glm(ray.direction);
  if (along_axis) {
    // The place of the line along the axis that the ray passes nearest.
    const glm::dvec3 between = origin - drag.start;
    const double b = glm::dot(direction, drag.axis), d = glm::dot(direction, between), e = glm::dot(drag.axis, between);
    const double denominator = 1 - b * b;
    if (denominator < 1e-4) return {};  // seen from its end a line has no length
    return set_point(stage, drag.index, drag.start + (e - b * d) / denominator * drag.axis);
  }
  const double facing = glm::dot(direction, stage.view.forward);
  const double way = glm::dot(drag.start - origin, stage.view.forward) / facing;
  if (!(facing > 1e-9) || !(way > 0)) return {};
  return set_point(stage, drag.index, origin + way * direction);
}

Insertion insertion_before(int index, glm::dvec3 position) {
  return {index, position, scene::InsertPoint{index, to_eigen(position)}, {index, 0}};
}

glm::dvec3 handle_place(const Stage& stage, HandleIndex index) {
  for (const Handle& handle : stage.handles)
    if (handle.index == index) return handle.position;
  return glm::dvec3(0);
}

}  // namespace

std::optional<scene::SurfaceHit> Stage::pick(const scene::Ray& ray) const { return web::pick(figure, ray); }

std::optional<scene::LocalFrame> local_of(const Stage& stage, HandleIndex index) {
  const scene::Animation& animation = stage.document.animation;
  const auto* patches = std::get_if<scene::BlendingSurfaceObject>(&stage.shape());
  if (patches && stage.surface()) return scene::local_frame(*patches, animation, *stage.surface(), index);
  const auto* curve = std::get_if<scene::BlendingCurveObject>(&stage.shape());
  const auto* figure = std::get_if<scene::BlendingCurveFigure>(&stage.figure);
  if (!curve || !figure || index == parameter_handle) return std::nullopt;
  return figure->local(index.first, *curve, animation);
}

std::optional<Gizmo> gizmo_of(const Stage& stage, HandleIndex index) {
  // A rolling surface is not quite where the document has it.
  if (stage.surface()) return make_gizmo(*stage.surface(), scene::blending_surface(stage.document), index, stage.view);
  const std::optional<scene::LocalFrame> local = local_of(stage, index);
  if (!local) return std::nullopt;
  return make_gizmo(to_glm(scene::local_origin(*local)), to_glm_matrix(scene::turned_axes(*local)), stage.view);
}

bool exists(const Stage& stage, HandleIndex index) {
  return has_handle(stage.shape(), index) && has_handle(stage.shown, index);
}

HandleIndex neighbour(const Stage& stage, std::optional<HandleIndex> from, int step) {
  const HandleGrid grid = handle_grid(stage.shape());
  const int rows = grid.rows, count = grid.columns * rows;
  if (count == 0) return parameter_handle;
  const bool somewhere = from && *from != parameter_handle;
  const int present = somewhere ? from->first * rows + from->second : step > 0 ? -1 : count;
  const int next = (present + step + count) % count;
  return {next / rows, next % rows};
}

HandleIndex handle_of(const Held& held) {
  const auto* patch = std::get_if<PatchDrag>(&held);
  return patch ? patch->patch : std::get_if<PointDrag>(&held)->index;
}

bool exists(const Stage& stage, const Held& held) {
  if (!exists(stage, handle_of(held))) return false;
  return std::holds_alternative<PatchDrag>(held) == local_of(stage, handle_of(held)).has_value();
}

Held take_hold(const Stage& stage, HandleIndex index, std::optional<GizmoPart> part, glm::dvec2 pointer) {
  if (const auto local = local_of(stage, index)) return take_hold({*local, stage.view}, index, part, pointer);
  const glm::dvec3 start = index == parameter_handle ? handle_place(stage, index) : point_of(stage, index);
  const std::optional<glm::dvec3> screen = stage.view.project(start);
  const glm::dvec2 offset = screen ? pointer - glm::dvec2(*screen) : glm::dvec2(0);
  return PointDrag{index, start, offset, pointer, point_axis(stage, index)};
}

Commands drag_to(Held& held, const Stage& stage, glm::dvec2 pointer, bool shift) {
  if (auto* point = std::get_if<PointDrag>(&held)) return move_point(*point, stage, pointer, shift);
  auto& patch = *std::get_if<PatchDrag>(&held);
  return set_edit(stage, patch.patch, drag_to(patch, {*local_of(stage, patch.patch), stage.view}, pointer, shift));
}

Commands hold_still(const Held& held, const Stage& stage) {
  const auto* patch = std::get_if<PatchDrag>(&held);
  if (!patch || (patch->part && patch->part != GizmoPart::move_normal)) return {};
  PatchDrag still = *patch;
  return set_edit(stage, still.patch,
                  drag_to(still, {*local_of(stage, still.patch), stage.view}, still.pointer, still.along_axis));
}

Commands nudged(const Stage& stage, HandleIndex index, glm::dvec3 pixels) {
  if (index == parameter_handle) {
    const scene::Parameter& row = *scene::find_parameter("curve.parameter");
    const scene::Limits range = scene::range_of(stage.document, row);
    const scene::ParameterValue now = row.get(stage.document);
    const double t = *std::get_if<double>(&now) + 0.001 * (pixels.x + pixels.y) * (range.max - range.min);
    return {scene::SetParameter{"curve.parameter", std::clamp(t, range.min, range.max)}};
  }
  const std::optional<scene::LocalFrame> local = local_of(stage, index);
  const glm::dvec3 at = local ? to_glm(scene::local_origin(*local)) : point_of(stage, index);
  const glm::dvec3 third = local ? to_glm_matrix(local->axes)[2] : point_axis(stage, index);
  const glm::dvec3 offset =
      stage.view.pixel_size(at) * (pixels.x * stage.view.right + pixels.y * stage.view.up + pixels.z * third);
  return local ? set_edit(stage, index, moved_by(*local, offset)) : set_point(stage, index, at + offset);
}

Commands removed(const Stage& stage, HandleIndex index) {
  if (local_of(stage, index)) return set_edit(stage, index, {});
  if (index == parameter_handle || net_of(stage)) return {};  // of a net whole lines go, by their own buttons
  return {scene::RemovePoint{index.first}};
}

bool takes_list(const Stage& stage) { return scene::is_made_from_list(stage.shape()); }

bool adds_on_polygon(const Stage& stage) {
  return has_polygon(stage) && !std::holds_alternative<scene::FittedCurveObject>(stage.shape());
}

bool has_polygon(const Stage& stage) { return net_of(stage) || !scene::curve_points(stage.shape()).empty(); }

std::optional<double> curve_parameter_at(const Stage& stage, glm::dvec2 screen, double reach) {
  if (path_of(stage.figure).empty()) return std::nullopt;
  const CurvePlace place = nearest_place(stage, screen);
  return place.distance <= reach ? std::optional(place.t) : std::nullopt;
}

namespace {

/// The leg nearest to a place on the screen: where on it, measured in space.
struct LegPlace {
  double distance;  ///< CSS pixels
  double share;
};
std::optional<LegPlace> place_on_leg(const View& view, glm::dvec3 from, glm::dvec3 to, glm::dvec2 screen) {
  const std::optional<glm::dvec3> a = view.project(from), b = view.project(to);
  if (!a || !b) return std::nullopt;
  const double share = nearest_share(glm::dvec2(*a), glm::dvec2(*b), screen);
  if (share <= 0 || share >= 1) return std::nullopt;
  // Equal steps on the screen are not equal steps in space.
  const double near = share / b->z, far = (1 - share) / a->z;
  return LegPlace{glm::length(glm::dvec2(*a) + share * glm::dvec2(*b - *a) - screen), near / (near + far)};
}

/// A knot at the place of a net's leg that lies between the Greville abscissae of its ends, and the line that it makes.
std::optional<Insertion> insertion_on_net(const Stage& stage, const scene::BSplineSurfaceObject& object,
                                          glm::dvec2 screen, double reach) {
  std::optional<Insertion> found;
  double best = reach;
  for (const scene::NetDirection direction : {scene::NetDirection::u, scene::NetDirection::v}) {
    const bool along_u = direction == scene::NetDirection::u;
    const KnotVector knots = scene::net_knots(object, direction);
    const int n = knots.count(), across = along_u ? object.columns() : object.rows();
    for (int line = 0; line < across; ++line) {
      for (int k = 0; k + (knots.closed() ? 0 : 1) < n; ++k) {
        const auto at = [&](int index) { return along_u ? HandleIndex(index, line) : HandleIndex(line, index); };
        const glm::dvec3 from = point_of(stage, at(k)), to = point_of(stage, at((k + 1) % n));
        const std::optional<LegPlace> place = place_on_leg(stage.view, from, to, screen);
        if (!place || !(place->distance < best)) continue;
        best = place->distance;
        const double start = scene::greville(knots, k);
        const double end = k + 1 < n ? scene::greville(knots, k + 1) : scene::greville(knots, 0) + knots.period();
        const double t = knots.reduced(std::lerp(start, end, place->share));
        found = Insertion{k + 1, glm::mix(from, to, place->share), scene::InsertNetLine{direction, t}, at(k + 1)};
      }
    }
  }
  return found;
}

}  // namespace

std::optional<Insertion> insertion_at(const Stage& stage, glm::dvec2 screen, double reach) {
  if (const auto* object = net_of(stage)) return insertion_on_net(stage, *object, screen, reach);
  const scene::Shape& shape = stage.shape();
  const std::span<const Eigen::Vector3d> points = scene::curve_points(shape);
  const std::size_t legs = points.empty() ? 0 : points.size() - (scene::closes(shape) ? 0 : 1);
  std::optional<Insertion> found;
  double best = reach;
  for (std::size_t k = 0; k < legs; ++k) {
    const glm::dvec3 from = to_glm(points[k]), to = to_glm(points[(k + 1) % points.size()]);
    const std::optional<LegPlace> place = place_on_leg(stage.view, from, to, screen);
    if (!place || !(place->distance < best)) continue;
    best = place->distance;
    found = insertion_before(static_cast<int>(k) + 1, glm::mix(from, to, place->share));
  }
  return found;
}

std::optional<Landing> landing(const Stage& stage, const Insertion& insertion) {
  const auto* line = std::get_if<scene::InsertNetLine>(&insertion.command);
  if (!line || !net_of(stage)) return Landing{insertion.handle, insertion.position};
  scene::BSplineSurfaceObject after = *net_of(stage);
  if (!scene::insert_net_line(after, line->direction, line->at)) return std::nullopt;
  // In a closed direction a knot near the start may number the lines anew: the one with its say there is meant.
  const KnotVector knots = scene::net_knots(after, line->direction);
  const auto gap = [&](int k) {
    const double way = std::abs(scene::greville(knots, k) - line->at);
    return knots.closed() ? std::min(std::fmod(way, knots.period()), knots.period() - std::fmod(way, knots.period()))
                          : way;
  };
  int nearest = 0;
  for (int k = 1; k < knots.count(); ++k)
    if (gap(k) < gap(nearest)) nearest = k;
  HandleIndex handle = insertion.handle;
  (line->direction == scene::NetDirection::u ? handle.first : handle.second) = nearest;
  const auto [i, j] = handle;
  return Landing{handle, to_glm(after.net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)])};
}

std::optional<Insertion> insertion_after(const Stage& stage, HandleIndex index) {
  const scene::Shape& shape = stage.shape();
  const std::span<const Eigen::Vector3d> points = scene::curve_points(shape);
  const std::size_t k = static_cast<std::size_t>(std::max(index.first, 0));
  if (index == parameter_handle || k >= points.size()) return std::nullopt;
  const bool end = k + 1 == points.size() && !scene::closes(shape);
  const glm::dvec3 here = to_glm(points[k]);
  const glm::dvec3 there = to_glm(end ? points[k - 1] : points[(k + 1) % points.size()]);
  return insertion_before(static_cast<int>(k) + 1, end ? 2.0 * here - there : 0.5 * (here + there));
}

}  // namespace knotwork::web
