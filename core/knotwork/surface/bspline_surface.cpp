#include "knotwork/surface/bspline_surface.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/point_check.h"
#include "knotwork/surface/net.h"

namespace knotwork {
namespace {

constexpr int jet_order = 2;
constexpr std::size_t most_splines = KnotVector::max_degree + 1;

/// The splines of one direction that are not 0 at a parameter, with the derivatives that a jet needs.
struct JetBasis {
  int span;
  std::array<double, (jet_order + 1) * most_splines> rows;

  void set(const KnotVector& knots, double t, int hint) {
    const std::size_t size = (jet_order + 1) * (static_cast<std::size_t>(knots.degree()) + 1);
    const double reduced = knots.reduced(t);
    span = knots.span(reduced, hint);
    bspline_basis(knots, span, reduced, jet_order, std::span(rows).first(size));
  }
};

/// For one u the sums over i of c_ij and the splines' derivatives, for as many columns j as a v needs at a time. A
/// column stays until one takes its place that is degree+1 further.
struct ColumnSums {
  struct Column {
    int j = -1;
    std::array<Eigen::Vector3d, jet_order + 1> sums;
  };
  std::array<Column, most_splines> columns;

  const std::array<Eigen::Vector3d, jet_order + 1>& at(const BSplineSurface& surface, const JetBasis& basis_u, int j) {
    Column& column = columns[static_cast<std::size_t>(j % (surface.knots_v().degree() + 1))];
    if (column.j != j) {
      column.j = j;
      const int p = surface.knots_u().degree();
      for (Eigen::Vector3d& sum : column.sums) sum.setZero();
      for (int i = 0; i <= p; ++i) {
        const Eigen::Vector3d& c = surface.point(basis_u.span - p + i, j);
        for (std::size_t k = 0; k < column.sums.size(); ++k) {
          column.sums[k] += basis_u.rows[k * (static_cast<std::size_t>(p) + 1) + static_cast<std::size_t>(i)] * c;
        }
      }
    }
    return column.sums;
  }
};

SurfaceJet jet_at(const BSplineSurface& surface, const JetBasis& basis_u, const JetBasis& basis_v,
                  ColumnSums& columns) {
  const std::size_t width = static_cast<std::size_t>(surface.knots_v().degree()) + 1;
  SurfaceJet jet;
  for (std::size_t k = 0; k < width; ++k) {
    const auto& by_u = columns.at(surface, basis_u, basis_v.span - surface.knots_v().degree() + static_cast<int>(k));
    const double b = basis_v.rows[k], b_v = basis_v.rows[width + k], b_vv = basis_v.rows[2 * width + k];
    jet.s += b * by_u[0];
    jet.su += b * by_u[1];
    jet.sv += b_v * by_u[0];
    jet.suu += b * by_u[2];
    jet.suv += b_v * by_u[1];
    jet.svv += b_vv * by_u[0];
  }
  return jet;
}

std::vector<Eigen::Vector3d> points_of(const BSplineCurve& curve) {
  return {curve.points().begin(), curve.points().end()};
}

struct RefinedRows {
  KnotVector knots;
  std::vector<Eigen::Vector3d> points;
};

/// A net whose rows are the points of curves, with one knot more. The first row tells whether the knot is possible.
Result<RefinedRows> rows_with_knot(std::span<const Eigen::Vector3d> net, const KnotVector& knots, double t) {
  const auto row_with_knot = [&](std::vector<Eigen::Vector3d> row) {
    return BSplineCurve::make(knots, std::move(row)).value().with_knot(t);
  };
  const std::span<const Eigen::Vector3d> first = net.first(static_cast<std::size_t>(knots.count()));
  const Result<BSplineCurve> probe = row_with_knot({first.begin(), first.end()});
  if (!probe) return probe.error();
  return RefinedRows{probe.value().knots(), changed_rows(net, knots.count(), [&](std::vector<Eigen::Vector3d> row) {
                       return points_of(row_with_knot(std::move(row)).value());
                     })};
}

}  // namespace

Result<BSplineSurface> BSplineSurface::make(KnotVector knots_u, KnotVector knots_v,
                                            std::vector<Eigen::Vector3d> points) {
  const std::size_t expected = static_cast<std::size_t>(knots_u.count()) * static_cast<std::size_t>(knots_v.count());
  if (points.size() != expected) {
    return Error{"points", "These knots belong to " + std::to_string(expected) + " control points, not to " +
                               std::to_string(points.size()) + "."};
  }
  if (Status status = check_points(points); !status) return status.error();
  return BSplineSurface(std::move(knots_u), std::move(knots_v), std::move(points));
}

BSplineSurface::BSplineSurface(KnotVector knots_u, KnotVector knots_v, std::vector<Eigen::Vector3d> points)
    : knots_u_(std::move(knots_u)), knots_v_(std::move(knots_v)), points_(std::move(points)) {}

const Eigen::Vector3d& BSplineSurface::point(int i, int j) const {
  return points_[static_cast<std::size_t>(i % knots_u_.count()) * static_cast<std::size_t>(knots_v_.count()) +
                 static_cast<std::size_t>(j % knots_v_.count())];
}

SurfaceJet BSplineSurface::evaluate(double u, double v) const {
  SurfaceJet jet;
  evaluate_grid({&u, 1}, {&v, 1}, {&jet, 1});
  return jet;
}

void BSplineSurface::evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const {
  assert(uv.size() == out.size());
  for (std::size_t k = 0; k < uv.size(); ++k) out[k] = evaluate(uv[k].x(), uv[k].y());
}

void BSplineSurface::evaluate_grid(std::span<const double> u, std::span<const double> v,
                                   std::span<SurfaceJet> out) const {
  assert(out.size() == u.size() * v.size());
  // v in blocks on the stack, as in BlendingSurface.
  constexpr std::size_t block = 32;
  std::array<JetBasis, block> bases_v;
  JetBasis basis_u;
  basis_u.span = knots_u_.degree();
  for (std::size_t first = 0; first < v.size(); first += block) {
    const std::size_t size = std::min(block, v.size() - first);
    for (std::size_t b = 0; b < size; ++b) {
      bases_v[b].set(knots_v_, v[first + b], b > 0 ? bases_v[b - 1].span : knots_v_.degree());
    }
    for (std::size_t a = 0; a < u.size(); ++a) {
      basis_u.set(knots_u_, u[a], basis_u.span);
      ColumnSums columns;
      for (std::size_t b = 0; b < size; ++b) {
        out[a * v.size() + first + b] = jet_at(*this, basis_u, bases_v[b], columns);
      }
    }
  }
}

void BSplineSurface::evaluate(double u, double v, int order_u, int order_v, std::span<Eigen::Vector3d> out) const {
  const int p = knots_u_.degree(), q = knots_v_.degree();
  const std::size_t orders_u = static_cast<std::size_t>(order_u) + 1, orders_v = static_cast<std::size_t>(order_v) + 1;
  const std::size_t width_u = static_cast<std::size_t>(p) + 1, width_v = static_cast<std::size_t>(q) + 1;
  assert(order_u >= 0 && order_v >= 0 && out.size() == orders_u * orders_v);
  const double reduced_u = knots_u_.reduced(u), reduced_v = knots_v_.reduced(v);
  const int span_u = knots_u_.span(reduced_u), span_v = knots_v_.span(reduced_v);
  std::vector<double> basis_u(orders_u * width_u), basis_v(orders_v * width_v);
  bspline_basis(knots_u_, span_u, reduced_u, order_u, basis_u);
  bspline_basis(knots_v_, span_v, reduced_v, order_v, basis_v);
  for (std::size_t a = 0; a < orders_u; ++a) {
    const std::span<Eigen::Vector3d> row = out.subspan(a * orders_v, orders_v);
    for (Eigen::Vector3d& partial : row) partial.setZero();
    for (std::size_t j = 0; j < width_v; ++j) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < width_u; ++i) {
        sum += basis_u[a * width_u + i] * point(span_u - p + static_cast<int>(i), span_v - q + static_cast<int>(j));
      }
      for (std::size_t b = 0; b < orders_v; ++b) row[b] += basis_v[b * width_v + j] * sum;
    }
  }
}

BSplineCurve BSplineSurface::curve_u(double v) const {
  std::vector<Eigen::Vector3d> points = changed_rows(points_, knots_v_.count(), [&](std::vector<Eigen::Vector3d> row) {
    return std::vector<Eigen::Vector3d>{BSplineCurve::make(knots_v_, std::move(row)).value()(v)};
  });
  return BSplineCurve::make(knots_u_, std::move(points)).value();
}

BSplineCurve BSplineSurface::curve_v(double u) const {
  std::vector<Eigen::Vector3d> points =
      changed_columns(points_, knots_v_.count(), [&](std::vector<Eigen::Vector3d> row) {
        return std::vector<Eigen::Vector3d>{BSplineCurve::make(knots_u_, std::move(row)).value()(u)};
      });
  return BSplineCurve::make(knots_v_, std::move(points)).value();
}

Result<BSplineSurface> BSplineSurface::with_knot_u(double u) const {
  const int n_u = knots_u_.count(), n_v = knots_v_.count();
  Result<RefinedRows> refined = rows_with_knot(transposed(points_, n_v), knots_u_, u);
  if (!refined) return Error{"u", refined.error().message};
  return BSplineSurface(refined.value().knots, knots_v_, transposed(refined.value().points, n_u + 1));
}

Result<BSplineSurface> BSplineSurface::with_knot_v(double v) const {
  Result<RefinedRows> refined = rows_with_knot(points_, knots_v_, v);
  if (!refined) return Error{"v", refined.error().message};
  return BSplineSurface(knots_u_, refined.value().knots, std::move(refined.value().points));
}

}  // namespace knotwork
