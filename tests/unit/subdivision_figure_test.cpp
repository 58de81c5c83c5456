#include "knotwork/scene/subdivision_figure.h"

#include <cmath>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene::subdivision_figure_test {
namespace {

SubdivisionCurveObject report_polygon() {
  const Document document = find_chapter("subdivision")->start_document();
  return *std::get_if<SubdivisionCurveObject>(&stage_shape(document));
}

SubdivisionCurveObject at_step(int step, double fraction = 0, Topology topology = Topology::closed) {
  SubdivisionCurveObject object = report_polygon();
  object.topology = topology;
  object.step = step;
  object.fraction = fraction;
  REQUIRE(check_subdivision(object));
  return object;
}

}  // namespace

TEST_CASE("subdivision figure: every whole level is the core's, every step between it split or averaged points") {
  for (const Topology topology : {Topology::closed, Topology::open}) {
    for (int step = 0; step <= 16; ++step) {
      CAPTURE(step);
      const SubdivisionCurveObject object = at_step(step, 0, topology);
      const SubdivisionFigure figure(object);
      CHECK(figure.level == step / 4);
      CHECK(figure.pass == step % 4);
      CHECK(figure.closed == (topology == Topology::closed));
      CHECK(figure.doubled == (step % 4 == 1));
      std::vector<Eigen::Vector3d> expected = subdivide(scheme_of(object), object.points, step / 4).value();
      if (step % 4 > 0) expected = split_points(expected);
      for (int k = 1; k < step % 4; ++k) expected = averaged_points(expected, topology);
      CHECK(figure.polygon == expected);
    }
  }
}

TEST_CASE("subdivision figure: vertices slide from one pass to the next without a jump") {
  for (const int step : {1, 2, 3, 6}) {
    const SubdivisionFigure before(at_step(step)), after(at_step(step + 1)), begun(at_step(step, 1e-9)),
        nearly(at_step(step, 1 - 1e-9)), half(at_step(step, 0.5));
    REQUIRE(begun.polygon.size() == before.polygon.size());
    REQUIRE(nearly.polygon.size() == after.polygon.size());
    for (std::size_t i = 0; i < before.polygon.size(); ++i) {
      CHECK((begun.polygon[i] - before.polygon[i]).norm() < 1e-7);
      CHECK((nearly.polygon[i] - after.polygon[i]).norm() < 1e-7);
      CHECK((half.polygon[i] - (before.polygon[i] + after.polygon[i]) / 2).norm() < 1e-13);
    }
    CHECK_FALSE(half.doubled);
  }
  // The split moves nothing.
  CHECK(SubdivisionFigure(at_step(4, 0.5)).polygon == SubdivisionFigure(at_step(4)).polygon);
}

TEST_CASE("subdivision figure: the distance to the limit falls fourfold a level") {
  for (const Topology topology : {Topology::closed, Topology::open}) {
    for (int degree = 2; degree <= 5; ++degree) {
      CAPTURE(degree);
      SubdivisionCurveObject object = at_step(0, 0, topology);
      object.degree = degree;
      const SubdivisionFigure figure(object);
      REQUIRE(figure.distances.size() >= 11);
      for (std::size_t k = 0; k < figure.distances.size(); ++k) CHECK(figure.distances[k].level == static_cast<int>(k));
      for (std::size_t k = 5; k < 10; ++k)
        CHECK(figure.distances[k].maximum / figure.distances[k + 1].maximum == doctest::Approx(4).epsilon(0.03));
    }
  }
}

TEST_CASE("subdivision figure: degree 1 is its own limit, deep walks are measured to their end") {
  SubdivisionCurveObject object = at_step(0);
  object.degree = 1;
  object.step = 0;
  for (const SubdivisionFigure::LevelDistance& distance : SubdivisionFigure(object).distances)
    CHECK(distance.maximum < 1e-14);
  object = report_polygon();
  REQUIRE(set_levels(object, 13));
  const SubdivisionFigure figure(object);
  CHECK(figure.polygon.size() == 7u << 13);
  CHECK(figure.distances.back().level == 13);
  CHECK((figure.limit.curve(3.5) - limit_curve(scheme_of(object), object.points).value()(3.5)).norm() == 0);
}

}  // namespace knotwork::scene::subdivision_figure_test
