#include "web/holding.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "knotwork/scene/curve_edits.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

const scene::BlendingSurfaceObject* patches_of(const scene::Shape& shape) {
  return std::get_if<scene::BlendingSurfaceObject>(&shape);
}

int point_count(const scene::Shape& shape) { return static_cast<int>(scene::curve_points(shape).size()); }

PatchScene patch_scene(const Stage& stage) {
  return {scene::blending_surface(stage.document), stage.document.animation, *stage.surface, stage.view};
}

glm::dvec3 point_of(const Stage& stage, HandleIndex index) {
  return to_glm(scene::curve_points(scene::stage_shape(stage.document))[static_cast<std::size_t>(index.first)]);
}

Commands set_edit(const Stage& stage, scene::PatchIndex patch, const scene::PatchEdit& edit) {
  if (edit == edit_of(scene::blending_surface(stage.document), patch)) return {};
  return {scene::SetPatchEdit{patch, edit}};
}

Commands set_point(const Stage& stage, HandleIndex index, glm::dvec3 position) {
  const double most = scene::limits::coordinate.max;
  const glm::dvec3 limited = glm::clamp(position, glm::dvec3(-most), glm::dvec3(most));
  if (limited == point_of(stage, index)) return {};
  return {scene::SetPoint{index.first, to_eigen(limited)}};
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
CurvePlace nearest_place(const Stage& stage, glm::dvec2 pointer) {
  const std::vector<scene::CurveFigure::Sample>& samples = stage.curve->samples;
  CurvePlace best{samples.front().t, std::numeric_limits<double>::max()};
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    const glm::dvec2 a = seen(stage.view, to_glm(samples[k].point));
    const glm::dvec2 b = seen(stage.view, to_glm(samples[k + 1].point));
    const double share = nearest_share(a, b, pointer);
    const double distance = glm::length(a + share * (b - a) - pointer);
    if (distance < best.distance) best = {std::lerp(samples[k].t, samples[k + 1].t, share), distance};
  }
  return best;
}

Commands move_point(PointDrag& drag, const Stage& stage, glm::dvec2 pointer, bool along_z) {
  drag.pointer = pointer;
  const glm::dvec2 target = pointer - drag.grab_offset;
  if (drag.index == parameter_handle) {
    return {scene::SetParameter{"curve.parameter", nearest_place(stage, target).t}};
  }
  const scene::Ray ray = stage.view.ray(target);
  const glm::dvec3 origin = to_glm(ray.origin), direction = to_glm(ray.direction);
  if (along_z) {
    // The place of the vertical line that the ray passes nearest.
    const glm::dvec3 z(0, 0, 1), between = origin - drag.start;
    const double b = glm::dot(direction, z), d = glm::dot(direction, between), e = glm::dot(z, between);
    const double denominator = 1 - b * b;
    if (denominator < 1e-4) return {};  // seen from above z has no length
    return set_point(stage, drag.index, drag.start + (e - b * d) / denominator * z);
  }
  const double facing = glm::dot(direction, stage.view.forward);
  const double way = glm::dot(drag.start - origin, stage.view.forward) / facing;
  if (!(facing > 1e-9) || !(way > 0)) return {};
  return set_point(stage, drag.index, origin + way * direction);
}

std::optional<int> index_from(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  // One spelling for each handle: no sign, no leading zeros.
  if (!whole || value < 0 || std::to_string(value) != text) return std::nullopt;
  return value;
}

/// What follows the prefix; nothing when the text begins otherwise.
std::optional<std::string_view> after(std::string_view prefix, std::string_view text) {
  return text.starts_with(prefix) ? std::optional(text.substr(prefix.size())) : std::nullopt;
}

}  // namespace

bool has_handle(const scene::Shape& shape, HandleIndex index) {
  const auto [i, j] = index;
  if (const auto* surface = patches_of(shape))
    return i >= 0 && j >= 0 && i < surface->locals_u && j < surface->locals_v;
  return index == parameter_handle || (i >= 0 && j == 0 && i < point_count(shape));
}

std::string handle_id(const scene::Shape& shape, HandleIndex index) {
  if (patches_of(shape)) return "patch-" + std::to_string(index.first) + "-" + std::to_string(index.second);
  return index == parameter_handle ? "parameter" : "point-" + std::to_string(index.first);
}

std::optional<HandleIndex> find_handle(const scene::Shape& shape, std::string_view id) {
  std::optional<HandleIndex> found;
  if (const auto pair = after("patch-", id); pair && patches_of(shape)) {
    const std::size_t dash = std::min(pair->find('-'), pair->size());
    const auto i = index_from(pair->substr(0, dash)), j = index_from(pair->substr(std::min(dash + 1, pair->size())));
    if (i && j) found = HandleIndex(*i, *j);
  } else if (const auto number = after("point-", id); number && !patches_of(shape)) {
    if (const auto i = index_from(*number)) found = HandleIndex(*i, 0);
  } else if (id == "parameter" && !patches_of(shape)) {
    found = parameter_handle;
  }
  return found && has_handle(shape, *found) ? found : std::nullopt;
}

std::string handle_name(const scene::Shape& shape, HandleIndex index) {
  if (patches_of(shape)) return "Patch " + std::to_string(index.first) + ", " + std::to_string(index.second);
  return index == parameter_handle ? "Parameter" : "Point " + std::to_string(index.first);
}

bool exists(const Stage& stage, HandleIndex index) {
  const scene::Shape& shape = scene::stage_shape(stage.document);
  if (!has_handle(shape, index)) return false;
  if (!patches_of(shape)) return stage.curve != nullptr && index.first < stage.curve->curve.knots().count();
  return stage.surface != nullptr && index.first < stage.surface->knots_u().count() &&
         index.second < stage.surface->knots_v().count();
}

HandleIndex neighbour(const Stage& stage, std::optional<HandleIndex> from, int step) {
  const scene::Shape& shape = scene::stage_shape(stage.document);
  const auto* surface = patches_of(shape);
  const int rows = surface ? surface->locals_v : 1, count = surface ? surface->locals_u * rows : point_count(shape);
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
  const bool of_this_kind = std::holds_alternative<PatchDrag>(held) ? stage.surface != nullptr : stage.curve != nullptr;
  return of_this_kind && exists(stage, handle_of(held));
}

Held take_hold(const Stage& stage, HandleIndex index, std::optional<GizmoPart> part, glm::dvec2 pointer) {
  if (stage.surface) return take_hold(patch_scene(stage), index, part, pointer);
  const glm::dvec3 start =
      index == parameter_handle ? to_glm(stage.curve->construction.back().front()) : point_of(stage, index);
  const std::optional<glm::dvec3> screen = stage.view.project(start);
  return PointDrag{index, start, screen ? pointer - glm::dvec2(*screen) : glm::dvec2(0), pointer};
}

Commands drag_to(Held& held, const Stage& stage, glm::dvec2 pointer, bool shift) {
  if (auto* point = std::get_if<PointDrag>(&held)) return move_point(*point, stage, pointer, shift);
  auto& patch = *std::get_if<PatchDrag>(&held);
  return set_edit(stage, patch.patch, drag_to(patch, patch_scene(stage), pointer, shift));
}

Commands hold_still(const Held& held, const Stage& stage) {
  const auto* patch = std::get_if<PatchDrag>(&held);
  if (!patch || (patch->part && patch->part != GizmoPart::move_normal)) return {};
  PatchDrag still = *patch;
  return set_edit(stage, still.patch, drag_to(still, patch_scene(stage), still.pointer, still.along_axis));
}

Commands nudged(const Stage& stage, HandleIndex index, glm::dvec3 pixels) {
  if (index == parameter_handle) {
    const KnotVector& knots = stage.curve->curve.knots();
    const double t = stage.curve->t + 0.001 * (pixels.x + pixels.y) * knots.period();
    return {scene::SetParameter{"curve.parameter", std::clamp(t, knots.start(), knots.end())}};
  }
  const bool patch = stage.surface != nullptr;
  const glm::dvec3 at = patch ? document_origin(patch_scene(stage), index) : point_of(stage, index);
  const glm::dvec3 third = patch ? to_glm_matrix(scene::patch_frame(*stage.surface, index))[2] : glm::dvec3(0, 0, 1);
  const glm::dvec3 offset =
      stage.view.pixel_size(at) * (pixels.x * stage.view.right + pixels.y * stage.view.up + pixels.z * third);
  return patch ? set_edit(stage, index, moved_by(patch_scene(stage), index, offset))
               : set_point(stage, index, at + offset);
}

Commands removed(const Stage& stage, HandleIndex index) {
  if (stage.surface) return set_edit(stage, index, {});
  if (index == parameter_handle) return {};
  return {scene::RemovePoint{index.first}};
}

std::optional<double> curve_parameter_at(const Stage& stage, glm::dvec2 screen, double reach) {
  if (stage.curve == nullptr) return std::nullopt;
  const CurvePlace place = nearest_place(stage, screen);
  return place.distance <= reach ? std::optional(place.t) : std::nullopt;
}

std::optional<Insertion> insertion_at(const Stage& stage, glm::dvec2 screen, double reach) {
  const scene::Shape& shape = scene::stage_shape(stage.document);
  const std::span<const Eigen::Vector3d> points = scene::curve_points(shape);
  const std::size_t legs = points.empty() ? 0 : points.size() - (scene::closes(shape) ? 0 : 1);
  std::optional<Insertion> found;
  double best = reach;
  for (std::size_t k = 0; k < legs; ++k) {
    const glm::dvec3 from = to_glm(points[k]), to = to_glm(points[(k + 1) % points.size()]);
    const std::optional<glm::dvec3> a = stage.view.project(from), b = stage.view.project(to);
    if (!a || !b) continue;
    const double share = nearest_share(glm::dvec2(*a), glm::dvec2(*b), screen);
    const double distance = glm::length(glm::dvec2(*a) + share * glm::dvec2(*b - *a) - screen);
    if (!(distance < best) || share <= 0 || share >= 1) continue;
    best = distance;
    // Equal steps on the screen are not equal steps in space.
    const double near = share / b->z, far = (1 - share) / a->z;
    found = Insertion{static_cast<int>(k) + 1, glm::mix(from, to, near / (near + far))};
  }
  return found;
}

std::optional<Insertion> insertion_after(const Stage& stage, HandleIndex index) {
  const scene::Shape& shape = scene::stage_shape(stage.document);
  const std::span<const Eigen::Vector3d> points = scene::curve_points(shape);
  const std::size_t k = static_cast<std::size_t>(std::max(index.first, 0));
  if (index == parameter_handle || k >= points.size()) return std::nullopt;
  const bool end = k + 1 == points.size() && !scene::closes(shape);
  const glm::dvec3 here = to_glm(points[k]);
  const glm::dvec3 there = to_glm(end ? points[k - 1] : points[(k + 1) % points.size()]);
  return Insertion{static_cast<int>(k) + 1, end ? 2.0 * here - there : 0.5 * (here + there)};
}

}  // namespace knotwork::web
