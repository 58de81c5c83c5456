#pragma once

#include <cstddef>

#include "knotwork/basis/lanes.h"

namespace knotwork {

/// Numbers of neighbouring points, number by number: kernels compute them so, a lane for each point, and hand them over
/// as points. `columns` numbers for each of `size` points; on the stack, to stay in the first-level cache.
template <std::size_t columns, std::size_t size>
class PointColumns {
 public:
  /// A kernel may write whole lanes, up to lane_count places beyond the last point.
  double* at(std::size_t column, std::size_t m) { return &values_[column][m]; }
  const double* at(std::size_t column, std::size_t m) const { return &values_[column][m]; }

  /// out[m columns + c] = column c of point m, for all points.
  void hand_over(double* out) const { hand_over_strips(size, out); }
  /// The same for m < count.
  void hand_over(std::size_t count, double* out) const {
    const std::size_t in_strips = count / strip_size * strip_size;
    hand_over_strips(in_strips, out);
    out += columns * in_strips;
    for (std::size_t m = in_strips; m < count; ++m) {
      for (std::size_t c = 0; c < columns; ++c) *out++ = values_[c][m];
    }
  }

 private:
  // Shuffles across more than four lanes are no faster than two of four.
  static constexpr std::size_t strip_size = lane_count < 4 ? lane_count : 4;
  using Strip = VectorOf<strip_size>::Type;

  static_assert(size % strip_size == 0);

  void hand_over_strips(std::size_t count, double* out) const;
  alignas(64) double values_[columns][size + lane_count];
};

template <std::size_t columns, std::size_t size>
void PointColumns<columns, size>::hand_over_strips(std::size_t count, double* out) const {
  Strip a, b, c, d;
  for (std::size_t m = 0; m < count; m += strip_size, out += columns * strip_size) {
    if constexpr (columns == 3) {
      load(a, at(0, m));
      load(b, at(1, m));
      load(c, at(2, m));
      store_points(a, b, c, out);
    } else {
      constexpr std::size_t in_fours = columns / 4 * 4;
      for (std::size_t column = 0; column < in_fours; column += 4) {
        load(a, at(column, m));
        load(b, at(column + 1, m));
        load(c, at(column + 2, m));
        load(d, at(column + 3, m));
        store_fours(a, b, c, d, out + column, columns);
      }
      for (std::size_t column = in_fours; column < columns; ++column) {
        for (std::size_t k = 0; k < strip_size; ++k) out[k * columns + column] = values_[column][m + k];
      }
    }
  }
}

}  // namespace knotwork
