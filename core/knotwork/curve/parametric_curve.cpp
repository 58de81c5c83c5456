#include "knotwork/curve/parametric_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/blending_curve.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/curve/curve_catalogue.h"

namespace knotwork {

Eigen::Vector3d CurveView::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate(t, {&point, 1});
  return point;
}

CurveView curve_view(const BezierCurve& curve) {
  return curve_view<BezierCurve>(curve, curve.start(), curve.end(), Topology::open, {}, curve.degree());
}

CurveView curve_view(const BSplineCurve& curve) {
  const KnotVector& knots = curve.knots();
  return curve_view<BSplineCurve>(curve, knots.start(), knots.end(), knots.topology(), knots.knots(), curve.degree());
}

CurveView curve_view(const BlendingCurve& curve) {
  constexpr int detail = 16;
  const KnotVector& knots = curve.knots();
  return curve_view<BlendingCurve>(curve, knots.start(), knots.end(), knots.topology(), knots.knots(), detail);
}

CurveView curve_view(const CatalogueCurve& curve) {
  // 64 oscillations a turn of 2 pi: the chrysanthemum has 56, and no measure that counts them goes beyond 24.
  constexpr double a_turn = 8 * 64, least = 64;
  const auto function = [](const void* self, double t, std::span<Eigen::Vector3d> out) {
    evaluate(*static_cast<const CatalogueCurve*>(self), t, out);
  };
  const Interval where = domain(curve);
  const double turns = std::min((where.end - where.start) / (2 * std::numbers::pi), 64.0);
  const Topology topology = curve_catalogue()[static_cast<std::size_t>(curve.row)].topology;
  return {&curve, function, where.start, where.end, topology, {}, static_cast<int>(std::max(least, a_turn * turns))};
}

CurveView curve_view(const ModelCurve& curve) {
  assert(curve.max_order() >= 3);
  return curve_view<ModelCurve>(curve, curve.start(), curve.end(), curve.topology());
}

std::vector<double> piece_ends(double from, double to, std::span<const double> breaks) {
  assert(from < to);
  std::vector<double> ends{from};
  for (const double t : breaks) {
    if (t > ends.back() && t < to) ends.push_back(t);
  }
  ends.push_back(to);
  return ends;
}

double just_before(double end) {
  const double before = std::nextafter(end, -std::numeric_limits<double>::infinity());
  constexpr double least = std::numeric_limits<double>::min();
  return before < 0 && before > -least ? -least : before;
}

}  // namespace knotwork
