#include "knotwork/scene/model_figure.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "knotwork/mesh/surface_tables.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/history.h"
#include "knotwork/scene/models.h"
#include "knotwork/scene/picking.h"
#include "unit/even_grid.h"

namespace knotwork::scene::model_figure_test {
namespace {

Document start() { return find_chapter("model-surface")->start_document(); }

std::string_view id_of_model(const Document& document) { return model_row(model_kind(*stage_model(document))).id; }

}  // namespace

TEST_CASE("model figure: every surface of the catalogue is sampled without a gap, with unit normals, poles included") {
  for (const ModelRow& row : model_kinds()) {
    CAPTURE(row.id);
    const ModelFigure figure(make_model(row.kind));
    const SurfaceTables tables = surface_tables(knotted_surface(figure), test::grid_of(figure, 48, 32));
    REQUIRE(tables.grid.columns() == static_cast<int>(tables.grid.u.size()));
    REQUIRE(tables.points.size() == 4 * tables.grid.u.size() * tables.grid.v.size());
    int bad = 0;
    for (std::size_t k = 0; k < tables.normals.size(); k += 4) {
      const float length = std::hypot(tables.normals[k], tables.normals[k + 1], tables.normals[k + 2]);
      if (!(std::abs(length - 1) < 1e-5F) || !std::isfinite(tables.points[k])) ++bad;
    }
    CHECK(bad == 0);
    // Lines in the middle of each open domain, an even number of cells.
    CHECK(figure.knots_u().interval_count() % 2 == 0);
    CHECK(figure.knots_v().interval_count() % 2 == 0);
    const SurfaceDomain where = domain(figure.model());
    CHECK(figure.knots_u().start() == where.u.start);
    CHECK(figure.knots_v().end() == where.v.end);
  }
}

TEST_CASE("model figure: which surfaces have one side only") {
  std::set<std::string_view> one_sided;
  for (const ModelRow& row : model_kinds())
    if (ModelFigure(make_model(row.kind)).one_sided()) one_sided.insert(row.id);
  CHECK(one_sided.contains("moebius"));
  CHECK(one_sided.contains("klein-bottle"));
  CHECK(one_sided.contains("boy"));
  CHECK_FALSE(one_sided.contains("torus"));
  CHECK_FALSE(one_sided.contains("sphere"));
}

TEST_CASE("model figure: a ray meets a model where it is") {
  for (const ModelRow& row : model_kinds()) {
    if (row.id != "sphere" && row.id != "torus" && row.id != "moebius") continue;
    CAPTURE(row.id);
    const ModelFigure figure(make_model(row.kind));
    const KnottedSurface surface = knotted_surface(figure);
    const PickNet net(surface);
    const SurfaceJet target = surface.evaluate(std::lerp(figure.knots_u().start(), figure.knots_u().end(), 0.3),
                                               std::lerp(figure.knots_v().start(), figure.knots_v().end(), 0.6));
    const Eigen::Vector3d normal = target.su.cross(target.sv).normalized();
    const auto hit = net.pick(surface, {target.s + 1e-2 * normal, -normal});
    REQUIRE(hit);
    CHECK((hit->jet.s - target.s).norm() < 1e-9);
  }
}

TEST_CASE("model figure: the gallery and its measures are parameters, undone exactly; the sheet stays out") {
  Document document = start();
  const Document before = document;
  CHECK(id_of_model(document) == "boy");
  History history;
  for (const ModelRow& row : model_kinds()) {
    CAPTURE(row.id);
    const Status status = history.perform(document, SetParameter{"model", std::string(row.id)});
    CHECK(status.has_value() == (row.kind != ModelKind::sheet));
    if (row.kind == ModelKind::sheet) continue;
    CHECK(id_of_model(document) == row.id);
    for (const CatalogueMeasure& measure : model_measures(row.kind)) {
      const std::string id = "model." + std::string(measure.id);
      CHECK(history.perform(document, SetParameter{id, measure.standard}));
      CHECK_FALSE(apply(document, SetParameter{id, std::nan("")}));
      CHECK_FALSE(apply(document, SetParameter{id, 2 * measure.greatest}));
    }
    const Result<Document> again = parse_document(write_document(document));
    REQUIRE(again);
    CHECK(again.value() == document);
  }
  CHECK(refused_choice(document, *find_parameter("model"), "sheet") == sheet_alone);
  CHECK(refused_choice(document, *find_parameter("model"), "torus").empty());
  while (history.undo(document)) {
  }
  CHECK(document == before);

  *stage_model(document) = Sheet{};
  CHECK(check(document).error().path == "objects[0].model.kind");
}

}  // namespace knotwork::scene::model_figure_test
