#include "web/composition.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "web/gizmo.h"

namespace knotwork::web {
namespace {

constexpr double widest_margin = 34;     // CSS pixels to the stage's edge
constexpr double least_clearance = 10;   // CSS pixels to an obstacle
constexpr double roomy_stage = 500;      // its shorter side; from here on a gizmo at the rim keeps clear as well
constexpr int places = 11;               // tried in each direction
constexpr double smallest_share = 0.34;  // of the stage's shorter side; below it obstacles are given up,
constexpr double worthwhile_gain = 1.2;  // each if it makes the picture so much larger
constexpr int refinements = 4;           // of the place on a small stage, by half the way each

/// The viewport whose free part has its middle at (x, y).
Viewport centred(const Viewport& stage, double x, double y) {
  Viewport viewport = stage;
  viewport.inset_left = std::max(2 * x - stage.width, 0.0);
  viewport.inset_right = std::max(stage.width - 2 * x, 0.0);
  viewport.inset_top = std::max(2 * y - stage.height, 0.0);
  viewport.inset_bottom = std::max(stage.height - 2 * y, 0.0);
  return viewport;
}

/// What has to keep clear of what.
struct Demands {
  bool points_off_readouts, handles_off_readouts, points_off_regions, handles_off_regions;
};
/// From all to nothing.
constexpr std::array<Demands, 5> concessions{{{true, true, true, true},
                                              {false, true, true, true},
                                              {false, false, true, true},
                                              {false, false, false, true},
                                              {false, false, false, false}}};

bool beside(glm::dvec2 place, glm::dvec2 reach, std::span<const std::array<double, 4>> obstacles) {
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const auto& rect) {
    return place.x > rect[0] - reach.x && place.x < rect[0] + rect[2] + reach.x && place.y > rect[1] - reach.y &&
           place.y < rect[1] + rect[3] + reach.y;
  });
}

bool is_small(const Viewport& stage) { return std::min(stage.width, stage.height) < roomy_stage; }

struct Fit {
  const Motif& motif;
  const Obstacles& obstacles;

  bool clear(std::span<const glm::dvec3> points, const View& view, bool off_readouts, bool off_regions) const {
    const Viewport& stage = view.viewport;
    const glm::dvec2 margin(std::min(widest_margin, 0.06 * std::min(stage.width, stage.height)));
    const glm::dvec2 clearance(is_small(stage) ? least_clearance : gizmo_radius);
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
      const std::optional<glm::dvec3> screen = view.project(point);
      if (!screen || !uncovered(*screen, margin, stage, {})) return false;
      return (!off_readouts || beside(*screen, clearance, obstacles.readouts)) &&
             (!off_regions || beside(*screen, clearance, obstacles.regions));
    });
  }

  bool holds(const scene::Camera& camera, const Viewport& viewport, const Demands& demands) const {
    const View view = make_view(camera, viewport);
    return clear(motif.handles, view, demands.handles_off_readouts, demands.handles_off_regions) &&
           clear(motif.points, view, demands.points_off_readouts, demands.points_off_regions);
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

/// The best picture so far, as the places of its middle are tried.
struct Search {
  const Fit& fit;
  const Demands& demands;
  const Viewport& stage;
  double radius;  ///< of the motif about the camera's target, model units
  scene::Camera camera;
  glm::dvec2 place{0.5, 0.5};  ///< of the middle, shares of the stage
  double score = 0, size = 0;  ///< CSS pixels a model unit; 0: none has been found

  void look_at(glm::dvec2 tried) {
    const Viewport viewport = centred(stage, tried.x * stage.width, tried.y * stage.height);
    scene::Camera moved = camera;
    moved.distance = 1;
    // A little smaller and in the middle looks better than larger and in a corner.
    const double weight = 1 - 0.35 * std::abs(tried.x - 0.5) - 0.35 * std::abs(tried.y - 0.5);
    const double score_at_1 = weight * magnification(moved, viewport);  // in proportion to 1 / distance
    double far = score > 0 ? score_at_1 / score : 400 * radius, near = 1.02 * radius;
    moved.distance = far;
    if (far <= near || !fit.holds(moved, viewport, demands)) return;  // not even as good as the best one
    for (int k = 0; k < 13; ++k) {
      moved.distance = std::sqrt(far * near);
      (fit.holds(moved, viewport, demands) ? far : near) = moved.distance;
    }
    camera.distance = far;
    score = score_at_1 / far;
    size = score / weight;
    place = tried;
  }

  void look_everywhere() {
    constexpr double step = 0.72 / (places - 1);
    for (int a = 0; a < places; ++a)
      for (int b = 0; b < places; ++b) look_at({0.14 + step * a, 0.14 + step * b});
    // Between two obstacles that leave a narrow strip, the right place may be between two of these.
    double width = step;
    for (int k = 0; k < (is_small(stage) ? refinements : 0); ++k) {
      width /= 2;
      const glm::dvec2 middle = place;
      for (const double x : {-width, 0.0, width})
        for (const double y : {-width, 0.0, width})
          if (x != 0 || y != 0) look_at(glm::clamp(middle + glm::dvec2(x, y), 0.14, 0.86));
    }
  }
};

}  // namespace

bool uncovered(glm::dvec2 place, glm::dvec2 reach, const Viewport& stage, const Obstacles& obstacles) {
  return place.x >= reach.x && place.y >= reach.y && place.x <= stage.width - reach.x &&
         place.y <= stage.height - reach.y && beside(place, reach, obstacles.regions) &&
         beside(place, reach, obstacles.readouts);
}

Composition compose(const scene::Camera& direction, const Motif& motif, const Viewport& viewport,
                    const Obstacles& obstacles) {
  const std::span<const glm::dvec3> points = motif.points;
  Composition middle_of_stage{direction, centred(viewport, 0.5 * viewport.width, 0.5 * viewport.height)};
  if (points.empty()) return middle_of_stage;
  const glm::dvec3 middle = middle_of(points, make_view(direction, middle_of_stage.viewport));
  double radius = 0;
  for (const glm::dvec3& point : points) radius = std::max(radius, glm::distance(point, middle));
  const bool has_extent = radius > 1e-9 * (1 + glm::length(middle));
  if (!has_extent || !std::isfinite(radius)) return middle_of_stage;
  scene::Camera camera = direction;
  camera.target = {middle.x, middle.y, middle.z};

  const Fit fit{motif, obstacles};
  const double enough = smallest_share * std::min(viewport.width, viewport.height) / (2 * radius);
  std::optional<Search> best;
  for (const Demands& demands : concessions) {
    const bool out_of_reach = !demands.handles_off_regions && !motif.handles.empty();
    if (best && (best->size >= enough || (out_of_reach && best->size > 0))) break;
    Search search{fit, demands, viewport, radius, camera};
    search.look_everywhere();
    if (!best || search.size > worthwhile_gain * best->size) best.emplace(search);
  }
  return {best->camera, centred(viewport, best->place.x * viewport.width, best->place.y * viewport.height)};
}

}  // namespace knotwork::web
