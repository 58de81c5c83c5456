#include "knotwork/curve/interval_minimum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

#include "knotwork/curve/parametric_curve.h"

namespace knotwork {
namespace {

/// What the end of an interval knows of f.
struct MinimumSample {
  double t;
  ScalarJet jet;
};

class MinimumSearch {
 public:
  MinimumSearch(const ScalarFunction& f, double constant, double root) : f_(f), constant_(constant), root_(root) {}

  IntervalMinimum run(std::span<const double> ends, int detail) {
    std::vector<MinimumSample> samples;
    for (std::size_t piece = 1; piece < ends.size(); ++piece) {
      const double from = ends[piece - 1], to = ends[piece];
      for (int k = 0; k < detail; ++k) samples.push_back(sample(std::lerp(from, to, static_cast<double>(k) / detail)));
      // The piece's own derivatives at its end; the value there is the next one's too.
      const ScalarJet left = sample(just_before(to)).jet;
      samples.push_back({to, {sample(to).jet.f, left.d1, left.d2}});
    }
    const std::size_t row = static_cast<std::size_t>(detail) + 1;
    budget_ = 10000 + 200 * static_cast<long>(samples.size());
    best_ = {samples.front().t, samples.front().jet.f};
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      if (k % row == 0) offer(samples[k].t, samples[k].jet.f);
      if ((k + 1) % row == 0) continue;  // from one piece to the next
      search(samples[k], samples[k + 1], 0);
      if ((k + 2) % row == 0) offer(samples[k + 1].t, samples[k + 1].jet.f);
    }
    return best_;
  }

 private:
  MinimumSample sample(double t) {
    const ScalarJet jet = f_(t);
    least_ = std::min(least_, jet.f);
    return {t, jet};
  }

  /// Below which two values near f are the same.
  double rounding(double f) const { return constant_ + root_ * std::sqrt(std::max(f, 0.0)); }

  /// Candidates come with growing t; one that is as good as the best does not replace it.
  void offer(double t, double value) {
    if (value < best_.value - rounding(value)) best_ = {t, value};
    least_ = std::min(least_, value);
  }

  void search(const MinimumSample& a, const MinimumSample& b, int depth) {
    const double h = b.t - a.t, middle = (a.t + b.t) / 2;
    if (!(a.t < middle && middle < b.t)) return offer_best({a, b, b});
    const MinimumSample m = sample(middle);
    // The cubic's Bernstein coefficients, and how far it is from f: even and odd parts of the difference.
    const double c[4] = {a.jet.f, a.jet.f + h * a.jet.d1 / 3, b.jet.f - h * b.jet.d1 / 3, b.jet.f};
    const double off = std::abs((c[0] + 3 * c[1] + 3 * c[2] + c[3]) / 8 - m.jet.f);
    const double slope = h * m.jet.d1, off_slope = std::abs(3 * (c[3] + c[2] - c[1] - c[0]) / 4 - slope);
    const double error = 4 * off + off_slope;
    const auto [low, high] = std::minmax({c[0], c[1], c[2], c[3]});
    if (low - error > least_ + rounding(least_)) return;
    if (high - low + error <= rounding(least_)) return offer(a.t, a.jet.f);
    // Rises or falls throughout: the ends are the business of the neighbours.
    const double steps[3] = {c[1] - c[0], c[2] - c[1], c[3] - c[2]}, bend = 2 * off_slope + 6 * off;
    if (std::min({steps[0], steps[1], steps[2]}) > bend || std::max({steps[0], steps[1], steps[2]}) < -bend) return;
    // Bends upwards throughout: with a change of sign, one minimum; without, it is at an end, as above.
    if (6 * std::min(steps[1] - steps[0], steps[2] - steps[1]) > 32 * off + 16 * off_slope) {
      if (a.jet.d1 <= 0 && b.jet.d1 >= 0) descend(a, b, m);
      return;
    }
    if (depth == 40 || --budget_ < 0) return offer_best({a, m, b});
    search(a, m, depth + 1);
    search(m, b, depth + 1);
  }

  void offer_best(std::initializer_list<MinimumSample> samples) {
    for (const MinimumSample& s : samples) offer(s.t, s.jet.f);
  }

  /// f' = 0 between a and b, where it grows through 0.
  void descend(const MinimumSample& a, const MinimumSample& b, const MinimumSample& m) {
    double low = a.t, high = b.t, before = std::numeric_limits<double>::max();
    const double last_digit = std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    MinimumSample at = a.jet.d1 == 0 ? a : b.jet.d1 == 0 ? b : m;
    while (at.jet.d1 != 0) {
      (at.jet.d1 < 0 ? low : high) = at.t;
      // Newton's step while it stays inside and each slope is half the one before; else the middle. Compared before
      // dividing: a quotient beyond the interval may be beyond all numbers.
      const double slope = std::abs(at.jet.d1);
      if (slope <= at.jet.d2 * last_digit) break;
      const bool newton = slope < before / 2 && slope < at.jet.d2 * (high - low);
      double next = newton ? at.t - at.jet.d1 / at.jet.d2 : low;
      if (!(low < next && next < high)) next = (low + high) / 2;
      if (!(low < next && next < high)) break;
      before = slope;
      at = sample(next);
    }
    offer(at.t, at.jet.f);
  }

  ScalarFunction f_;
  double constant_, root_;
  double least_ = std::numeric_limits<double>::max();  ///< of all values seen
  long budget_ = 0;                                    ///< of halvings; only noise takes more
  IntervalMinimum best_{};
};

}  // namespace

IntervalMinimum interval_minimum(const ScalarFunction& f, std::span<const double> ends, int detail, double constant,
                                 double root) {
  return MinimumSearch(f, constant, root).run(ends, std::max(detail, 1));
}

}  // namespace knotwork
