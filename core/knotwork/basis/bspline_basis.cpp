#include "knotwork/basis/bspline_basis.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "knotwork/basis/fixed_degree.h"
#include "knotwork/basis/lanes.h"

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

/// times_factor() with the divisions taken out of the loop over the parameters, and the distances to the knots found
/// once. Of the usual degree the compiler knows the loops' lengths.
template <int fixed_degree>
void basis_columns(const KnotVector& knots, int span, std::span<const double> t, std::span<double> out) {
  const std::size_t p = degree_or_fixed<fixed_degree>(knots.degree());
  const std::size_t size = t.size();
  // The bound keeps the reciprocals finite.
  constexpr double least_width = 1e-290;
  constexpr std::size_t most = degree_or_fixed<fixed_degree>(KnotVector::max_degree);
  std::array<double, most*(most + 1) / 2> reciprocal;
  for (int d = 1, k = 0; d <= static_cast<int>(p); ++d) {
    for (int r = 0; r < d; ++r, ++k)
      reciprocal[static_cast<std::size_t>(k)] =
          1 / std::max(knots[span + 1 + r] - knots[span - d + 1 + r], least_width);
  }
  std::array<double, most> left, right;  // t_{span-k} and t_{span+1+k}
  for (std::size_t k = 0; k < p; ++k) {
    left[k] = knots[span - static_cast<int>(k)];
    right[k] = knots[span + 1 + static_cast<int>(k)];
  }
  std::array<Lanes, most> from_left, to_right;  // t - t_{span-k} and t_{span+1+k} - t
  std::array<Lanes, most + 1> row;
  for (std::size_t first = 0; first < size; first += lane_count) {
    const bool whole = first + lane_count <= size;
    Lanes at;
    if (whole) {
      load(at, &t[first]);
    } else {
      for (std::size_t l = 0; l < lane_count; ++l) at[l] = t[std::min(first + l, size - 1)];
    }
    for (std::size_t k = 0; k < p; ++k) {
      from_left[k] = at - left[k];
      to_right[k] = right[k] - at;
    }
    row[0] = Lanes{} + 1.0;
    const double* next_reciprocal = reciprocal.data();
    for (std::size_t d = 1; d <= p; ++d) {
      Lanes carried{};
      for (std::size_t r = 0; r < d; ++r) {
        const Lanes value = row[r] * *next_reciprocal++;
        row[r] = carried + value * to_right[r];
        carried = value * from_left[d - 1 - r];
      }
      row[d] = carried;
    }
    for (std::size_t j = 0; j <= p; ++j) {
      double* const to = out.data() + j * size + first;
      if (whole) {
        store(row[j], to);
      } else {
        for (std::size_t l = 0; first + l < size; ++l) to[l] = row[j][l];
      }
    }
  }
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
  assert(out.size() == t.size() * (static_cast<std::size_t>(knots.degree()) + 1));
  assert(knots[span] < knots[span + 1]);
  return knots.degree() == 3 ? basis_columns<3>(knots, span, t, out) : basis_columns<any_degree>(knots, span, t, out);
}

}  // namespace knotwork
