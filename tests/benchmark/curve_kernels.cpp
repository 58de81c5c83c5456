#include <memory>

#include "benchmark/kernel.h"
#include "knotwork/basis/blending_function.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/curve/curve_catalogue.h"
#include "knotwork/curve/spline_pieces.h"
#include "unit/model_curves.h"

namespace knotwork::benchmark {
namespace {

constexpr std::size_t count = 1000;

/// A curve's evaluation one parameter at a time, and all at once, against a reference for one point.
template <class Curve, class Reference>
void add_single_and_batch(std::vector<Kernel>& rows, const std::string& name, const Curve& curve,
                          const std::vector<double>& t, int order, const Reference& reference) {
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(t.size() * values);
  // Points only: what the derivatives are is held to the points' in tests/property.
  const auto error = [=] {
    std::vector<Eigen::Vector3d> points, expected;
    for (std::size_t m = 0; m < t.size(); ++m) {
      points.push_back((*out)[m * values]);
      expected.push_back(reference(t[m]));
    }
    return difference(points, expected);
  };
  const auto single = [=] {
    for (std::size_t m = 0; m < t.size(); ++m) curve.evaluate(t[m], std::span(*out).subspan(m * values, values));
  };
  rows.push_back({name + ", single", t.size(), single, error});
  rows.push_back({name + ", batch", t.size(), [=] { curve.evaluate(t, order, *out); }, error});
}

void add_bspline(std::vector<Kernel>& rows, int degree, int points) {
  const KnotVector knots = KnotVector::uniform(degree, points, Topology::open, 0, 1).value();
  const BSplineCurve curve = BSplineCurve::make(knots, wavy_points(static_cast<std::size_t>(points))).value();
  const std::string name =
      "bspline curve, degree " + std::to_string(degree) + ", " + std::to_string(points) + " points";
  const auto reference = [=](double t) { return curve.de_boor(t).back().front(); };
  const std::vector<double> t = parameters(0, 1, count);
  add_single_and_batch(rows, name + ", point", curve, t, 0, reference);
  add_single_and_batch(rows, name + ", 3 derivatives", curve, t, 3, reference);

  const auto pieces = std::make_shared<const SplinePieces>(curve);
  for (const int order : {0, 2}) {
    const std::size_t values = static_cast<std::size_t>(order) + 1;
    for (const bool sorted : {true, false}) {
      const std::vector<double> at = sorted ? t : shuffled(t);
      const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(count * values);
      const auto error = [=] {
        std::vector<Eigen::Vector3d> expected(count * values);
        curve.evaluate(at, order, expected);
        return difference(*out, expected);
      };
      rows.push_back(
          {name + (order == 0 ? ", point" : ", 2 derivatives") + (sorted ? ", pieces" : ", pieces, any order"), count,
           [=] { pieces->evaluate(at, order, *out); }, error});
    }
  }
}

void add_blending_curve(std::vector<Kernel>& rows, BlendingKind kind) {
  const ModelCurve model = test::report_curve();
  const KnotVector knots = KnotVector::uniform(1, 10, Topology::closed, model.start(), model.end()).value();
  BlendingCurve curve = BlendingCurve::make(model, knots, BlendingFunction::make(kind).value(), {},
                                            BlendingCurve::unmoved_locals(model, knots))
                            .value();
  curve.set_local(3, Eigen::Translation3d(0, 0, 0.5) * curve.local(3));
  const auto reference = [=](double t) {
    Eigen::Vector3d point;
    curve.evaluate_two_curves(t, {&point, 1});
    return point;
  };
  add_single_and_batch(rows, "blending curve, " + std::string(blending_family(kind).id) + ", 3 derivatives", curve,
                       parameters(model.start(), model.end(), count), 3, reference);
}

void add_catalogue_curve(std::vector<Kernel>& rows, const char* id) {
  const CatalogueCurve curve = make_catalogue_curve(id).value();
  const Interval where = domain(curve);
  const std::vector<double> t = parameters(where.start, where.end, count);
  const auto out = std::make_shared<std::vector<Eigen::Vector3d>>(4 * count);
  // The batch against single points: the formula itself is held to oracle 09.
  const auto error = [=] {
    std::vector<Eigen::Vector3d> expected(4 * count);
    for (std::size_t m = 0; m < count; ++m) evaluate(curve, t[m], std::span(expected).subspan(4 * m, 4));
    return difference(*out, expected);
  };
  rows.push_back({"catalogue curve, " + std::string(id) + ", 3 derivatives, batch", count,
                  [=] { evaluate(curve, t, 3, *out); }, error});
}

void add_blending_function(std::vector<Kernel>& rows, BlendingKind kind) {
  const BlendingFunction b = BlendingFunction::make(kind, blending_family(kind).parameter_default).value();
  const std::vector<double> w = parameters(0, 1, count);
  const auto out = std::make_shared<std::vector<BlendingValue>>(count);
  // B against 1 - B on the other side: all families of the table are symmetric.
  const auto error = [=] {
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k) worst = std::max(worst, std::abs((*out)[k][0] + b(1 - w[k])[0] - 1));
    return worst;
  };
  rows.push_back(
      {"blending function, " + std::string(blending_family(kind).id), count, [=] { b.evaluate(w, *out); }, error});
}

}  // namespace

std::vector<Kernel> curve_kernels() {
  std::vector<Kernel> rows;
  for (const int degree : {3, 16}) {
    const BezierCurve curve = BezierCurve::make(wavy_points(static_cast<std::size_t>(degree) + 1)).value();
    add_single_and_batch(rows, "bezier curve, degree " + std::to_string(degree) + ", 2 derivatives", curve,
                         parameters(0, 1, count), 2, [=](double t) { return curve.de_casteljau(t).back().front(); });
  }
  add_bspline(rows, 3, 7);
  add_bspline(rows, 3, 1000);
  add_bspline(rows, 9, 1000);
  add_blending_curve(rows, BlendingKind::polynomial2);
  add_blending_curve(rows, BlendingKind::expo_rational);
  for (const char* id : {"circle", "torus-knot", "chrysanthemum"}) add_catalogue_curve(rows, id);
  for (const BlendingFamily& family : blending_families()) add_blending_function(rows, family.kind);
  return rows;
}

}  // namespace knotwork::benchmark
