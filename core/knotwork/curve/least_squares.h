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
/// least, for points p_j in model units at the parameters x_j, in any order. Open, x_j must lie in the domain; closed, it
/// is brought into it. parameterization.h has parameters for points, and knots for parameters.
///
/// d_i = 2 (a_i c_{i-1} + b_i c_{i+1} - c_i), a_i + b_i = 1, is twice the way from control point i to the straight line
/// through its neighbours, over the Greville abscissae; i = 1..n-2 open, all i closed. On equidistant knots that is the
/// second difference of P-splines (Eilers and Marx, Statistical Science 11, 1996). Straight lines cost nothing, so that a
/// large lambda leads to the regression line; closed, to the mean of the points.
///
/// Without smoothing, there must be as many points as free control points, at parameters that meet the conditions of
/// Schoenberg and Whitney (schoenberg_whitney.h). Closed, that is not always enough: n points, equidistant, on the knots
/// of a curve of even degree do not determine it when n is even. The pivots of the factorization show it. With smoothing,
/// two different parameters are enough; closed or with interpolated ends, one.
///
/// Banded Householder reflections, span by span (banded_triangle.h): O(m p^2) time, memory in proportion to m + n p.
/// Control points have an error of about cond(A) 1e-16, as from Eigen's dense QR.
/// Errors, with paths: `points` (too few, or not as many as parameters), `points[i]`, `parameters` (they leave control
/// points undetermined; the message names basis functions), `parameters[j]`, `weights` (not as many as points),
/// `weights[j]`, `smoothing`, `interpolate_ends`. Source: THEORY 2.4.
Result<LeastSquaresFit> fit_least_squares(const KnotVector& knots, std::span<const Eigen::Vector3d> points,
                                          std::span<const double> parameters, const LeastSquaresOptions& options = {});

}  // namespace knotwork
