#include "web/camera.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web::camera_test {
namespace {

using std::numbers::pi;

const std::array viewports{
    Viewport{805, 900, 2, 0, 0, 0, 0},      Viewport{805, 900, 1, 0, 0, 300, 64},
    Viewport{390, 388, 3, 0, 40, 0, 56},    Viewport{300, 1200, 1, 20, 10, 30, 500},
    Viewport{1920, 400, 1.5, 700, 0, 0, 0},
};

scene::Camera camera_at(double distance, double azimuth, double elevation, const Eigen::Vector3d& target = {0, 0, 0}) {
  return {target, distance, azimuth, elevation};
}

const std::array cameras{
    scene::Camera{},
    camera_at(0.05, 2.9, -1.5533, {3, -2, 1}),
    camera_at(12, -3.1, 1.5533),
    camera_at(1e4, 0.3, -0.7, {1e5, -1e6, 20}),
    camera_at(2, 0, 0, {-1, 5, 3}),
};

template <class Check>
void for_every_view(Check check) {
  for (const Viewport& viewport : viewports) {
    for (const scene::Camera& camera : cameras) {
      CAPTURE(viewport.width);
      CAPTURE(camera.distance);
      check(camera, make_view(camera, viewport));
    }
  }
}

glm::dvec2 screen_of(const View& view, glm::dvec3 point) {
  const auto screen = view.project(point);
  REQUIRE(screen.has_value());
  return glm::dvec2(*screen);
}

double gap(glm::dvec2 a, glm::dvec2 b) { return glm::length(a - b); }

}  // namespace

TEST_CASE("the free area is what the insets leave") {
  const FreeArea area = free_area({800, 600, 1, 100, 20, 300, 80});
  CHECK(area.centre == glm::dvec2(300, 270));
  CHECK(area.size == glm::dvec2(400, 500));
  SUBCASE("greedy insets leave a quarter") {
    const FreeArea narrow = free_area({800, 600, 1, 400, 0, 800, 0});
    CHECK(narrow.size.x == doctest::Approx(200));
    CHECK(narrow.centre.x == doctest::Approx(200 + 100));
    CHECK(narrow.size.y == 600);
  }
  SUBCASE("a stage without a size") {
    const FreeArea none = free_area({0, 0, 1, 0, 0, 0, 0});
    CHECK(none.size == glm::dvec2(1, 1));
  }
}

TEST_CASE("the target appears at the centre of the free area") {
  for_every_view([](const scene::Camera& camera, const View& view) {
    CHECK(gap(screen_of(view, to_glm(camera.target)), free_area(view.viewport).centre) < 1e-6);
    CHECK(view.project(to_glm(camera.target))->z == doctest::Approx(camera.distance));
  });
}

TEST_CASE("the directions of the screen are a right-handed frame with z up") {
  for_every_view([](const scene::Camera&, const View& view) {
    CHECK(glm::length(view.right) == doctest::Approx(1));
    CHECK(glm::length(view.up) == doctest::Approx(1));
    CHECK(glm::length(glm::cross(view.right, view.up) + view.forward) < 1e-14);
    CHECK(view.right.z == 0);
    CHECK(view.up.z > 0);
  });
}

TEST_CASE("project and ray are inverse to each other") {
  std::mt19937 random(5);
  for_every_view([&](const scene::Camera& camera, const View& view) {
    std::uniform_real_distribution<double> x(-50, view.viewport.width + 50), y(-50, view.viewport.height + 50);
    std::uniform_real_distribution<double> way(0.02, 3);
    // Where coordinates are as large as a document allows, doubles near the target are this far apart.
    const double rounding = 4e-16 * camera.target.norm() / view.pixel_size(to_glm(camera.target));
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 screen(x(random), y(random));
      const scene::Ray ray = view.ray(screen);
      CHECK(ray.direction.norm() == doctest::Approx(1).epsilon(1e-14));
      const glm::dvec3 point = to_glm(ray.origin + camera.distance * way(random) * ray.direction);
      CHECK(gap(screen_of(view, point), screen) < 1e-9 + 100 * rounding);
    }
  });
}

TEST_CASE("the matrices draw where project points to") {
  for_every_view([](const scene::Camera& camera, const View& view) {
    if (camera.target.norm() > 100) return;  // a matrix with a translation of 1e6 cannot hold 1e-6 of a pixel
    for (const glm::dvec3 offset : {glm::dvec3(0.1, 0.2, -0.1), glm::dvec3(-0.3, 0.1, 0.2)}) {
      const glm::dvec3 point = to_glm(camera.target) + camera.distance * offset;
      const glm::dvec4 clip = view.projection * view.view * glm::dvec4(point, 1);
      const glm::dvec3 device = glm::dvec3(clip) / clip.w;
      const glm::dvec2 screen(view.viewport.width * (0.5 + 0.5 * device.x),
                              view.viewport.height * (0.5 - 0.5 * device.y));
      CHECK(gap(screen, screen_of(view, point)) < 1e-6);
      CHECK(std::abs(device.z) < 1);
    }
  });
}

TEST_CASE("near and far leave 24 bits enough to tell surfaces apart") {
  for (const double distance : {0.05, 0.5, 5.2, 60.0, 1e4}) {
    const View view = make_view(camera_at(distance, 0, 0), viewports[0]);
    const auto depth = [&](double d) {
      const glm::dvec4 clip = view.projection * glm::dvec4(0, 0, -d, 1);
      return 0.5 + 0.5 * clip.z / clip.w;
    };
    CHECK((depth(distance * (1 + 1e-4)) - depth(distance)) * 16777216 > 10);
    CHECK(depth(0.03 * distance) > 0);
    CHECK(depth(distance + 20) < 1);
  }
}

TEST_CASE("what is not in front of the eye has no place on the screen") {
  const View view = make_view(scene::Camera{}, viewports[1]);
  CHECK_FALSE(view.project(view.eye - view.forward).has_value());
  CHECK_FALSE(view.project(view.eye).has_value());
  CHECK_FALSE(view.project(view.eye + 3.0 * view.right).has_value());
  CHECK(view.project(view.eye + 0.01 * view.forward).has_value());
}

TEST_CASE("pixel_size is the size of a pixel") {
  for_every_view([](const scene::Camera& camera, const View& view) {
    const glm::dvec3 point = to_glm(camera.target) + 0.2 * camera.distance * (view.forward + view.up);
    const double size = view.pixel_size(point);
    const glm::dvec2 moved = screen_of(view, point + 10 * size * view.right) - screen_of(view, point);
    CHECK(gap(moved, {10, 0}) < 1e-5);
    CHECK(view.pixel_size(view.eye - 5.0 * view.forward) > 0);
  });
}

TEST_CASE("orbit turns about z and stops before the poles") {
  const scene::Camera start;
  const Viewport& viewport = viewports[0];
  const scene::Camera turned = orbit(start, {100, 50}, viewport);
  CHECK(turned.azimuth < start.azimuth);
  CHECK(turned.elevation > start.elevation);
  CHECK(turned.distance == start.distance);
  CHECK(turned.target == start.target);

  // What faces the reader follows the pointer: to the right and down.
  const View before = make_view(start, viewport), after = make_view(turned, viewport);
  const glm::dvec3 near_point = -0.5 * before.forward;
  CHECK(screen_of(after, near_point).x > screen_of(before, near_point).x + 10);
  CHECK(screen_of(after, near_point).y > screen_of(before, near_point).y + 10);

  CHECK(orbit(start, {0, 1e5}, viewport).elevation == max_elevation);
  CHECK(orbit(start, {0, -1e5}, viewport).elevation == -max_elevation);
  CHECK(std::abs(orbit(start, {12345, 0}, viewport).azimuth) <= pi);
  const double side = 805;  // the shorter one
  CHECK(std::abs(std::remainder(orbit(start, {side, 0}, viewport).azimuth - start.azimuth, 2 * pi)) ==
        doctest::Approx(pi));
}

TEST_CASE("pan takes what lies at the target's depth along with the pointer") {
  for_every_view([](const scene::Camera& camera, const View& view) {
    if (camera.target.norm() > 100) return;
    const glm::dvec3 point = to_glm(camera.target) + 0.1 * camera.distance * view.right;
    const scene::Camera moved = pan(camera, {37, -21}, view);
    const glm::dvec2 way = screen_of(make_view(moved, view.viewport), point) - screen_of(view, point);
    CHECK(gap(way, {37, -21}) < 1e-6);
  });
  scene::Camera far;
  far.target = {0.9e6, 0, 0};
  far.distance = 1e4;
  for (int k = 0; k < 100; ++k) far = pan(far, {1e5, 1e5}, make_view(far, viewports[0]));
  CHECK(far.target.cwiseAbs().maxCoeff() <= scene::max_coordinate);
}

TEST_CASE("zoom keeps what is under the anchor, at the limits of the distance too") {
  for_every_view([](const scene::Camera& camera, const View& view) {
    if (camera.target.norm() > 100) return;
    const glm::dvec2 anchor = free_area(view.viewport).centre + glm::dvec2(40, -30);
    const glm::dvec3 point =
        to_glm(camera.target) + view.pixel_size(to_glm(camera.target)) * (40.0 * view.right + 30.0 * view.up);
    REQUIRE(gap(screen_of(view, point), anchor) < 1e-6);
    for (const double factor : {1.3, 0.4, 1e9, 1e-9}) {
      const scene::Camera zoomed = zoom(camera, factor, anchor, view);
      CHECK(zoomed.distance == doctest::Approx(std::clamp(camera.distance / factor, min_distance, max_distance)));
      CHECK(gap(screen_of(make_view(zoomed, view.viewport), point), anchor) < 1e-5);
    }
  });
  const View view = make_view(scene::Camera{}, viewports[0]);
  for (const double factor : {0.0, -2.0, static_cast<double>(INFINITY)}) {
    CHECK(zoom(scene::Camera{}, factor, {0, 0}, view) == scene::Camera{});
  }
}

TEST_CASE("zoom about a point in front of the target comes nearer and nearer to it and never passes it") {
  scene::Camera camera;
  const glm::dvec3 around = to_glm(camera.target) +
                            0.6 * (make_view(camera, viewports[0]).eye - to_glm(camera.target)) +
                            glm::dvec3(0.1, 0.2, -0.1);
  const glm::dvec2 there = screen_of(make_view(camera, viewports[0]), around);
  double before = glm::distance(make_view(camera, viewports[0]).eye, around);
  for (int notch = 0; notch < 16; ++notch) {
    camera = zoom(camera, 1.25, around);
    const View view = make_view(camera, viewports[0]);
    CHECK(gap(screen_of(view, around), there) < 1e-6);
    const double now = glm::distance(view.eye, around);
    CHECK(now == doctest::Approx(before / 1.25));
    before = now;
  }
  CHECK(zoom(camera, 0, around) == camera);
}

TEST_CASE("the field of view is that of the free area's shorter side") {
  for (const Viewport& viewport : viewports) {
    const View view = make_view(scene::Camera{}, viewport);
    const FreeArea area = free_area(viewport);
    const bool wide = area.size.x > area.size.y;
    const glm::dvec2 half = wide ? glm::dvec2(0, 0.5 * area.size.y) : glm::dvec2(0.5 * area.size.x, 0);
    const glm::dvec3 a = to_glm(view.ray(area.centre + half).direction),
                     b = to_glm(view.ray(area.centre - half).direction);
    CHECK(std::acos(glm::dot(a, b)) == doctest::Approx(field_of_view));
  }
}

TEST_CASE("between goes smoothly, the shorter way round") {
  const scene::Camera from = camera_at(2, 3.0, 0.2, {1, 0, 0}), to = camera_at(8, -3.0, -0.6, {0, 2, 0});
  CHECK(between(from, to, 0) == from);
  CHECK(between(from, to, 1) == to);
  CHECK(between(from, to, -3) == from);
  CHECK(between(from, to, 7) == to);
  const scene::Camera half = between(from, to, 0.5);
  CHECK(half.distance == doctest::Approx(4));
  CHECK(half.elevation == doctest::Approx(-0.2));
  CHECK(std::abs(std::remainder(half.azimuth - pi, 2 * pi)) < 1e-9);
  CHECK((half.target - Eigen::Vector3d(0.5, 1, 0)).norm() < 1e-12);
  double last = 0;
  for (int k = 0; k <= 50; ++k) {
    const double way = (between(from, to, k / 50.0).target - from.target).norm();
    CHECK(way >= last);
    last = way;
  }
  // Eased: the first step is far smaller than an even one.
  CHECK((between(from, to, 0.02).target - from.target).norm() < 0.2 * 0.02 * std::sqrt(5.0));
}

}  // namespace knotwork::web::camera_test
