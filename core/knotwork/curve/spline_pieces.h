#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/bspline_curve.h"

namespace knotwork {

/// A B-spline curve prepared for evaluation at very many parameters: the Bezier points of every piece and of its first
/// two derivatives, with the binomial factors already multiplied in. A point costs p steps of three operations, instead
/// of BSplineCurve's O(p^2) for its basis. The same curve at the same parameters: clamped or wrapped into the domain,
/// at a knot the piece on its right, at an open end the last one. Error below 1e-13 of the control polygon's size
/// (derivatives: of the largest |D^k c| that points of this size can have), at every degree: all terms are convex
/// combinations.
/// Takes 3p points of 32 bytes for each piece; built in O(p^3) for each. Source: THEORY 2.3; Farin, Curves and Surfaces
/// for CAGD (nested multiplication in Bernstein form).
class SplinePieces {
 public:
  static constexpr int max_order = 2;

  explicit SplinePieces(const BSplineCurve& curve);

  int degree() const { return knots_.degree(); }
  int piece_count() const { return static_cast<int>(breaks_.size()) - 1; }

  Eigen::Vector3d operator()(double t) const;
  /// out[m (order+1) + k] = the k-th derivative at t[m], 0 <= order <= max_order. The parameters come in any order;
  /// sorted ones are the fastest, several of a piece at a time. t[m] must not be NaN. Allocates nothing.
  void evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const;

 private:
  /// One Bezier point times its binomial factor; the fourth is 0.
  struct alignas(4 * sizeof(double)) Coefficient {
    double x, y, z, zero;
  };

  std::size_t piece_at(double t) const;
  std::size_t bucket_of(double t) const;
  const Coefficient* coefficients(std::size_t piece, std::size_t order) const {
    return coefficients_[order].data() + piece * (static_cast<std::size_t>(degree()) + 1 - order);
  }
  template <int fixed_degree, std::size_t values>
  void evaluate_all(std::span<const double> t, double* out) const;
  template <int fixed_degree, std::size_t values>
  void evaluate_together(std::size_t piece, const double* t, double* out) const;
  template <int fixed_degree, std::size_t values>
  void evaluate_alone(double t, double* out) const;

  KnotVector knots_;
  /// The distinct knots of the domain and 1 / (the distance to the next).
  std::vector<double> breaks_, inverse_widths_;
  /// coefficients_[k]: of D^k c, p+1-k for each piece.
  std::array<std::vector<Coefficient>, max_order + 1> coefficients_;
  /// The domain in equal buckets, and how many inner breaks lie in those before each: a search begins near its goal.
  std::vector<int> breaks_before_;
  double buckets_per_unit_ = 0;
};

}  // namespace knotwork
