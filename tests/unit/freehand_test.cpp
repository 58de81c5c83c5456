#include "web/freehand.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web::freehand_test {
namespace {

View view_of(double elevation) {
  scene::Camera camera;
  camera.target = {1, 2, 3};
  camera.distance = 10;
  camera.elevation = elevation;
  return make_view(camera, {.width = 800, .height = 600});
}

const glm::dvec3 target{1, 2, 3};

Stroke arc(int events) {
  Stroke stroke;
  for (int k = 0; k < events; ++k) {
    const double angle = 3.0 * k / (events - 1);
    draw_on(stroke, {400 + 150 * std::cos(angle), 300 + 150 * std::sin(angle)});
  }
  return stroke;
}

}  // namespace

TEST_CASE("freehand: a trembling hand draws nothing, a moving one a line") {
  Stroke stroke;
  for (int k = 0; k < 50; ++k) draw_on(stroke, {100 + 0.5 * (k % 3), 100});
  CHECK(stroke.size() == 1);
  draw_on(stroke, {110, 100});
  CHECK(stroke.size() == 2);
  CHECK(drawn_points({}, view_of(0.5), target, {}).empty());
  CHECK(drawn_points({{5, 5}}, view_of(0.5), target, {}).empty());
}

TEST_CASE("freehand: steps are even, however fast the hand was, and the ends are kept") {
  const View view = view_of(0.5);
  for (const int events : {8, 40, 400}) {
    const Stroke stroke = arc(events);
    const std::vector<Eigen::Vector3d> points = drawn_points(stroke, view, target, {});
    CHECK(points.size() >= 54);  // an arc of 450 pixels
    CHECK(points.size() <= 58);
    glm::dvec2 last(*view.project(to_glm(points.front())));
    CHECK(glm::distance(last, stroke.front()) < 1e-6);
    for (std::size_t k = 1; k < points.size(); ++k) {
      const glm::dvec2 here(*view.project(to_glm(points[k])));
      CHECK(glm::distance(here, last) > 6);
      CHECK(glm::distance(here, last) < 9);
      last = here;
    }
    CHECK(glm::distance(last, stroke.back()) < 1e-6);
  }
  Stroke scribble;
  for (int k = 0; k < 40000; ++k) draw_on(scribble, {k % 2 == 0 ? 0.0 : 700.0, 0.01 * k});
  CHECK(drawn_points(scribble, view, target, {}).size() == 2000);
}

TEST_CASE("freehand: drawn in the screen's plane through the target, or in the plane of flat data") {
  const std::vector<Eigen::Vector3d> flat{{0, 0, 0.5}, {1, 0, 0.5}}, bent{{0, 0, 0.5}, {1, 0, 0.6}};
  for (const double elevation : {0.05, 0.6, 1.5}) {
    const View view = view_of(elevation);
    for (const Eigen::Vector3d& point : drawn_points(arc(40), view, target, bent))
      CHECK(std::abs(glm::dot(to_glm(point) - target, view.forward)) < 1e-9);
    for (const Eigen::Vector3d& point : drawn_points(arc(40), view, target, flat)) {
      // Seen from the side a flat plane has no width to draw on.
      if (elevation > 0.1)
        CHECK(std::abs(point.z() - 0.5) < 1e-9);
      else
        CHECK(std::abs(glm::dot(to_glm(point) - target, view.forward)) < 1e-9);
    }
  }
}

}  // namespace knotwork::web::freehand_test
