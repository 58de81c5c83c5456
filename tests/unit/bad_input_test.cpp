// What readers do wrong, once for every kind of object: each file's own tests name all paths, this one holds the
// messages to their form. An error is one sentence for a person, with the place.

#include <cctype>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/bspline_refinement.h"
#include "knotwork/curve/closest_point.h"
#include "knotwork/curve/curve_catalogue.h"
#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/parameterization.h"
#include "knotwork/surface/bezier_surface.h"
#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/surface_catalogue.h"
#include "unit/model_curves.h"
#include "unit/oracle.h"

namespace knotwork::bad_input_test {
using namespace test;
namespace {

using Points = std::vector<Eigen::Vector3d>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Points line(int count) {
  Points points;
  for (int k = 0; k < count; ++k) points.emplace_back(k, 0, 0);
  return points;
}
Points broken(int count, double coordinate) {
  Points points = line(count);
  points[2].y() = coordinate;
  return points;
}
KnotVector uniform(int degree, int count, Topology topology = Topology::open) {
  return KnotVector::uniform(degree, count, topology, 0, 1).value();
}

bool is_sentence(const std::string& message) {
  return message.size() >= 20 && message.size() <= 200 && message.back() == '.' &&
         std::isupper(static_cast<unsigned char>(message.front())) != 0;
}

/// Refused, for the reason at this path.
template <class T>
void refused(const Result<T>& result, const std::string& path) {
  CAPTURE(path);
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().path == path);
  CAPTURE(result.error().message);
  CHECK(is_sentence(result.error().message));
}

}  // namespace

TEST_CASE("bad input: too few points, and degrees too high") {
  refused(BezierCurve::make({}), "points");
  refused(BezierCurve::make(line(max_bezier_degree + 2)), "points");
  refused(KnotVector::uniform(3, 3, Topology::open, 0, 1), "count");
  refused(KnotVector::uniform(3, 2, Topology::closed, 0, 1), "count");
  refused(KnotVector::uniform(17, 40, Topology::open, 0, 1), "degree");
  refused(BSplineCurve::make(uniform(3, 6), line(5)), "points");
  refused(elevated(BSplineCurve::make(uniform(16, 17), line(17)).value()), "degree");
  refused(BezierSurface::make(17, 2, line(54)), "degree_u");
  refused(BezierSurface::make(2, 2, line(8)), "points");
  refused(BSplineSurface::make(uniform(2, 3), uniform(2, 4), line(11)), "points");
  refused(fit_least_squares(uniform(3, 6), line(5), std::vector<double>{0, 0.2, 0.4, 0.7, 1}), "points");
  refused(subdivide({.degree = 10}, line(12), 1), "degree");
  refused(subdivide({.degree = 4, .topology = Topology::open}, line(4), 1), "points");
  refused(parameterize(line(1), 1, Topology::open, 0, 1), "points");
  refused(averaged_knots(3, 6, Topology::open, std::vector<double>{0, 0.5, 1}), "parameters");
}

TEST_CASE("bad input: knots that decrease, stand too often in one place, or are no numbers") {
  refused(KnotVector::make(1, Topology::open, {0, 0, 2, 1, 3, 3}), "knots[3]");
  refused(KnotVector::make(2, Topology::open, {0, 0, 0, 1, 1, 1, 2, 2, 2}), "knots[5]");
  refused(KnotVector::make(1, Topology::closed, {-1, 0, 1, 1, 2, 3}), "knots[3]");
  for (const double bad : {nan, infinity, -infinity}) {
    refused(KnotVector::make(1, Topology::open, {0, 0, bad, 1, 1}), "knots[2]");
    refused(KnotVector::uniform(1, 4, Topology::open, bad, 1), "start");
  }
  const BSplineCurve curve = BSplineCurve::make(uniform(2, 5), line(5)).value();
  for (const double bad : {nan, infinity, -0.5, 1.5}) {
    refused(curve.with_knot(bad), "t");
    refused(without_knot(curve, bad), "t");
  }
}

TEST_CASE("bad input: points that are no numbers") {
  for (const double bad : {nan, infinity, -infinity}) {
    const Points points = broken(6, bad);
    refused(BezierCurve::make(points), "points[2]");
    refused(BSplineCurve::make(uniform(3, 6), points), "points[2]");
    refused(BezierSurface::make(1, 2, points), "points[2]");
    refused(BSplineSurface::make(uniform(1, 2), uniform(2, 3), points), "points[2]");
    refused(fit_least_squares(uniform(3, 5), points, std::vector<double>{0, 0.1, 0.3, 0.6, 0.8, 1}), "points[2]");
    refused(subdivide({}, points, 1), "points[2]");
    refused(limit_curve({}, points), "points[2]");
    refused(parameterize(points, 1, Topology::open, 0, 1), "points[2]");
    const BSplineCurve curve = BSplineCurve::make(uniform(2, 5), line(5)).value();
    refused(closest_point(curve_view(curve), Eigen::Vector3d(0, bad, 0)), "point");

    const ModelCurve model = report_curve();
    const KnotVector knots = KnotVector::uniform(1, 4, Topology::closed, model.start(), model.end()).value();
    std::vector<Eigen::Affine3d> locals = BlendingCurve::unmoved_locals(model, knots);
    locals[1].translation().x() = bad;
    const BlendingFunction b = BlendingFunction::make(BlendingKind::polynomial2).value();
    refused(BlendingCurve::make(model, knots, b, {}, locals), "locals[1]");
    const ModelSurface flat = Sheet{.bend_u = 0, .bend_v = 0};
    const KnotVector ends = KnotVector::uniform(1, 2, Topology::open, domain(flat).u.start, domain(flat).u.end).value();
    std::vector<Eigen::Affine3d> patches = BlendingSurface::unmoved_locals(flat, ends, ends);
    patches[3].linear()(0, 0) = bad;
    refused(BlendingSurface::make(flat, ends, ends, b, patches), "locals[3]");
    refused(make_catalogue_curve("circle", std::vector<double>{bad}),
            std::string(find_catalogue_curve("circle")->measures[0].id));
    refused(make_catalogue_surface("sphere", std::vector<double>{bad}),
            std::string(find_catalogue_surface("sphere")->measures[0].id));
  }
}

TEST_CASE("bad input: data in one place, and a million of them") {
  const Points points(1000000, Eigen::Vector3d(1, 2, 3));
  refused(parameterize(points, 1, Topology::open, 0, 1), "points");
  const std::vector<double> parameters(points.size(), 0.5);
  refused(fit_least_squares(uniform(3, 8), points, parameters), "parameters");
  const Result<KnotVector> knots = averaged_knots(3, 8, Topology::open, parameters);
  REQUIRE_FALSE(knots.has_value());
  CHECK(knots.error().path.starts_with("knots["));
  CHECK(is_sentence(knots.error().message));
  refused(BezierCurve::make(points), "points");
  refused(subdivide({}, points, 3), "levels");
  refused(limit_curve({}, points), "points");
}

}  // namespace knotwork::bad_input_test
