#pragma once

#include <vector>

#include "knotwork/curve/parametric_curve.h"

namespace knotwork {

/// The length of a curve from its start on, s(t) = integral of |c'| from start to t, and its inverse. Built once, for
/// many questions. The curve must outlive it.
///
/// Gauss-Legendre (16 points) on every smooth piece, halved until the halves add up to the whole within 1e-14 of the
/// length: relative accuracy 1e-13 of the whole length, at cusps too. Where speed vanishes at a cusp, the halving goes
/// on to that point. Rounding of the points limits what can be had: 1e-15 of the curve's distance from the origin.
/// Source: THEORY 2.9.
class ArcLength {
 public:
  explicit ArcLength(const CurveView& curve);
  /// From `from` on to `to` only: start <= from < to <= end.
  ArcLength(const CurveView& curve, double from, double to);

  double length() const { return lengths_.back(); }

  /// The length up to t, not NaN. Before the start it is 0, behind the end the whole length.
  double at(double t) const;

  /// The parameter t with at(t) = s, not NaN: by Newton's method, halving where it fails. |at(t) - s| <= 1e-12
  /// length(). The start for s <= 0, the end for s >= length(); where the curve pauses, the first such parameter. A
  /// curve without length yields its start.
  double parameter_at(double s) const;

  /// `count` parameters, increasing, at equal lengths from each other: open, from start to end; closed, from the start
  /// on, the last as far before it. count >= 2, or 1 for the start alone.
  std::vector<double> equidistant(int count) const;

 private:
  double length_between(double from, double to) const;
  void add(double from, double to, double whole, double tolerance, int depth);

  CurveView curve_;
  /// s(parameters_[k]) = lengths_[k]; between two neighbours one Gauss rule suffices.
  std::vector<double> parameters_, lengths_;
};

/// The length from `from` to `to`, start <= from, to <= end; negative when `from` lies behind `to`. Accuracy as above.
double arc_length(const CurveView& curve, double from, double to);
double arc_length(const CurveView& curve);

}  // namespace knotwork
