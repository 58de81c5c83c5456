#include "web/composition.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "web/gizmo.h"

namespace knotwork::web::composition_test {
namespace {

using Rect = std::array<double, 4>;

/// Points of a torus, wide and low as the start picture.
std::vector<glm::dvec3> torus_points() {
  std::vector<glm::dvec3> points;
  for (int a = 0; a < 24; ++a) {
    for (int b = 0; b < 12; ++b) {
      const double u = a * std::numbers::pi / 12, v = b * std::numbers::pi / 6;
      points.emplace_back((1 + 0.45 * std::cos(v)) * std::cos(u) + 3, (1 + 0.45 * std::cos(v)) * std::sin(u) - 2,
                          0.45 * std::sin(v));
    }
  }
  return points;
}

bool inside(const Rect& rect, glm::dvec3 at) {
  return at.x > rect[0] && at.x < rect[0] + rect[2] && at.y > rect[1] && at.y < rect[1] + rect[3];
}

/// The width of the picture in CSS pixels; checks on the way that it keeps clear of the edges, and of the obstacles by
/// `clearance`.
double checked_width(const Composition& composition, const std::vector<glm::dvec3>& points,
                     const std::vector<Rect>& obstacles, double clearance = 0) {
  const View view = make_view(composition.camera, composition.viewport);
  double low = 1e9, high = -1e9;
  bool all_on_stage = true, all_clear = true;
  for (const glm::dvec3& point : points) {
    const std::optional<glm::dvec3> at = view.project(point);
    REQUIRE(at.has_value());
    all_on_stage = all_on_stage && inside({0, 0, view.viewport.width, view.viewport.height}, *at);
    for (const auto& [x, y, width, height] : obstacles) {
      const Rect kept{x - clearance, y - clearance, width + 2 * clearance, height + 2 * clearance};
      all_clear = all_clear && !inside(kept, *at);
    }
    low = std::min(low, at->x);
    high = std::max(high, at->x);
  }
  CHECK(all_on_stage);
  CHECK(all_clear);
  return high - low;
}

}  // namespace

TEST_CASE("a picture fills what panel and clock leave free") {
  const std::vector<glm::dvec3> points = torus_points();
  const scene::Camera direction;
  struct Stage {
    double width, height;
    std::vector<Rect> obstacles;
    double least_width;
    double clearance;  // a gizmo's radius where there is room for it
  };
  const std::vector<Stage> stages{{806, 900, {{510, 20, 276, 410}, {0, 820, 806, 80}}, 500, gizmo_radius},
                                  {574, 768, {{300, 14, 260, 340}, {0, 700, 574, 68}}, 325, gizmo_radius},
                                  {390, 388, {{270, 10, 110, 40}, {0, 320, 390, 68}}, 260, 8},
                                  {1600, 500, {{1300, 20, 276, 410}, {0, 430, 1600, 70}}, 500, gizmo_radius}};
  for (const Stage& stage : stages) {
    CAPTURE(stage.width);
    const Composition composition =
        compose(direction, {points, {}}, {.width = stage.width, .height = stage.height}, {stage.obstacles, {}});
    CHECK(checked_width(composition, points, stage.obstacles, stage.clearance) > stage.least_width);
    CHECK(composition.camera.azimuth == direction.azimuth);
    CHECK(composition.camera.elevation == direction.elevation);
  }
}

TEST_CASE("an obstacle makes the picture smaller or moves it, never the other way round") {
  const std::vector<glm::dvec3> points = torus_points();
  const Viewport stage{.width = 800, .height = 600};
  const double free = checked_width(compose({}, {points, {}}, stage, {}), points, {});
  const std::vector<Rect> panel{{500, 0, 300, 600}};
  const double beside = checked_width(compose({}, {points, {}}, stage, {panel, {}}), points, panel);
  CHECK(free > 1.3 * beside);
  CHECK(beside > 200);
}

TEST_CASE("the camera turns about the middle of the points") {
  const std::vector<glm::dvec3> points = torus_points();
  const Composition composition = compose({}, {points, {}}, {.width = 800, .height = 600}, {});
  const View view = make_view(composition.camera, composition.viewport);
  CHECK(std::abs(composition.camera.target.x() - 3) < 0.2);
  CHECK(std::abs(composition.camera.target.y() + 2) < 0.2);
  CHECK(view.project({composition.camera.target.x(), composition.camera.target.y(), composition.camera.target.z()})
            .has_value());
}

TEST_CASE("without room, or without points, there still is a picture") {
  const std::vector<glm::dvec3> points = torus_points();
  const Viewport stage{.width = 390, .height = 388};
  const std::vector<Rect> everything{{0, 0, 390, 388}};
  CHECK(checked_width(compose({}, {points, {}}, stage, {everything, {}}), points, {}) > 200);

  const scene::Camera camera{.target = {1, 2, 3}, .distance = 7};
  CHECK(compose(camera, {}, stage, {everything, {}}).camera == camera);
  const std::vector<glm::dvec3> one(5, {1, 1, 1});
  CHECK(compose(camera, {one, {}}, stage, {}).camera.distance == camera.distance);
}

/// A phone's small stage with buttons at the top, words below them, and a plot and a clock at the foot.
struct SmallStage {
  Viewport viewport{.width = 360, .height = 294};
  std::vector<Rect> regions{{8, 8, 208, 44}, {222, 8, 134, 48}, {0, 122, 360, 108}, {10, 230, 340, 52}};
  std::vector<Rect> readouts{{0, 0, 156, 116}};
};

/// Handles on a circle in the plane that the camera looks at.
std::vector<glm::dvec3> ring_of_handles() {
  std::vector<glm::dvec3> points;
  points.reserve(20);
  for (int k = 0; k < 20; ++k)
    points.emplace_back(std::cos(k * std::numbers::pi / 10), 0, std::sin(k * std::numbers::pi / 10));
  return points;
}

scene::Camera ahead() {
  scene::Camera camera;
  camera.azimuth = -std::numbers::pi / 2;
  camera.elevation = 0;
  return camera;
}

TEST_CASE("where there is little room, every handle still is in reach") {
  const std::vector<glm::dvec3> handles = ring_of_handles();
  const SmallStage stage;
  const Composition composition = compose(ahead(), {handles, handles}, stage.viewport, {stage.regions, stage.readouts});
  CHECK(checked_width(composition, handles, stage.regions, 9.9) > 40);
}

TEST_CASE("where there is little room, what is no handle may be covered, words before buttons") {
  const std::vector<glm::dvec3> points = ring_of_handles();
  const std::vector<glm::dvec3> handles{points[5]};  // the topmost
  SmallStage stage;
  const auto composed = [&] {
    return compose(ahead(), {points, handles}, stage.viewport, {stage.regions, stage.readouts});
  };
  CHECK(checked_width(composed(), handles, stage.regions, 9.9) == 0);
  CHECK(checked_width(composed(), points, {}) > 100);

  // Without plot and clock there is room beside the buttons, if the words are given up.
  stage.regions.resize(2);
  stage.readouts = {{0, 0, 360, 250}};
  CHECK(checked_width(composed(), points, stage.regions, 9.9) > 100);
  // With room beside the words too, nothing is covered.
  stage.readouts = {{0, 0, 156, 116}};
  CHECK(checked_width(composed(), points, stage.readouts, 9.9) > 100);
}

TEST_CASE("a narrow strip between obstacles is used to its middle") {
  const std::vector<glm::dvec3> handles = ring_of_handles();
  const Viewport stage{.width = 360, .height = 294};
  // Its middle is half way between two of the places that are tried first.
  const std::vector<Rect> regions{{0, 0, 360, 58}, {0, 172, 360, 122}};
  const Composition composition = compose(ahead(), {handles, handles}, stage, {regions, {}});
  CHECK(checked_width(composition, handles, regions, 9.9) > 0.95 * (172 - 58 - 20));
}

}  // namespace knotwork::web::composition_test
