#include "knotwork/curve/schoenberg_whitney.h"

#include <cassert>
#include <cstddef>
#include <string>

namespace knotwork {
namespace {

/// Numbers of parameters on the left of knots.
class ParametersLeftOf {
 public:
  ParametersLeftOf(const KnotVector& knots, const ParameterCount& count)
      : knots_(knots), from_(knots.degree()), to_(knots.last_span() + 1) {
    const std::size_t size = static_cast<std::size_t>(to_ - from_) + 1;
    below_.resize(size);
    up_to_.resize(size);
    for (std::size_t s = 0; s + 1 < size; ++s) below_[s + 1] = below_[s] + count.on[s] + count.inside[s];
    total_ = below_.back() + (knots.closed() ? 0 : count.on.back());
    for (std::size_t s = size; s-- > 0;) {
      const int i = from_ + static_cast<int>(s);
      const bool repeated = i < to_ && knots[i] == knots[i + 1];
      const int on = s < count.on.size() ? count.on[s] : 0;
      up_to_[s] = repeated ? up_to_[s + 1] : below_[s] + on;
    }
  }

  /// Parameters x < t_i, for a support that ends at t_i; closed, rounds are counted through: i may be any that is >= p.
  int below(int i) const {
    if (knots_.closed()) return wrapped(below_, i);
    if (i <= to_) return below_[index(i)];
    return i < knots_.count() + knots_.degree() && knots_[i] == knots_.end() ? below_.back() : total_;
  }
  /// Parameters x <= t_i, for a support that begins at t_i; closed, i >= 0.
  int up_to(int i) const {
    if (knots_.closed()) return wrapped(up_to_, i + knots_.count()) - total_;
    if (i >= from_) return up_to_[index(i)];
    return i > 0 && knots_[i] == knots_.start() ? up_to_.front() : 0;
  }

  int total() const { return total_; }

 private:
  std::size_t index(int i) const { return static_cast<std::size_t>(i - from_); }
  int wrapped(const std::vector<int>& counts, int i) const {
    const int rounds = (i - from_) / knots_.count();
    return rounds * total_ + counts[index(i - rounds * knots_.count())];
  }

  const KnotVector& knots_;
  int from_, to_;
  int total_ = 0;
  std::vector<int> below_, up_to_;
};

}  // namespace

Status check_schoenberg_whitney(const KnotVector& knots, const ParameterCount& count, int first, int last) {
  const int p = knots.degree(), n = knots.count();
  const ParametersLeftOf left(knots, count);
  assert(!knots.closed() || (first == 0 && last == n - 1));
  int most_missing = 0, worst_start = 0, worst_end = 0;
  if (knots.closed() && left.total() < n) {
    most_missing = n - left.total();
    worst_end = n + p;
  } else {
    // Functions j .. e-p-1 have the open interval (t_j, t_e) as the union of their supports. For every e the j is kept
    // that leaves most missing. Closed, two rounds let every run of up to n functions come by; an arc longer than a
    // period counts parameters twice, but then it holds them all, and these are enough.
    const int end = (knots.closed() ? last + n : last) + p + 1;
    int start = first;
    for (int j = first, e = first + p + 1; e <= end; ++j, ++e) {
      if (left.up_to(j) - j >= left.up_to(start) - start) start = j;
      const int missing = (e - p - start) - (left.below(e) - left.up_to(start));
      if (missing > most_missing) {
        most_missing = missing;
        worst_start = start;
        worst_end = e;
      }
    }
  }
  if (most_missing == 0) return success();

  const int functions = worst_end - p - worst_start, supporting = functions - most_missing;
  const auto name = [&](int i) { return std::to_string(knots.closed() ? i % n : i); };
  std::string message = supporting == 0   ? std::string("No data supports")
                        : supporting == 1 ? std::string("Only one parameter supports")
                                          : "Only " + std::to_string(supporting) + " different parameters support";
  message += functions == 1 ? " the basis function " + name(worst_start)
                            : " the " + std::to_string(functions) + " basis functions " + name(worst_start) + " to " +
                                  name(worst_end - p - 1);
  return Error{"parameters", message + ": give more data there, use fewer control points, or smooth."};
}

}  // namespace knotwork
