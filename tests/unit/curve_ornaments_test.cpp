#include "web/curve_ornaments.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "knotwork/scene/chapters.h"
#include "web/theme.h"

namespace knotwork::web::curve_ornaments_test {
namespace {

constexpr glm::dvec2 half_a_name(10, 8);  // CSS pixels

/// A curve and its handles as they stand on a stage which they fill.
struct NamedCurve {
  Figure figure;
  std::vector<Handle> handles;
  View view;

  NamedCurve(std::string_view chapter, const Viewport& stage)
      : NamedCurve(scene::find_chapter(chapter)->start_document(), stage) {}
  NamedCurve(const scene::Document& document, const Viewport& stage)
      : figure(make_figure(scene::stage_shape(document), document.animation)) {
    const std::vector<glm::dvec3> points = outline(figure);
    const Composition composition = compose(document.camera, {points, {}}, stage, {});
    view = make_view(composition.camera, composition.viewport);
    take_handles(figure, scene::stage_shape(document), handles);
    for (Handle& handle : handles) handle.screen = view.project(handle.position);
  }

  std::vector<StageLabel> names(const Obstacles& covered) const {
    return labels_of(figure, handles, view, make_theme(false), covered);
  }
};

}  // namespace

TEST_CASE("names of points stay on a small stage, where they fill it") {
  for (const char* chapter : {"bezier-curve", "bspline-curve"}) {
    CAPTURE(chapter);
    const NamedCurve curve(chapter, {.width = 200, .height = 180});
    const std::vector<StageLabel> names = curve.names({});
    REQUIRE(names.size() > 3);
    for (const StageLabel& name : names) CHECK(uncovered(name.place, half_a_name, curve.view.viewport, {}));
  }
}

TEST_CASE("a name that would be covered goes to another side of its point") {
  const NamedCurve curve("bspline-curve", {.width = 390, .height = 388});
  const std::vector<StageLabel> free = curve.names({});
  for (std::size_t k = 0; k < free.size(); ++k) {
    CAPTURE(k);
    const glm::dvec2 corner = free[k].place - glm::dvec2(6);
    const std::vector<std::array<double, 4>> word{{corner.x, corner.y, 12, 12}};
    for (const Obstacles& covered : {Obstacles{word, {}}, Obstacles{{}, word}}) {
      const std::vector<StageLabel> names = curve.names(covered);
      REQUIRE(names.size() == free.size());
      CHECK(uncovered(names[k].place, half_a_name, curve.view.viewport, covered));
      CHECK(glm::distance(names[k].place, glm::dvec2(*curve.handles[k].screen)) < 20);
    }
  }
}

TEST_CASE("a name goes round a ring about its point") {
  const NamedCurve curve("bspline-curve", {.width = 390, .height = 388});
  const glm::dvec2 corner = glm::dvec2(*curve.handles[3].screen) - 12.5;
  const std::vector<std::array<double, 4>> ring{{corner.x, corner.y, 25, 25}};
  CHECK(uncovered(curve.names({{}, ring})[3].place, half_a_name, curve.view.viewport, {{}, ring}));
}

TEST_CASE("with every side covered a name still stands beside its point") {
  const NamedCurve curve("bspline-curve", {.width = 390, .height = 388});
  const std::vector<std::array<double, 4>> all{{0, 0, 390, 388}};
  const std::vector<StageLabel> free = curve.names({}), covered = curve.names({all, {}});
  REQUIRE(covered.size() == free.size());
  for (std::size_t k = 0; k < free.size(); ++k)
    CHECK(glm::distance(covered[k].place, glm::dvec2(*curve.handles[k].screen)) < 31);
}

}  // namespace knotwork::web::curve_ornaments_test
