#include "knotwork/scene/knot_edits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>

#include "knotwork/scene/limits.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// Relative to the period; what comes through JSON or a drag and back is still evenly spaced.
constexpr double even_tolerance = 1e-12;

std::vector<double> copied(std::span<const double> values) { return {values.begin(), values.end()}; }

/// All knots of a closed vector from those of one period, t_p .. t_{p+n-1}.
std::vector<double> repeated(const std::vector<double>& period, double length, int degree) {
  const int n = static_cast<int>(period.size());
  std::vector<double> knots;
  for (int i = -degree; i <= n + degree; ++i) {
    const int round = i >= 0 ? i / n : -((n - 1 - i) / n);
    knots.push_back(period[static_cast<std::size_t>(i - round * n)] + round * length);
  }
  return knots;
}

}  // namespace

int least_points(int degree, Topology topology) {
  return topology == Topology::closed ? std::max(degree, 2) : degree + 1;
}

Ends ends_of(const KnotVector& knots) {
  const bool clamped = knots[0] == knots.start() && knots[static_cast<int>(knots.knots().size()) - 1] == knots.end();
  return knots.closed() || clamped ? Ends::clamped : Ends::unclamped;
}

Result<KnotVector> even_knots(int degree, int points, Topology topology, Ends ends) {
  const int intervals = topology == Topology::closed ? points : points - degree;
  if (topology == Topology::closed || ends == Ends::clamped || intervals < 1)
    return KnotVector::uniform(degree, points, topology, 0, std::max(intervals, 1));
  std::vector<double> knots(static_cast<std::size_t>(points + degree + 1));
  std::iota(knots.begin(), knots.end(), 0.0);
  return KnotVector::make(degree, topology, std::move(knots));
}

bool evenly_spaced(const KnotVector& knots) {
  const Result<KnotVector> made = even_knots(knots.degree(), knots.count(), knots.topology(), ends_of(knots));
  if (!made) return false;
  const KnotVector& even = made.value();
  const double scale = knots.period() / even.period();
  const std::span<const double> a = knots.knots(), b = even.knots();
  return std::equal(a.begin(), a.end(), b.begin(), [&](double x, double y) {
    return std::abs(x - knots.start() - scale * (y - even.start())) <= even_tolerance * knots.period();
  });
}

double greville(const KnotVector& knots, int i) {
  double sum = 0;
  for (int k = i + 1; k <= i + knots.degree(); ++k) sum += knots[k];
  return sum / knots.degree();
}

Result<KnotVector> with_knot_for(const KnotVector& knots, int i) {
  const int n = knots.count(), p = knots.degree();
  if (knots.closed()) {
    const double before = i > 0 ? greville(knots, i - 1) : greville(knots, n - 1) - knots.period();
    const double after = i < n ? greville(knots, i) : greville(knots, 0) + knots.period();
    std::vector<double> period(knots.knots().begin() + p, knots.knots().begin() + p + n);
    period.push_back(knots.reduced((before + after) / 2));
    std::sort(period.begin(), period.end());
    return KnotVector::make(p, Topology::closed, repeated(period, knots.period(), p));
  }
  const int a = std::clamp(i, 1, n - 1);
  std::vector<double> inserted = copied(knots.knots());
  const double t = std::clamp((greville(knots, a - 1) + greville(knots, a)) / 2, knots.start(), knots.end());
  inserted.insert(std::upper_bound(inserted.begin(), inserted.end(), t), t);
  return KnotVector::make(p, Topology::open, std::move(inserted));
}

Result<KnotVector> without_knot_of(const KnotVector& knots, int i) {
  const int n = knots.count(), p = knots.degree();
  const int first = knots.closed() ? p : p + 1, last = knots.closed() ? p + n - 1 : n - 1;
  const double said = knots.closed() ? knots.reduced(greville(knots, i)) : greville(knots, i);
  int gone = first;
  for (int k = first; k <= last; ++k)
    if (std::abs(knots[k] - said) < std::abs(knots[gone] - said)) gone = k;
  if (knots.closed()) {
    std::vector<double> period(knots.knots().begin() + p, knots.knots().begin() + p + n);
    period.erase(period.begin() + (gone - p));
    return KnotVector::make(p, Topology::closed, repeated(period, knots.period(), p));
  }
  std::vector<double> rest = copied(knots.knots());
  rest.erase(rest.begin() + gone);
  return KnotVector::make(p, Topology::open, std::move(rest));
}

Result<std::vector<double>> with_knot_moved(const KnotVector& knots, int index, double value) {
  const int size = static_cast<int>(knots.knots().size()), p = knots.degree(), n = knots.count();
  if (index < 0 || index >= size || (knots.closed() && (index < p || index >= p + n)))
    return Error{"index", "There is no knot " + std::to_string(index) + " to be moved."};
  if (!limits::coordinate.contains(value)) return Error{"value", number_message(limits::coordinate)};
  std::vector<double> moved = copied(knots.knots());
  moved[static_cast<std::size_t>(index)] = value;
  if (knots.closed()) moved = repeated({moved.begin() + p, moved.begin() + p + n}, knots.period(), p);
  const Result<KnotVector> made = KnotVector::make(p, knots.topology(), moved);
  if (!made) return Error{"value", made.error().message};
  return moved;
}

}  // namespace knotwork::scene
