#include "web/composition.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "web/gizmo.h"

namespace knotwork::web {
namespace {

constexpr double widest_margin = 34;     // CSS pixels to the stage's edge
constexpr double least_clearance = 10;   // CSS pixels to an obstacle
constexpr double roomy_stage = 500;      // its shorter side; from here on a gizmo at the rim keeps clear as well
constexpr int places = 11;               // tried in each direction
constexpr double smallest_share = 0.34;  // of the stage's shorter side; below it obstacles are ignored

/// The viewport whose free part has its middle at (x, y).
Viewport centred(const Viewport& stage, double x, double y) {
  Viewport viewport = stage;
  viewport.inset_left = std::max(2 * x - stage.width, 0.0);
  viewport.inset_right = std::max(stage.width - 2 * x, 0.0);
  viewport.inset_top = std::max(2 * y - stage.height, 0.0);
  viewport.inset_bottom = std::max(stage.height - 2 * y, 0.0);
  return viewport;
}

struct Fit {
  const scene::Camera& direction;
  std::span<const glm::dvec3> points;
  std::span<const std::array<double, 4>> obstacles;

  bool clear(const glm::dvec3& screen, const Viewport& stage) const {
    const double margin = std::min(widest_margin, 0.06 * std::min(stage.width, stage.height));
    if (screen.x < margin || screen.y < margin || screen.x > stage.width - margin || screen.y > stage.height - margin)
      return false;
    const double clearance = std::min(stage.width, stage.height) < roomy_stage ? least_clearance : gizmo_radius;
    return std::none_of(obstacles.begin(), obstacles.end(), [&](const auto& rect) {
      return screen.x > rect[0] - clearance && screen.x < rect[0] + rect[2] + clearance &&
             screen.y > rect[1] - clearance && screen.y < rect[1] + rect[3] + clearance;
    });
  }

  bool holds(const scene::Camera& camera, const Viewport& viewport) const {
    const View view = make_view(camera, viewport);
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
      const std::optional<glm::dvec3> screen = view.project(point);
      return screen && clear(*screen, viewport);
    });
  }
};

/// Size on the screen of something at the target: CSS pixels a model unit.
double magnification(const scene::Camera& camera, const Viewport& viewport) {
  const View view = make_view(camera, viewport);
  return 1 / view.pixel_size({camera.target.x(), camera.target.y(), camera.target.z()});
}

/// The middle of the points' box along the view's own axes: what the eye takes for the middle.
glm::dvec3 middle_of(std::span<const glm::dvec3> points, const View& view) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& point : points) {
    const glm::dvec3 along(glm::dot(point, view.right), glm::dot(point, view.up), glm::dot(point, view.forward));
    low = glm::min(low, along);
    high = glm::max(high, along);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  return middle.x * view.right + middle.y * view.up + middle.z * view.forward;
}

}  // namespace

Composition compose(const scene::Camera& direction, std::span<const glm::dvec3> points, const Viewport& viewport,
                    std::span<const std::array<double, 4>> obstacles) {
  Composition best{direction, centred(viewport, 0.5 * viewport.width, 0.5 * viewport.height)};
  if (points.empty()) return best;
  const glm::dvec3 middle = middle_of(points, make_view(direction, best.viewport));
  double radius = 0;
  for (const glm::dvec3& point : points) radius = std::max(radius, glm::distance(point, middle));
  const bool has_extent = radius > 1e-9 * (1 + glm::length(middle));
  if (!has_extent || !std::isfinite(radius)) return best;
  best.camera.target = {middle.x, middle.y, middle.z};

  const Fit fit{direction, points, obstacles};
  const auto search = [&](std::span<const std::array<double, 4>> in_the_way) {
    Fit present = fit;
    present.obstacles = in_the_way;
    double best_score = 0, best_size = 0;
    for (int a = 0; a < places; ++a) {
      for (int b = 0; b < places; ++b) {
        const double x = std::lerp(0.14, 0.86, static_cast<double>(a) / (places - 1));
        const double y = std::lerp(0.14, 0.86, static_cast<double>(b) / (places - 1));
        const Viewport tried = centred(viewport, x * viewport.width, y * viewport.height);
        scene::Camera camera = best.camera;
        camera.distance = 1;
        // A little smaller and in the middle looks better than larger and in a corner.
        const double weight = 1 - 0.35 * std::abs(x - 0.5) - 0.35 * std::abs(y - 0.5);
        const double score_at_1 = weight * magnification(camera, tried);  // in proportion to 1 / distance
        double far = best_score > 0 ? score_at_1 / best_score : 400 * radius, near = 1.02 * radius;
        camera.distance = far;
        if (far <= near || !present.holds(camera, tried)) continue;  // not even as good as the best one
        for (int k = 0; k < 13; ++k) {
          camera.distance = std::sqrt(far * near);
          (present.holds(camera, tried) ? far : near) = camera.distance;
        }
        camera.distance = far;
        best_score = score_at_1 / far;
        best_size = best_score / weight;
        best.camera.distance = camera.distance;
        best.viewport = tried;
      }
    }
    return best_size;
  };
  const double size = search(obstacles);
  if (size * 2 * radius < smallest_share * std::min(viewport.width, viewport.height)) search({});
  return best;
}

}  // namespace knotwork::web
