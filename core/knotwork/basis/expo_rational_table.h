#pragma once

#include <vector>

#include "knotwork/basis/blending_function.h"

namespace knotwork {

/// The integral of phi(s) = exp(-beta |s-lambda|^a / (s (1-s)^gamma)^alpha), a = alpha(1+gamma), prepared once so that
/// B(t) = S int_0^t phi costs ten values of phi.
///
/// phi spans hundreds of orders of magnitude. [0,1] is therefore cut at lambda, and each side is integrated from its own
/// end, in cells over which the exponent changes by a bounded amount: the result has full relative accuracy wherever it
/// is not below 1e-300, where a uniform table would have only an absolute one.
class ExpoRationalTable {
 public:
  explicit ExpoRationalTable(const ExpoRationalParameters& parameters);

  const ExpoRationalParameters& parameters() const { return parameters_; }
  /// S = 1 / int_0^1 phi.
  double scale() const { return scale_; }
  /// {B, B', B'', B'''}, 0 <= t <= 1. Derivatives from the exact formulas B' = S phi, B'' = S phi h,
  /// B''' = S phi (h^2 + h'), h = (log phi)'. Where one is unbounded (at t = lambda if a < 2) it is given as 0.
  BlendingValue operator()(double t) const;

 private:
  /// A point by its distances from both ends and from lambda, none of them spoilt by cancellation.
  struct Place {
    double s, r, x;  ///< t, 1 - t, t - lambda
  };
  /// phi with h and h'.
  struct Density {
    double phi, h, h1;
  };
  /// One side of lambda, seen from its end: integral[k] = int of phi from the end to edge[k].
  struct Side {
    bool left;
    std::vector<double> edge, integral;
  };

  Place place(bool left, double distance_from_end) const;
  /// -log phi, infinite where phi underflows.
  double decay(const Place& place) const;
  Density density(const Place& place) const;
  double quadrature(bool left, double a, double b) const;
  Side make_side(bool left) const;
  double from_end(const Side& side, double distance) const;

  ExpoRationalParameters parameters_;
  bool default_;
  Side left_, right_;
  double scale_;
};

}  // namespace knotwork
