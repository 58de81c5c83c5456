#include "knotwork/scene/blending_curve_edits.h"

#include <limits>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/history.h"

#include "unit/refused_command.h"

namespace knotwork::scene::blending_curve_edits_test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Document start() { return find_chapter("blending-curve")->start_document(); }

BlendingCurveObject& curve_of(Document& document) { return *std::get_if<BlendingCurveObject>(&stage_shape(document)); }

BlendingCurveObject start_curve() {
  Document document = start();
  return curve_of(document);
}

int row_called(std::string_view id) { return static_cast<int>(find_catalogue_curve(id) - curve_catalogue().data()); }

/// The path of the error of a document whose curve has been spoilt.
template <class F>
std::string path_with(F spoil) {
  Document document = start();
  spoil(curve_of(document));
  const Status status = check(document);
  REQUIRE_FALSE(status);
  CHECK_FALSE(status.error().message.empty());
  return status.error().path;
}

}  // namespace

TEST_CASE("blending curve edits: knots are even, or at their shares of the domain") {
  BlendingCurveObject object = start_curve();
  const KnotVector even = knots_of(object);
  CHECK(even.count() == 10);
  CHECK(even.closed());
  CHECK(even.start() == 0);
  CHECK(even[4] == doctest::Approx(0.3 * even.period()));

  object.locals = 4;
  object.knots = {0.2, 0.3, 0.9};
  REQUIRE(check_curve(object));
  const KnotVector closed = knots_of(object);
  CHECK(closed.count() == 4);
  CHECK(closed[2] == doctest::Approx(0.2 * closed.period()));
  CHECK(closed[0] == doctest::Approx(-0.1 * closed.period()));
  CHECK(closed[6] == doctest::Approx(1.2 * closed.period()));

  object.topology = Topology::open;
  object.knots = {0.2, 0.3};
  REQUIRE(check_curve(object));
  const KnotVector open = knots_of(object);
  CHECK(open.count() == 4);
  CHECK(open.knots().size() == 6);
  CHECK(open[0] == open[1]);
  CHECK(open[3] == doctest::Approx(0.3 * open.period()));
}

TEST_CASE("blending curve edits: a knot moves between its neighbours, and no farther") {
  BlendingCurveObject object = start_curve();
  const double period = knots_of(object).period();
  REQUIRE(set_knot(object, 2, 0.05 * period));
  CHECK(object.knots.size() == 9);
  CHECK(knots_of(object)[2] == doctest::Approx(0.05 * period));
  CHECK(knots_of(object)[3] == doctest::Approx(0.2 * period));
  REQUIRE(check_curve(object));
  const BlendingCurveObject before = object;
  CHECK(set_knot(object, 2, 0.2 * period).error().path == "value");  // on its neighbour
  CHECK(set_knot(object, 2, -1).error().path == "value");
  CHECK(set_knot(object, 2, not_a_number).error().path == "value");
  CHECK(set_knot(object, 1, 0.01).error().path == "index");  // the ends stay
  CHECK(set_knot(object, 11, 0.01).error().path == "index");
  CHECK(object == before);
}

TEST_CASE("blending curve edits: topology, count and model bring even knots and an opening with them") {
  BlendingCurveObject object = start_curve();
  REQUIRE(set_knot(object, 4, 1.8));
  REQUIRE(set_topology(object, Topology::open));
  CHECK(object.knots.empty());
  CHECK(knots_of(object).interval_count() == 9);
  REQUIRE(set_topology(object, Topology::closed));
  REQUIRE(set_knot(object, 4, 1.8));
  REQUIRE(set_local_count(object, 5));
  CHECK(object.knots.empty());
  CHECK(object.edits == start_curve().edits);
  CHECK(set_local_count(object, 1).error().path == "count");
  CHECK(set_local_count(object, 65).error().path == "count");

  REQUIRE(set_model(object, row_called("helix")));
  CHECK(object.topology == Topology::open);
  CHECK(set_topology(object, Topology::closed).error().path == "topology");
  CHECK(object.topology == Topology::open);
  REQUIRE(check_curve(object));
  // The same curve again keeps its measures.
  REQUIRE(set_measure(object, 0, 2.5));
  REQUIRE(set_model(object, row_called("helix")));
  CHECK(object.model.measures[0] == 2.5);
}

TEST_CASE("blending curve edits: measures that leave no curve to blend over are refused") {
  BlendingCurveObject object = start_curve();
  REQUIRE(set_model(object, row_called("arc")));
  REQUIRE(set_measure(object, 0, 1e-6));
  const BlendingCurveObject before = object;
  CHECK(set_measure(object, 1, 1e-6).error().path == "measure");  // a domain 6e12 long
  CHECK(object == before);
  ModelCurveObject alone;
  REQUIRE(set_model(alone, row_called("torus-knot")));
  CHECK(set_measure(alone, 0, 2.5).error().path == "measure");  // a count
  CHECK(set_measure(alone, 2, -1).error().path == "measure");
  CHECK(set_measure(alone, 2, not_a_number).error().path == "measure");
}

TEST_CASE("blending curve edits: documents with bad curves are refused with the member's path") {
  using Object = BlendingCurveObject;
  CHECK(path_with([](Object& o) { o.locals = 1; }) == "objects[0].locals.count");
  CHECK(path_with([](Object& o) { o.local_degree = 4; }) == "objects[0].locals.degree");
  CHECK(path_with([](Object& o) { o.knots = {0.5}; }) == "objects[0].knots");
  CHECK(path_with([](Object& o) {
          o.locals = 3;
          o.knots = {0.5, 0.4};
        }) == "objects[0].knots[1]");
  CHECK(path_with([](Object& o) {
          o.locals = 3;
          o.knots = {0.5, 1};
        }) == "objects[0].knots[1]");
  CHECK(path_with([](Object& o) { o.knots.assign(64, 0.5); }) == "objects[0].knots");
  CHECK(path_with([](Object& o) { o.model = standard_curve(row_called("line")); }) == "objects[0].topology");
  CHECK(path_with([](Object& o) { o.model.measures[0] = not_a_number; }) == "objects[0].model.size");
  CHECK(path_with([](Object& o) { o.edits[{1, 2}] = PatchEdit{}; }) == "objects[0].edits");
  CHECK(path_with([](Object& o) { o.edits[{1, 0}].scale.x() = 0; }) == "objects[0].edits[0].scale[0]");
  CHECK(path_with([](Object& o) {
          o.blending = BlendingKind::rational;
          o.blending_parameter = 1;
        }) == "objects[0].blending.parameter");
  CHECK(path_with([](Object& o) { o.parameter = 1.5; }) == "objects[0].parameter");

  // A line without direction has all measures within their limits.
  Document document = find_chapter("model-curve")->start_document();
  auto& model = *std::get_if<ModelCurveObject>(&stage_shape(document));
  model.model = standard_curve(row_called("line"));
  for (std::size_t k = 3; k < 6; ++k) model.model.measures[k] = 0;
  CHECK(check(document).error().path == "objects[0].model.directionX");
}

TEST_CASE("blending curve edits: JSON names each measure, and misses or refuses no other") {
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CAPTURE(row.id);
    Document document = start();
    REQUIRE(set_model(curve_of(document), row_called(row.id)));
    curve_of(document).local_kind = LocalCurveKind::arc;
    const std::string text = write_document(document);
    const Result<Document> again = parse_document(text);
    REQUIRE(again);
    CHECK(again.value() == document);
    const std::string named = "\"" + std::string(row.measures.front().id) + "\":";
    std::string other = text;
    other.replace(other.find(named), named.size(), "\"girth\":");
    CHECK(parse_document(other).error().path == "objects[0].model." + std::string(row.measures.front().id));
  }
}

TEST_CASE("blending curve edits: commands edit one local, and undo takes them back exactly") {
  Document document = start();
  const Document before = document;
  History history;
  PatchEdit edit;
  edit.translation = {0.1, 0.2, 0.3};
  REQUIRE(history.perform(document, SetLocalEdit{7, edit}));
  CHECK(curve_of(document).edits.at({7, 0}) == edit);
  CHECK(history.undo_label() == "Move local curve 7");
  REQUIRE(history.perform(document, SetKnot{3, 1.4}));
  REQUIRE(history.perform(document, SetParameter{"curve.topology", "open"}));
  REQUIRE(history.perform(document, SetParameter{"locals.kind", "bezier-hermite"}));
  REQUIRE(history.perform(document, SetParameter{"curve.model", "helix"}));
  REQUIRE(history.perform(document, SetParameter{"curve.turns", 5.0}));
  REQUIRE(history.perform(document, SetLocalEdit{7, PatchEdit{}}));
  CHECK(curve_of(document).edits.size() == 1);
  REQUIRE(history.perform(document, ResetLocals{}));
  CHECK(curve_of(document).edits.empty());
  while (history.undo(document)) {
  }
  CHECK(document == before);

  CHECK(refusal(start(), SetLocalEdit{10, edit}).path == "local");
  CHECK(refusal(start(), SetLocalEdit{-1, edit}).path == "local");
  edit.translation.x() = not_a_number;
  CHECK(refusal(start(), SetLocalEdit{1, edit}).path == "translation[0]");
  CHECK(refusal(find_chapter("blending-surface")->start_document(), SetLocalEdit{0, {}}).path == "local");
  CHECK(refusal(start(), SetPatchEdit{{0, 0}, {}}).path == "patch");
  CHECK(refusal(start(), SetKnot{4, 1e3}).path == "value");
}

}  // namespace knotwork::scene::blending_curve_edits_test
