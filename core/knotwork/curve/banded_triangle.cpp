#include "knotwork/curve/banded_triangle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace knotwork {
namespace {

/// Numbers below this are zero: their squares would be subnormal, and solutions that divide by them overflow.
constexpr double negligible_number = 1e-130;
/// A solution of such a size has no meaning; stopping here keeps back substitution from overflowing.
constexpr double largest_solution = 1e100;
/// A pivot smaller than this, relative to its column's norm, is rounding error.
constexpr double least_pivot = 1e-13;

double dot_product(std::span<const double> a, std::span<const double> b) {
  RowBlock::Lanes sums = RowBlock::Lanes::Zero();
  for (std::size_t i = 0; i < a.size(); i += RowBlock::lanes)
    sums += RowBlock::at(a.data() + i) * RowBlock::at(b.data() + i);
  return sums.sum();
}

/// The reflection I + u u' / (beta u_0), u = (u_0, v), that takes (pivot, v) to (beta, 0). beta has the sign that lets
/// nothing cancel in u_0 = pivot - beta.
class Reflection {
 public:
  /// Sets the pivot to beta. False, and nothing done, when there is nothing to take to 0.
  bool make(double& pivot, std::span<const double> v) {
    const double square = dot_product(v, v);
    if (!(square > negligible_number * negligible_number)) return false;
    const double norm = std::sqrt(pivot * pivot + square);
    beta_ = pivot > 0 ? -norm : norm;
    top_ = pivot - beta_;
    v_ = v;
    pivot = beta_;
    return true;
  }
  /// To another column (entry, c).
  void apply(double& entry, std::span<double> c) const {
    const double factor = (entry + dot_product(v_, c) / top_) / beta_;
    entry += factor * top_;
    for (std::size_t i = 0; i < c.size(); i += RowBlock::lanes)
      RowBlock::at(c.data() + i) += factor * RowBlock::at(v_.data() + i);
  }

 private:
  std::span<const double> v_;
  double beta_ = 0, top_ = 0;
};

/// Works rows into the top `width` rows of a triangle, stored as BandedTriangle stores it.
void work_rows_in(double* triangle, std::size_t width, RowBlock& rows) {
  constexpr std::size_t sides = BandedTriangle::right_hand_sides;
  assert(rows.columns() == width + sides);
  for (std::size_t k = 0; k < width; ++k, triangle += width + sides) {
    Reflection reflection;
    if (!reflection.make(triangle[0], rows.column(k))) continue;
    for (std::size_t c = k + 1; c < width; ++c) reflection.apply(triangle[c - k], rows.column(c));
    for (std::size_t c = width; c < width + sides; ++c) reflection.apply(triangle[c], rows.column(c));
  }
}

}  // namespace

BandedTriangle::BandedTriangle(std::size_t columns, std::size_t width, Topology topology)
    : columns_(columns),
      width_(width),
      closed_(topology == Topology::closed),
      triangle_((columns + width - 1) * (width + right_hand_sides)) {
  assert(columns >= 1 && (!closed_ || columns >= width - 1));
  if (!closed_) return;
  const std::size_t seam_columns = 2 * width - 1;
  border_.resize(columns * (width - 1));
  seam_.resize(seam_columns * (seam_columns + right_hand_sides));
}

void BandedTriangle::add(std::size_t first, RowBlock& rows) {
  // Worked in out of order, rows would fill the triangle beyond its band.
  assert(first >= last_first_ && first < columns_);
  last_first_ = first;
  if (closed_ && first + width_ > columns_) {
    add_to_seam(first, rows);
  } else {
    work_rows_in(row(first), width_, rows);
  }
}

/// Where the seam's rows keep column c of A. The last width-1 columns have places of their own, behind a ring through
/// which the others pass.
std::size_t BandedTriangle::seam_column(std::size_t c) const {
  const std::size_t inner = columns_ - (width_ - 1);
  return c < inner ? c % width_ : width_ + (c - inner);
}

void BandedTriangle::add_to_seam(std::size_t first, RowBlock& rows) {
  const std::size_t seam_columns = 2 * width_ - 1;
  RowBlock spread(seam_columns + right_hand_sides, rows.rows());
  spread.clear(rows.rows());
  const auto add = [&](std::size_t from, std::size_t to) {
    const std::span<const double> source = rows.column(from);
    const std::span<double> target = spread.column(to);
    for (std::size_t i = 0; i < source.size(); ++i) target[i] += source[i];
  };
  // With fewer columns than `width` one of them comes twice, and counts twice.
  for (std::size_t c = 0; c < width_; ++c) add(c, seam_column((first + c) % columns_));
  for (std::size_t c = 0; c < right_hand_sides; ++c) add(width_ + c, seam_columns + c);
  work_rows_in(seam_.data(), seam_columns, spread);
}

void BandedTriangle::sweep_seam() {
  const std::size_t seam_columns = 2 * width_ - 1;
  RowBlock rows(seam_columns + right_hand_sides, seam_columns);
  rows.clear(seam_columns);
  for (std::size_t i = 0; i < seam_columns; ++i) {
    const double* const from = seam_.data() + i * (seam_columns + right_hand_sides);
    for (std::size_t c = i; c < seam_columns; ++c) rows.column(c)[i] = from[c - i];
    for (std::size_t c = 0; c < right_hand_sides; ++c) rows.column(seam_columns + c)[i] = from[seam_columns + c];
  }
  for (std::size_t k = 0; k < columns_; ++k) {
    Reflection reflection;
    const std::span<double> eliminated = rows.column(seam_column(k));
    if (reflection.make(row(k)[0], eliminated)) {
      for_each_right_of_diagonal(
          k, [&](std::size_t c, double& entry) { reflection.apply(entry, rows.column(seam_column(c))); });
      for (std::size_t c = 0; c < right_hand_sides; ++c)
        reflection.apply(right_hand_side(k)[c], rows.column(seam_columns + c));
    }
    // Its place in the ring is the one of column k + width.
    std::fill(eliminated.begin(), eliminated.end(), 0.0);
  }
}

/// visit(c, R_kc) for c > k: the band, then what of the border lies right of it.
template <class Visit>
void BandedTriangle::for_each_right_of_diagonal(std::size_t k, Visit visit) {
  const std::size_t band_end = std::min(k + width_, columns_);
  for (std::size_t c = k + 1; c < band_end; ++c) visit(c, row(k)[c - k]);
  if (!closed_) return;
  const std::size_t inner = columns_ - (width_ - 1);
  for (std::size_t c = std::max(inner, band_end); c < columns_; ++c) visit(c, border_[k * (width_ - 1) + c - inner]);
}

void BandedTriangle::fix(std::size_t k, const Eigen::Vector3d& value) {
  std::fill_n(row(k), width_, 0.0);
  row(k)[0] = 1;
  Eigen::Map<Eigen::Vector3d>(right_hand_side(k)) = value;
}

std::optional<std::size_t> BandedTriangle::solve(std::span<Eigen::Vector3d> x) {
  assert(x.size() == columns_);
  if (closed_) sweep_seam();
  std::vector<double> square(columns_);
  for (std::size_t k = 0; k < columns_; ++k) {
    square[k] += row(k)[0] * row(k)[0];
    for_each_right_of_diagonal(k, [&](std::size_t c, double entry) { square[c] += entry * entry; });
  }
  // Every pivot before any of the substitution: the first column that depends on others is the one to name.
  for (std::size_t k = 0; k < columns_; ++k) {
    if (!(std::abs(row(k)[0]) > std::max(negligible_number, least_pivot * std::sqrt(square[k])))) return k;
  }
  for (std::size_t k = columns_; k-- > 0;) {
    Eigen::Vector3d sum = Eigen::Map<const Eigen::Vector3d>(right_hand_side(k));
    for_each_right_of_diagonal(k, [&](std::size_t c, double entry) { sum -= entry * x[c]; });
    x[k] = sum / row(k)[0];
    for (const double coordinate : x[k]) {
      if (!(std::abs(coordinate) < largest_solution)) return k;
    }
  }
  return std::nullopt;
}

}  // namespace knotwork
