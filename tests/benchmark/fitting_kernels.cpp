#include <memory>
#include <optional>

#include "benchmark/kernel.h"
#include "knotwork/curve/bspline_refinement.h"
#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/curve/least_squares.h"

namespace knotwork::benchmark {
namespace {

/// 10^5 data on a spline of 1000 control points: the fit must bring it back.
void add_least_squares(std::vector<Kernel>& rows, Topology topology) {
  constexpr std::size_t data_count = 100000;
  const KnotVector knots = KnotVector::uniform(3, 1000, topology, 0, 1).value();
  const BSplineCurve truth = BSplineCurve::make(knots, wavy_points(1000)).value();
  const std::vector<double> x = parameters(0, 1, data_count);
  std::vector<Eigen::Vector3d> data(data_count);
  truth.evaluate(x, 0, data);
  const auto fit = std::make_shared<std::optional<Result<LeastSquaresFit>>>();
  const auto error = [=] {
    return fit->has_value() && **fit ? difference((*fit)->value().curve.points(), truth.points()) : HUGE_VAL;
  };
  rows.push_back({topology == Topology::open ? "least squares, 10^5 points to 1000, open"
                                             : "least squares, 10^5 points to 1000, closed",
                  data_count, [=] { *fit = fit_least_squares(knots, data, x); }, error});
}

/// Closed, degree 3: 16 levels of 7 points.
void add_lane_riesenfeld(std::vector<Kernel>& rows) {
  constexpr int levels = 16;
  const LaneRiesenfeld scheme;
  const std::vector<Eigen::Vector3d> polygon = wavy_points(7);
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>();
  const auto error = [=] { return difference(*out, subdivided_by_passes(scheme, polygon, levels)); };
  rows.push_back({"lane-riesenfeld, closed degree 3, 16 levels", subdivided_count(scheme, polygon.size(), levels),
                  [=] { *out = subdivide(scheme, polygon, levels).value(); }, error, 0});
}

void add_refinement(std::vector<Kernel>& rows) {
  const KnotVector knots = KnotVector::uniform(3, 1000, Topology::open, 0, 1).value();
  const BSplineCurve curve = BSplineCurve::make(knots, wavy_points(1000)).value();
  const std::vector<double> t = parameters(0, 1, 500);
  const auto changed = std::make_shared<std::optional<BSplineCurve>>();
  const auto error = [=] {
    std::vector<Eigen::Vector3d> actual(t.size()), expected(t.size());
    (*changed)->evaluate(t, 0, actual);
    curve.evaluate(t, 0, expected);
    return difference(actual, expected);
  };
  rows.push_back({"knot insertion, 1000 points", 1, [=] { *changed = curve.with_knot(0.4321).value(); }, error});
  rows.push_back({"degree elevation, 1000 points", 1, [=] { *changed = elevated(curve).value(); }, error});
}

}  // namespace

std::vector<Kernel> fitting_kernels() {
  std::vector<Kernel> rows;
  add_least_squares(rows, Topology::open);
  add_least_squares(rows, Topology::closed);
  add_lane_riesenfeld(rows);
  add_refinement(rows);
  return rows;
}

}  // namespace knotwork::benchmark
