#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/row_block.h"

namespace knotwork {

/// min |A x - b|, A of n columns and any number of rows, b of three right-hand sides, by Householder reflections: only
/// the triangle R of A = Q R is kept, and rows of A are worked into it as they come (sequential accumulation: Lawson
/// and Hanson, Solving Least Squares Problems, ch. 27).
///
/// The nonzeros of a row stand in `width` neighbouring columns. R then has the same width and n rows: m rows of A cost
/// O(m width^2) time, and no memory. In a closed problem columns go round, n-1 having 0 as its neighbour; the rows that
/// do so are gathered in a small triangle of their own and swept through R at the end, once: O(n width^2).
/// Orthogonal on purpose: the normal equations A'A x = A'b square the condition number, so that data in bad places cost
/// them twice as many digits.
class BandedTriangle {
 public:
  static constexpr std::size_t right_hand_sides = 3;

  /// Precondition: columns >= width - 1 when closed, columns >= 1.
  BandedTriangle(std::size_t columns, std::size_t width, Topology topology);

  /// Rows with their nonzeros in columns first .. first + width - 1 (closed: modulo n; open: those >= n are zero).
  /// `rows` holds these columns, then the right-hand sides; it is overwritten. `first` never decreases.
  void add(std::size_t first, RowBlock& rows);

  /// x[k] = value instead of what the rows say. Precondition: column k of all rows is zero.
  void fix(std::size_t k, const Eigen::Vector3d& value);

  /// The solution, into x (n points); or the column that, numerically, depends on those before it: its pivot is below
  /// 1e-13 of the column's norm. Call it once, when all rows are in.
  std::optional<std::size_t> solve(std::span<Eigen::Vector3d> x);

 private:
  std::size_t seam_column(std::size_t c) const;
  void add_to_seam(std::size_t first, RowBlock& rows);
  void sweep_seam();
  double* row(std::size_t k) { return triangle_.data() + k * (width_ + right_hand_sides); }
  double* right_hand_side(std::size_t k) { return row(k) + width_; }
  template <class Visit>
  void for_each_right_of_diagonal(std::size_t k, Visit visit);

  std::size_t columns_, width_;
  bool closed_;
  /// n rows (and width-1 more, of zeros): R_kk .. R_{k,k+width-1}, then the right-hand sides.
  std::vector<double> triangle_;
  /// Closed: R_{k,n-width+1} .. R_{k,n-1}, where they stand right of the band.
  std::vector<double> border_;
  /// Closed: the triangle of the rows that go round.
  std::vector<double> seam_;
  std::size_t last_first_ = 0;
};

}  // namespace knotwork
