#include "knotwork/scene/subdivision_edits.h"

#include <limits>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/history.h"

#include "unit/refused_command.h"

namespace knotwork::scene::subdivision_edits_test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Document start() { return find_chapter("subdivision")->start_document(); }

SubdivisionCurveObject& polygon(Document& document) {
  return *std::get_if<SubdivisionCurveObject>(&stage_shape(document));
}

Document with(std::string id, ParameterValue value, Document document = start()) {
  REQUIRE(apply(document, SetParameter{std::move(id), std::move(value)}));
  return document;
}

}  // namespace

TEST_CASE("subdivision edits: levels go to the walk's end, steps walk it") {
  Document document = with("subdivision.levels", 3.0);
  CHECK(polygon(document).step == 12);
  document = with("subdivision.step", 5.0, document);
  CHECK(polygon(document).step == 5);
  CHECK(polygon(document).levels == 3);
  document = with("subdivision.fraction", 0.25, document);
  CHECK(polygon(document).fraction == 0.25);
  Document further = with("subdivision.step", 6.0, document);
  CHECK(polygon(further).fraction == 0);
  CHECK(refusal(document, SetParameter{"subdivision.step", 13.0}).message == "Must be a whole number from 0 to 12.");
  CHECK(range_of(document, *find_parameter("subdivision.step")).max == 12);

  const Document end = with("subdivision.step", 12.0, document);
  CHECK_FALSE(find_parameter("subdivision.fraction")->disabled(end).empty());
  CHECK(refusal(end, SetParameter{"subdivision.fraction", 0.5}).path == "subdivision.fraction");
  CHECK(find_parameter("subdivision.fraction")->disabled(document).empty());
}

TEST_CASE("subdivision edits: a new degree keeps the levels done") {
  Document document = with("subdivision.fraction", 0.5, with("subdivision.step", 9.0, with("subdivision.levels", 4.0)));
  document = with("curve.degree", 5.0, document);
  CHECK(polygon(document).step == 12);  // two levels of six steps
  CHECK(polygon(document).fraction == 0);
  CHECK(polygon(document).levels == 4);
}

TEST_CASE("subdivision edits: points are moved, added, deleted and replaced, and undone exactly") {
  Document document = start();
  const Document before = document;
  History history;
  REQUIRE(history.perform(document, SetPoint{2, {1, 2, 3}}));
  CHECK(polygon(document).points[2] == Eigen::Vector3d(1, 2, 3));
  REQUIRE(history.perform(document, InsertPoint{0, {4, 5, 6}}));
  CHECK(polygon(document).points.size() == 8);
  REQUIRE(history.perform(document, RemovePoint{7}));
  REQUIRE(history.perform(document, SetPoints{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}));
  CHECK(polygon(document).points.size() == 3);
  for (int k = 0; k < 4; ++k) CHECK(history.undo(document));
  CHECK(document == before);
}

TEST_CASE("subdivision edits: too few points, too many vertices, no numbers") {
  const Document open = with("curve.topology", "open");
  CHECK(refusal(open, SetParameter{"curve.degree", 7.0}).message ==
        "An open polygon needs at least 8 points for degree 7.");
  CHECK(refusal(open, SetPoints{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}).path == "points");
  CHECK(refusal(start(), SetPoints{{{0, 0, 0}}}).path == "points");
  CHECK(refusal(with("curve.degree", 9.0), SetParameter{"curve.topology", "open"}).path == "curve.topology");
  CHECK(refusal(start(), SetPoint{1, {0, not_a_number, 0}}).path == "position");
  CHECK(refusal(start(), SetPoints{{{0, 0, 0}, {1, not_a_number, 0}}}).path == "points[1]");
  CHECK(refusal(start(), SetPoints{std::vector<Eigen::Vector3d>(1000000, Eigen::Vector3d::Zero())}).message ==
        "There must be from 2 to 512 points; there are 1000000.");

  CHECK(range_of(start(), *find_parameter("subdivision.levels")).max == 13);  // 7 * 2^13 < 2^16 < 7 * 2^14
  CHECK(refusal(start(), SetParameter{"subdivision.levels", 14.0}).message ==
        "At most 13 levels of 7 points keep within 65536 vertices.");
  Document deep = with("subdivision.levels", 13.0);
  REQUIRE(apply(deep, InsertPoint{0, {0, 0, 0}}));
  CHECK(refusal(deep, InsertPoint{0, {0, 0, 1}}).message ==
        "At most 12 levels of 9 points keep within 65536 vertices.");
}

TEST_CASE("subdivision edits: the clock walks to the end, stops there and begins again") {
  Document document = with("subdivision.step", 0.0, with("subdivision.levels", 1.0));
  REQUIRE(apply(document, AdvanceClock{5}));
  CHECK(polygon(document).step == 0);
  document = with("animation.playing", true, document);
  REQUIRE(apply(document, AdvanceClock{1.5}));
  CHECK(polygon(document).step == 1);
  CHECK(polygon(document).fraction == doctest::Approx(0.5));
  document = with("animation.speed", 2.0, document);
  REQUIRE(apply(document, AdvanceClock{1}));
  CHECK(polygon(document).step == 3);
  CHECK(polygon(document).fraction == doctest::Approx(0.5));
  REQUIRE(apply(document, AdvanceClock{1e6}));
  CHECK(polygon(document).step == 4);
  CHECK(polygon(document).fraction == 0);
  CHECK_FALSE(document.animation.playing);
  CHECK(check(document));
  document = with("animation.playing", true, document);
  REQUIRE(apply(document, AdvanceClock{0.25}));
  CHECK(polygon(document).step == 0);
  CHECK(polygon(document).fraction == doctest::Approx(0.5));
}

TEST_CASE("subdivision edits: documents are read back bit for bit, bad ones refused with a path") {
  Document document = with("subdivision.fraction", 1.0 / 3, with("subdivision.step", 7.0));
  const Result<Document> again = parse_document(write_document(document));
  REQUIRE(again);
  CHECK(again.value() == document);
  const auto path_of = [](auto change) {
    Document bad = start();
    change(polygon(bad));
    const Status status = check(bad);
    REQUIRE_FALSE(status);
    return status.error().path;
  };
  CHECK(path_of([](auto& object) { object.points.resize(1); }) == "objects[0].points");
  CHECK(path_of([](auto& object) { object.topology = Topology::open, object.degree = 9; }) == "objects[0].points");
  CHECK(path_of([](auto& object) { object.degree = 0; }) == "objects[0].degree");
  CHECK(path_of([](auto& object) { object.levels = 14; }) == "objects[0].levels");
  CHECK(path_of([](auto& object) { object.step = 17; }) == "objects[0].step");
  CHECK(path_of([](auto& object) { object.step = -1; }) == "objects[0].step");
  CHECK(path_of([](auto& object) { object.fraction = not_a_number; }) == "objects[0].fraction");
  CHECK(path_of([](auto& object) { object.step = 16, object.fraction = 0.5; }) == "objects[0].fraction");
  CHECK(path_of([](auto& object) { object.points[1].z() = not_a_number; }) == "objects[0].points[1][2]");
}

}  // namespace knotwork::scene::subdivision_edits_test
