#include "knotwork/scene/curve_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene {

namespace {

constexpr int most_samples = 4096, fine_steps = 48, coarse_steps = 4;  // steps are in a knot interval

double parameter_of(const Shape& shape) {
  if (const auto* bezier = std::get_if<BezierCurveObject>(&shape)) return bezier->parameter;
  const auto* curve = std::get_if<BSplineCurveObject>(&shape);
  return curve != nullptr ? curve->parameter : 0;
}

std::vector<CurveFigure::Mark> marks_of(const BSplineCurve& curve) {
  const KnotVector& knots = curve.knots();
  std::vector<CurveFigure::Mark> marks;
  const int last = knots.closed() ? knots.last_span() : static_cast<int>(knots.knots().size()) - 1;
  for (int i = knots.closed() ? knots.degree() : 0; i <= last; ++i) {
    const double t = knots[i];
    if (!marks.empty() && marks.back().t == t) {
      marks.back().last = i;
    } else {
      const bool inner = knots.closed() || (t > knots.start() && t < knots.end());
      marks.push_back({t, curve(t), i, i, inner});
    }
  }
  return marks;
}

}  // namespace

BSplineCurve spline_of(const Shape& shape) {
  if (const auto* curve = std::get_if<BSplineCurveObject>(&shape)) return build_curve(*curve).value();
  if (const auto* fitted = std::get_if<FittedCurveObject>(&shape)) return build_fit(*fitted).value().fit.curve;
  if (const auto* polygon = std::get_if<SubdivisionCurveObject>(&shape))
    return limit_curve(scheme_of(*polygon), polygon->points).value();
  const std::vector<Eigen::Vector3d>& points = std::get_if<BezierCurveObject>(&shape)->points;
  const int count = static_cast<int>(points.size());
  return BSplineCurve::make(KnotVector::uniform(count - 1, count, Topology::open, 0, 1).value(), points).value();
}

CurveFigure::CurveFigure(const Shape& shape) : CurveFigure(spline_of(shape), parameter_of(shape)) {}

CurveFigure::CurveFigure(BSplineCurve drawn, double share)
    : curve(std::move(drawn)),
      t(std::lerp(curve.knots().start(), curve.knots().end(), share)),
      construction(curve.de_boor(t)),
      marks(marks_of(curve)) {
  const KnotVector& knots = curve.knots();
  const int p = curve.degree();
  const int steps = std::clamp(most_samples / knots.interval_count(), coarse_steps, fine_steps);
  std::vector<double> basis(static_cast<std::size_t>(p) + 1);
  for (int span = p; span <= knots.last_span(); ++span) {
    if (!(knots[span] < knots[span + 1])) continue;
    // A span ends where the next one begins, with weights of its own: at a corner both are wanted.
    for (int k = 0; k <= steps; ++k) {
      const double at = std::lerp(knots[span], knots[span + 1], static_cast<double>(k) / steps);
      bspline_basis(knots, span, at, 0, basis);
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int j = 0; j <= p; ++j) point += basis[static_cast<std::size_t>(j)] * curve.point(span - p + j);
      samples.push_back({at, point});
      firsts.push_back(span - p);
      weights.insert(weights.end(), basis.begin(), basis.end());
    }
  }
}

double CurveFigure::weight(std::size_t k, int i) const {
  const int n = curve.knots().count(), width = curve.degree() + 1;
  double sum = 0;
  // A closed curve of few points meets a point more than once.
  for (int j = 0; j < width; ++j)
    if ((firsts[k] + j) % n == i) sum += weights[k * static_cast<std::size_t>(width) + static_cast<std::size_t>(j)];
  return sum;
}

}  // namespace knotwork::scene
