#include "knotwork/scene/curve_figure.h"

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"

namespace knotwork::scene::curve_figure_test {
namespace {

Shape shape_of(std::string_view chapter) { return stage_shape(find_chapter(chapter)->start_document()); }

BSplineCurveObject report_curve() {
  const Shape shape = shape_of("bspline-curve");
  return *std::get_if<BSplineCurveObject>(&shape);
}

void check_figure(const Shape& shape) {
  const CurveFigure figure(shape);
  const std::size_t width = static_cast<std::size_t>(figure.curve.degree()) + 1;
  REQUIRE(figure.weights.size() == figure.samples.size() * width);
  CHECK((figure.construction.back().front() - figure.curve(figure.t)).norm() < 1e-13);
  for (std::size_t k = 0; k < figure.samples.size(); ++k) {
    // The weights mix the points into the curve, and are a partition of unity.
    Eigen::Vector3d mixed = Eigen::Vector3d::Zero();
    double sum = 0;
    for (int i = 0; i < figure.curve.knots().count(); ++i) {
      mixed += figure.weight(k, i) * figure.curve.point(i);
      sum += figure.weight(k, i);
    }
    CHECK(std::abs(sum - 1) < 1e-13);
    CHECK((mixed - figure.samples[k].point).norm() < 1e-12);
    CHECK((figure.curve(figure.samples[k].t) - figure.samples[k].point).norm() < 1e-12);
  }
}

}  // namespace

TEST_CASE("curve figure: samples lie on the curve, their weights mix the points into it") {
  check_figure(shape_of("bezier-curve"));
  check_figure(shape_of("bspline-curve"));
  BSplineCurveObject curve = report_curve();
  REQUIRE(set_topology(curve, Topology::closed));
  check_figure(curve);
  curve.points.resize(3);
  REQUIRE(set_degree(curve, 3));  // each point is met more than once
  check_figure(curve);
}

TEST_CASE("curve figure: marks gather the knots that coincide") {
  BSplineCurveObject curve = report_curve();
  REQUIRE(set_knot(curve, 4, 2));
  const CurveFigure figure(curve);
  REQUIRE(figure.marks.size() == 4);
  CHECK(figure.marks[0].first == 0);
  CHECK(figure.marks[0].last == 3);
  CHECK_FALSE(figure.marks[0].inner);
  CHECK(figure.marks[1].first == 4);
  CHECK(figure.marks[1].last == 5);
  CHECK(figure.marks[1].inner);
  CHECK(figure.marks[1].t == 2);
  CHECK(figure.marks[2].first == 6);
  CHECK(figure.marks[3].last == 10);

  REQUIRE(set_topology(curve, Topology::closed));
  const CurveFigure closed(curve);
  CHECK(closed.marks.size() == 7);
  for (const CurveFigure::Mark& mark : closed.marks) CHECK(mark.inner);
}

TEST_CASE("curve figure: a Bezier curve is a B-spline without inner knots") {
  const Shape shape = shape_of("bezier-curve");
  const BSplineCurve spline = spline_of(shape);
  const auto points = curve_points(shape);
  const BezierCurve curve = BezierCurve::make({points.begin(), points.end()}).value();
  for (const double t : {0.0, 0.2, 0.7, 1.0}) CHECK((spline(t) - curve(t)).norm() < 1e-14);
  const PointTriangle one = CurveFigure(shape).construction, other = curve.de_casteljau(0.4);
  REQUIRE(one.size() == other.size());
  for (std::size_t row = 0; row < one.size(); ++row)
    for (std::size_t k = 0; k < one[row].size(); ++k) CHECK((one[row][k] - other[row][k]).norm() < 1e-14);
}

}  // namespace knotwork::scene::curve_figure_test
