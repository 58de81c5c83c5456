#include "knotwork/scene/fit_edits.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/history.h"

#include "unit/refused_command.h"

namespace knotwork::scene::fit_edits_test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

Document start(std::string_view chapter = "least-squares") { return find_chapter(chapter)->start_document(); }

FittedCurveObject& fitted(Document& document) { return *std::get_if<FittedCurveObject>(&stage_shape(document)); }

double rms(Document document) { return build_fit(fitted(document)).value().fit.rms; }

Document with(std::string id, ParameterValue value, Document document = start()) {
  REQUIRE(apply(document, SetParameter{std::move(id), std::move(value)}));
  return document;
}

std::vector<Eigen::Vector3d> wave(int count) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j) points.emplace_back(0.01 * j, std::sin(0.01 * j), 0);
  return points;
}

}  // namespace

TEST_CASE("fit edits: the start documents are the report's experiment, and the same put right") {
  CHECK(rms(start()) == doctest::Approx(0.0170422832));
  CHECK(rms(with("fitted.count", 6.0)) == doctest::Approx(0.1435259208));
  CHECK(rms(with("fitted.ends", "interpolated")) == doctest::Approx(0.0170915583));
  CHECK(rms(start("least-squares-closed")) == doctest::Approx(0.0022269053));
  Document open = start();
  CHECK(fitted(open).points.size() == 20);
  CHECK(fitted(open).points.front() == fitted(open).points.back());
  Document closed = start("least-squares-closed");
  // The prose says so.
  CHECK(rms(start()) > 7 * rms(closed));
  CHECK((fitted(closed).points.front() - fitted(closed).points.back()).norm() > 1);
}

TEST_CASE("fit edits: every parameter reaches the fit") {
  const double plain = rms(start());
  for (const SetParameter& edit : {SetParameter{"curve.degree", 5.0}, SetParameter{"curve.topology", "closed"},
                                   SetParameter{"fitted.smoothing", 2.0}, SetParameter{"fitted.knots", "averaged"}}) {
    CAPTURE(edit.id);
    CHECK(rms(with(edit.id, edit.value)) != plain);
  }
  // Of equal chords every exponent makes the same parameters; of unequal ones it does not.
  Document document = start();
  REQUIRE(apply(document, SetPoint{3, {9, 4, 1}}));
  const double uniform = rms(document);
  CHECK(rms(with("fitted.parameters", "chordLength", document)) != uniform);
  CHECK(rms(with("fitted.parameters", "centripetal", document)) != uniform);
}

TEST_CASE("fit edits: held ends sleep while the curve is closed") {
  Document document = with("curve.topology", "closed", with("fitted.ends", "interpolated"));
  CHECK(fitted(document).ends == FitEnds::interpolated);
  CHECK_FALSE(find_parameter("fitted.ends")->disabled(document).empty());
  document = with("curve.topology", "open", document);
  CHECK(find_parameter("fitted.ends")->disabled(document).empty());
  CHECK(rms(document) == doctest::Approx(0.0170915583));
}

TEST_CASE("fit edits: data are moved, added, deleted and replaced, and undone exactly") {
  Document document = start();
  const Document before = document;
  History history;
  REQUIRE(history.perform(document, SetPoint{5, {1, 2, 3}}));
  CHECK(fitted(document).points[5] == Eigen::Vector3d(1, 2, 3));
  REQUIRE(history.perform(document, InsertPoint{20, {7, 0, 0}}));
  CHECK(fitted(document).points.size() == 21);
  REQUIRE(history.perform(document, RemovePoint{0}));
  CHECK(fitted(document).points.size() == 20);
  REQUIRE(history.perform(document, SetPoints{wave(300)}));
  CHECK(fitted(document).points == wave(300));
  CHECK(history.undo_label() == "Replace the points");
  for (int k = 0; k < 4; ++k) CHECK(history.undo(document));
  CHECK(document == before);
  CHECK_FALSE(history.can_undo());
}

TEST_CASE("fit edits: what cannot be fitted is refused with the core's sentence, and nothing changes") {
  const std::string few =
      "There are 7 points for 8 control points: give more points, use fewer control points, or smooth.";
  const Error error = refusal(start(), SetPoints{wave(7)});
  CHECK(error.path == "points");
  CHECK(error.message == few);
  CHECK(refusal(start(), SetParameter{"fitted.count", 21.0}).path == "fitted.count");
  CHECK(refusal(start(), SetParameter{"fitted.count", 3.0}).message ==
        "An open curve of degree 3 needs at least 4 control points.");
  CHECK(refusal(start(), SetParameter{"curve.degree", 8.0}).message ==
        "An open curve of degree 8 needs at least 9 control points.");

  Document tight = start();
  REQUIRE(apply(tight, SetPoints{wave(8)}));
  CHECK(refusal(tight, RemovePoint{2}).message == few);
  // Smoothing determines what the data leave open.
  tight = with("fitted.smoothing", 0.5, tight);
  REQUIRE(apply(tight, RemovePoint{2}));
  CHECK(refusal(tight, SetParameter{"fitted.smoothing", 0.0}).message == few);
  CHECK(range_of(tight, *find_parameter("fitted.count")).max == limits::points.max);
  CHECK(range_of(start(), *find_parameter("fitted.count")).max == 20);
}

TEST_CASE("fit edits: no numbers, too far away, too many, too few") {
  for (const double wrong : {not_a_number, infinity, -infinity, 1e7}) {
    std::vector<Eigen::Vector3d> points = wave(30);
    points[17].y() = wrong;
    CHECK(refusal(start(), SetPoints{points}).path == "points[17]");
    CHECK(refusal(start(), SetPoint{3, {0, wrong, 0}}).path == "position");
    CHECK(refusal(start(), InsertPoint{3, {0, 0, wrong}}).path == "position");
    CHECK(refusal(start(), SetParameter{"fitted.smoothing", wrong}).path == "fitted.smoothing");
  }
  CHECK(refusal(start(), SetPoints{}).message == "There must be from 2 to 20000 points; there are 0.");
  CHECK(refusal(start(), SetPoints{wave(20001)}).message == "There must be from 2 to 20000 points; there are 20001.");
  CHECK(refusal(start(), SetPoints{std::vector<Eigen::Vector3d>(1000000, Eigen::Vector3d::Zero())}).path == "points");
  CHECK(refusal(start(), SetPoint{20, {0, 0, 0}}).path == "index");
  CHECK(refusal(start("bspline-curve"), SetPoints{wave(9)}).path == "points");
  CHECK(refusal(start("blending-surface"), SetPoints{wave(9)}).path == "points");
  Document full = start();
  REQUIRE(apply(full, SetPoints{wave(20000)}));
  CHECK(refusal(full, InsertPoint{4, {0, 0, 0}}).path == "index");
}

TEST_CASE("fit edits: data that coincide") {
  const std::vector<Eigen::Vector3d> one_place(12, Eigen::Vector3d(1, 2, 3));
  Document document = start();
  REQUIRE(apply(document, SetPoints{one_place}));  // uniform parameters do not mind
  CHECK(rms(document) < 1e-13);
  const std::string sentence = "All points are in one place: move one away, or use uniform parameters.";
  CHECK(refusal(document, SetParameter{"fitted.parameters", "chordLength"}).message == sentence);
  CHECK(refusal(with("fitted.parameters", "centripetal"), SetPoints{one_place}).message == sentence);

  // Dragged onto its neighbours, point after point, a datum is refused where the basis functions lose their support.
  Document chords = with("fitted.count", 20.0, with("fitted.parameters", "chordLength"));
  const Error error = refusal(chords, SetPoint{1, fitted(chords).points[0]});
  CHECK(error.path == "position");
  CHECK(error.message.find("basis functions") != std::string::npos);
}

TEST_CASE("fit edits: documents with fitted curves are read back bit for bit, bad ones refused with a path") {
  Document document = with("fitted.smoothing", 0.1, with("fitted.parameters", "chordLength"));
  REQUIRE(apply(document, SetPoints{wave(20000)}));
  const Result<Document> again = parse_document(write_document(document));
  REQUIRE(again);
  CHECK(again.value() == document);

  const auto path_of = [](auto change) {
    Document bad = start();
    change(fitted(bad));
    const Status status = check(bad);
    REQUIRE_FALSE(status);
    return status.error().path;
  };
  CHECK(path_of([](auto& object) { object.points.resize(7); }) == "objects[0].points");
  CHECK(path_of([](auto& object) { object.points.clear(); }) == "objects[0].points");
  CHECK(path_of([](auto& object) { object.points[4].x() = not_a_number; }) == "objects[0].points[4][0]");
  CHECK(path_of([](auto& object) { object.degree = 10; }) == "objects[0].degree");
  CHECK(path_of([](auto& object) { object.degree = 9; }) == "objects[0].count");
  CHECK(path_of([](auto& object) { object.count = 513; }) == "objects[0].count");
  CHECK(path_of([](auto& object) { object.smoothing = -1; }) == "objects[0].smoothing");
  Document many = document;
  many.objects.push_back(many.objects.front());
  many.objects.back().id = "second";
  CHECK(check(many).error().path == "objects[1].points");
}

TEST_CASE("fit edits: degree and topology are shared with the other curves") {
  const Document document = start();
  CHECK(degree_of(stage_shape(document)) == 3);
  CHECK(topology_of(stage_shape(document)) == Topology::open);
  CHECK_FALSE(closes(stage_shape(document)));
  CHECK(closes(stage_shape(start("least-squares-closed"))));
  CHECK(degree_range(stage_shape(document)).max == 7);
  CHECK(notice(document, SetParameter{"curve.degree", 4.0}).empty());
}

}  // namespace knotwork::scene::fit_edits_test
