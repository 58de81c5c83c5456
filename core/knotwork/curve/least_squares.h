#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// What a fit may be asked for beside the least squares.
struct LeastSquaresOptions {
  /// Bound on coordinates of data, weights and smoothing, so that no square overflows.
  static constexpr double largest_number = 1e50;

  /// The curve begins at points.front() and ends at points.back(), exactly. Open knots with p or p+1 equal ones at both
  /// ends only; these two points belong to the parameters start() and end().
  bool interpolate_ends = false;
  /// lambda >= 0, the weight of the penalty below. 0: none.
  double smoothing = 0;
  /// w_j >= 0, one for every point; a whole number counts as so many equal points. Empty: all 1.
  std::span<const double> weights = {};
};

struct LeastSquaresFit {
  BSplineCurve curve;
  double rms;                     ///< sqrt(sum_j w_j r_j^2 / sum_j w_j), model units
  double maximum;                 ///< max_j r_j, points of weight 0 counted
  std::vector<double> residuals;  ///< r_j = |c(x_j) - p_j|, in the order of the data
};

/// The spline curve c on the given knots that makes
///   sum_j w_j |c(x_j) - p_j|^2 + lambda sum_i |d_i|^2
/// least, for points p_j in model units at the parameters x_j (see parameterization.h), in any order. Open, x_j must lie in the
/// domain; closed, it is brought into it.
///
/// d_i = 2 (a_i c_{i-1} + b_i c_{i+1} - c_i), a_i + b_i = 1, twice the way from control point i to the straight line that
/// its neighbours c_{i-1} and c_{i+1} span over their Greville abscissae; i = 1..n-2 open, all i closed. On equidistant
/// knots this is the second difference of P-splines (Eilers and Marx, Statistical Science 11, 1996). Straight lines cost
/// nothing, so that a large lambda leads to the regression line (closed: to a point).
///
/// Without smoothing there must be as many points as free control points, at parameters that satisfy Schoenberg and Whitney
/// (schoenberg_whitney.h); closed, that is not always enough: as many points as control points, both even, equidistant
/// and on the knots of a curve of even degree determine nothing. With smoothing, two different parameters are enough
/// (closed: one point; ends interpolated: none).
///
/// Banded Householder reflections, span by span (banded_triangle.h): O(m p^2) time, memory in proportion to m + n p.
/// Control points have an error of about cond(A) 1e-16, as from Eigen's dense QR.
/// Errors, with paths: `points` (too few, or not as many as parameters), `points[i]`, `parameters` (in places that leave control points
/// undetermined), `parameters[j]`, `weights`, `weights[j]`, `smoothing`, `interpolate_ends`. Source: THEORY 2.4.
Result<LeastSquaresFit> fit_least_squares(const KnotVector& knots, std::span<const Eigen::Vector3d> points,
                                          std::span<const double> parameters, const LeastSquaresOptions& options = {});

}  // namespace knotwork
