#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace knotwork {

/// Some rows of a matrix and of the right-hand sides beside it, column after column. The number of rows is filled up to
/// a multiple of `lanes` by rows of zeros, which change no least squares solution, so that loops over them vectorize.
class RowBlock {
 public:
  static constexpr std::size_t lanes = 8;
  /// So many numbers of a column, for arithmetic with them all.
  using Lanes = Eigen::Array<double, lanes, 1>;
  static Eigen::Map<Lanes> at(double* first) { return Eigen::Map<Lanes>(first); }
  static Eigen::Map<const Lanes> at(const double* first) { return Eigen::Map<const Lanes>(first); }

  /// Room for so many rows; none are there yet.
  RowBlock(std::size_t columns, std::size_t most_rows) : columns_(columns), values_(columns * filled_up(most_rows)) {}

  /// So many rows, of any content but for those that fill up. Precondition: rows <= most_rows.
  void resize(std::size_t rows) {
    stride_ = filled_up(rows);
    for (std::size_t j = 0; j < columns_; ++j) std::fill(column(j).data() + rows, column(j).data() + stride_, 0.0);
  }
  /// So many rows, all zero.
  void clear(std::size_t rows) {
    stride_ = filled_up(rows);
    std::fill_n(values_.begin(), columns_ * stride_, 0.0);
  }
  /// Rows, those of zeros counted.
  std::size_t rows() const { return stride_; }
  std::size_t columns() const { return columns_; }
  std::span<double> column(std::size_t j) { return {values_.data() + j * stride_, stride_}; }
  /// So many columns one after the other.
  std::span<double> columns(std::size_t first, std::size_t count) {
    return {values_.data() + first * stride_, count * stride_};
  }

 private:
  static std::size_t filled_up(std::size_t rows) { return (rows + lanes - 1) / lanes * lanes; }

  std::size_t columns_;
  std::size_t stride_ = 0;
  std::vector<double> values_;
};

}  // namespace knotwork
