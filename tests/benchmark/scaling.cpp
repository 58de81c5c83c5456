// knotwork_scaling: the cost an item over four decades of input. Sorted parameters and data cost the same whatever the
// number of control points, but for the caches; shuffled ones may grow with its logarithm. The names tell what a curve's
// evaluator takes in memory, as glibc's allocator counts it: built only where that is found.

#include <malloc.h>

#include <memory>
#include <string>
#include <utility>

#include "benchmark/kernel.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/spline_pieces.h"

namespace knotwork::benchmark {
namespace {

constexpr std::size_t parameter_count = 200000;

BSplineCurve curve_of(int points) {
  return BSplineCurve::make(KnotVector::uniform(3, points, Topology::open, 0, 1).value(),
                            wavy_points(static_cast<std::size_t>(points)))
      .value();
}

std::size_t allocated() {
  const struct mallinfo2 now = mallinfo2();
  return now.uordblks + now.hblkhd;
}

void add_curve(std::vector<Kernel>& rows, int points) {
  const auto curve = std::make_shared<const BSplineCurve>(curve_of(points));
  const std::size_t before = allocated();
  const auto pieces = std::make_shared<const SplinePieces>(*curve);
  const std::size_t bytes = (allocated() - before) / static_cast<std::size_t>(points);
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(parameter_count);
  for (const bool in_order : {true, false}) {
    const std::vector<double> sorted = parameters(0, 1, parameter_count);
    const auto t = std::make_shared<const std::vector<double>>(in_order ? sorted : shuffled(sorted));
    const std::string name = std::string(in_order ? "sorted" : "shuffled") + " parameters, curve of " +
                             std::to_string(points) + " points (" + std::to_string(bytes) + " bytes each)";
    const auto error = [=] {
      std::vector<Eigen::Vector3d> expected(parameter_count);
      curve->evaluate(*t, 0, expected);
      return difference(*out, expected);
    };
    rows.push_back({name, parameter_count, [=] { pieces->evaluate(*t, 0, *out); }, error});
  }
}

/// Ten data a control point.
void add_fit(std::vector<Kernel>& rows, int points) {
  const std::size_t data_count = 10 * static_cast<std::size_t>(points);
  const BSplineCurve truth = curve_of(points);
  const auto x = std::make_shared<const std::vector<double>>(parameters(0, 1, data_count));
  const auto data = std::make_shared<std::vector<Eigen::Vector3d>>(data_count);
  truth.evaluate(*x, 0, *data);
  const auto fitted = std::make_shared<std::vector<Eigen::Vector3d>>();
  const KnotVector knots = truth.knots();
  const auto run = [=] {
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, *data, *x);
    fitted->assign(fit.value().curve.points().begin(), fit.value().curve.points().end());
  };
  const std::vector<Eigen::Vector3d> expected(truth.points().begin(), truth.points().end());
  rows.push_back({"least squares, " + std::to_string(points) + " points, a datum", data_count, run,
                  [=] { return difference(*fitted, expected); }, 1e-11});
}

void add_subdivision(std::vector<Kernel>& rows, int levels) {
  const LaneRiesenfeld scheme;
  const std::vector<Eigen::Vector3d> polygon = wavy_points(7);
  const std::size_t count = subdivided_count(scheme, polygon.size(), levels);
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(count);
  const auto error = [=] { return difference(*out, subdivided_by_passes(scheme, polygon, levels)); };
  rows.push_back({"subdivision to " + std::to_string(count) + " points", count,
                  [=] { subdivide(scheme, polygon, levels, *out); }, error});
}

}  // namespace

std::vector<Kernel> all_kernels() {
  std::vector<Kernel> rows;
  for (const int points : {10, 100, 1000, 10000, 100000}) add_curve(rows, points);
  for (const int points : {10, 100, 1000, 10000, 100000}) add_fit(rows, points);
  for (const int levels : {3, 6, 10, 13, 16}) add_subdivision(rows, levels);
  return rows;
}

}  // namespace knotwork::benchmark
