#include "knotwork/scene/curve_edits.h"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/history.h"

namespace knotwork::scene::curve_edits_test {
namespace {

BSplineCurveObject report_curve() {
  const Document document = find_chapter("bspline-curve")->start_document();
  return *std::get_if<BSplineCurveObject>(&stage_shape(document));
}

/// Random points under random sorted knots, some of them double.
BSplineCurveObject uneven_curve(std::mt19937& random, int degree, int count, Topology topology) {
  std::uniform_real_distribution<double> step(0.2, 1.5), coordinate(-2, 2);
  BSplineCurveObject curve;
  curve.degree = degree;
  curve.topology = topology;
  curve.points.clear();
  for (int i = 0; i < count; ++i) curve.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  curve.knots.clear();
  if (topology == Topology::open) {
    double t = 0;
    for (int i = 0; i <= count + degree; ++i) {
      const bool clamped = i <= degree || i > count;
      if (i > 0 && !(clamped && i != degree + 1 && i != count) && !(i == degree + 3 && degree > 1)) t += step(random);
      if (i > count) t = curve.knots.back();
      curve.knots.push_back(t);
    }
  } else {
    std::vector<double> period{0};
    for (int i = 1; i < count; ++i) period.push_back(period.back() + (i == 2 && degree > 1 ? 0 : step(random)));
    const double length = period.back() + step(random);
    for (int i = -degree; i <= count + degree; ++i) {
      const int round = i >= 0 ? i / count : -((count - 1 - i) / count);
      curve.knots.push_back(period[static_cast<std::size_t>(i - round * count)] + round * length);
    }
  }
  return curve;
}

}  // namespace

TEST_CASE("curve edits: a point more or less leaves a valid curve that ends where its points say") {
  std::mt19937 random(11);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= max_degree; ++degree) {
      for (const bool even : {true, false}) {
        CAPTURE(degree);
        CAPTURE(even);
        BSplineCurveObject curve = uneven_curve(random, degree, degree + 5, topology);
        if (even) REQUIRE(set_degree(curve, degree));
        REQUIRE(build_curve(curve).has_value());
        CHECK(knots_are_even(curve) == even);
        Shape shape = curve;
        for (int index = 0; index <= degree + 5; ++index) {
          CAPTURE(index);
          Shape longer = shape;
          REQUIRE(insert_point(longer, index, {9, 9, 9}));
          CHECK(curve_points(longer).size() == curve.points.size() + 1);
          CHECK(curve_points(longer)[static_cast<std::size_t>(index)] == Eigen::Vector3d(9, 9, 9));
          const auto& made = *std::get_if<BSplineCurveObject>(&longer);
          REQUIRE(build_curve(made).has_value());
          CHECK(knots_are_even(made) == even);
          REQUIRE(remove_point(longer, index));
          CHECK(std::get_if<BSplineCurveObject>(&longer)->points == curve.points);
          REQUIRE(build_curve(*std::get_if<BSplineCurveObject>(&longer)).has_value());
        }
      }
    }
  }
}

TEST_CASE("curve edits: among uneven knots the others keep their places, and the new one is the new point's") {
  BSplineCurveObject curve = report_curve();
  REQUIRE(set_knot(curve, 5, 2.6));
  Shape shape = curve;
  REQUIRE(insert_point(shape, 4, {0, 0, 0}));
  const auto& longer = *std::get_if<BSplineCurveObject>(&shape);
  // Greville abscissae (2.6 + 1 + 3)/3 of point 3 and (2.6 + 3 + 4)/3 of point 4: the mean is 2.7.
  CHECK(longer.knots.size() == curve.knots.size() + 1);
  CHECK(longer.knots[6] == doctest::Approx(2.7));
  CHECK(longer.knots[5] == 2.6);
  CHECK(longer.knots[7] == 3);
}

TEST_CASE("curve edits: knots move, those of a closed curve with their copies, and stay sorted") {
  BSplineCurveObject curve = report_curve();
  REQUIRE(set_knot(curve, 5, 1.25));
  CHECK(curve.knots == std::vector<double>{0, 0, 0, 0, 1, 1.25, 3, 4, 4, 4, 4});
  REQUIRE(set_topology(curve, Topology::closed));
  CHECK(curve.knots.size() == 14);
  REQUIRE(set_knot(curve, 4, 1.5));
  CHECK(curve.knots[4] == 1.5);
  CHECK(curve.knots[11] == 8.5);
  REQUIRE(set_knot(curve, 3, -0.25));
  CHECK(curve.knots[3] == -0.25);
  CHECK(curve.knots[10] == 6.75);
  CHECK(build_curve(curve).has_value());

  const auto refused = [&](int index, double value) {
    const BSplineCurveObject before = curve;
    const Status status = set_knot(curve, index, value);
    CHECK(curve == before);
    REQUIRE_FALSE(status);
    CHECK_FALSE(status.error().message.empty());
    return status.error().path;
  };
  CHECK(refused(4, 7.5) == "value");  // beyond its neighbour
  CHECK(refused(2, 1) == "index");    // a copy
  CHECK(refused(10, 7) == "index");
  CHECK(refused(-1, 0) == "index");
  CHECK(refused(99, 0) == "index");
  CHECK(refused(4, std::numeric_limits<double>::quiet_NaN()) == "value");
  CHECK(refused(4, 1e7) == "value");

  curve = report_curve();
  REQUIRE(set_knot(curve, 4, 2));
  REQUIRE(set_knot(curve, 6, 2));
  curve.degree = 3;
  CHECK(build_curve(curve).has_value());  // triple, as the degree allows
  REQUIRE(set_degree(curve, 2));
  REQUIRE(set_knot(curve, 3, 2));
  CHECK(refused(5, 2) == "value");  // triple at degree 2
}

TEST_CASE("curve edits: another degree or topology takes even knots and keeps the points") {
  for (int degree = 1; degree <= 6; ++degree) {
    BSplineCurveObject curve = report_curve();
    REQUIRE(set_knot(curve, 5, 2.2));
    const std::vector<Eigen::Vector3d> points = curve.points;
    REQUIRE(set_degree(curve, degree));
    CHECK(curve.points == points);
    CHECK(curve.degree == degree);
    CHECK(knots_are_even(curve));
    const BSplineCurve built = build_curve(curve).value();
    CHECK(built.knots().end() == 7 - degree);
    CHECK(built(0) == points.front());
    REQUIRE(set_topology(curve, Topology::closed));
    CHECK(build_curve(curve).value().knots().period() == 7);
  }
  BSplineCurveObject curve = report_curve();
  const BSplineCurveObject before = curve;
  const Status high = set_degree(curve, 7);
  REQUIRE_FALSE(high);
  CHECK(high.error().message == "An open curve of degree 7 needs at least 8 points.");
  CHECK_FALSE(set_degree(curve, 10));
  CHECK_FALSE(set_degree(curve, 0));
  CHECK(curve == before);
}

TEST_CASE("curve edits: what cannot be is refused with the reason") {
  Shape surface = BlendingSurfaceObject{};
  CHECK(curve_points(surface).empty());
  CHECK_FALSE(set_point(surface, 0, {0, 0, 0}));
  CHECK_FALSE(insert_point(surface, 0, {0, 0, 0}));
  CHECK_FALSE(remove_point(surface, 0));

  Shape shape = report_curve();
  const Shape before = shape;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int index : {-1, 7, 100}) {
    CHECK(set_point(shape, index, {0, 0, 0}).error().path == "index");
    CHECK(remove_point(shape, index).error().path == "index");
  }
  CHECK(insert_point(shape, 8, {0, 0, 0}).error().path == "index");
  CHECK(set_point(shape, 0, {nan, 0, 0}).error().path == "position");
  CHECK(insert_point(shape, 0, {0, 2e6, 0}).error().path == "position");
  CHECK(shape == before);

  for (int count = 7; count > 4; --count) REQUIRE(remove_point(shape, 0));
  const Status last = remove_point(shape, 0);
  REQUIRE_FALSE(last);
  CHECK(last.error().message == "An open curve of degree 3 needs at least 4 points.");

  Shape bezier = BezierCurveObject{};
  CHECK_FALSE(remove_point(bezier, 0));
  for (int count = 2; count < 17; ++count) REQUIRE(insert_point(bezier, 1, {0, 1, 0}));
  CHECK_FALSE(insert_point(bezier, 1, {0, 1, 0}));
  CHECK(curve_points(bezier).size() == 17);

  BSplineCurveObject many;
  many.points.assign(512, Eigen::Vector3d::Zero());
  REQUIRE(set_degree(many, 3));
  Shape full = many;
  CHECK_FALSE(insert_point(full, 3, {0, 0, 0}));
}

TEST_CASE("curve edits: as commands each is one step of the history") {
  Document document = find_chapter("bspline-curve")->start_document();
  const Document start = document;
  History history;
  CHECK(history.perform(document, SetPoint{2, {1, 1, 1}}));
  CHECK(history.undo_label() == "Move point 2");
  CHECK(history.perform(document, InsertPoint{3, {2, 2, 2}}));
  CHECK(history.undo_label() == "Add point 3");
  CHECK(history.perform(document, RemovePoint{0}));
  CHECK(history.undo_label() == "Delete point 0");
  CHECK(history.perform(document, SetKnot{4, 1.1}));
  CHECK(history.undo_label() == "Move knot 4");
  CHECK(notice(document, SetParameter{"curve.degree", 2.0}) == "The knots are evenly spaced again.");
  CHECK(history.perform(document, SetParameter{"curve.topology", "closed"}));
  CHECK(history.undo_label() == "Close the curve");
  for (int k = 0; k < 5; ++k) CHECK(history.undo(document));
  CHECK(document == start);

  CHECK(apply(document, SetPatchEdit{}).error().message == "What is on the stage has no local patches.");
  CHECK_FALSE(apply(document, ResetPatches{}));
  Document surface = find_chapter("blending-surface")->start_document();
  CHECK_FALSE(apply(surface, SetKnot{4, 1}));
  CHECK_FALSE(apply(surface, SetPoint{0, {0, 0, 0}}));
}

TEST_CASE("curve edits: ends are clamped or not, under the same points") {
  BSplineCurveObject curve = report_curve();
  const BSplineCurveObject start = curve;
  CHECK(is_clamped(curve));
  REQUIRE(set_clamped(curve, false));
  CHECK(curve.points == start.points);
  CHECK(curve.knots == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK_FALSE(is_clamped(curve));
  CHECK(knots_are_even(curve));
  // Nothing holds the curve at its ends any more, and what is added keeps it so.
  const BSplineCurve loose = build_curve(curve).value();
  CHECK((loose(3) - curve.points.front()).norm() > 0.1);
  Shape shape = curve;
  REQUIRE(insert_point(shape, 3, {0, 0, 0}));
  CHECK(std::get_if<BSplineCurveObject>(&shape)->knots.back() == 11);
  REQUIRE(set_degree(curve, 2));
  CHECK_FALSE(is_clamped(curve));
  curve.knots[4] = 3.5;
  CHECK_FALSE(knots_are_even(curve));
  REQUIRE(set_degree(curve, 3));
  REQUIRE(set_clamped(curve, true));
  CHECK(curve == start);
}

}  // namespace knotwork::scene::curve_edits_test
