// The grids of BSplineSurface that are evaluated by the row. Fast because of what a point does not cost: the basis is
// evaluated once a row and once a column of the grid, the net is summed over u once a row, and what is left, q+1 products
// a coordinate, is the same sum for all points of a knot interval, so that neighbours share one instruction.

#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/basis/fixed_degree.h"
#include "knotwork/basis/lanes.h"
#include "knotwork/basis/point_columns.h"
#include "knotwork/surface/bspline_surface.h"
#include "knotwork/surface/frame_columns.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

constexpr std::size_t most_functions = KnotVector::max_degree + 1;

/// The basis at every v: for each place the span and, function by function, values and slopes.
class BasisAtColumns {
 public:
  BasisAtColumns(const KnotVector& knots, std::span<const double> v, int order)
      : stride_(v.size() + lane_count), spans_(v.size()) {
    const std::size_t functions = static_cast<std::size_t>(knots.degree()) + 1;
    const std::size_t rows = functions * (static_cast<std::size_t>(order) + 1);
    values_.resize(rows * stride_);
    std::array<double, 2 * most_functions> basis;
    int span = knots.degree();
    for (std::size_t m = 0; m < v.size(); ++m) {
      const double reduced = knots.reduced(v[m]);
      span = knots.span(reduced, span);
      spans_[m] = span;
      bspline_basis(knots, span, reduced, order, std::span(basis).first(rows));
      for (std::size_t k = 0; k < rows; ++k) values_[k * stride_ + m] = basis[k];
    }
  }
  /// Row k at places m, m + 1, ..: b_k, and behind the last function its slope.
  const double* at(std::size_t k, std::size_t m) const { return &values_[k * stride_ + m]; }
  int span(std::size_t m) const { return spans_[m]; }
  /// Behind the places from m on that have its span, within `end`.
  std::size_t end_of_interval(std::size_t m, std::size_t end) const {
    const int span = spans_[m];
    while (m < end && spans_[m] == span) ++m;
    return m;
  }

 private:
  std::size_t stride_;
  std::vector<int> spans_;
  std::vector<double> values_;
};

/// For one u the sums over i of b_i(u) c_ij, coordinate by coordinate, for every column j, going round where v is
/// closed.
class NetRow {
 public:
  explicit NetRow(const BSplineSurface& surface)
      : surface_(surface), columns_(static_cast<std::size_t>(surface.knots_v().last_span()) + 1), sums_(3 * columns_) {}

  /// `weights`: p+1 numbers for the rows that end with `span`.
  void set(int span, const double* weights) {
    const int p = surface_.knots_u().degree();
    for (std::size_t j = 0; j < columns_; ++j) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int i = 0; i <= p; ++i) sum += weights[i] * surface_.point(span - p + i, static_cast<int>(j));
      for (std::size_t c = 0; c < 3; ++c) sums_[c * columns_ + j] = sum[static_cast<Eigen::Index>(c)];
    }
  }
  /// A coordinate of the columns from j on.
  const double* at(std::size_t coordinate, int j) const {
    return &sums_[coordinate * columns_ + static_cast<std::size_t>(j)];
  }

 private:
  const BSplineSurface& surface_;
  std::size_t columns_;
  std::vector<double> sums_;
};

/// sum_k basis_k row_k at the places first .. end - 1 of one knot interval, whole lanes at a time.
template <int fixed_degree>
void sum_points(const NetRow& row, const BasisAtColumns& basis, int degree, std::size_t first, std::size_t end,
                std::size_t at, PointColumns<3, row_piece>& to) {
  const std::size_t functions = degree_or_fixed<fixed_degree>(degree) + 1;
  const int j = basis.span(first) - static_cast<int>(functions) + 1;
  const double *x = row.at(0, j), *y = row.at(1, j), *z = row.at(2, j);
  for (std::size_t m = first; m < end; m += lane_count, at += lane_count) {
    Lanes b, sum_x{}, sum_y{}, sum_z{};
    for (std::size_t k = 0; k < functions; ++k) {
      load(b, basis.at(k, m));
      sum_x += b * x[k];
      sum_y += b * y[k];
      sum_z += b * z[k];
    }
    store(sum_x, to.at(0, at));
    store(sum_y, to.at(1, at));
    store(sum_z, to.at(2, at));
  }
}

/// The same for S, S_u and S_v: `row_u` holds the sums of the splines' slopes.
template <int fixed_degree>
void sum_frames(const NetRow& row, const NetRow& row_u, const BasisAtColumns& basis, int degree, std::size_t first,
                std::size_t end, std::size_t at, FrameColumns& to) {
  const std::size_t functions = degree_or_fixed<fixed_degree>(degree) + 1;
  const int j = basis.span(first) - static_cast<int>(functions) + 1;
  for (std::size_t c = 0; c < 3; ++c) {
    const double *x = row.at(c, j), *x_u = row_u.at(c, j);
    for (std::size_t m = first, place = at; m < end; m += lane_count, place += lane_count) {
      Lanes b, slope, s{}, su{}, sv{};
      for (std::size_t k = 0; k < functions; ++k) {
        load(b, basis.at(k, m));
        load(slope, basis.at(functions + k, m));
        s += b * x[k];
        su += b * x_u[k];
        sv += slope * x[k];
      }
      store(s, to.at(FrameColumns::s + c, place));
      store(su, to.at(FrameColumns::su + c, place));
      store(sv, to.at(FrameColumns::sv + c, place));
    }
  }
}

}  // namespace

void BSplineSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                   std::span<Eigen::Vector3d> out) const {
  assert(out.size() == u.size() * v.size());
  const BasisAtColumns basis(knots_v_, v, 0);
  const auto sum = knots_v_.degree() == 3 ? sum_points<3> : sum_points<any_degree>;
  NetRow row(*this);
  std::array<double, most_functions> basis_u;
  PointColumns<3, row_piece> points;
  int span = knots_u_.degree();
  for (std::size_t a = 0; a < u.size(); ++a) {
    const double reduced = knots_u_.reduced(u[a]);
    span = knots_u_.span(reduced, span);
    bspline_basis(knots_u_, span, reduced, 0,
                  std::span(basis_u).first(static_cast<std::size_t>(knots_u_.degree()) + 1));
    row.set(span, basis_u.data());
    for (std::size_t first = 0; first < v.size(); first += row_piece) {
      const std::size_t end = std::min(first + row_piece, v.size());
      for (std::size_t m = first; m < end;) {
        const std::size_t next = basis.end_of_interval(m, end);
        sum(row, basis, knots_v_.degree(), m, next, m - first, points);
        m = next;
      }
      points.hand_over(end - first, out[a * v.size() + first].data());
    }
  }
}

void BSplineSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                   std::span<SurfaceFrame> out) const {
  assert(out.size() == u.size() * v.size());
  const BasisAtColumns basis(knots_v_, v, 1);
  const auto sum = knots_v_.degree() == 3 ? sum_frames<3> : sum_frames<any_degree>;
  const std::size_t functions_u = static_cast<std::size_t>(knots_u_.degree()) + 1;
  NetRow row(*this), row_u(*this);
  std::array<double, 2 * most_functions> basis_u;
  FrameColumns frames;
  int span = knots_u_.degree();
  for (std::size_t a = 0; a < u.size(); ++a) {
    const double reduced = knots_u_.reduced(u[a]);
    span = knots_u_.span(reduced, span);
    bspline_basis(knots_u_, span, reduced, 1, std::span(basis_u).first(2 * functions_u));
    row.set(span, basis_u.data());
    row_u.set(span, basis_u.data() + functions_u);
    for (std::size_t first = 0; first < v.size(); first += row_piece) {
      const std::size_t end = std::min(first + row_piece, v.size());
      for (std::size_t m = first; m < end;) {
        const std::size_t next = basis.end_of_interval(m, end);
        sum(row, row_u, basis, knots_v_.degree(), m, next, m - first, frames);
        m = next;
      }
      frames.hand_over(out.subspan(a * v.size() + first, end - first),
                       [&](std::size_t k) { return unit_normal(evaluate(u[a], v[first + k])); });
    }
  }
}

}  // namespace knotwork
