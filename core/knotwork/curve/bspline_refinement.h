#pragma once

#include <vector>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// Other knots, another degree or another topology for the same curve. Where no loss is mentioned the curve stays the
/// same to 1e-13 of its control polygon's size: new points are convex combinations of old ones (blossoms). A knot
/// vector that would be too long is refused with the error path `count`. Source: THEORY 2.1, 2.2; Piegl & Tiller, The
/// NURBS Book, ch. 5 and 12.

/// A curve after the removal of a knot.
struct KnotRemoval {
  BSplineCurve curve;
  /// A bound on the distance between the old curve and the new one at the same parameter, in model units: they differ
  /// by this times one old b_{j,p}. A knot is removable (the curve is smoother there than its knots say) where it is
  /// 1e-13 of the polygon's size or so; a caller that needs exactness compares it with its own tolerance.
  double deviation;
};

/// The curve with one copy of the knot at t and one point fewer (Tiller 1992). p-1 new points have to meet the p
/// equations of Boehm's insertion; all but one are met, solved from both ends as far as that divides by 1/2 or more, so
/// that errors do not multiply. A closed curve that loses the only knot at its start begins at the next knot.
/// Error path: `t`, when there is no knot here inside the domain, or no point to spare (closed: max(2, p) are left).
Result<KnotRemoval> without_knot(const BSplineCurve& curve, double t);

/// The curve as one of degree p+1, every knot's multiplicity one higher: the new point j is the mean of the p+1
/// blossoms that leave out one of u_{j+1} .. u_{j+p+1}. Error path: `degree`, at KnotVector::max_degree.
Result<BSplineCurve> elevated(const BSplineCurve& curve);

/// How smooth a curve is at a knot: inside an open curve; everywhere on a closed one, the start included.
struct KnotContinuity {
  double t;
  int multiplicity;
  /// p - multiplicity: at least that by its knots.
  int smoothness;
  /// The highest k such that the derivatives 0..k agree from both sides; p when both sides are one polynomial.
  int measured;
};

/// Derivatives agree when their difference is below this times sum_j |D^k b_j| |c_j - c_i|, the terms that they are
/// made of, of the larger side: a bound that neither the units nor the place in space change.
inline constexpr double smoothness_tolerance = 1e-9;

/// Every distinct knot, in ascending order.
std::vector<KnotContinuity> continuity(const BSplineCurve& curve);

/// The curve as an open one with p+1 knots at either end, so that it begins in its first point and ends in its last.
/// Always exact. A closed curve is cut at its start.
Result<BSplineCurve> clamped(const BSplineCurve& curve);

/// The curve as an open one with end knots that are not repeated. A closed curve keeps its knots and goes round once,
/// c_0 .. c_{n-1}, c_0 .. c_{p-1}; to an open one the outermost interval is repeated p times at either end. Exact but
/// for rounding, which is that of the new points: these lie outside the curve, and the further the higher the degree.
Result<BSplineCurve> unclamped(const BSplineCurve& curve);

/// The curve as a closed one whose start is a knot of the given multiplicity m. Exact where the derivatives 0..p-m
/// agree at both ends to smoothness_tolerance, otherwise refused. A closed curve is returned as it is.
/// Error paths: `points`, with the first derivative that does not agree; `count`, when fewer than max(2, p) points
/// would be left (insert knots first); `seam_multiplicity`, outside 1..p.
Result<BSplineCurve> closed(const BSplineCurve& curve, int seam_multiplicity = 1);

}  // namespace knotwork
