#include "web/interaction.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include "stage_reader.h"

namespace knotwork::web::interaction_test {
namespace {

using Drag = InteractionState::Drag;

double gap(glm::dvec2 a, glm::dvec2 b) { return glm::length(a - b); }

const std::array<scene::Camera, 4> cameras{
    scene::Camera{},
    scene::Camera{{0.2, 0.1, -0.1}, 2.6, 2.5, -1.2},
    scene::Camera{{0, 0, 0}, 9, -3.0, 1.5533},
    scene::Camera{{1.2, 0, 0}, 1.8, 0.2, 0.3},
};

scene::Document playing_document(scene::MotionKind motion) {
  scene::Document document = Reader::standard_document();
  document.animation = {true, 0.4, 1.5, motion, 0.3, 1, 0.5};
  return document;
}

void touch(Reader& reader) { reader.device = PointerDevice::touch; }

}  // namespace

TEST_CASE("handle ids") {
  scene::BlendingSurfaceObject many;
  many.locals_u = many.locals_v = 128;
  const scene::Shape surface = many;
  CHECK(handle_id(surface, {2, 1}) == "patch-2-1");
  CHECK(find_handle(surface, "patch-2-1") == scene::PatchIndex(2, 1));
  CHECK(find_handle(surface, "patch-0-127") == scene::PatchIndex(0, 127));
  for (const char* wrong :
       {"", "patch", "patch-", "patch-2", "patch-2-", "patch--2-1", "patch-2--1", "patch-2-1-", "patch-2-1 ",
        "patch-02-1", "patch-+2-1", "Patch-2-1", "patch-2-99999999999", "patch-a-b"}) {
    CAPTURE(wrong);
    CHECK_FALSE(find_handle(surface, wrong).has_value());
  }
}

TEST_CASE("a tap on a handle selects it and changes nothing") {
  for (const PointerDevice device : {PointerDevice::mouse, PointerDevice::pen, PointerDevice::touch}) {
    Reader reader;
    reader.device = device;
    const scene::Document before = reader.document;
    const scene::PatchIndex patch = reader.visible_handle(2);
    const glm::dvec2 at = reader.at(patch);
    CHECK(reader.down(at).used);
    CHECK(reader.selected(patch));
    CHECK(reader.notice == "Patch " + std::to_string(patch.first) + ", " + std::to_string(patch.second) + " selected");
    reader.move(at + glm::dvec2(2, 1));
    CHECK(reader.up(at + glm::dvec2(2, 1)).used);
    CHECK(reader.document == before);
    CHECK_FALSE(reader.history.can_undo());
    CHECK(reader.state.drag == Drag::none);
  }
}

TEST_CASE("a dragged handle stays under the pointer, from every side") {
  for (const scene::Camera& camera : cameras) {
    for (const PointerDevice device : {PointerDevice::mouse, PointerDevice::touch}) {
      for (const bool frame_each_event : {true, false}) {
        CAPTURE(camera.distance);
        CAPTURE(frame_each_event);
        scene::Document document = Reader::standard_document();
        document.camera = camera;
        Reader reader(document);
        reader.device = device;
        reader.frame_each_event = frame_each_event;
        const scene::Document before = reader.document;
        const scene::PatchIndex patch = reader.visible_handle(1);
        const glm::dvec2 grab = reader.at(patch) + glm::dvec2(5, -4);
        const double depth = glm::dot(reader.origin(patch) - reader.view.eye, reader.view.forward);
        reader.down(grab);
        for (int k = 1; k <= 30; ++k) {
          const glm::dvec2 pointer = grab + glm::dvec2(7 * k, 60 * std::sin(0.2 * k));
          CHECK(reader.move(pointer).used);
          CHECK(gap(reader.at(patch), pointer - glm::dvec2(5, -4)) < 1e-6);
          CHECK(glm::dot(reader.origin(patch) - reader.view.eye, reader.view.forward) == doctest::Approx(depth));
        }
        reader.up(grab + glm::dvec2(210, 60 * std::sin(6.0)));
        CHECK(reader.object().edits.size() == 1);
        CHECK(reader.edit(patch).rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
        CHECK(reader.notice.ends_with(" moved"));
        // One step of history for the whole drag.
        REQUIRE(reader.history.can_undo());
        CHECK(reader.history.undo(reader.document));
        CHECK(reader.document == before);
        CHECK_FALSE(reader.history.can_undo());
      }
    }
  }
}

TEST_CASE("a drag that comes back leaves no entry") {
  Reader reader;
  const glm::dvec2 at = reader.at(reader.visible_handle());
  reader.down(at);
  reader.move(at + glm::dvec2(40, 0));
  reader.move(at);
  reader.up(at);
  CHECK(reader.edit(reader.visible_handle()).translation.norm() < 1e-12);
}

TEST_CASE("what a tap may wander is 3 pixels for a mouse, 6 for a finger") {
  for (const auto& [device, slack] : {std::pair{PointerDevice::mouse, 3.0}, std::pair{PointerDevice::touch, 6.0}}) {
    Reader reader;
    reader.device = device;
    const glm::dvec2 at = reader.at(reader.visible_handle());
    reader.down(at);
    CHECK_FALSE(reader.move(at + glm::dvec2(slack - 0.1, 0)).begin_gesture);
    CHECK(reader.object().edits.empty());
    const Outcome outcome = reader.move(at + glm::dvec2(slack + 0.1, 0));
    CHECK(outcome.begin_gesture);
    CHECK(reader.object().edits.size() == 1);
    reader.up(at);
  }
}

TEST_CASE("one event with the whole way is a drag too") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle();
  const glm::dvec2 at = reader.at(patch);
  reader.down(at);
  const Outcome outcome = reader.up(at + glm::dvec2(50, 20));
  CHECK(outcome.begin_gesture);
  CHECK(outcome.end_gesture);
  CHECK(gap(reader.at(patch), at + glm::dvec2(50, 20)) < 1e-6);
}

TEST_CASE("Shift in the middle of a drag goes along the normal, without a jump") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle(1);
  const glm::dvec2 grab = reader.at(patch) + glm::dvec2(3, 2);
  const glm::dvec3 normal = to_glm_matrix(scene::patch_frame(reader.surface(), patch))[2];
  reader.down(grab);
  reader.move(grab + glm::dvec2(40, 10));
  const glm::dvec3 in_plane = reader.origin(patch);

  reader.modifiers.shift = true;
  reader.move(grab + glm::dvec2(40, 10));
  CHECK(glm::length(reader.origin(patch) - in_plane) < 1e-12);
  reader.move(grab + glm::dvec2(41, 9));
  CHECK(glm::length(reader.origin(patch) - in_plane) < 20 * reader.view.pixel_size(in_plane));
  reader.move(grab + glm::dvec2(70, -60));
  const glm::dvec3 along = reader.origin(patch);
  CHECK(glm::length(along - in_plane) > 1e-3);
  CHECK(glm::length(glm::cross(along - in_plane, normal)) < 1e-12);

  reader.modifiers.shift = false;
  reader.move(grab + glm::dvec2(70, -60));
  CHECK(glm::length(reader.origin(patch) - along) < 1e-12);
  const glm::dvec2 at = reader.at(patch);
  reader.move(grab + glm::dvec2(80, -75));
  CHECK(gap(reader.at(patch), at + glm::dvec2(10, -15)) < 1e-6);
  reader.up(grab + glm::dvec2(80, -75));
  CHECK(reader.history.undo(reader.document));
  CHECK(reader.object().edits.empty());
}

TEST_CASE("while the animation plays the handle stays under the pointer") {
  for (const scene::MotionKind motion : {scene::MotionKind::breathe, scene::MotionKind::report}) {
    for (const bool frame_each_event : {true, false}) {
      Reader reader(playing_document(motion));
      reader.frame_each_event = frame_each_event;
      const scene::PatchIndex patch = reader.visible_handle(1);
      const glm::dvec2 grab = reader.at(patch) + glm::dvec2(-4, 5);
      reader.down(grab);
      glm::dvec2 pointer = grab;
      for (int k = 1; k <= 40; ++k) {
        reader.happen([] {
          Outcome tick;
          tick.commands.emplace_back(scene::AdvanceClock{0.05});
          return tick;
        }());
        if (k % 3 == 0) {  // the pointer rests for two frames of three
          pointer = grab + glm::dvec2(3 * k, -k);
          reader.move(pointer);
        } else if (k > 3) {
          reader.happen(hold(reader.state, reader.stage()));
        }
        if (k >= 3) CHECK(gap(reader.at(patch), pointer - glm::dvec2(-4, 5)) < 1e-6);
      }
      CHECK(reader.document.animation.time > 2);
      reader.up(pointer);
      CHECK(hold(reader.state, reader.stage()).commands.empty());
      CHECK(reader.history.undo(reader.document));
      CHECK(reader.object().edits.empty());
      CHECK_FALSE(reader.history.can_undo());
    }
  }
}

TEST_CASE("pointercancel and Escape put the document back") {
  for (const bool by_key : {false, true}) {
    for (const bool gizmo : {false, true}) {
      Reader reader;
      const scene::PatchIndex patch = reader.visible_handle(1);
      reader.drag(reader.at(patch), reader.at(patch) + glm::dvec2(30, 10));
      const scene::Document before = reader.document;
      glm::dvec2 grab = reader.at(patch);
      if (gizmo) {
        for (const GizmoStroke& stroke : make_gizmo(reader.surface(), reader.object(), patch, reader.view).strokes) {
          if (stroke.part == GizmoPart::scale_u && stroke.radius > 0) grab = *reader.view.project(stroke.points[0]);
        }
      }
      reader.down(grab);
      CHECK(reader.state.drag == (gizmo ? Drag::gizmo : Drag::handle));
      reader.move(grab + glm::dvec2(60, 60));
      CHECK(reader.document != before);
      CHECK((by_key ? reader.press("Escape") : reader.send(PointerType::cancel, {0, 0})).cancel_gesture);
      CHECK(reader.document == before);
      CHECK(reader.selected(patch));
      // The finger still there does nothing more.
      CHECK_FALSE(reader.move(grab + glm::dvec2(90, 90)).begin_gesture);
      reader.up(grab + glm::dvec2(90, 90));
      CHECK(reader.document == before);
      CHECK(reader.state.drag == Drag::none);
      CHECK(reader.history.undo(reader.document));
      CHECK_FALSE(reader.history.can_undo());
    }
  }
}

TEST_CASE("a press whose release was lost does not wedge the stage") {
  Reader reader;
  const scene::PatchIndex first = reader.visible_handle(0), second = reader.visible_handle(3);
  const glm::dvec2 at = reader.at(first);
  reader.down(at);
  reader.move(at + glm::dvec2(30, 30));
  const Outcome again = reader.down(reader.at(second));
  CHECK(again.end_gesture);
  CHECK(reader.selected(second));
  const glm::dvec2 from = reader.at(second);
  reader.move(from + glm::dvec2(20, 0));
  reader.up(from + glm::dvec2(20, 0));
  CHECK(reader.object().edits.size() == 2);
  CHECK(reader.history.undo(reader.document));
  CHECK(reader.object().edits.size() == 1);
  CHECK(reader.history.undo(reader.document));
  CHECK_FALSE(reader.history.can_undo());
}

TEST_CASE("on empty space: orbit, and pan with Shift or another button") {
  Reader reader;
  const scene::Camera start = reader.document.camera;
  const glm::dvec2 at = reader.empty_place();
  reader.drag(at, at + glm::dvec2(100, 40));
  CHECK(reader.document.camera.azimuth < start.azimuth);
  CHECK(reader.document.camera.elevation > start.elevation);
  CHECK(reader.document.camera.target == start.target);
  CHECK_FALSE(reader.history.can_undo());

  for (const auto& [button, shift] : {std::pair{1, false}, std::pair{2, false}, std::pair{0, true}}) {
    Reader panning;
    panning.modifiers.shift = shift;
    panning.down(at, 1, button);
    panning.move(at + glm::dvec2(50, 20));
    panning.up(at + glm::dvec2(50, 20));
    CHECK(panning.document.camera.azimuth == start.azimuth);
    CHECK(panning.document.camera.target != start.target);
  }
  // A middle or right press on a handle pans too.
  Reader right;
  const scene::PatchIndex patch = right.visible_handle();
  right.down(right.at(patch), 1, 2);
  CHECK(right.state.drag == Drag::pan);
  CHECK_FALSE(right.state.selected.has_value());
}

TEST_CASE("an orbit begins without a jerk and does not depend on how many events tell of it") {
  std::array<scene::Camera, 2> ends;
  for (std::size_t k = 0; k < 2; ++k) {
    Reader reader;
    reader.frame_each_event = k == 0;
    reader.drag(reader.empty_place(), reader.empty_place() + glm::dvec2(200, 0), k == 0 ? 1 : 400);
    ends[k] = reader.document.camera;
  }
  CHECK(ends[0].azimuth == doctest::Approx(ends[1].azimuth));
  Reader reader;
  const double start = reader.document.camera.azimuth;
  reader.down(reader.empty_place());
  reader.move(reader.empty_place() + glm::dvec2(3.5, 0));
  CHECK(std::abs(reader.document.camera.azimuth - start) < 0.01);
}

TEST_CASE("two fingers pan and pinch; the same places stay under them") {
  for (const bool frame_each_event : {true, false}) {
    Reader reader;
    touch(reader);
    reader.frame_each_event = frame_each_event;
    const glm::dvec2 a(60, 700), b(160, 760);
    REQUIRE_FALSE(reader.stage().pick(reader.view.ray(0.5 * (a + b))).has_value());
    reader.down(a, 1);
    reader.down(b, 2);
    CHECK(reader.state.drag == Drag::pinch);
    // Model points at the target's depth under both fingers.
    const View before = make_view(reader.document.camera, reader.viewport);
    const auto under = [&](glm::dvec2 screen) {
      const auto ray = before.ray(screen);
      const glm::dvec3 direction = to_glm(ray.direction);
      return before.eye + reader.document.camera.distance / glm::dot(direction, before.forward) * direction;
    };
    const glm::dvec3 at_a = under(a), at_b = under(b);
    const double distance = reader.document.camera.distance;
    for (int k = 1; k <= 20; ++k) {
      reader.move(a + 1.0 * k * glm::dvec2(-2, -3), 1);
      reader.move(b + 1.0 * k * glm::dvec2(8, 3), 2);
    }
    const glm::dvec2 end_a = a + glm::dvec2(-40, -60), end_b = b + glm::dvec2(160, 60);
    const View after = make_view(reader.document.camera, reader.viewport);
    CHECK(reader.document.camera.distance ==
          doctest::Approx(distance * glm::length(b - a) / glm::length(end_b - end_a)));
    CHECK(reader.document.camera.azimuth == scene::Camera{}.azimuth);
    // Pan and zoom cannot turn; the midpoint is what stays.
    const glm::dvec2 middle = 0.5 * (glm::dvec2(*after.project(at_a)) + glm::dvec2(*after.project(at_b)));
    CHECK(gap(middle, 0.5 * (end_a + end_b)) < 1e-6);
    CHECK_FALSE(reader.history.can_undo());
  }
}

TEST_CASE("a pinch over the surface keeps the place between the fingers and never passes it") {
  Reader reader;
  touch(reader);
  const glm::dvec2 middle = reader.at(reader.visible_handle()) + glm::dvec2(10, -20);
  const auto hit = reader.stage().pick(reader.view.ray(middle));
  REQUIRE(hit.has_value());
  const glm::dvec3 place = to_glm(hit->jet.s);
  glm::dvec2 shift(0);
  for (int pinch = 0; pinch < 4; ++pinch) {
    const glm::dvec2 a = middle + shift - glm::dvec2(30, 10), b = middle + shift + glm::dvec2(30, 10);
    reader.down(a, 1);
    reader.down(b, 2);
    for (int k = 1; k <= 10; ++k) {
      reader.move(a - static_cast<double>(k) * glm::dvec2(12, 3), 1);
      reader.move(b + static_cast<double>(k) * glm::dvec2(14, 5), 2);
    }
    shift += glm::dvec2(10, 10);
    CHECK(gap(glm::dvec2(*reader.view.project(place)), middle + shift) < 0.5);
    reader.up(a - glm::dvec2(120, 30), 1);
    reader.up(b + glm::dvec2(140, 50), 2);
  }
  CHECK(reader.view.pixel_size(place) < 0.01 * make_view(scene::Camera{}, reader.viewport).pixel_size(place));
}

TEST_CASE("fingers left over from a pinch rest; a finger put back goes on") {
  Reader reader;
  touch(reader);
  reader.down({100, 300}, 1);
  reader.down({200, 300}, 2);
  reader.move({220, 300}, 2);
  reader.up({220, 300}, 2);
  const scene::Camera still = reader.document.camera;
  reader.move({180, 420}, 1);
  CHECK(reader.document.camera == still);

  reader.down({400, 420}, 3);
  CHECK(reader.document.camera == still);
  reader.move({401, 420}, 3);
  CHECK(reader.document.camera.distance < still.distance);
  CHECK(reader.document.camera.distance > 0.98 * still.distance);
  reader.up({401, 420}, 3);
  reader.up({180, 420}, 1);
  CHECK(reader.state.drag == Drag::none);
  CHECK(reader.framed == 0);

  // All up: one finger orbits again.
  reader.drag(reader.empty_place(), reader.empty_place() + glm::dvec2(50, 0));
  CHECK(reader.document.camera.azimuth != still.azimuth);
}

TEST_CASE("a third finger is ignored") {
  Reader reader;
  touch(reader);
  reader.down({100, 300}, 1);
  reader.down({200, 300}, 2);
  const scene::Camera still = reader.document.camera;
  reader.down({300, 600}, 3);
  reader.move({400, 100}, 3);
  CHECK(reader.document.camera == still);
  reader.move({210, 300}, 2);
  CHECK(reader.document.camera != still);
  for (const int id : {1, 2, 3}) reader.up({210, 300}, id);
  CHECK(reader.state.drag == Drag::none);
  CHECK(reader.state.pointers.empty());
}

TEST_CASE("a second finger cancels a handle drag that has just begun and ends one that has lasted") {
  for (const bool lasted : {false, true}) {
    Reader reader;
    touch(reader);
    const scene::Document before = reader.document;
    const scene::PatchIndex patch = reader.visible_handle();
    const glm::dvec2 at = reader.at(patch);
    reader.down(at, 1);
    reader.move(at + glm::dvec2(20, 0), 1);
    CHECK(reader.object().edits.size() == 1);
    if (lasted) reader.now += 2000;
    const Outcome outcome = reader.down(at + glm::dvec2(120, 0), 2);
    CHECK(outcome.cancel_gesture == !lasted);
    CHECK(outcome.end_gesture == lasted);
    CHECK((reader.object() == scene::blending_surface(before)) == !lasted);
    reader.move(at + glm::dvec2(160, 0), 2);
    CHECK(reader.document.camera.distance < before.camera.distance);
    CHECK(reader.history.can_undo() == lasted);
  }
  // Before the drag has begun there is nothing to take back but the selection.
  Reader reader;
  touch(reader);
  const glm::dvec2 at = reader.at(reader.visible_handle());
  reader.down(at, 1);
  CHECK(reader.state.selected.has_value());
  CHECK_FALSE(reader.down(at + glm::dvec2(100, 0), 2).cancel_gesture);
  CHECK(reader.state.drag == Drag::pinch);
  CHECK_FALSE(reader.state.selected.has_value());
}

TEST_CASE("a second finger ends an orbit where it is") {
  Reader reader;
  touch(reader);
  reader.down(reader.empty_place(), 1);
  reader.move(reader.empty_place() + glm::dvec2(40, 0), 1);
  const scene::Camera turned = reader.document.camera;
  const Outcome outcome = reader.down({200, 300}, 2);
  CHECK_FALSE(outcome.cancel_gesture);
  CHECK(reader.document.camera == turned);
}

TEST_CASE("double click and double tap frame the scene") {
  for (const PointerDevice device : {PointerDevice::mouse, PointerDevice::touch}) {
    Reader reader;
    reader.device = device;
    reader.tap(reader.empty_place());
    CHECK(reader.framed == 0);
    reader.now += 200;
    reader.tap(reader.empty_place() + glm::dvec2(10, 10));
    CHECK(reader.framed == 1);
    reader.tap(reader.empty_place());  // the third of a triple begins anew
    CHECK(reader.framed == 1);
  }
  SUBCASE("too slow") {
    Reader reader;
    reader.tap(reader.empty_place());
    reader.now += 400;
    reader.tap(reader.empty_place());
    CHECK(reader.framed == 0);
  }
  SUBCASE("too far") {
    Reader reader;
    reader.tap(reader.empty_place());
    reader.tap(reader.empty_place() + glm::dvec2(0, 30));
    CHECK(reader.framed == 0);
  }
  SUBCASE("moved between") {
    Reader reader;
    reader.tap(reader.empty_place());
    reader.drag(reader.empty_place(), reader.empty_place() + glm::dvec2(10, 0), 2);
    reader.tap(reader.empty_place());
    CHECK(reader.framed == 0);
  }
  SUBCASE("on a handle") {
    Reader reader;
    const glm::dvec2 at = reader.at(reader.visible_handle());
    reader.tap(at);
    reader.tap(at);
    CHECK(reader.framed == 0);
  }
  SUBCASE("with another button") {
    Reader reader;
    for (int k = 0; k < 2; ++k) reader.down(reader.empty_place(), 1, 2), reader.up(reader.empty_place());
    CHECK(reader.framed == 0);
  }
}

TEST_CASE("a tap beside the handles lets go of the selection, a drag does not") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle();
  reader.tap(reader.at(patch));
  reader.drag(reader.empty_place(), reader.empty_place() + glm::dvec2(30, 0));
  CHECK(reader.selected(patch));
  reader.tap(reader.empty_place());
  CHECK_FALSE(reader.state.selected.has_value());
}

TEST_CASE("a plain wheel is the page's; with Ctrl or Meta it zooms about the pointer") {
  Reader reader;
  const glm::dvec2 at(200, 300);
  CHECK_FALSE(reader.roll(100, at).used);
  CHECK(reader.document.camera == scene::Camera{});
  for (const bool meta : {false, true}) {
    Reader zooming;
    (meta ? zooming.modifiers.meta : zooming.modifiers.control) = true;
    const auto ray = zooming.view.ray(at);
    const glm::dvec3 direction = to_glm(ray.direction);
    const glm::dvec3 point =
        zooming.view.eye + zooming.document.camera.distance / glm::dot(direction, zooming.view.forward) * direction;
    CHECK(zooming.roll(-100, at).used);
    CHECK(zooming.document.camera.distance == doctest::Approx(5.2 * std::exp(-0.22)));
    CHECK(gap(glm::dvec2(*zooming.view.project(point)), at) < 1e-6);
    zooming.roll(100, at);
    CHECK(zooming.document.camera.distance == doctest::Approx(5.2));
    // A trackpad's small steps count more, a wild wheel less; more is never less.
    zooming.roll(-2, at);
    CHECK(zooming.document.camera.distance == doctest::Approx(5.2 * std::exp(-0.02)));
    double last = 0;
    for (double delta = 1; delta < 1e5; delta *= 1.3) {
      zooming.document.camera = {};
      zooming.draw();
      zooming.roll(delta, at);
      CHECK(zooming.document.camera.distance >= last);
      last = zooming.document.camera.distance;
    }
    CHECK(last < 5.2 * 2);
    CHECK(zooming.roll(0, at).used);
  }
}

TEST_CASE("hovering finds handle, gizmo and surface, and redraws only for a change") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle();
  const glm::dvec2 at = reader.at(patch);
  CHECK(reader.move(at + glm::dvec2(4, 4)).redraw);
  CHECK(reader.state.hovered == patch);
  CHECK(reader.state.probe.has_value());
  CHECK(std::string(cursor(reader.state)) == "grab");
  CHECK_FALSE(reader.move(at + glm::dvec2(4, 4)).redraw);
  CHECK_FALSE(reader.move(at + glm::dvec2(4, 4)).used);

  // The probe is the surface point under the pointer.
  const glm::dvec2 beside = at + glm::dvec2(25, 18);
  reader.move(beside);
  CHECK_FALSE(reader.state.hovered.has_value());
  if (reader.state.probe) {
    const SurfaceJet jet = reader.surface().evaluate(reader.state.probe->x, reader.state.probe->y);
    CHECK(gap(glm::dvec2(*reader.view.project(to_glm(jet.s))), beside) < 1e-4);
  }

  CHECK(reader.move(reader.empty_place()).redraw);
  CHECK_FALSE(reader.state.probe.has_value());
  CHECK_FALSE(reader.move(reader.empty_place() + glm::dvec2(1, 0)).redraw);
  CHECK(std::string(cursor(reader.state)) == "default");

  reader.tap(at);
  const Gizmo gizmo = make_gizmo(reader.surface(), reader.object(), patch, reader.view);
  for (const GizmoStroke& stroke : gizmo.strokes) {
    if (stroke.radius == 0) continue;
    reader.move(glm::dvec2(*reader.view.project(stroke.points[0])));
    CHECK(reader.state.hovered_part == stroke.part);
  }
  CHECK(reader.send(PointerType::leave, {0, 0}).redraw);
  CHECK_FALSE(reader.state.hovered_part.has_value());
  CHECK_FALSE(reader.send(PointerType::leave, {0, 0}).redraw);
}

TEST_CASE("fingers do not hover; their tap on the surface sets the probe") {
  Reader reader;
  touch(reader);
  const glm::dvec2 at = reader.at(reader.visible_handle());
  CHECK_FALSE(reader.move(at).redraw);
  CHECK_FALSE(reader.state.hovered.has_value());
  glm::dvec2 on_surface = at;
  while (gap(on_surface, at) < 25) on_surface += glm::dvec2(1, 0.5);
  REQUIRE(reader.stage().pick(reader.view.ray(on_surface)).has_value());
  reader.tap(on_surface);
  CHECK(reader.state.probe.has_value());
  reader.now += 1000;
  reader.tap(reader.empty_place());
  CHECK_FALSE(reader.state.probe.has_value());
}

TEST_CASE("of two handles the visible one is held, then the nearer") {
  Reader reader;
  const glm::dvec2 at(300, 300);
  const auto handle = [&](scene::PatchIndex patch, glm::dvec2 off, bool hidden) {
    return Handle{patch, {0, 0, 0}, glm::dvec3(at + off, 1), hidden};
  };
  const auto held = [&](std::vector<Handle> handles) {
    InteractionState state;
    const Stage stage{reader.document, reader.figure, scene::stage_shape(reader.document), reader.view, handles};
    pointer(state, stage, {PointerType::down, 1, reader.device, at, 0, {}, 0});
    return state.selected;
  };
  CHECK(held({handle({0, 0}, {1, 0}, true), handle({1, 1}, {11, 0}, false)}) == scene::PatchIndex(1, 1));
  CHECK(held({handle({0, 0}, {1, 0}, true), handle({1, 1}, {13, 0}, false)}) == scene::PatchIndex(0, 0));
  CHECK(held({handle({0, 0}, {5, 0}, false), handle({1, 1}, {4, 0}, false)}) == scene::PatchIndex(1, 1));
  CHECK_FALSE(held({handle({0, 0}, {12.5, 0}, false)}).has_value());
  // Behind the camera: no screen position, nothing to hold.
  CHECK_FALSE(held({Handle{{0, 0}, {0, 0, 0}, std::nullopt, false}}).has_value());
  // Of a frame that knew more patches than there are.
  CHECK_FALSE(held({handle({40, 0}, {0, 0}, false)}).has_value());
  reader.device = PointerDevice::touch;
  CHECK(held({handle({0, 0}, {23, 0}, false)}) == scene::PatchIndex(0, 0));
  CHECK_FALSE(held({handle({0, 0}, {25, 0}, false)}).has_value());
  // Switched off, handles cannot be held.
  reader.document.display.handles = false;
  CHECK_FALSE(held({handle({0, 0}, {0, 0}, false)}).has_value());
}

TEST_CASE("with the camera amid the handles, those behind it are out of reach") {
  scene::Document document = Reader::standard_document();
  document.camera = {{0, 0, 0}, 0.3, 0.2, 0};
  Reader reader(document);
  int behind = 0;
  for (const Handle& handle : reader.handles) behind += handle.screen ? 0 : 1;
  CHECK(behind > 0);
  for (int x = 0; x < 805; x += 70) {
    for (int y = 0; y < 900; y += 70) {
      reader.move({x, y});
      if (!reader.state.hovered) continue;
      CHECK(gap(reader.at(*reader.state.hovered), {x, y}) <= 12);
    }
  }
}

TEST_CASE("the gizmo turns, scales and moves the selected patch, one entry each") {
  scene::Document document = Reader::standard_document();
  Reader reader(document);
  const scene::PatchIndex patch = reader.visible_handle(1);
  reader.tap(reader.at(patch));
  for (const GizmoPart part : {GizmoPart::turn_u, GizmoPart::turn_v, GizmoPart::turn_normal, GizmoPart::scale_u,
                               GizmoPart::scale_v, GizmoPart::scale_all, GizmoPart::move_normal}) {
    CAPTURE(static_cast<int>(part));
    const scene::PatchEdit before = reader.edit(patch);
    const scene::Document untouched = reader.document;
    std::optional<glm::dvec2> grab;
    const Gizmo gizmo = make_gizmo(reader.surface(), reader.object(), patch, reader.view);
    for (const GizmoStroke& stroke : gizmo.strokes) {
      for (const glm::dvec3& point : stroke.points) {
        const glm::dvec2 at(*reader.view.project(point));
        if (stroke.part == part && !grab && gap(at, reader.at(patch)) > 12 &&
            pick_gizmo(gizmo, reader.view, at, 8) == part)
          grab = at;
      }
    }
    REQUIRE(grab.has_value());
    reader.drag(*grab, *grab + glm::dvec2(31, -22));
    const scene::PatchEdit after = reader.edit(patch);
    CHECK((after.rotation.coeffs() != before.rotation.coeffs()) == turns(part));
    CHECK((after.scale != before.scale) == scales(part));
    CHECK((after.translation != before.translation) == (part == GizmoPart::move_normal));
    CHECK(reader.notice.ends_with(turns(part) ? " turned" : scales(part) ? " scaled" : " moved"));
    const scene::Document changed = reader.document;
    CHECK(reader.history.undo(reader.document));
    CHECK(reader.document == untouched);
    CHECK(reader.history.redo(reader.document));
    CHECK(reader.document == changed);
    reader.draw();
  }
}

TEST_CASE("the handle at the gizmo's middle can be held whatever the rings do") {
  // From straight above, the rings about u and v are lines through the handle.
  Reader reader;
  const scene::PatchIndex patch{1, 1};
  const Eigen::Vector3d d = scene::patch_frame(reader.surface(), patch).col(2);
  reader.document.camera = {scene::patch_origin(reader.surface(), patch), 3, std::atan2(d.y(), d.x()),
                            std::clamp(std::asin(d.z()), -1.55, 1.55)};
  reader.draw();
  reader.happen(select(reader.state, reader.stage(), patch));
  for (const PointerDevice device : {PointerDevice::mouse, PointerDevice::touch}) {
    reader.device = device;
    reader.down(reader.at(patch) + glm::dvec2(5, 0));
    CHECK(reader.state.drag == Drag::handle);
    reader.up(reader.at(patch) + glm::dvec2(5, 0));
  }
}

TEST_CASE("arrow keys move the selected patch on the screen") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle(1);
  CHECK_FALSE(reader.press("ArrowLeft").used);
  CHECK_FALSE(reader.press("Delete").used);
  reader.tap(reader.at(patch));
  const std::array<std::pair<const char*, glm::dvec2>, 4> arrows{
      {{"ArrowLeft", {-8, 0}}, {"ArrowRight", {8, 0}}, {"ArrowUp", {0, -8}}, {"ArrowDown", {0, 8}}}};
  for (const auto& [name, way] : arrows) {
    for (const bool finer : {false, true}) {
      reader.modifiers.shift = finer;
      const glm::dvec2 before = reader.at(patch);
      reader.type(name);
      CHECK(gap(reader.at(patch) - before, finer ? way / 8.0 : way) < 1e-6);
      CHECK(reader.notice.ends_with(" moved"));
    }
  }
  reader.modifiers.shift = false;
  const glm::dvec3 before = reader.origin(patch);
  reader.type("PageUp");
  const glm::dvec3 normal = to_glm_matrix(scene::patch_frame(reader.surface(), patch))[2];
  CHECK(glm::dot(reader.origin(patch) - before, normal) > 0);
  reader.type("PageDown");
  // Every key is a step of history of its own.
  int steps = 0;
  while (reader.history.undo(reader.document)) ++steps;
  CHECK(steps == 10);
  CHECK(reader.document == Reader::standard_document());
}

TEST_CASE("a key held down is one step of history, even when its release is lost") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle(1);
  reader.tap(reader.at(patch));
  for (int k = 0; k < 5; ++k) reader.press("ArrowRight");
  SUBCASE("released") { CHECK(reader.press("ArrowRight", false).end_gesture); }
  SUBCASE("blurred") { CHECK(reader.happen(blur(reader.state)).end_gesture); }
  SUBCASE("a press") { CHECK(reader.down(reader.empty_place()).end_gesture); }
  SUBCASE("another patch") { CHECK(reader.press("]").end_gesture); }
  CHECK(reader.object().edits.size() == 1);
  CHECK(reader.history.undo(reader.document));
  CHECK(reader.object().edits.empty());
  CHECK_FALSE(reader.history.can_undo());
}

TEST_CASE("Escape takes back a nudge under way, then lets go of the selection") {
  Reader reader;
  reader.tap(reader.at(reader.visible_handle()));
  reader.press("ArrowRight");
  CHECK(reader.press("Escape").cancel_gesture);
  CHECK(reader.object().edits.empty());
  CHECK(reader.press("Escape").used);
  CHECK_FALSE(reader.state.selected.has_value());
  CHECK_FALSE(reader.press("Escape").used);
}

TEST_CASE("keys that select, reset, zoom, frame, play, undo") {
  Reader reader;
  reader.type("]");
  CHECK(reader.selected({0, 0}));
  reader.type("[");
  CHECK(reader.selected({5, 3}));
  reader.type("]");
  reader.type("]");
  CHECK(reader.selected({0, 1}));
  CHECK(reader.notice == "Patch 0, 1 selected");

  reader.type("Delete");
  CHECK_FALSE(reader.history.can_undo());
  reader.type("ArrowUp");
  CHECK(reader.object().edits.size() == 1);
  reader.type("Delete");
  CHECK(reader.object().edits.empty());
  CHECK(reader.notice == "Patch 0, 1 reset");
  CHECK(reader.history.undo(reader.document));
  CHECK(reader.object().edits.size() == 1);

  const double distance = reader.document.camera.distance;
  reader.type("+");
  CHECK(reader.document.camera.distance < distance);
  reader.type("-");
  CHECK(reader.document.camera.distance == doctest::Approx(distance));
  reader.type("0");
  reader.type("Home");
  CHECK(reader.framed == 2);
  reader.type(" ");
  CHECK(reader.play_toggled == 1);

  for (const char* unknown : {"Tab", "Enter", "a", "F5", "Shift", ""}) CHECK_FALSE(reader.press(unknown).used);

  reader.modifiers.control = true;
  reader.type("z");
  CHECK(reader.undone == 1);
  reader.type("y");
  reader.modifiers.shift = true;
  reader.type("Z");
  CHECK(reader.redone == 2);
  reader.modifiers = {};
  reader.modifiers.meta = true;
  reader.type("z");
  CHECK(reader.undone == 2);
  for (const char* browser : {"r", "+", "-", "0", "ArrowLeft", "Home"}) CHECK_FALSE(reader.press(browser).used);
  reader.modifiers = {};
  reader.modifiers.alt = true;
  CHECK_FALSE(reader.press("ArrowLeft").used);
}

TEST_CASE("keys wait while a hand is on the patch") {
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle();
  const glm::dvec2 at = reader.at(patch);
  reader.down(at);
  reader.move(at + glm::dvec2(20, 0));
  const scene::Document during = reader.document;
  for (const char* name : {"ArrowLeft", "Delete", "]"}) {
    const Outcome outcome = reader.press(name);
    CHECK(outcome.used);
    CHECK(outcome.commands.empty());
  }
  reader.modifiers.control = true;
  CHECK_FALSE(reader.press("z").undo);
  reader.modifiers.control = false;
  CHECK(reader.press(" ").toggle_play);
  CHECK_FALSE(reader.press("Tab").used);
  CHECK(reader.selected(patch));
  CHECK(reader.document == during);
  reader.up(at + glm::dvec2(20, 0));
}

TEST_CASE("an event with numbers that are none is ignored") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  Reader reader;
  const scene::PatchIndex patch = reader.visible_handle();
  const glm::dvec2 at = reader.at(patch);
  for (const double bad : {nan, infinite, -infinite, 1e300}) {
    for (const PointerType type : {PointerType::down, PointerType::move, PointerType::up, PointerType::leave}) {
      CHECK_FALSE(reader.send(type, {bad, 10}).used);
      CHECK_FALSE(reader.send(type, {10, bad}).used);
    }
    reader.modifiers.control = true;
    CHECK_FALSE(reader.roll(bad, at).used);
    CHECK_FALSE(reader.roll(1, {bad, 0}).used);
    reader.modifiers.control = false;
  }
  CHECK(reader.state.pointers.empty());
  Outcome outcome = pointer(reader.state, reader.stage(), {PointerType::down, 1, PointerDevice::mouse, at, 0, {}, nan});
  CHECK_FALSE(outcome.used);

  // In the middle of a drag they do not disturb it; a broken release still releases.
  reader.down(at);
  reader.move(at + glm::dvec2(20, 0));
  CHECK_FALSE(reader.move({nan, 0}).used);
  CHECK(gap(reader.at(patch), at + glm::dvec2(20, 0)) < 1e-6);
  CHECK(reader.up({nan, nan}).end_gesture);
  CHECK(reader.state.drag == Drag::none);
}

TEST_CASE("a handle can be dragged no farther than a document holds") {
  scene::Document document = Reader::standard_document();
  document.camera.distance = max_distance;
  Reader reader(document);
  const scene::PatchIndex patch{0, 0};
  const glm::dvec2 at = reader.at(patch);
  reader.happen(select(reader.state, reader.stage(), patch));
  for (int k = 0; k < 20; ++k) {
    const glm::dvec2 from = reader.at(patch);
    reader.down(at);
    reader.move(at + glm::dvec2(9e5, 0));
    reader.up(at + glm::dvec2(9e5, 0));
    if (reader.edit(patch).translation.cwiseAbs().maxCoeff() >= scene::max_coordinate) break;
    CHECK(gap(from, reader.at(patch)) > 1);
    reader.document.camera.target = to_eigen(reader.origin(patch));
    reader.draw();
  }
  CHECK(reader.edit(patch).translation.cwiseAbs().maxCoeff() <= scene::max_coordinate);
  CHECK(scene::check(reader.document).has_value());
}

TEST_CASE("patches that go while they are held or selected are let go") {
  Reader reader;
  reader.happen(select(reader.state, reader.stage(), scene::PatchIndex{5, 3}));
  const glm::dvec2 at = reader.at({5, 3});
  reader.down(at);
  reader.move(at + glm::dvec2(30, 0));
  reader.object().locals_u = 3;
  // The frame with fewer patches has not come yet, then it has.
  const Outcome outcome = reader.move(at + glm::dvec2(40, 0));
  CHECK(outcome.end_gesture);
  CHECK_FALSE(reader.state.selected.has_value());
  reader.move(at + glm::dvec2(50, 0));
  reader.up(at + glm::dvec2(50, 0));
  CHECK(reader.state.drag == Drag::none);
  CHECK_FALSE(reader.happen(select(reader.state, reader.stage(), scene::PatchIndex{5, 3})).redraw);

  // The selection may have been taken away from outside, with the hand still on the patch.
  const glm::dvec2 other = reader.at({2, 0});
  reader.happen(select(reader.state, reader.stage(), scene::PatchIndex{2, 0}));
  reader.down(other);
  reader.move(other + glm::dvec2(30, 0));
  reader.state.selected.reset();
  reader.object().locals_u = 2;
  CHECK(reader.move(other + glm::dvec2(40, 0)).end_gesture);
  reader.up(other);

  // More patches in the document than on the stage as yet.
  reader.frame_each_event = false;
  reader.object().locals_u = 20;
  reader.happen(select(reader.state, reader.stage(), scene::PatchIndex{15, 0}));
  CHECK_FALSE(reader.state.selected.has_value());
}

TEST_CASE("any stream of events leaves a valid document and lets go in the end") {
  const std::array<const char*, 14> keys{"ArrowLeft", "PageUp", "[", "]", "Delete", "Escape", "+",
                                         "-",         "0",      " ", "z", "y",      "Tab",    "Shift"};
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    scene::Document document = playing_document(seed % 2 ? scene::MotionKind::breathe : scene::MotionKind::report);
    document.objects[0].shape = [] {
      scene::BlendingSurfaceObject object;
      object.locals_u = object.locals_v = 3;
      return object;
    }();
    Reader reader(document);
    for (int k = 0; k < 1200; ++k) {
      reader.frame_each_event = below(8) == 0;
      reader.now += below(300);
      reader.device = static_cast<PointerDevice>(below(3));
      reader.modifiers = {below(4) == 0, below(6) == 0, below(9) == 0, below(9) == 0};
      const glm::dvec2 anywhere(below(900) - 50, below(1000) - 50);
      const Handle& handle = reader.handles[static_cast<std::size_t>(below(9))];
      const glm::dvec2 at = below(3) == 0 && handle.screen ? glm::dvec2(*handle.screen) : anywhere;
      const int kind = below(12);
      if (kind < 8) {
        constexpr std::array types{PointerType::down, PointerType::move, PointerType::move,   PointerType::move,
                                   PointerType::up,   PointerType::up,   PointerType::cancel, PointerType::leave};
        reader.send(types[static_cast<std::size_t>(kind)], at, below(4), below(20) == 0 ? below(6) - 1 : 0);
      } else if (kind < 10) {
        reader.press(keys[static_cast<std::size_t>(below(14))], below(3) != 0);
      } else if (kind == 10) {
        reader.roll(below(400) - 200, at);
      } else {
        Outcome tick;
        tick.commands.emplace_back(scene::AdvanceClock{0.03});
        reader.happen(tick);
        reader.happen(hold(reader.state, reader.stage()));
      }
      const bool drags = reader.state.drag == Drag::handle || reader.state.drag == Drag::gizmo;
      REQUIRE(reader.gesture_open == (reader.state.nudging || (drags && reader.state.gesture_open)));
      REQUIRE((reader.state.drag == Drag::none) == reader.state.pointers.empty());
    }
    CHECK(scene::check(reader.document).has_value());
    for (int id = 0; id < 4; ++id) reader.up({10, 10}, id);
    reader.happen(blur(reader.state));
    CHECK(reader.state.drag == Drag::none);
    CHECK_FALSE(reader.gesture_open);
    while (reader.history.undo(reader.document)) continue;
    CHECK(scene::check(reader.document).has_value());
  }
}

}  // namespace knotwork::web::interaction_test
