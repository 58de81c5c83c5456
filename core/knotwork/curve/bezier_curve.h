#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/bernstein.h"
#include "knotwork/curve/point_triangle.h"
#include "knotwork/result.h"

namespace knotwork {

/// A Bezier curve of degree p over [start, end]: c(t) = sum_k c_k b_{p,k}(w), w = (t-start)/(end-start), with p+1 points
/// in model units. Parameters outside the domain are clamped to it; derivatives are with respect to t.
/// Valid once constructed. Source: THEORY 2.3.
class BezierCurve {
 public:
  /// 1 to max_bezier_degree + 1 finite points. Error path: `points`, `points[i]`, `start` or `end`.
  static Result<BezierCurve> make(std::vector<Eigen::Vector3d> points, double start = 0, double end = 1);

  int degree() const { return static_cast<int>(points_.size()) - 1; }
  std::span<const Eigen::Vector3d> points() const { return points_; }
  double start() const { return start_; }
  double end() const { return end_; }

  Eigen::Vector3d operator()(double t) const;
  /// out[k] = the k-th derivative, k = 0 .. out.size()-1; 0 above the degree. t must not be NaN.
  /// Error below 1e-13 of the largest |D^k c| that points of this size can have.
  void evaluate(double t, std::span<Eigen::Vector3d> out) const;
  /// The same for many parameters: out[m (order+1) + k] at t[m]. Allocates nothing.
  void evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const;

  /// De Casteljau's construction at t: row k+1 divides the legs of row k in the ratio w : 1-w.
  PointTriangle de_casteljau(double t) const;

  /// The same curve with one more point: q_j = j/(p+1) c_{j-1} + (1 - j/(p+1)) c_j. Precondition: p below
  /// max_bezier_degree.
  BezierCurve elevated() const;
  /// The curve before and the curve after t, each over its part of the domain. Precondition: start < t < end.
  std::pair<BezierCurve, BezierCurve> split(double t) const;

 private:
  BezierCurve(std::vector<Eigen::Vector3d> points, double start, double end);
  double share_at(double t) const;

  std::vector<Eigen::Vector3d> points_;
  double start_, end_;
};

}  // namespace knotwork
