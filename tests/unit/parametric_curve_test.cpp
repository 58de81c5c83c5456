#include "knotwork/curve/parametric_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/closest_point.h"
#include "knotwork/curve/curve_catalogue.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::parametric_curve_test {
using namespace test;

TEST_CASE("views are the curves they look at") {
  std::mt19937 random(91);
  const BSplineCurve spline = random_spline(3, 8, Topology::closed, random);
  const BezierCurve bezier = BezierCurve::make({{0, 1, 2}, {3, 4, 5}, {6, 0, 0}}, 2, 5).value();
  const CurveView views[] = {curve_view(spline), curve_view(bezier)};
  CHECK(views[0].closed());
  CHECK_FALSE(views[1].closed());
  CHECK(views[0].start == spline.knots().start());
  CHECK(views[0].end == spline.knots().end());
  CHECK(views[1].start == 2);
  CHECK(views[1].end == 5);
  for (const double t : {2.0, 3.3, 4.9}) {
    CHECK(views[0](t) == spline(t));
    CHECK(views[1](t) == bezier(t));
    std::array<Eigen::Vector3d, 4> seen, own;
    views[0].evaluate(t, seen);
    spline.evaluate(t, own);
    CHECK(seen == own);
  }
}

TEST_CASE("catalogue, model and blending curves have views, so that every measure works on them") {
  const double pi = std::numbers::pi;
  const CatalogueCurve circle = make_catalogue_curve("circle", std::array{1.5}).value();
  const CurveView view = curve_view(circle);
  CHECK(view.closed());
  CHECK(close(arc_length(view), 3 * pi, 1e-12));
  CHECK(close(closest_point(view, {0, 4, 3}).value().point, {0, 1.5, 0}, 1e-12));

  const ModelCurve model(0, 2 * pi, Topology::closed, 3, [](double t, std::span<Eigen::Vector3d> out) {
    evaluate(make_catalogue_curve("circle", std::array{1.5}).value(), t, out);
  });
  CHECK(close(arc_length(curve_view(model)), 3 * pi, 1e-12));
  CHECK(curve_view(model).closed());

  // Unmoved, it is the circle; a local pulled out makes it longer, and nearer to a point there.
  const KnotVector knots = KnotVector::uniform(1, 5, Topology::closed, 0, 2 * pi).value();
  const BlendingFunction b = BlendingFunction::make(BlendingKind::polynomial3).value();
  BlendingCurve curve = BlendingCurve::make(model, knots, b, {}, BlendingCurve::unmoved_locals(model, knots)).value();
  CHECK(close(arc_length(curve_view(curve)), 3 * pi, 1e-12));
  CHECK(curve_view(curve).breaks.size() == knots.knots().size());
  curve.set_local(0, Eigen::Translation3d(1, 0, 0) * curve.local(0));
  CHECK(arc_length(curve_view(curve)) > 3 * pi + 0.5);
  const ClosestPoint nearest = closest_point(curve_view(curve), {4, 0, 0}).value();
  CHECK(close(nearest.point, {2.5, 0, 0}, 1e-12));

  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CAPTURE(row.id);
    const CatalogueCurve any = make_catalogue_curve(row.id).value();
    const CurveView seen = curve_view(any);
    CHECK(seen.closed() == (row.topology == Topology::closed));
    CHECK(arc_length(seen) > 0);
    // A point of the curve is nearest to itself.
    const double t = seen.start + 0.37 * (seen.end - seen.start);
    CHECK(closest_point(seen, seen(t)).value().distance < 1e-9);
  }
}

TEST_CASE("pieces end at the breaks within, each once") {
  const std::vector<double> knots{-1, 0, 0, 0, 1, 2, 2, 4, 4, 9};
  CHECK(piece_ends(0, 4, knots) == std::vector<double>{0, 1, 2, 4});
  CHECK(piece_ends(0.5, 1.5, knots) == std::vector<double>{0.5, 1, 1.5});
  CHECK(piece_ends(5, 6, knots) == std::vector<double>{5, 6});
  CHECK(piece_ends(5, 6, {}) == std::vector<double>{5, 6});
}

TEST_CASE("just before a corner the derivatives are those of the piece that ends there") {
  for (const double corner : {0.0, 1.0, 1e10}) {
    const BSplineCurve path =
        BSplineCurve::make(
            KnotVector::make(1, Topology::open, {corner - 2, corner - 2, corner, corner + 1, corner + 1}).value(),
            {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}})
            .value();
    std::array<Eigen::Vector3d, 2> before, at;
    path.evaluate(just_before(corner), before);
    path.evaluate(corner, at);
    CHECK(before[1] == Eigen::Vector3d(2, 0, 0));
    CHECK(at[1] == Eigen::Vector3d(0, 1, 0));
    CHECK(close(before[0], at[0], 1e-5));
  }
}

TEST_CASE("before any parameter lies a number whose inverse is finite") {
  for (const double t : {0.0, -0.0, 1.0, -1.0, 1e-300, -1e-300, std::numeric_limits<double>::min(), 1e10}) {
    const double before = just_before(t);
    CHECK(before < t);
    CHECK(t - before <=
          std::max(std::numeric_limits<double>::epsilon() * std::abs(t), std::numeric_limits<double>::min()));
    if (before != 0) CHECK(std::isfinite(1 / before));
  }
}

}  // namespace knotwork::parametric_curve_test
