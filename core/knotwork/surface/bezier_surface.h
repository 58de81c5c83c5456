#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/bernstein.h"
#include "knotwork/result.h"
#include "knotwork/surface/bspline_surface.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// A net of rows x columns points, row by row.
struct PointNet {
  int rows, columns;
  std::vector<Eigen::Vector3d> points;
};

/// A tensor-product Bezier surface of degrees p and q over [start.x, end.x] x [start.y, end.y]:
/// S(u,v) = sum_ij b_{p,i}(wu) b_{q,j}(wv) c_ij with wu = (u-start.x)/(end.x-start.x), wv likewise, over a net of
/// (p+1) x (q+1) points in model units. Parameters outside are clamped; partials are with respect to u and v.
/// Evaluated as the B-spline surface on p+1 and q+1 knots at each end, whose basis the Bernstein polynomials are.
/// Valid once constructed. Source: THEORY 2.3, 2.11.
class BezierSurface {
 public:
  /// `points[i * (q+1) + j]` is c_ij. Error path: `degree_u` or `degree_v` (outside 1..max_bezier_degree), `start` or
  /// `end` (not finite, beyond KnotVector::max_knot, or the end not behind the start), `points`, `points[k]`.
  static Result<BezierSurface> make(int degree_u, int degree_v, std::vector<Eigen::Vector3d> points,
                                    const Eigen::Vector2d& start = {0, 0}, const Eigen::Vector2d& end = {1, 1});

  int degree_u() const { return spline_.knots_u().degree(); }
  int degree_v() const { return spline_.knots_v().degree(); }
  Eigen::Vector2d start() const { return {spline_.knots_u().start(), spline_.knots_v().start()}; }
  Eigen::Vector2d end() const { return {spline_.knots_u().end(), spline_.knots_v().end()}; }
  std::span<const Eigen::Vector3d> points() const { return spline_.points(); }
  const Eigen::Vector3d& point(int i, int j) const { return spline_.point(i, j); }
  /// For all evaluation: one point, batches, grids, partials of any order, isoparametric curves.
  const BSplineSurface& spline() const { return spline_; }

  SurfaceJet evaluate(double u, double v) const { return spline_.evaluate(u, v); }

  /// De Casteljau's construction at (u,v), for drawing: the net, then a net for each round, the last of 1 x 1. A round
  /// replaces every cell by its bilinear point at (wu, wv); once one direction has no more than one row or column, the
  /// rounds go on in the other alone.
  std::vector<PointNet> de_casteljau(double u, double v) const;

  /// The same surface with one more row (u) or column (v). Precondition: that degree is below max_bezier_degree.
  BezierSurface elevated_u() const;
  BezierSurface elevated_v() const;
  /// The parts before and behind a parameter, each over its part of the domain. Precondition: start < parameter < end.
  std::pair<BezierSurface, BezierSurface> split_u(double u) const;
  std::pair<BezierSurface, BezierSurface> split_v(double v) const;

 private:
  explicit BezierSurface(BSplineSurface spline) : spline_(std::move(spline)) {}

  BSplineSurface spline_;
};

}  // namespace knotwork
