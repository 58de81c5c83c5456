// Points drawn by hand on the stage, and what a hand and keys do to the data of a fit.

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/history.h"
#include "web/interaction.h"
#include "web/vectors.h"

namespace knotwork::web::drawing_test {
namespace {

/// A reader before a stage with a figure of points; events act as on the page.
struct Drawer {
  scene::Document document;
  scene::History history;
  InteractionState state;
  Viewport viewport{800, 600};
  View view;
  Figure figure;
  std::vector<Handle> handles;
  double now = 0;

  explicit Drawer(std::string_view chapter)
      : document(scene::find_chapter(chapter)->start_document()),
        figure(make_figure(scene::stage_shape(document), document.animation)) {
    draw();
  }

  void draw() {
    view = make_view(document.camera, viewport);
    figure = make_figure(scene::stage_shape(document), document.animation);
    take_handles(figure, scene::stage_shape(document), handles);
    for (Handle& handle : handles) handle.screen = view.project(handle.position);
  }

  /// How many commands were refused.
  int happen(const Outcome& outcome) {
    int refused = 0;
    if (outcome.begin_gesture) history.begin_gesture();
    for (const scene::Command& command : outcome.commands) refused += history.perform(document, command) ? 0 : 1;
    if (outcome.end_gesture) history.end_gesture();
    if (outcome.cancel_gesture) history.cancel_gesture(document);
    draw();
    return refused;
  }

  int send(PointerType type, glm::dvec2 at, int id = 1, PointerDevice device = PointerDevice::mouse) {
    const Stage stage{document, figure, scene::stage_shape(document), view, handles};
    return happen(pointer(state, stage, {type, id, device, at, type == PointerType::move ? -1 : 0, {}, now += 8}));
  }
  int press(const char* name) {
    const Stage stage{document, figure, scene::stage_shape(document), view, handles};
    return happen(key(state, stage, {true, name, {}}));
  }
  /// A quarter of a circle.
  int stroke(double radius = 150) {
    int refused = 0;
    for (int k = 0; k <= 20; ++k) {
      const glm::dvec2 at(400 + radius * std::cos(0.08 * k), 300 - radius * std::sin(0.08 * k));
      refused += send(k == 0 ? PointerType::down : PointerType::move, at);
    }
    return refused + send(PointerType::up, {400 + radius * std::cos(1.6), 300 - radius * std::sin(1.6)});
  }
  std::vector<Eigen::Vector3d> points() const {
    const auto list = scene::curve_points(scene::stage_shape(document));
    return {list.begin(), list.end()};
  }
};

}  // namespace

TEST_CASE("drawing: after D the next drag draws the data, as one step; the one after turns the view") {
  for (const char* chapter : {"least-squares", "subdivision"}) {
    CAPTURE(chapter);
    Drawer drawer(chapter);
    const scene::Document before = drawer.document;
    drawer.press("d");
    CHECK(drawer.state.drawing);
    CHECK(std::string_view(cursor(drawer.state)) == "crosshair");
    CHECK(drawer.stroke() == 0);
    CHECK_FALSE(drawer.state.drawing);
    CHECK(drawer.points().size() >= 28);  // 240 pixels
    CHECK(drawer.points().size() <= 32);
    CHECK(drawer.document.camera == before.camera);
    CHECK(drawer.history.undo_label() == "Replace the points");
    const scene::Document drawn = drawer.document;
    drawer.stroke(320);
    CHECK(drawer.document.objects == drawn.objects);
    CHECK_FALSE(drawer.document.camera == drawn.camera);
    CHECK(drawer.history.undo(drawer.document));
    CHECK(drawer.document.objects == before.objects);
    CHECK_FALSE(drawer.history.can_undo());
  }
}

TEST_CASE("drawing: Escape, D again, a second finger and a figure that takes no points end it without a change") {
  Drawer drawer("least-squares");
  const scene::Document before = drawer.document;
  drawer.press("D");
  drawer.press("Escape");
  CHECK_FALSE(drawer.state.drawing);
  drawer.press("d");
  drawer.press("d");
  CHECK_FALSE(drawer.state.drawing);

  drawer.press("d");
  drawer.send(PointerType::down, {300, 300});
  drawer.send(PointerType::move, {400, 300});
  CHECK_FALSE(drawer.state.stroke.empty());
  drawer.press("Escape");
  drawer.send(PointerType::move, {500, 300});
  drawer.send(PointerType::up, {500, 300});
  CHECK(drawer.document == before);
  CHECK(drawer.state.stroke.empty());

  drawer.press("d");
  drawer.send(PointerType::down, {300, 300}, 1, PointerDevice::touch);
  drawer.send(PointerType::move, {400, 300}, 1, PointerDevice::touch);
  drawer.send(PointerType::down, {500, 400}, 2, PointerDevice::touch);
  drawer.send(PointerType::up, {500, 400}, 2, PointerDevice::touch);
  drawer.send(PointerType::up, {400, 300}, 1, PointerDevice::touch);
  CHECK(drawer.document.objects == before.objects);

  Drawer curve("bspline-curve");
  curve.press("d");
  CHECK_FALSE(curve.state.drawing);
}

TEST_CASE("drawing: a line too short for the fit is refused, a press alone changes nothing") {
  Drawer drawer("least-squares");
  const scene::Document before = drawer.document;
  drawer.press("d");
  drawer.send(PointerType::down, {300, 300});
  drawer.send(PointerType::up, {300, 300});
  CHECK(drawer.document == before);
  drawer.press("d");
  drawer.send(PointerType::down, {300, 300});
  drawer.send(PointerType::move, {320, 300});
  CHECK(drawer.send(PointerType::up, {320, 300}) == 1);
  CHECK(drawer.document == before);
}

TEST_CASE("drawing: data are dragged, added and deleted by hand; no press between them adds one") {
  Drawer drawer("least-squares-closed");
  const glm::dvec2 at(*drawer.handles[4].screen);
  drawer.send(PointerType::down, at);
  drawer.send(PointerType::move, at + glm::dvec2(30, -20));
  drawer.send(PointerType::up, at + glm::dvec2(30, -20));
  CHECK(drawer.points().size() == 20);
  CHECK(glm::distance(glm::dvec2(*drawer.view.project(to_glm(drawer.points()[4]))), at + glm::dvec2(30, -20)) < 0.5);
  drawer.press("Insert");
  CHECK(drawer.points().size() == 21);
  drawer.press("Delete");
  CHECK(drawer.points().size() == 20);
  drawer.press("Escape");

  const glm::dvec2 between = 0.5 * (glm::dvec2(*drawer.handles[10].screen) + glm::dvec2(*drawer.handles[11].screen));
  drawer.send(PointerType::down, between);
  drawer.send(PointerType::up, between);
  CHECK(drawer.points().size() == 20);

  Drawer polygon("subdivision");
  const glm::dvec2 leg = 0.5 * (glm::dvec2(*polygon.handles[0].screen) + glm::dvec2(*polygon.handles[1].screen));
  polygon.send(PointerType::down, leg);
  polygon.send(PointerType::up, leg);
  CHECK(polygon.points().size() == 8);
}

TEST_CASE("drawing: many data have no handles, and no one of them is selected") {
  Drawer drawer("least-squares");
  std::vector<Eigen::Vector3d> many;
  many.reserve(20000);
  for (int j = 0; j < 20000; ++j) many.emplace_back(0.001 * j, std::sin(0.001 * j), 0);
  Outcome pasted;
  pasted.commands = {scene::SetPoints{many}};
  CHECK(drawer.happen(pasted) == 0);
  CHECK(drawer.handles.empty());
  drawer.press("]");
  CHECK_FALSE(drawer.state.selected);
  CHECK_FALSE(outline(drawer.figure).empty());
}

}  // namespace knotwork::web::drawing_test
