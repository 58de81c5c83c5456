#include "knotwork/basis/bernstein.h"

#include <cassert>
#include <cstddef>

namespace knotwork {
namespace {

/// A row of k numbers becomes one of k+1: out_j = left * in_{j-1} + right * in_j, the outside being 0. In place.
void spread(std::span<double> row, int k, double left, double right) {
  row[static_cast<std::size_t>(k)] = 0;
  for (std::size_t j = static_cast<std::size_t>(k); j > 0; --j) row[j] = left * row[j - 1] + right * row[j];
  row[0] *= right;
}

}  // namespace

void bernstein(int degree, double t, std::span<double> out) { bernstein_derivative(degree, t, 0, 1, out); }

void bernstein_derivative(int degree, double t, int order, double delta, std::span<double> out) {
  assert(degree >= 0 && degree <= max_bezier_degree && order >= 0);
  assert(out.size() == static_cast<std::size_t>(degree) + 1);
  if (order > degree) {
    for (double& value : out) value = 0;
    return;
  }
  // D b_{p,k} = p (b_{p-1,k-1} - b_{p-1,k}): the polynomials of the lower degree, differenced `order` times.
  out[0] = 1;
  for (int k = 1; k <= degree; ++k) {
    const bool differenced = k > degree - order;
    spread(out, k, differenced ? k * delta : t, differenced ? -k * delta : 1 - t);
  }
}

Eigen::MatrixXd bernstein_hermite(int degree, double t, double delta) {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(degree + 1, degree + 1);
  const std::size_t width = static_cast<std::size_t>(degree) + 1;
  for (int r = 0; r <= degree; ++r) bernstein_derivative(degree, t, r, delta, {rows.row(r).data(), width});
  return rows;
}

}  // namespace knotwork
