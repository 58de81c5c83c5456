// Local curves of a blending curve in the hand: the same code as for patches, the blending curve's own commands.

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "knotwork/scene/chapters.h"
#include "web/holding.h"
#include "web/vectors.h"

namespace knotwork::web::local_curve_hold_test {
namespace {

struct Scene {
  scene::Document document = scene::find_chapter("blending-curve")->start_document();
  std::optional<Figure> figure;
  View view;
  std::vector<Handle> handles;

  Scene() { draw(); }
  void draw() {
    update_figure(figure, scene::stage_shape(document), document.animation);
    view = make_view(document.camera, {1000, 800});
    take_handles(*figure, scene::stage_shape(document), handles);
    for (Handle& handle : handles) handle.screen = view.project(handle.position);
  }
  Stage stage() { return {document, *figure, scene::stage_shape(document), view, handles}; }
  void apply(const Commands& commands) {
    for (const scene::Command& command : commands) CHECK(scene::apply(document, command));
  }
  const scene::BlendingCurveObject& curve() const {
    return *std::get_if<scene::BlendingCurveObject>(&scene::stage_shape(document));
  }
  glm::dvec2 seen(int k) const { return glm::dvec2(*handles[static_cast<std::size_t>(k)].screen); }
};

}  // namespace

TEST_CASE("local curve hold: handles are named, and one for the parameter comes last") {
  Scene scene;
  const scene::Shape& shape = scene::stage_shape(scene.document);
  REQUIRE(scene.handles.size() == 11);
  CHECK(handle_id(shape, {3, 0}) == "local-3");
  CHECK(handle_name(shape, {3, 0}) == "Local curve 3");
  CHECK(find_handle(shape, "local-9") == HandleIndex(9, 0));
  CHECK_FALSE(find_handle(shape, "local-10"));
  CHECK_FALSE(find_handle(shape, "patch-1-0"));
  CHECK(scene.handles.back().index == parameter_handle);
  CHECK(find_handle(shape, "parameter") == parameter_handle);
}

TEST_CASE("local curve hold: a handle stays under the pointer, also while the clock runs") {
  Scene scene;
  scene.document.animation.time = 0.7;
  scene.draw();
  const glm::dvec2 start = scene.seen(6);
  Held held = take_hold(scene.stage(), {6, 0}, std::nullopt, start + glm::dvec2(3, 2));
  CHECK(exists(scene.stage(), held));
  scene.apply(drag_to(held, scene.stage(), start + glm::dvec2(53, -28), false));
  scene.draw();
  CHECK(glm::length(scene.seen(6) - start - glm::dvec2(50, -30)) < 1e-6);
  CHECK(scene.curve().edits.size() == 2);
  scene.document.animation.time = 1.4;
  scene.apply(hold_still(held, scene.stage()));
  scene.draw();
  CHECK(glm::length(scene.seen(6) - start - glm::dvec2(50, -30)) < 1e-6);
  // The document may be ahead of the figure.
  scene.document.animation.time = 2;
  CHECK(scene::local_origin(*local_of(scene.stage(), {6, 0})) !=
        std::get_if<scene::BlendingCurveFigure>(&*scene.figure)->curve.local(6).translation());
}

TEST_CASE("local curve hold: the gizmo turns and scales, keys move, Delete puts back") {
  Scene scene;
  const std::optional<Gizmo> gizmo = gizmo_of(scene.stage(), {6, 0});
  REQUIRE(gizmo);
  CHECK(gizmo->strokes.size() > 5);
  CHECK_FALSE(gizmo_of(scene.stage(), parameter_handle));
  const glm::dvec2 start = scene.seen(6);
  for (const GizmoPart part : {GizmoPart::turn_normal, GizmoPart::scale_all}) {
    Held held = take_hold(scene.stage(), {6, 0}, part, start + glm::dvec2(40, 0));
    scene.apply(drag_to(held, scene.stage(), start + glm::dvec2(50, 30), false));
    scene.draw();
  }
  const scene::PatchEdit turned = scene.curve().edits.at({6, 0});
  CHECK(turned.translation.norm() == 0);
  CHECK(turned.scale.x() != 1);
  scene.apply(nudged(scene.stage(), {6, 0}, {10, 0, 0}));
  scene.draw();
  CHECK(scene.seen(6).x == doctest::Approx(start.x + 10).epsilon(0.01));
  scene.apply(removed(scene.stage(), {6, 0}));
  CHECK(scene.curve().edits.size() == 1);
  CHECK(removed(scene.stage(), {6, 0}).empty());
}

TEST_CASE("local curve hold: the parameter slides along the curve and is no local") {
  Scene scene;
  const glm::dvec2 start(*scene.handles.back().screen);
  Held held = take_hold(scene.stage(), parameter_handle, std::nullopt, start);
  CHECK(exists(scene.stage(), held));
  const double before = scene.curve().parameter;
  scene.apply(drag_to(held, scene.stage(), start + glm::dvec2(60, 40), false));
  CHECK(scene.curve().parameter != before);
  CHECK(scene.curve().edits.size() == 1);
  CHECK(removed(scene.stage(), parameter_handle).empty());
  CHECK(neighbour(scene.stage(), HandleIndex(9, 0), 1) == HandleIndex(0, 0));
  CHECK_FALSE(has_polygon(scene.stage()));
  // A model curve has nothing else.
  scene.document = scene::find_chapter("model-curve")->start_document();
  scene.draw();
  CHECK(scene.handles.size() == 1);
  CHECK(neighbour(scene.stage(), std::nullopt, 1) == parameter_handle);
  CHECK_FALSE(exists(scene.stage(), HandleIndex(0, 0)));
}

}  // namespace knotwork::web::local_curve_hold_test
