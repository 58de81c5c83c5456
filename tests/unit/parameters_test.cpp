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
  for (const Chapter& chapter : chapters())
    if (applies(chapter.start_document(), row)) return chapter.start_document();
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
  const std::set<std::string_view> promised{"topology.u",
                                            "topology.v",
                                            "model",
                                            "locals.u",
                                            "locals.v",
                                            "blending.function",
                                            "blending.parameter",
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
                                            "curve.parameter",
                                            "display.polygon",
                                            "display.construction"};
  std::set<std::string_view> ids;
  for (const Parameter& row : parameters()) {
    CAPTURE(row.id);
    const Document document = document_for(row);
    CHECK(ids.insert(row.id).second);
    CHECK(find_parameter(row.id) == &row);
    CHECK_FALSE(row.label.empty());
    CHECK_FALSE(row.group.empty());
    REQUIRE((row.get != nullptr));
    REQUIRE((row.set != nullptr));
    REQUIRE((row.disabled != nullptr));
    const bool numeric = row.kind == ParameterKind::number || row.kind == ParameterKind::integer;
    CHECK((row.kind == ParameterKind::choice) == (row.choices.size() >= 2));
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

  // The same model again does not reset its measures.
  Document torus = with("model", "torus");
  blending_surface(torus).model = Torus{2, 0.5, 0.25};
  CHECK(with("model", "torus", torus) == torus);
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
