#include "knotwork/basis/bspline_basis.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace knotwork {
namespace {

/// row (d numbers) times T_d(t) (d+1 numbers), in place.
void times_factor(const KnotVector& knots, int span, double t, int d, std::span<double> row) {
  double carried = 0;
  for (int r = 0; r < d; ++r) {
    const double value = row[static_cast<std::size_t>(r)];
    const double from = knots[span - d + 1 + r], to = knots[span + 1 + r];
    const double width = to - from;
    // Both shares from their own ends: neither loses digits where it is small.
    row[static_cast<std::size_t>(r)] = carried + value * ((to - t) / width);
    carried = value * ((t - from) / width);
  }
  row[static_cast<std::size_t>(d)] = carried;
}

/// row (d numbers) times d T'_d (d+1 numbers), in place.
void times_derivative(const KnotVector& knots, int span, int d, std::span<double> row) {
  double carried = 0;
  for (int r = 0; r < d; ++r) {
    const double slope = d * row[static_cast<std::size_t>(r)] / (knots[span + 1 + r] - knots[span - d + 1 + r]);
    row[static_cast<std::size_t>(r)] = carried - slope;
    carried = slope;
  }
  row[static_cast<std::size_t>(d)] = carried;
}

}  // namespace

void bspline_basis(const KnotVector& knots, int span, double t, int order, std::span<double> out) {
  const int p = knots.degree();
  const std::size_t width = static_cast<std::size_t>(p) + 1;
  assert(order >= 0 && out.size() == width * (static_cast<std::size_t>(order) + 1));
  assert(knots[span] < knots[span + 1]);
  std::fill(out.begin(), out.end(), 0.0);

  // The row for the k-th derivative waits at degree p-k, while the values go on to degree p.
  const std::span<double> values = out.first(width);
  values[0] = 1;
  for (int d = 0; d <= p; ++d) {
    if (d > 0) times_factor(knots, span, t, d, values);
    const int k = p - d;
    if (k == 0 || k > order) continue;
    const std::span<double> row = out.subspan(static_cast<std::size_t>(k) * width, width);
    std::copy_n(values.begin(), d + 1, row.begin());
    for (int e = d + 1; e <= p; ++e) times_derivative(knots, span, e, row);
  }
}

}  // namespace knotwork
