#include "knotwork/curve/parametric_curve.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/bspline_curve.h"

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

std::vector<double> piece_ends(double from, double to, std::span<const double> breaks) {
  assert(from < to);
  std::vector<double> ends{from};
  for (const double t : breaks) {
    if (t > ends.back() && t < to) ends.push_back(t);
  }
  ends.push_back(to);
  return ends;
}

double just_before(double end) { return std::nextafter(end, -std::numeric_limits<double>::infinity()); }

}  // namespace knotwork
