#pragma once

#include <vector>

#include "knotwork/curve/parametric_curve.h"

namespace knotwork {

/// How smoothly two pieces of a curve meet at a parameter t.
struct Continuity {
  double t = 0;
  /// C^k: the greatest k such that c, c', .., c^(k) have the same values from both sides; -1 where the curve is torn.
  /// At most the order that was looked at.
  int parametric = -1;
  /// G^k of the shape, at most 2: 0 a common point, 1 a common tangent direction, 2 a common curvature vector kappa N as
  /// well, in whatever speed. At most 0 where the curve has no speed on one side.
  int geometric = -1;
  /// |c'(t-) - c'(t+)|, model units by units of t.
  double velocity_gap = 0;
};

/// At t inside (start, end), or at the start of a closed curve, where its ends meet.
///
/// Derivatives up to `order` (1 to 3) of both sides are compared. What differs by less than `tolerance` times the sum of
/// its own size and of s / h^k, h the shorter one of the two pieces and s the largest of |c|, h |c'| and h^2 |c''|, is
/// rounding. Numbers that a hand has set differ by more, so a curve is C^1 only if it was made so.
/// Source: THEORY 2.2 (multiplicity and continuity), 2.9 (curvature).
Continuity continuity_at(const CurveView& curve, double t, int order = 3, double tolerance = 1e-9);

/// At each break inside the curve, and at the seam of a closed one first.
std::vector<Continuity> joints(const CurveView& curve, int order = 3);

}  // namespace knotwork
