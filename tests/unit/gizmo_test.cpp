#include "web/gizmo.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web::gizmo_test {
namespace {

constexpr std::array all_parts{GizmoPart::turn_u,  GizmoPart::turn_v,    GizmoPart::turn_normal, GizmoPart::scale_u,
                               GizmoPart::scale_v, GizmoPart::scale_all, GizmoPart::move_normal};
const Viewport viewport{805, 900, 1, 0, 0, 300, 60};

struct Setting {
  scene::BlendingSurfaceObject object;
  BlendingSurface surface;
  View view;

  explicit Setting(const scene::Camera& camera = {}, scene::BlendingSurfaceObject shape = {})
      : object(std::move(shape)), surface(scene::build_surface(object, {})), view(make_view(camera, viewport)) {}
  Gizmo gizmo(scene::PatchIndex patch) const { return make_gizmo(surface, object, patch, view); }
};

glm::dvec2 screen_of(const View& view, glm::dvec3 point) {
  const auto screen = view.project(point);
  REQUIRE(screen.has_value());
  return glm::dvec2(*screen);
}

/// A camera that looks at a patch along a direction of its frame.
scene::Camera facing(const Setting& setting, scene::PatchIndex patch, const Eigen::Vector3d& own_direction,
                     double distance) {
  const Eigen::Vector3d d = (scene::patch_frame(setting.surface, patch) * own_direction).normalized();
  return {scene::patch_origin(setting.surface, patch), distance, std::atan2(d.y(), d.x()), std::asin(d.z())};
}

}  // namespace

TEST_CASE("the parts are told apart") {
  int rings = 0, knobs = 0;
  for (const GizmoPart part : all_parts) {
    rings += turns(part) ? 1 : 0;
    knobs += scales(part) ? 1 : 0;
    CHECK_FALSE((turns(part) && scales(part)));
  }
  CHECK(rings == 3);
  CHECK(knobs == 3);
  CHECK(gizmo_axis(GizmoPart::turn_u) == 0);
  CHECK(gizmo_axis(GizmoPart::scale_v) == 1);
  CHECK(gizmo_axis(GizmoPart::move_normal) == 2);
}

TEST_CASE("the gizmo's axes are the patch's, turned by its edit") {
  scene::BlendingSurfaceObject object;
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  object.edits[{2, 1}] = {{0.1, 0, 0.2}, rotation, {1, 2, 3}};
  const Setting setting({}, object);
  const Gizmo gizmo = setting.gizmo({2, 1});
  const Eigen::Matrix3d expected = scene::patch_frame(setting.surface, {2, 1}) * rotation.toRotationMatrix();
  for (int k = 0; k < 3; ++k) CHECK(glm::length(gizmo.axes[k] - to_glm(Eigen::Vector3d(expected.col(k)))) < 1e-14);
  CHECK(glm::length(glm::cross(gizmo.axes[0], gizmo.axes[1]) - gizmo.axes[2]) < 1e-14);
  CHECK(glm::length(gizmo.origin - to_glm(scene::patch_origin(setting.surface, {2, 1}))) == 0);

  // Unmoved: along the surface and out of it.
  const Gizmo plain = setting.gizmo({0, 0});
  const Eigen::Vector2d centre = setting.surface.centre(0, 0);
  const SurfaceJet jet = evaluate(setting.surface.model(), centre.x(), centre.y());
  CHECK(glm::dot(plain.axes[0], to_glm(jet.su)) == doctest::Approx(jet.su.norm()));
  CHECK(std::abs(glm::dot(plain.axes[2], to_glm(jet.sv))) < 1e-12);
}

TEST_CASE("its size is constant on the screen") {
  const Setting start;
  for (const double distance : {0.4, 3.0, 50.0}) {
    const Setting setting(facing(start, {1, 1}, {0, 0, 1}, distance));
    const Gizmo gizmo = setting.gizmo({1, 1});
    const glm::dvec2 centre = screen_of(setting.view, gizmo.origin);
    for (const GizmoStroke& stroke : gizmo.strokes) {
      if (stroke.part != GizmoPart::turn_normal) continue;
      for (const glm::dvec3& point : stroke.points) {
        CHECK(glm::length(screen_of(setting.view, point) - centre) == doctest::Approx(gizmo_radius).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("rings close; knobs and arrow stand outside of them") {
  const Setting setting;
  const Gizmo gizmo = setting.gizmo({3, 0});
  std::array<int, 7> strokes{};
  for (const GizmoStroke& stroke : gizmo.strokes) {
    ++strokes[static_cast<std::size_t>(stroke.part)];
    REQUIRE_FALSE(stroke.points.empty());
    if (turns(stroke.part)) {
      CHECK(stroke.points.front() == stroke.points.back());
      for (const glm::dvec3& point : stroke.points) {
        CHECK(glm::length(point - gizmo.origin) == doctest::Approx(gizmo.size));
        CHECK(std::abs(glm::dot(point - gizmo.origin, gizmo.axes[gizmo_axis(stroke.part)])) < 1e-12);
      }
    } else if (stroke.radius > 0) {
      CHECK(stroke.points.size() == 1);
      const double px = setting.view.pixel_size(gizmo.origin);
      CHECK(glm::length(stroke.points[0] - gizmo.origin) - stroke.radius * px > gizmo.size);
    }
  }
  for (const int count : strokes) CHECK(count > 0);
}

TEST_CASE("every part is under the pointer that points at it") {
  const Setting start;
  const Setting setting(facing(start, {1, 1}, {0.5, 0.35, 0.8}, 4));
  const Gizmo gizmo = setting.gizmo({1, 1});
  std::array<bool, 7> found{};
  for (const GizmoStroke& stroke : gizmo.strokes) {
    for (const glm::dvec3& point : stroke.points) {
      const auto picked = pick_gizmo(gizmo, setting.view, screen_of(setting.view, point), 8);
      REQUIRE(picked.has_value());
      // Where strokes cross another may win; knobs are never covered.
      if (stroke.radius > 0) CHECK(*picked == stroke.part);
      if (*picked == stroke.part) found[static_cast<std::size_t>(stroke.part)] = true;
    }
  }
  for (const bool part : found) CHECK(part);
}

TEST_CASE("reach is counted in CSS pixels, from a knob's rim") {
  const Setting start;
  const Setting setting(facing(start, {1, 1}, {0, 0, 1}, 4));
  const Gizmo gizmo = setting.gizmo({1, 1});
  const glm::dvec2 centre = screen_of(setting.view, gizmo.origin);
  const glm::dvec2 u = glm::normalize(screen_of(setting.view, gizmo.origin + gizmo.size * gizmo.axes[0]) - centre);
  const glm::dvec2 away = u;
  const glm::dvec2 knob = screen_of(setting.view, gizmo.origin + 1.26 * gizmo.size * gizmo.axes[0]);
  CHECK(pick_gizmo(gizmo, setting.view, knob + 12.0 * away, 8) == GizmoPart::scale_u);
  CHECK_FALSE(pick_gizmo(gizmo, setting.view, knob + 14.0 * away, 8).has_value());
  CHECK(pick_gizmo(gizmo, setting.view, knob + 14.0 * away, 18) == GizmoPart::scale_u);
  const glm::dvec2 diagonal = glm::normalize(glm::dvec2(u.x - u.y, u.x + u.y));
  CHECK(pick_gizmo(gizmo, setting.view, centre - (gizmo_radius + 6) * diagonal, 8) == GizmoPart::turn_normal);
  CHECK_FALSE(pick_gizmo(gizmo, setting.view, centre - (gizmo_radius + 10) * diagonal, 8).has_value());
  CHECK_FALSE(pick_gizmo(gizmo, setting.view, {5, 5}, 8).has_value());
}

TEST_CASE("where rings cross on the screen the one in front is held") {
  const Setting start;
  const Setting setting(facing(start, {1, 1}, {0.6, 0.5, 0.62}, 4));
  const Gizmo gizmo = setting.gizmo({1, 1});
  const auto passes_in_front = [&](const GizmoStroke& stroke, glm::dvec3 place) {
    for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k) {
      const glm::dvec3 a = *setting.view.project(stroke.points[k]), b = *setting.view.project(stroke.points[k + 1]);
      const glm::dvec2 along = glm::dvec2(b - a), to = glm::dvec2(place - a);
      const double t = glm::dot(to, along) / glm::dot(along, along);
      if (t < 0 || t > 1 || place.z - a.z < 0.6 * gizmo.size) continue;
      if (glm::length(to - t * along) < 0.8) return true;
    }
    return false;
  };
  int crossings = 0;
  for (const GizmoStroke& behind : gizmo.strokes) {
    for (const GizmoStroke& before : gizmo.strokes) {
      if (!turns(behind.part) || !turns(before.part) || behind.part == before.part) continue;
      for (const glm::dvec3& point : behind.points) {
        const glm::dvec3 place = *setting.view.project(point);
        if (!passes_in_front(before, place)) continue;
        ++crossings;
        CHECK(pick_gizmo(gizmo, setting.view, glm::dvec2(place), 8) != behind.part);
      }
    }
  }
  CHECK(crossings > 0);
}

TEST_CASE("a patch behind the camera has no gizmo to hold") {
  scene::Camera camera;
  camera.target = {0, 0, 50};
  camera.distance = 1;
  camera.elevation = -1.2;  // looks up, away from the surface
  const Setting setting(camera);
  const Gizmo gizmo = setting.gizmo({0, 0});
  CHECK(gizmo.strokes.empty());
  CHECK(gizmo.size > 0);
  CHECK_FALSE(pick_gizmo(gizmo, setting.view, {300, 300}, 1e9).has_value());
}

}  // namespace knotwork::web::gizmo_test
