#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/point_triangle.h"
#include "knotwork/result.h"

namespace knotwork {

/// A B-spline curve of degree p with n control points in model units: c(t) = sum_i c_i b_{i,p}(t). Open or closed as
/// its knot vector is; closed, the points go round: c_{i+n} = c_i. A parameter outside is brought into the domain, by
/// clamping (open) or by the period (closed). At a knot, derivatives are those of the interval on its right; at the end
/// of an open curve, of the interval on its left. Valid once constructed. Source: THEORY 2.1, 2.2.
class BSplineCurve {
 public:
  /// As many finite points as knots.count(). Error path: `points` or `points[i]`.
  static Result<BSplineCurve> make(KnotVector knots, std::vector<Eigen::Vector3d> points);

  const KnotVector& knots() const { return knots_; }
  int degree() const { return knots_.degree(); }
  /// c_0 .. c_{n-1}.
  std::span<const Eigen::Vector3d> points() const { return points_; }
  /// c_i; closed, for any i >= 0.
  const Eigen::Vector3d& point(int i) const { return points_[static_cast<std::size_t>(i % knots_.count())]; }

  Eigen::Vector3d operator()(double t) const;
  /// out[k] = the k-th derivative with respect to t, k = 0 .. out.size()-1; 0 above the degree. t must not be NaN.
  /// Error below 1e-13 of the largest |D^k c| that points of this size can have on these knots.
  void evaluate(double t, std::span<Eigen::Vector3d> out) const;
  /// The same for many parameters: out[m (order+1) + k] at t[m]. Sorted parameters find their span in O(1). Allocates
  /// nothing up to order 3.
  void evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const;

  /// The matrix-factor form of THEORY 2.1, T_1 T_2 .. T_p (c_{i-p}, .., c_i), multiplied out from the right: row k+1 of
  /// the triangle is T_{p-k} times row k. This is de Boor's construction at t.
  PointTriangle de_boor(double t) const;

  /// The blossom (polar form) f(a_1, .., a_p) of the polynomial on a span: symmetric, affine in each argument, and
  /// f(t, .., t) = c(t) there. Control points are blossoms, c_i = f(t_{i+1}, .., t_{i+p}), so that every change of the
  /// knots asks for f only: O(p^2), and by convex combinations alone where the arguments hold all knots between them.
  /// Of fewer arguments, p-r, it is the blossom of the r-th derivative. `arguments` do not decrease. `span`: one that is
  /// not empty, p to knots().last_span(). Source: Ramshaw, Blossoms are polar forms, CAGD 6, 1989.
  Eigen::Vector3d blossom(int span, std::span<const double> arguments) const;

  /// The Greville abscissae (t_{i+1} + .. + t_{i+p}) / p, i = 0..n-1: where control point i has its greatest say.
  std::vector<double> greville_abscissae() const;

  /// The same curve with one more knot and one more point (Boehm). t in the domain; at a knot its multiplicity grows.
  /// Error path: `t`, when it is not in the domain or its knot already has the multiplicity p (p+1 at an open end).
  Result<BSplineCurve> with_knot(double t) const;

  /// The polynomial pieces, one for each knot interval that is not empty, each over its interval (Bezier extraction):
  /// the points of the piece over [a, b] are f(a, .., a, b, .., b). Neighbours share their common point.
  std::vector<BezierCurve> bezier_pieces() const;

 private:
  BSplineCurve(KnotVector knots, std::vector<Eigen::Vector3d> points);
  void evaluate_on(int span, double t, std::span<Eigen::Vector3d> out) const;

  KnotVector knots_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace knotwork
