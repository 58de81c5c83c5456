#include "web/patch_drag.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "stage_reader.h"

namespace knotwork::web::patch_drag_test {
namespace {

using std::numbers::pi;

LocalScene scene_of(Reader& reader, scene::PatchIndex patch) {
  return {scene::local_frame(reader.object(), reader.document.animation, reader.surface(), patch), reader.view};
}

glm::dvec3 document_origin(Reader& reader, scene::PatchIndex patch) {
  return to_glm(scene::local_origin(scene_of(reader, patch).local));
}

/// Applies drags of one patch to a document, without events.
struct Hand {
  Reader reader;
  scene::PatchIndex patch;
  PatchDrag drag;

  Hand(scene::Document document, scene::PatchIndex which, std::optional<GizmoPart> part, glm::dvec2 at)
      : reader(std::move(document)), patch(which), drag(take_hold(scene_now(), which, part, at)) {}

  LocalScene scene_now() { return scene_of(reader, patch); }
  scene::PatchEdit to(glm::dvec2 pointer, bool shift = false) {
    const scene::PatchEdit edit = drag_to(drag, scene_now(), pointer, shift);
    reader.object().edits[patch] = edit;
    return edit;
  }
  glm::dvec3 origin() { return to_glm(scene::local_origin(scene_now().local)); }
};

scene::Document edited_document() {
  scene::Document document = Reader::standard_document();
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.6, Eigen::Vector3d(2, -1, 1).normalized()));
  scene::blending_surface(document).edits[{4, 1}] = {{0.1, -0.05, 0.2}, rotation, {1.5, 0.5, 2}};
  return document;
}

/// The document seen along a direction of the patch's own frame.
scene::Document seen_along(scene::Document document, scene::PatchIndex patch, const Eigen::Vector3d& own) {
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  const glm::dmat3 axes = gizmo_axes(surface, scene::blending_surface(document), patch);
  const Eigen::Vector3d d = to_eigen(glm::normalize(axes * to_glm(own)));
  document.camera = {scene::patch_origin(surface, patch), 3, std::atan2(d.y(), d.x()), std::asin(d.z())};
  return document;
}

glm::dvec2 place(Hand& hand, glm::dvec3 own) {
  Reader& reader = hand.reader;
  const glm::dmat3 axes = gizmo_axes(reader.surface(), reader.object(), hand.patch);
  const glm::dvec3 origin = hand.origin();
  const double size = gizmo_radius * reader.view.pixel_size(origin);
  return glm::dvec2(*reader.view.project(origin + size * (axes * own)));
}

/// A hand on a part, at a place given in ring radii of the gizmo.
Hand hand_on(const scene::Document& document, scene::PatchIndex patch, GizmoPart part, glm::dvec3 own) {
  Hand looking(document, patch, part, {0, 0});
  return Hand(document, patch, part, place(looking, own));
}

double turn_of(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, int axis) {
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  const double along = turn.axis()[axis] * turn.angle();
  CHECK(std::abs(std::abs(along) - turn.angle()) < 1e-7);  // about that axis and no other
  return std::remainder(along, 2 * pi);
}

}  // namespace

TEST_CASE("a local frame's origin is where the builder puts the handle, whatever the animation does") {
  for (const scene::MotionKind motion : {scene::MotionKind::breathe, scene::MotionKind::report}) {
    scene::Document document = edited_document();
    document.animation = {true, 1.3, 1, motion, 0.4, 0.8, 0.5};
    Reader reader(document);
    for (const Handle& handle : reader.handles) {
      CHECK(glm::length(document_origin(reader, handle.index) - handle.position) < 1e-14);
    }
    // The surface of an earlier frame serves as well.
    reader.document.animation.time = 2.9;
    reader.object().edits[{4, 1}].translation = {0.5, 0.5, 0.5};
    CHECK(glm::length(document_origin(reader, {4, 1}) - reader.origin({4, 1})) < 1e-14);
  }
}

TEST_CASE("moved_by moves in model space and leaves the rest of the edit alone") {
  Reader reader(edited_document());
  const glm::dvec3 before = reader.origin({4, 1});
  const scene::PatchEdit start = reader.edit({4, 1}),
                         moved = moved_by(scene_of(reader, {4, 1}).local, {0.3, -0.7, 0.11});
  CHECK(moved.rotation.coeffs() == start.rotation.coeffs());
  CHECK(moved.scale == start.scale);
  reader.object().edits[{4, 1}] = moved;
  CHECK(glm::length(reader.origin({4, 1}) - before - glm::dvec3(0.3, -0.7, 0.11)) < 1e-14);
  const scene::PatchEdit far = moved_by(scene_of(reader, {4, 1}).local, {1e7, 0, 0});
  CHECK(far.translation.cwiseAbs().maxCoeff() == scene::max_coordinate);
}

TEST_CASE("Shift moves along the normal, to the point nearest to the pointer's ray") {
  Hand hand(edited_document(), {4, 1}, std::nullopt, {0, 0});
  const glm::dvec2 start(*hand.reader.view.project(hand.origin()));
  hand.drag = take_hold(hand.scene_now(), {4, 1}, std::nullopt, start + glm::dvec2(4, -3));
  const glm::dvec3 before = hand.origin();
  const glm::dvec3 normal = to_glm_matrix(scene::patch_frame(hand.reader.surface(), {4, 1}))[2];
  for (const glm::dvec2 step : {glm::dvec2(20, -40), glm::dvec2(-60, 10), glm::dvec2(0, 90)}) {
    hand.to(start + glm::dvec2(4, -3) + step, true);
    const glm::dvec3 moved = hand.origin() - before;
    CHECK(glm::length(glm::cross(moved, normal)) < 1e-12);
    const auto ray = hand.reader.view.ray(start + step);
    const auto off_ray = [&](glm::dvec3 p) {
      return glm::length(glm::cross(p - to_glm(ray.origin), to_glm(ray.direction)));
    };
    CHECK(off_ray(hand.origin()) <= off_ray(hand.origin() + 1e-4 * normal));
    CHECK(off_ray(hand.origin()) <= off_ray(hand.origin() - 1e-4 * normal));
  }
}

TEST_CASE("a normal that runs into the eye follows the pointer up and down") {
  scene::Document document = seen_along(Reader::standard_document(), {1, 1}, {0, 0, 1});
  Hand hand(document, {1, 1}, std::nullopt, {0, 0});
  const glm::dvec2 start(*hand.reader.view.project(hand.origin()));
  hand.drag = take_hold(hand.scene_now(), {1, 1}, std::nullopt, start);
  const double pixel = hand.reader.view.pixel_size(hand.origin());
  CHECK(hand.to(start + glm::dvec2(0, -30), true).translation.z() == doctest::Approx(30 * pixel));
  CHECK(hand.to(start + glm::dvec2(0, 30), true).translation.z() == doctest::Approx(-30 * pixel));
}

TEST_CASE("a pointer beyond the vanishing point leaves the handle where it is") {
  scene::Document document = seen_along(Reader::standard_document(), {1, 1}, {0.35, 0.1, -1});
  Hand hand(document, {1, 1}, std::nullopt, {0, 0});
  const glm::dvec2 start(*hand.reader.view.project(hand.origin()));
  hand.drag = take_hold(hand.scene_now(), {1, 1}, std::nullopt, start);
  const glm::dvec3 normal = to_glm_matrix(scene::patch_frame(hand.reader.surface(), {1, 1}))[2];
  const glm::dvec2 vanishing(*hand.reader.view.project(hand.reader.view.eye + 1e9 * normal));
  for (int k = 0; k <= 60; ++k) {
    hand.to(start + (k / 20.0) * (vanishing - start), true);
    const glm::dvec3 place = hand.origin();
    CHECK(glm::dot(place - hand.reader.view.eye, hand.reader.view.forward) > 0);
    CHECK(glm::length(place - hand.reader.view.eye) < 1000);
  }
}

TEST_CASE("a ring seen from the front turns with the pointer") {
  const std::array<GizmoPart, 3> rings{GizmoPart::turn_u, GizmoPart::turn_v, GizmoPart::turn_normal};
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    const glm::dvec3 a = glm::dmat3(1)[(axis + 1) % 3], b = glm::dmat3(1)[(axis + 2) % 3];
    const Eigen::Vector3d from = Eigen::Vector3d::Unit(axis) + Eigen::Vector3d(0.3, 0.2, 0.25);
    for (const double sign : {1.0, -1.0}) {  // from behind too
      const scene::Document document = seen_along(edited_document(), {4, 1}, sign * from);
      Hand hand = hand_on(document, {4, 1}, rings[static_cast<std::size_t>(axis)], a);
      CHECK_FALSE(hand.drag.by_tangent);
      Hand still(document, {4, 1}, std::nullopt, {0, 0});
      const scene::PatchEdit start = still.reader.edit({4, 1});
      scene::PatchEdit edit = start;
      for (int k = 1; k <= 20; ++k) {
        const double angle = 2.0 * k / 20;
        edit = hand.to(place(still, std::cos(angle) * a + std::sin(angle) * b));
      }
      CHECK(turn_of(start.rotation, edit.rotation, axis) == doctest::Approx(2.0));
      CHECK(edit.rotation.norm() == doctest::Approx(1).epsilon(1e-15));
      CHECK(edit.translation == start.translation);
      CHECK(edit.scale == start.scale);
    }
  }
}

TEST_CASE("turns go on past half a circle and snap to 15 degrees") {
  const scene::Document document = seen_along(Reader::standard_document(), {1, 1}, {0.2, 0.1, 1});
  Hand hand = hand_on(document, {1, 1}, GizmoPart::turn_normal, {1, 0, 0});
  Hand still(document, {1, 1}, std::nullopt, {0, 0});
  const auto on_ring = [&](double angle) { return place(still, {std::cos(angle), std::sin(angle), 0}); };
  for (int k = 1; k <= 50; ++k) hand.to(on_ring(0.1 * k));
  CHECK(hand.drag.angle == doctest::Approx(5));
  CHECK(turn_of(Eigen::Quaterniond::Identity(), hand.reader.edit({1, 1}).rotation, 2) == doctest::Approx(5 - 2 * pi));
  const scene::PatchEdit snapped = hand.to(on_ring(5.1), true);
  const double steps = turn_of(Eigen::Quaterniond::Identity(), snapped.rotation, 2) / (pi / 12);
  CHECK(steps == doctest::Approx(std::round(steps)).epsilon(1e-12));
  // Back at the start nothing is left, not even rounding.
  hand.to(on_ring(0.02), true);
  CHECK(std::abs(turn_of(Eigen::Quaterniond::Identity(), hand.reader.edit({1, 1}).rotation, 2)) < 1e-12);
}

TEST_CASE("a ring seen edge-on turns along its tangent, the near half with the pointer") {
  const scene::Document document = seen_along(Reader::standard_document(), {1, 1}, {0.05, 0.1, 1});
  // The ring about u lies in the plane of v and normal; its near end is the normal's.
  Hand near = hand_on(document, {1, 1}, GizmoPart::turn_u, {0, 0.3, 0.95});
  CHECK(near.drag.by_tangent);
  Hand still(document, {1, 1}, std::nullopt, {0, 0});
  const double small = 0.2;
  const glm::dvec2 way = place(still, {0, 0.3 * std::cos(small) - 0.95 * std::sin(small),
                                       0.95 * std::cos(small) + 0.3 * std::sin(small)}) -
                         place(still, {0, 0.3, 0.95});
  const scene::PatchEdit edit = near.to(near.drag.pointer_at_start + way);
  CHECK(turn_of(Eigen::Quaterniond::Identity(), edit.rotation, 0) == doctest::Approx(small).epsilon(0.15));

  // One radius of way is one radian.
  const scene::PatchEdit far = near.to(near.drag.pointer_at_start + gizmo_radius * near.drag.screen_axis);
  CHECK(turn_of(Eigen::Quaterniond::Identity(), far.rotation, 0) == doctest::Approx(1));
}

TEST_CASE("knobs scale by the ratio of distances") {
  const scene::Document document = seen_along(edited_document(), {4, 1}, {0.3, 0.2, 1});
  const scene::PatchEdit start = edit_of(scene::blending_surface(document), {4, 1});
  for (const int axis : {0, 1}) {
    const GizmoPart part = axis == 0 ? GizmoPart::scale_u : GizmoPart::scale_v;
    const glm::dvec3 own = glm::dmat3(1)[axis];
    Hand hand = hand_on(document, {4, 1}, part, 1.26 * own);
    Hand still(document, {4, 1}, std::nullopt, {0, 0});
    const glm::dvec2 centre = place(still, {0, 0, 0}), knob = hand.drag.pointer_at_start;
    const scene::PatchEdit doubled = hand.to(centre + 2.0 * (knob - centre));
    CHECK(doubled.scale[axis] == doctest::Approx(2 * start.scale[axis]).epsilon(1e-2));
    CHECK(doubled.scale[1 - axis] == start.scale[1 - axis]);
    CHECK(doubled.scale[2] == start.scale[2]);
    CHECK(doubled.rotation.coeffs() == start.rotation.coeffs());
    CHECK(hand.to(knob).scale[axis] == doctest::Approx(start.scale[axis]));
    CHECK(hand.to(centre - 3.0 * (knob - centre)).scale[axis] == 0.01);
    CHECK(hand.to(centre + 1e4 * (knob - centre)).scale[axis] == 100);
    const double snapped = hand.to(centre + 1.2 * (knob - centre), true).scale[axis];
    CHECK(std::remainder(snapped, 0.25) == 0);
    CHECK(hand.to(centre - 3.0 * (knob - centre), true).scale[axis] == 0.25);
  }
}

TEST_CASE("the even knob keeps the proportions, at its limits too") {
  const scene::Document document = seen_along(edited_document(), {4, 1}, {0.1, -0.2, 1});
  const scene::PatchEdit start = edit_of(scene::blending_surface(document), {4, 1});
  Hand hand = hand_on(document, {4, 1}, GizmoPart::scale_all, {0.92, 0.92, 0});
  Hand still(document, {4, 1}, std::nullopt, {0, 0});
  const glm::dvec2 centre = place(still, {0, 0, 0}), arm = hand.drag.pointer_at_start - centre;
  for (const double factor : {1.7, 0.5, 1e3, -4.0}) {
    const Eigen::Vector3d scale = hand.to(centre + factor * arm).scale;
    CHECK(scale.minCoeff() >= 0.01);
    CHECK(scale.maxCoeff() <= 100);
    CHECK((scale / scale.x() - start.scale / start.scale.x()).norm() < 1e-12);
  }
  CHECK(hand.to(centre + 1.5 * arm).scale.x() == doctest::Approx(1.5 * start.scale.x()).epsilon(1e-2));
}

TEST_CASE("a knob whose axis points at the reader still has a lever") {
  const scene::Document document = seen_along(Reader::standard_document(), {1, 1}, {1, 0, 0.02});
  Hand hand = hand_on(document, {1, 1}, GizmoPart::scale_u, {1.26, 0, 0});
  const Eigen::Vector3d scale = hand.to(hand.drag.pointer_at_start + 6.0 * hand.drag.screen_axis).scale;
  CHECK(scale.x() > 1);
  CHECK(scale.x() <= 1.6);
}

TEST_CASE("the arrow moves along the turned normal") {
  const scene::Document document = seen_along(edited_document(), {4, 1}, {1, 0.4, 0.3});
  Hand hand = hand_on(document, {4, 1}, GizmoPart::move_normal, {0, 0, 1.4});
  Hand still(document, {4, 1}, std::nullopt, {0, 0});
  const glm::dvec3 before = hand.origin(), normal = hand.drag.axes[2];
  for (const bool shift : {false, true}) {
    const glm::dvec2 end = place(still, {0, 0, 2.2});
    hand.to(end, shift);
    const glm::dvec3 moved = hand.origin() - before;
    CHECK(glm::length(glm::cross(moved, normal)) < 1e-12);
    CHECK(glm::dot(moved, normal) > 0);
    // The arrow goes along: what was grabbed stays near the pointer.
    Hand after(hand.reader.document, {4, 1}, std::nullopt, {0, 0});
    CHECK(glm::length(place(after, {0, 0, 1.4}) - end) < 8);
  }
}

}  // namespace knotwork::web::patch_drag_test
