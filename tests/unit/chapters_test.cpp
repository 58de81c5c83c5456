#include "knotwork/scene/chapters.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/model_curve_figure.h"
#include "knotwork/scene/model_figure.h"
#include "knotwork/scene/net_figure.h"
#include "knotwork/scene/parameters.h"
#include "knotwork/scene/surface_builder.h"

namespace knotwork::scene::chapters_test {
TEST_CASE("chapters: every row opens a document that is valid, can be saved and built") {
  std::set<std::string_view> ids;
  REQUIRE_FALSE(chapters().empty());
  for (const Chapter& chapter : chapters()) {
    CAPTURE(chapter.id);
    CHECK(ids.insert(chapter.id).second);
    CHECK(find_chapter(chapter.id) == &chapter);
    CHECK_FALSE(chapter.title.empty());
    const Document document = chapter.start_document();
    CHECK(check(document));
    const Result<Document> again = parse_document(write_document(document));
    REQUIRE(again);
    CHECK(again.value() == document);
    const Shape& shape = stage_shape(document);
    if (const auto* surface = std::get_if<BlendingSurfaceObject>(&shape))
      CHECK(build_surface(*surface, document.animation).evaluate(0, 0).s.allFinite());
    else if (const auto* model = std::get_if<ModelCurveObject>(&shape))
      CHECK(ModelCurveFigure(*model).point.allFinite());
    else if (const auto* blending = std::get_if<BlendingCurveObject>(&shape))
      CHECK(BlendingCurveFigure(*blending, document.animation).point.allFinite());
    else if (const auto* net = std::get_if<BSplineSurfaceObject>(&shape))
      CHECK(NetFigure(*net).surface.evaluate(0.3, 0.4).s.allFinite());
    else if (const auto* alone = std::get_if<ModelSurfaceObject>(&shape))
      CHECK(ModelFigure(alone->model).evaluate(0.3, 0.4).s.allFinite());
    else
      CHECK(spline_of(shape)(0.3).allFinite());
    CHECK_FALSE(chapter.parameters.empty());
    for (std::string_view id : chapter.parameters) {
      REQUIRE(find_parameter(id) != nullptr);
      CHECK(applies(document, *find_parameter(id)));
    }
  }
  CHECK(find_chapter("no-such-chapter") == nullptr);
}

TEST_CASE("chapters: the blending surface opens as a torus with a patch pulled out at the left, towards the reader") {
  const Document document = find_chapter("blending-surface")->start_document();
  const BlendingSurfaceObject& object = blending_surface(document);
  CHECK(object.locals_u == 6);
  CHECK(object.locals_v == 4);
  CHECK(object.topology_u == Topology::closed);
  CHECK(object.topology_v == Topology::closed);
  REQUIRE(object.edits.size() == 1);

  const BlendingSurface surface = build_surface(object, document.animation);
  const Eigen::Vector3d pulled = patch_origin(surface, object.edits.begin()->first);
  const double azimuth = document.camera.azimuth;
  const Eigen::Vector3d eye(std::cos(azimuth), std::sin(azimuth), 0), right(-std::sin(azimuth), std::cos(azimuth), 0);
  CHECK(pulled.dot(right) < -1.2);
  CHECK(pulled.dot(eye) > 0.2);
  CHECK(pulled.z() == doctest::Approx(0));
  // Every other patch's origin lies nearer to the axis.
  for (int i = 0; i < object.locals_u; ++i) {
    for (int j = 0; j < object.locals_v; ++j) {
      if (object.edits.count({i, j}) == 0) CHECK(patch_origin(surface, {i, j}).norm() < pulled.norm() - 0.5);
    }
  }
}

}  // namespace knotwork::scene::chapters_test
