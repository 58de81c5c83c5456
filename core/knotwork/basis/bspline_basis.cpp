#include "knotwork/basis/bspline_basis.h"

#include <algorithm>
#include <array>
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

void bspline_basis_columns(const KnotVector& knots, int span, std::span<const double> t, std::span<double> out) {
  const int p = knots.degree();
  const std::size_t size = t.size();
  assert(out.size() == size * (static_cast<std::size_t>(p) + 1));
  assert(knots[span] < knots[span + 1]);

  // times_factor() with the divisions taken out of the loop over the parameters, and the distances to the knots found
  // once. The bound keeps the reciprocals finite.
  constexpr double least_width = 1e-290;
  constexpr std::size_t most_factors = KnotVector::max_degree * (KnotVector::max_degree + 1) / 2;
  std::array<double, most_factors> reciprocal;
  for (int d = 1, k = 0; d <= p; ++d) {
    for (int r = 0; r < d; ++r, ++k)
      reciprocal[static_cast<std::size_t>(k)] =
          1 / std::max(knots[span + 1 + r] - knots[span - d + 1 + r], least_width);
  }
  // So many parameters at a time that every inner loop has a fixed length, which compilers vectorize at any setting.
  constexpr std::size_t lanes = 8;
  using Lanes = std::array<double, lanes>;
  std::array<Lanes, KnotVector::max_degree> from_left, to_right;  // t - t_{span-k} and t_{span+1+k} - t
  std::array<Lanes, KnotVector::max_degree + 1> row;
  for (std::size_t first = 0; first < size; first += lanes) {
    const std::size_t here = std::min(lanes, size - first);
    for (std::size_t k = 0; k < static_cast<std::size_t>(p); ++k) {
      const double left = knots[span - static_cast<int>(k)], right = knots[span + 1 + static_cast<int>(k)];
      for (std::size_t l = 0; l < lanes; ++l) {
        const double at = t[first + std::min(l, here - 1)];
        from_left[k][l] = at - left;
        to_right[k][l] = right - at;
      }
    }
    row[0].fill(1);
    const double* next_reciprocal = reciprocal.data();
    for (std::size_t d = 1; d <= static_cast<std::size_t>(p); ++d) {
      Lanes carried{};
      for (std::size_t r = 0; r < d; ++r) {
        const double per_width = *next_reciprocal++;
        for (std::size_t l = 0; l < lanes; ++l) {
          const double value = row[r][l] * per_width;
          row[r][l] = carried[l] + value * to_right[r][l];
          carried[l] = value * from_left[d - 1 - r][l];
        }
      }
      row[d] = carried;
    }
    for (std::size_t j = 0; j <= static_cast<std::size_t>(p); ++j) {
      double* const to = out.data() + j * size + first;
      if (here == lanes) {
        for (std::size_t l = 0; l < lanes; ++l) to[l] = row[j][l];
      } else {
        std::copy_n(row[j].begin(), here, to);
      }
    }
  }
}

}  // namespace knotwork
