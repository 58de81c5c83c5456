#pragma once

#include <vector>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/scene/curve_sample.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// The curve of a shape as a B-spline, which a Bezier curve is too: without inner knots, over [0,1]. Of data it is the
/// fitted curve, of a subdivision the limit.
/// Precondition: the shape is a valid curve.
BSplineCurve spline_of(const Shape& shape);

/// What stands on the stage of a curve: everything that is drawn of it, held or read off.
struct CurveFigure {
  explicit CurveFigure(const Shape& shape);
  /// With its construction at a share of the domain.
  CurveFigure(BSplineCurve drawn, double share);

  /// A knot of the domain with the curve's point there; indices are of its first and last knot t_i.
  struct Mark {
    double t;
    Eigen::Vector3d point;
    int first, last;
    bool inner;  ///< between the ends, or anywhere on a closed curve
  };

  BSplineCurve curve;
  double t;                    ///< of the construction
  PointTriangle construction;  ///< its last row is the curve's point at t
  std::vector<CurveSample> samples;
  /// The basis functions at work at samples[k]: b_{firsts[k]+j}(t), j = 0..p, in weights[k (p+1) + j].
  std::vector<int> firsts;
  std::vector<double> weights;
  std::vector<Mark> marks;

  /// Whether control point i has a say at samples[k], and how much.
  double weight(std::size_t k, int i) const;
};

}  // namespace knotwork::scene
