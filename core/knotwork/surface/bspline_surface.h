#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/result.h"
#include "knotwork/surface/surface_frame.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// A tensor-product B-spline surface of degrees p and q over a net of n_u x n_v control points in model units:
/// S(u,v) = sum_ij b_{i,p}(u) b_{j,q}(v) c_ij. Open or closed in each direction as its knot vector is; in a closed
/// direction the points go round. (u,v) is brought into the domain: closed directions wrap, open ones clamp. At a knot,
/// partials are those of the interval on its right; at the end of an open direction, of the interval on its left.
/// Valid once constructed. Source: THEORY 2.11.
class BSplineSurface {
 public:
  /// `points[i * n_v + j]` is c_ij. Error path: `points` (wrong number) or `points[k]` (not finite).
  static Result<BSplineSurface> make(KnotVector knots_u, KnotVector knots_v, std::vector<Eigen::Vector3d> points);

  const KnotVector& knots_u() const { return knots_u_; }
  const KnotVector& knots_v() const { return knots_v_; }
  /// The net, row by row.
  std::span<const Eigen::Vector3d> points() const { return points_; }
  /// c_ij; in a closed direction for any index >= 0.
  const Eigen::Vector3d& point(int i, int j) const;

  SurfaceJet evaluate(double u, double v) const;
  /// u and v must not be NaN. Error below 1e-13 of the largest partial that points of this size can have on these
  /// knots.
  void evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const;
  /// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). The basis is evaluated once a row and column, and
  /// columns of the net are summed once a row as long as v is sorted. Allocates nothing.
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out) const;
  /// The points alone, and points with first partials and unit normals (unit_normal() of the whole jet where the
  /// partials are parallel): the fast path for large grids. The net is summed over u once a row, and a point is then a
  /// sum of q+1 columns, the same for all points of a knot interval; so sorted v are the fastest. Agrees with
  /// evaluate() within its stated error. Scratch memory: one row of the net and the basis at v.
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<Eigen::Vector3d> out) const;
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceFrame> out) const;
  /// out[a (order_v+1) + b] = the partial of order a by u and b by v, a <= order_u, b <= order_v; 0 above the degrees.
  void evaluate(double u, double v, int order_u, int order_v, std::span<Eigen::Vector3d> out) const;

  /// The isoparametric curve u -> S(u, v): point i is sum_j b_{j,q}(v) c_ij.
  BSplineCurve curve_u(double v) const;
  /// The isoparametric curve v -> S(u, v).
  BSplineCurve curve_v(double u) const;

  /// The same surface with one more knot and one more row (u) or column (v) of points. Error path: `u` or `v`, as for
  /// BSplineCurve::with_knot.
  Result<BSplineSurface> with_knot_u(double u) const;
  Result<BSplineSurface> with_knot_v(double v) const;

 private:
  BSplineSurface(KnotVector knots_u, KnotVector knots_v, std::vector<Eigen::Vector3d> points);

  KnotVector knots_u_, knots_v_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace knotwork
