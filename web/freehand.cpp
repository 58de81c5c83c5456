#include "web/freehand.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "knotwork/scene/limits.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr double least_way = 2;           // CSS pixels, nearer to the last point a hand only trembles
constexpr double even_step = 8;           // CSS pixels along the stroke
constexpr std::size_t most_drawn = 2000;  // points: more tell a fit nothing
constexpr double least_tilt = 0.15;  // of the view's direction from the horizontal, for drawing in a plane of height z

struct DrawingPlane {
  glm::dvec3 point, normal;
};

bool has_one_height(std::span<const Eigen::Vector3d> points) {
  return !points.empty() && std::all_of(points.begin(), points.end(),
                                        [&](const Eigen::Vector3d& point) { return point.z() == points[0].z(); });
}

DrawingPlane plane_for(const View& view, glm::dvec3 target, std::span<const Eigen::Vector3d> present) {
  if (has_one_height(present) && std::abs(view.forward.z) > least_tilt)
    return {glm::dvec3(target.x, target.y, present[0].z()), glm::dvec3(0, 0, 1)};
  return {target, view.forward};
}

std::optional<glm::dvec3> on_plane(const DrawingPlane& plane, const View& view, glm::dvec2 screen) {
  const scene::Ray ray = view.ray(screen);
  const glm::dvec3 origin = to_glm(ray.origin), direction = to_glm(ray.direction);
  const double facing = glm::dot(direction, plane.normal);
  const double way = glm::dot(plane.point - origin, plane.normal) / facing;
  if (std::abs(facing) < 1e-6 || !(way > 0)) return std::nullopt;
  const double limit = scene::limits::coordinate.max;
  return glm::clamp(origin + way * direction, glm::dvec3(-limit), glm::dvec3(limit));
}

/// The places at even steps along the stroke.
Stroke evenly(const Stroke& stroke) {
  double length = 0;
  for (std::size_t k = 1; k < stroke.size(); ++k) length += glm::distance(stroke[k - 1], stroke[k]);
  const auto steps = std::clamp<std::size_t>(static_cast<std::size_t>(length / even_step), 1, most_drawn - 1);
  const double step = length / static_cast<double>(steps);
  Stroke evened{stroke.front()};
  double passed = 0;
  for (std::size_t k = 1; k < stroke.size() && evened.size() < steps; ++k) {
    const double leg = glm::distance(stroke[k - 1], stroke[k]);
    while (evened.size() < steps && passed + leg >= step * static_cast<double>(evened.size())) {
      const double share = (step * static_cast<double>(evened.size()) - passed) / leg;
      evened.push_back(glm::mix(stroke[k - 1], stroke[k], share));
    }
    passed += leg;
  }
  evened.push_back(stroke.back());
  return evened;
}

}  // namespace

void draw_on(Stroke& stroke, glm::dvec2 pointer) {
  if (stroke.empty() || glm::distance(stroke.back(), pointer) >= least_way) stroke.push_back(pointer);
}

std::vector<Eigen::Vector3d> drawn_points(const Stroke& stroke, const View& view, glm::dvec3 target,
                                          std::span<const Eigen::Vector3d> present) {
  std::vector<Eigen::Vector3d> points;
  if (stroke.size() < 2) return points;
  const DrawingPlane plane = plane_for(view, target, present);
  for (const glm::dvec2& place : evenly(stroke)) {
    const std::optional<glm::dvec3> point = on_plane(plane, view, place);
    if (!point) return {};
    points.push_back(to_eigen(*point));
  }
  return points;
}

}  // namespace knotwork::web
