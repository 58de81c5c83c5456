#include "knotwork/scene/parameters.h"

#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"

namespace knotwork::scene::parameters_test {
namespace {

Document start() { return find_chapter("blending-surface")->start_document(); }

Document with(std::string id, ParameterValue value, Document document = start()) {
  REQUIRE(apply(document, SetParameter{std::move(id), std::move(value)}));
  return document;
}

/// The start document of a chapter that the row is about, in a state in which it can be set.
Document document_for(const Parameter& row) {
  if (row.id == "blending.parameter") return with("blending.function", "rational");
  if (row.id.starts_with("model.")) {
    for (const ModelRow& model : model_kinds()) {
      Document document = with("model", std::string(model.id));
      // Axes that stay apart whichever of their coordinates is set.
      if (model.id == "plane") blending_surface(document).model = plane_surface({0, 0, 0}, {2, 1, 1}, {1, 2, -1});
      if (applies(document, row)) return document;
    }
  }
  for (const Chapter& chapter : chapters())
    if (applies(chapter.start_document(), row)) return chapter.start_document();
  // A measure that the start document's curve has not.
  for (const CatalogueCurveRow& curve : curve_catalogue()) {
    const Document other = with("curve.model", std::string(curve.id), find_chapter("model-curve")->start_document());
    if (applies(other, row)) return other;
  }
  FAIL("no chapter has " << row.id);
  return {};
}

/// The message of a value that must be refused and change nothing.
std::string refusal(const std::string& id, ParameterValue value, Document document = start()) {
  CAPTURE(id);
  const Document before = document;
  const Status status = apply(document, SetParameter{id, std::move(value)});
  CHECK(document == before);
  if (status) return "accepted";
  CHECK(status.error().path == id);
  return status.error().message;
}

}  // namespace

TEST_CASE("parameters: the table has exactly the promised rows, each complete") {
  std::set<std::string> promised{"topology.u",
                                 "topology.v",
                                 "model",
                                 "locals.u",
                                 "locals.v",
                                 "blending.function",
                                 "blending.parameter",
                                 "display.comb",
                                 "display.osculating",
                                 "display.hodograph",
                                 "display.continuity",
                                 "display.shading",
                                 "samples.adaptive",
                                 "samples.u",
                                 "samples.v",
                                 "display.surface",
                                 "display.colours",
                                 "display.knots",
                                 "display.wireframe",
                                 "display.locals",
                                 "display.frames",
                                 "display.normals",
                                 "display.handles",
                                 "animation.playing",
                                 "animation.time",
                                 "animation.speed",
                                 "motion.kind",
                                 "motion.amplitude",
                                 "motion.translation",
                                 "motion.rotation",
                                 "curve.topology",
                                 "curve.degree",
                                 "curve.ends",
                                 "curve.parameter",
                                 "display.polygon",
                                 "display.construction",
                                 "curve.model",
                                 "locals.count",
                                 "locals.kind",
                                 "locals.degree",
                                 "patches.kind",
                                 "patches.degree.u",
                                 "patches.degree.v",
                                 "fitted.count",
                                 "fitted.parameters",
                                 "fitted.knots",
                                 "fitted.ends",
                                 "fitted.smoothing",
                                 "subdivision.levels",
                                 "subdivision.step",
                                 "subdivision.fraction",
                                 "subdivision.limit",
                                 "display.net",
                                 "net.u",
                                 "net.v",
                                 "surface.degree.u",
                                 "surface.degree.v"};
  // Every measure that a model has, under the measure's own id.
  std::set<std::string> measures;
  for (const ModelRow& model : model_kinds()) {
    for (const CatalogueMeasure& measure : model_measures(model.kind))
      measures.insert("model." + std::string(measure.id));
  }
  CHECK(measures.size() == 24);
  promised.insert(measures.begin(), measures.end());
  for (const CatalogueCurveRow& curve : curve_catalogue())
    for (const CatalogueMeasure& measure : curve.measures) promised.insert("curve." + std::string(measure.id));
  std::set<std::string> ids;
  for (const Parameter& row : parameters()) {
    CAPTURE(row.id);
    const Document document = document_for(row);
    CHECK(ids.insert(std::string(row.id)).second);
    CHECK(find_parameter(row.id) == &row);
    CHECK_FALSE(row.label.empty());
    CHECK_FALSE(row.group.empty());
    REQUIRE(static_cast<bool>(row.get));
    REQUIRE(static_cast<bool>(row.set));
    REQUIRE(static_cast<bool>(row.disabled));
    const bool numeric = row.kind == ParameterKind::number || row.kind == ParameterKind::integer;
    CHECK((row.kind == ParameterKind::choice) == (row.choices.size() >= 2));
    if (row.chosen)
      CHECK(row.get(document) == ParameterValue(row.choices[static_cast<std::size_t>(row.chosen(document))].id));
    CHECK(numeric == (row.max > row.min));
    if (numeric) {
      CHECK(row.step > 0);
      CHECK(row.soft_max > row.min);
      CHECK(row.soft_max <= row.max);
      CHECK(std::holds_alternative<double>(row.get(document)));
    }
  }
  CHECK(ids == promised);
  CHECK(find_parameter("topology") == nullptr);
}

TEST_CASE("parameters: every row sets what it gets, and nothing else changes it back") {
  for (const Parameter& row : parameters()) {
    CAPTURE(row.id);
    Document document = document_for(row);
    const auto sets = [&](const ParameterValue& value) {
      CHECK(row.set(document, value));
      CHECK(row.get(document) == value);
    };
    if (row.kind == ParameterKind::toggle) {
      sets(true);
      sets(false);
    } else if (row.kind == ParameterKind::choice) {
      for (const Choice& choice : row.choices) sets(choice.id);
    } else {
      const Limits range = range_of(document, row);
      sets(range.min);
      sets(range.max);
      sets(std::floor((range.min + range.max) / 2));
    }
  }
}

TEST_CASE("parameters: values out of range, of a wrong type or not finite are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Parameter& row : parameters()) {
    CAPTURE(row.id);
    const std::string id(row.id);
    const Document document = document_for(row);
    if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
      const Limits range = range_of(document, row);
      for (double x : {nan, inf, -inf, range.min - 0.001, range.max + 0.001, 1e300}) {
        CHECK(refusal(id, x, document) != "accepted");
      }
      CHECK(refusal(id, "2", document) != "accepted");
      CHECK(refusal(id, true, document) != "accepted");
      if (row.kind == ParameterKind::integer) CHECK(refusal(id, range.min + 0.5, document) != "accepted");
    } else if (row.kind == ParameterKind::choice) {
      CHECK(refusal(id, "no such choice", document) != "accepted");
      CHECK(refusal(id, 1.0, document) != "accepted");
      CHECK(refusal(id, true, document) != "accepted");
    } else {
      CHECK(refusal(id, 1.0, document) == "Must be true or false.");
      CHECK(refusal(id, "true", document) == "Must be true or false.");
    }
  }
  CHECK(refusal("curve.degree", 3.0) == "What is on the stage has no such parameter.");
  CHECK(refusal("locals.u", 1e9) == "Must be a whole number from 2 to 128.");
  CHECK(refusal("animation.speed", 5.0) == "Must be a number from 0.1 to 4.");
  CHECK(refusal("topology.u", "ajar") == "Must be open or closed.");
}

TEST_CASE("parameters: a direction in which the model is not closed can only be open") {
  const std::string sentence = "The plane is not closed in u, so its u direction can only be open.";
  const Document plane = with("model", "plane");
  CHECK(refusal("topology.u", "closed", plane) == sentence);
  CHECK(refused_choice(plane, *find_parameter("topology.u"), "closed") == sentence);
  CHECK(refused_choice(plane, *find_parameter("topology.u"), "open").empty());
  CHECK(refused_choice(plane, *find_parameter("model"), "torus").empty());

  const Document cylinder = with("model", "cylinder");
  CHECK(refusal("topology.u", "closed", cylinder).find("The cylinder is not closed in u") == 0);
  CHECK(refused_choice(cylinder, *find_parameter("topology.v"), "closed").empty());

  // A sheet rolls up and a torus can always be opened and closed again.
  for (const char* model : {"sheet", "torus"}) {
    const Document opened = with("topology.v", "open", with("topology.u", "open", with("model", model)));
    const Document closed = with("topology.v", "closed", with("topology.u", "closed", opened));
    CHECK(blending_surface(closed).topology_u == Topology::closed);
    CHECK(blending_surface(closed).topology_v == Topology::closed);
  }
}

TEST_CASE("parameters: a new model opens what it cannot close and keeps the rest") {
  const Document plane = with("model", "plane");
  CHECK(blending_surface(plane).topology_u == Topology::open);
  CHECK(blending_surface(plane).topology_v == Topology::open);
  CHECK(blending_surface(plane).edits == blending_surface(start()).edits);
  const Document cylinder = with("model", "cylinder");
  CHECK(blending_surface(cylinder).topology_u == Topology::open);
  CHECK(blending_surface(cylinder).topology_v == Topology::closed);

  // What only the model kept open closes again where another one can; what the reader has opened stays open.
  const Document round = with("model", "torus", plane);
  CHECK(blending_surface(round).topology_u == Topology::closed);
  CHECK(blending_surface(round).topology_v == Topology::closed);
  const Document cut = with("model", "torus", with("topology.v", "open", cylinder));
  CHECK(blending_surface(cut).topology_u == Topology::closed);
  CHECK(blending_surface(cut).topology_v == Topology::open);

  // The same model again does not reset its measures.
  Document torus = with("model", "torus");
  blending_surface(torus).model = torus_surface(2, 0.5, 0.25);
  CHECK(with("model", "torus", torus) == torus);
}

TEST_CASE("parameters: the measures are those of the model on the stage") {
  for (const ModelRow& model : model_kinds()) {
    CAPTURE(model.id);
    const Document document = with("model", std::string(model.id));
    std::size_t count = 0;
    for (const Parameter& row : parameters()) {
      if (row.id.starts_with("model.") && applies(document, row)) ++count;
    }
    CHECK(count == model_measures(model.kind).size());
    for (const CatalogueMeasure& measure : model_measures(model.kind)) {
      CAPTURE(measure.id);
      const Parameter& row = *find_parameter("model." + std::string(measure.id));
      REQUIRE(applies(document, row));
      CHECK(std::get<double>(row.get(document)) == measure.standard);
      CHECK(range_of(document, row).min == measure.least);
      CHECK(range_of(document, row).max == measure.greatest);
      CHECK(soft_range_of(document, row).contains(measure.standard));
    }
  }
  const Document torus = with("model.tubeRadius", 0.25, with("model", "torus"));
  CHECK(blending_surface(torus).model == ModelSurface(torus_surface(1, 0.25, 0.4)));
  CHECK(refusal("model.tubeRadius", 0.0, torus) == "Must be a number from 1e-06 to 1000000.");
  CHECK(refusal("model.size", 1.0, torus) == "What is on the stage has no such parameter.");
  CHECK(refusal("model.vAxisY", 0.0, with("model", "plane")) ==
        "The second axis of the plane must be neither zero nor parallel to the first.");
  // Rows of one id have the more general of their labels.
  CHECK(find_parameter("model.radius")->label == "radius");
}

TEST_CASE("parameters: a twisted direction closes where the patches fall onto each other") {
  const Document bottle = with("model", "klein-bottle");
  CHECK(blending_surface(bottle).topology_u == Topology::closed);
  const std::string even = "Going round the Klein bottle in u reflects the patches in v: their number must be even.";
  const std::string closed =
      "Going round the Klein bottle in u reflects the patches in v: that direction must be closed too.";
  CHECK(refusal("locals.v", 5.0, bottle) == even);
  CHECK(refusal("topology.v", "open", bottle) == closed);
  CHECK(refused_choice(bottle, *find_parameter("topology.v"), "open") == closed);
  const Document cut = with("topology.v", "open", with("topology.u", "open", bottle));
  CHECK(refused_choice(cut, *find_parameter("topology.u"), "closed") == closed);
  CHECK(refused_choice(cut, *find_parameter("topology.v"), "closed").empty());

  // A model that comes to an odd number opens, and says why.
  const Document odd = with("locals.v", 5.0);
  CHECK(notice(odd, SetParameter{"model", "klein-bottle"}) == even + " So u opens.");
  CHECK(blending_surface(with("model", "klein-bottle", odd)).topology_u == Topology::open);
  CHECK(blending_surface(with("model", "klein-bottle", odd)).topology_v == Topology::closed);

  // The Moebius strip is open across, whatever the number there.
  const Document strip = with("locals.u", 5.0, with("model", "moebius"));
  CHECK(blending_surface(strip).topology_u == Topology::open);
  CHECK(blending_surface(strip).topology_v == Topology::closed);
  for (const ModelRow& row : model_kinds()) {
    for (const double count : {2.0, 3.0, 4.0, 5.0}) {
      Document document = with("locals.v", count, with("locals.u", count));
      document = with("model", std::string(row.id), document);
      CHECK(check(document));
    }
  }
}

TEST_CASE("parameters: degrees are those of Bezier patches") {
  const Parameter& row = *find_parameter("patches.degree.u");
  CHECK(row.disabled(start()) == "Only Bézier patches have a degree to choose.");
  const Document patches = with("patches.degree.v", 1.0, with("patches.kind", "bezier-hermite"));
  CHECK(row.disabled(patches).empty());
  CHECK(blending_surface(patches).patches == LocalSurfaces{LocalSurfaceKind::bezier_hermite, 3, 1});
  CHECK(refusal("patches.degree.u", 4.0, patches) == "Must be a whole number from 1 to 3.");
}

TEST_CASE("parameters: a B-function brings its default parameter, its range and whether there is one") {
  const Parameter& row = *find_parameter("blending.parameter");
  CHECK_FALSE(row.disabled(start()).empty());
  CHECK(refusal("blending.parameter", 2.0) == row.disabled(start()));
  for (const BlendingFamily& family : blending_families()) {
    CAPTURE(family.id);
    Document document = start();
    if (document == with("blending.function", std::string(family.id))) continue;
    document = with("blending.function", std::string(family.id));
    CHECK(blending_surface(document).blending_parameter == family.parameter_default);
    CHECK(row.disabled(document).empty() == (family.parameter_max > 0));
    CHECK(range_of(document, row).max == (family.parameter_max > 0 ? family.parameter_max : row.max));
    CHECK(family.parameter_max <= row.max);
  }
  Document rational = with("blending.parameter", 7.0, with("blending.function", "rational"));
  CHECK(blending_surface(with("blending.function", "rational", rational)).blending_parameter == 7);
  CHECK(refusal("blending.parameter", 1.0, rational) == "Must be a whole number from 2 to 16.");
}

}  // namespace knotwork::scene::parameters_test
