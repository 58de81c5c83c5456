#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "knotwork/basis/interval.h"
#include "knotwork/result.h"

namespace knotwork {

/// Whether a parameter direction ends (open) or repeats with a period (closed). A property of a knot vector.
enum class Topology : unsigned char { open, closed };

/// A sorted knot vector t_0 <= t_1 <= ... of degree p over n control points (or local geometries).
///
/// Open:   n+p+1 knots, domain [t_p, t_n],     n-p intervals.
/// Closed: n+2p+1 knots, domain [t_p, t_{n+p}), n intervals, t_{i+n} = t_i + P with P = period().
/// A blending spline over n local geometries uses p = 1: local k lives on (t_k, t_{k+2}), centre t_{k+1}.
/// Inner multiplicity is at most p (closed: everywhere), p+1 at the ends of an open vector; the domain is not empty.
/// Valid once constructed. Source: THEORY 2.1, 2.2, 2.7.
class KnotVector {
 public:
  static constexpr int max_degree = 16;
  static constexpr int max_count = 1 << 17;
  /// Bound on |t_i|, so that no difference of knots overflows.
  static constexpr double max_knot = 1e100;
  /// How far t_{i+n} - t_i may differ from the period of a closed vector, relative to that period.
  static constexpr double period_tolerance = 1e-9;

  /// Takes the knots as given. Error path: `knots[i]`, `degree` or `count`.
  static Result<KnotVector> make(int degree, Topology topology, std::vector<double> knots);

  /// Equidistant knots on the domain [start, end]; open ones are clamped (multiplicity p+1 at both ends).
  /// Needs 1 <= p <= max_degree, start < end, n >= p+1 when open and n >= max(2, p) when closed,
  /// n <= max_count. Error path: `degree`, `count`, `start`, `end`, or `knots[i]` when so narrow that knots coincide.
  static Result<KnotVector> uniform(int degree, int count, Topology topology, double start, double end);

  int degree() const { return degree_; }
  /// n: control points, or local geometries when p = 1.
  int count() const { return count_; }
  Topology topology() const { return topology_; }
  bool closed() const { return topology_ == Topology::closed; }
  std::span<const double> knots() const { return knots_; }
  double operator[](int i) const { return knots_[static_cast<std::size_t>(i)]; }

  double start() const { return (*this)[degree_]; }
  double end() const { return (*this)[last_span() + 1]; }
  /// end() - start(); the period P of a closed vector.
  double period() const { return end() - start(); }
  /// Number of knot intervals of the domain, empty ones counted: n-p open, n closed.
  int interval_count() const { return last_span() - degree_ + 1; }
  /// The largest span index: n-1 open, n+p-1 closed.
  int last_span() const { return closed() ? count_ + degree_ - 1 : count_ - 1; }

  /// How often t, brought into the domain, stands among the knots; 0 between knots. A spline of degree p is C^(p-m) at a
  /// knot of multiplicity m. t must be finite.
  int multiplicity(double t) const;

  /// t brought into the domain: closed wraps into [start, end), open clamps to [start, end]. t must be finite.
  double reduced(double t) const;

  /// The span i with t_i <= t < t_{i+1}, i in [p, last_span()], never an empty interval; t = end() of an open vector
  /// belongs to the last non-empty span (left limit). Precondition: t is in the domain. O(log n).
  int span(double t) const;

  /// The same, trying `hint` and its right neighbour first: O(1) for sorted parameters.
  int span(double t, int hint) const;

 private:
  KnotVector(int degree, Topology topology, int count, std::vector<double> knots);

  int degree_;
  Topology topology_;
  int count_;
  std::vector<double> knots_;
};

/// The knot intervals of the domain that are not empty, in their order.
std::vector<Interval> knot_intervals(const KnotVector& knots);

/// w_{d,i}(t) = (t - t_i) / (t_{i+d} - t_i), and 0 where t_{i+d} = t_i. Source: THEORY 2.1.
double translation_and_scaling(const KnotVector& knots, int d, int i, double t);

}  // namespace knotwork
