#include "knotwork/curve/parametric_curve.h"

#include <array>
#include <vector>

#include "knotwork/curve/bezier_curve.h"
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

}  // namespace knotwork::parametric_curve_test
