#include "knotwork/basis/knot_vector.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace knotwork {
namespace {

std::string knot_path(int i) { return "knots[" + std::to_string(i) + "]"; }

/// Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
bool reasonable(double t) { return std::isfinite(t) && std::abs(t) <= KnotVector::max_knot; }

/// The index of the first knot that breaks sortedness, finiteness or the bound on multiplicity, with the reason.
Status check_order(int degree, Topology topology, std::span<const double> knots) {
  const int size = static_cast<int>(knots.size());
  const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < size; ++i) {
    if (!reasonable(knot(i))) {
      return Error{knot_path(i), "A knot must be a finite number of reasonable size."};
    }
    if (i > 0 && knot(i) < knot(i - 1)) return Error{knot_path(i), "The knots must not decrease."};
  }
  for (int first = 0; first < size;) {
    int last = first;
    while (last + 1 < size && knot(last + 1) == knot(first)) ++last;
    const bool at_open_end = topology == Topology::open && (first == 0 || last == size - 1);
    const int most = at_open_end ? degree + 1 : degree;
    if (last - first + 1 > most) {
      return Error{knot_path(first + most), "This knot may be repeated at most " + std::to_string(most) + " times."};
    }
    first = last + 1;
  }
  return success();
}

}  // namespace

KnotVector::KnotVector(int degree, Topology topology, int count, std::vector<double> knots)
    : degree_(degree), topology_(topology), count_(count), knots_(std::move(knots)) {}

Result<KnotVector> KnotVector::make(int degree, Topology topology, std::vector<double> knots) {
  if (degree < 1 || degree > max_degree) {
    return Error{"degree", "The degree must lie between 1 and " + std::to_string(max_degree) + "."};
  }
  const bool closed = topology == Topology::closed;
  const int least_count = closed ? std::max(2, degree) : degree + 1;
  const std::size_t extra = static_cast<std::size_t>(closed ? 2 * degree + 1 : degree + 1);
  if (knots.size() < extra + static_cast<std::size_t>(least_count)) {
    return Error{"count", "There are too few knots: this degree needs at least " +
                              std::to_string(extra + static_cast<std::size_t>(least_count)) + "."};
  }
  if (knots.size() > extra + static_cast<std::size_t>(max_count)) {
    return Error{"count", "There are too many knots: the count may be at most " + std::to_string(max_count) + "."};
  }
  if (const Status order = check_order(degree, topology, knots); !order) return order.error();

  const int count = static_cast<int>(knots.size() - extra);
  KnotVector result(degree, topology, count, std::move(knots));
  if (!(result.start() < result.end())) {
    return Error{knot_path(result.last_span() + 1), "The domain must not be empty."};
  }
  if (closed) {
    for (int i = 0; i <= 2 * degree; ++i) {
      const double gap = (result[i + count] - result[i]) - result.period();
      if (!(std::abs(gap) <= period_tolerance * result.period())) {
        return Error{knot_path(i + count), "The knots of a closed direction must repeat after one period."};
      }
    }
  }
  return result;
}

Result<KnotVector> KnotVector::uniform(int degree, int count, Topology topology, double start, double end) {
  if (degree < 1 || degree > max_degree) {
    return Error{"degree", "The degree must lie between 1 and " + std::to_string(max_degree) + "."};
  }
  const bool closed = topology == Topology::closed;
  const int least_count = closed ? std::max(2, degree) : degree + 1;
  if (count < least_count || count > max_count) {
    return Error{"count", "The count must lie between " + std::to_string(least_count) + " and " +
                              std::to_string(max_count) + "."};
  }
  if (!reasonable(start)) return Error{"start", "The start must be a finite number of reasonable size."};
  if (!reasonable(end)) return Error{"end", "The end must be a finite number of reasonable size."};
  if (!(start < end)) return Error{"end", "The end must be greater than the start."};

  const int intervals = closed ? count : count - degree;
  const double length = end - start;
  // The domain's ends come out exactly as given, whatever the rounding of the steps between.
  const auto at = [&](int step) {
    return step == intervals ? end : start + length * (static_cast<double>(step) / intervals);
  };
  std::vector<double> knots;
  knots.reserve(static_cast<std::size_t>(intervals + 2 * degree + 1));
  for (int step = -degree; step <= intervals + degree; ++step) {
    if (!closed) {
      knots.push_back(at(std::clamp(step, 0, intervals)));
    } else if (step < 0) {
      knots.push_back(at(step + intervals) - length);
    } else if (step > intervals) {
      knots.push_back(at(step - intervals) + length);
    } else {
      knots.push_back(at(step));
    }
  }
  return make(degree, topology, std::move(knots));
}

double KnotVector::reduced(double t) const {
  assert(std::isfinite(t));
  if (!closed()) return std::clamp(t, start(), end());
  if (t >= start() && t < end()) return t;
  // fmod is exact, so that whole periods are taken off without an error that grows with their number.
  double offset = std::fmod(t - start(), period());
  if (offset < 0) offset += period();
  const double wrapped = start() + offset;
  return wrapped < end() ? wrapped : start();
}

int KnotVector::multiplicity(double t) const {
  return static_cast<int>(std::count(knots_.begin(), knots_.end(), reduced(t)));
}

int KnotVector::span(double t) const {
  assert(t >= start() && t <= end());
  const auto first = knots_.begin() + degree_;
  const auto last = knots_.begin() + last_span() + 1;
  int i = static_cast<int>(std::upper_bound(first, last, t) - knots_.begin()) - 1;
  while (i > degree_ && !((*this)[i] < (*this)[i + 1])) --i;
  return i;
}

int KnotVector::span(double t, int hint) const {
  for (int i = hint; i <= hint + 1; ++i) {
    if (i >= degree_ && i <= last_span() && (*this)[i] <= t && t < (*this)[i + 1]) return i;
  }
  return span(t);
}

std::vector<Interval> knot_intervals(const KnotVector& knots) {
  std::vector<Interval> intervals;
  intervals.reserve(static_cast<std::size_t>(knots.interval_count()));
  for (int i = knots.degree(); i <= knots.last_span(); ++i)
    if (knots[i] < knots[i + 1]) intervals.push_back({knots[i], knots[i + 1]});
  return intervals;
}

double translation_and_scaling(const KnotVector& knots, int d, int i, double t) {
  const double width = knots[i + d] - knots[i];
  return width > 0 ? (t - knots[i]) / width : 0.0;
}

}  // namespace knotwork
