#include "knotwork/surface/bezier_surface.h"

#include <cassert>
#include <cstddef>

#include "knotwork/curve/bezier_curve.h"
#include "knotwork/surface/net.h"

namespace knotwork {
namespace {

using Points = std::vector<Eigen::Vector3d>;

static_assert(max_bezier_degree == KnotVector::max_degree);

/// The one interval of a direction, its ends p+1 times.
Result<KnotVector> bezier_knots(int degree, double start, double end) {
  return KnotVector::uniform(degree, degree + 1, Topology::open, start, end);
}

/// How far along the domain a parameter is, clamped to it.
double share_at(const KnotVector& knots, double t) { return (knots.reduced(t) - knots.start()) / knots.period(); }

/// One round in the direction of the columns: neighbours divided in the ratio w : 1-w. A single column stays.
PointNet between_columns(const PointNet& net, double w) {
  if (net.columns == 1) return net;
  return {net.rows, net.columns - 1, changed_rows(net.points, net.columns, [w](const Points& row) {
            Points next;
            for (std::size_t j = 0; j + 1 < row.size(); ++j) next.emplace_back((1 - w) * row[j] + w * row[j + 1]);
            return next;
          })};
}

PointNet exchanged(const PointNet& net) { return {net.columns, net.rows, transposed(net.points, net.columns)}; }

Points elevated_row(Points row) {
  const BezierCurve curve = BezierCurve::make(std::move(row)).value().elevated();
  return {curve.points().begin(), curve.points().end()};
}

/// The points of the part before or behind t of every row.
Points part_of_rows(const Points& net, const KnotVector& knots, double t, bool behind) {
  return changed_rows(net, knots.count(), [&](Points row) {
    const BezierCurve curve = BezierCurve::make(std::move(row), knots.start(), knots.end()).value();
    const auto [before, after] = curve.split(t);
    const BezierCurve& part = behind ? after : before;
    return Points(part.points().begin(), part.points().end());
  });
}

}  // namespace

Result<BezierSurface> BezierSurface::make(int degree_u, int degree_v, std::vector<Eigen::Vector3d> points,
                                          const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  const Result<KnotVector> u = bezier_knots(degree_u, start.x(), end.x());
  if (!u) return Error{u.error().path == "degree" ? "degree_u" : u.error().path, u.error().message};
  const Result<KnotVector> v = bezier_knots(degree_v, start.y(), end.y());
  if (!v) return Error{v.error().path == "degree" ? "degree_v" : v.error().path, v.error().message};
  Result<BSplineSurface> spline = BSplineSurface::make(u.value(), v.value(), std::move(points));
  if (!spline) return spline.error();
  return BezierSurface(std::move(spline).value());
}

std::vector<PointNet> BezierSurface::de_casteljau(double u, double v) const {
  const double w_u = share_at(spline_.knots_u(), u), w_v = share_at(spline_.knots_v(), v);
  std::vector<PointNet> nets{{degree_u() + 1, degree_v() + 1, {points().begin(), points().end()}}};
  while (nets.back().rows > 1 || nets.back().columns > 1) {
    nets.push_back(exchanged(between_columns(exchanged(between_columns(nets.back(), w_v)), w_u)));
  }
  return nets;
}

BezierSurface BezierSurface::elevated_u() const {
  assert(degree_u() < max_bezier_degree);
  return make(degree_u() + 1, degree_v(), changed_columns(points(), degree_v() + 1, elevated_row), start(), end())
      .value();
}

BezierSurface BezierSurface::elevated_v() const {
  assert(degree_v() < max_bezier_degree);
  return make(degree_u(), degree_v() + 1, changed_rows(points(), degree_v() + 1, elevated_row), start(), end()).value();
}

std::pair<BezierSurface, BezierSurface> BezierSurface::split_u(double u) const {
  assert(start().x() < u && u < end().x());
  const Points net = transposed(points(), degree_v() + 1);
  const auto part = [&](bool behind, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    Points columns = part_of_rows(net, spline_.knots_u(), u, behind);
    return make(degree_u(), degree_v(), transposed(columns, degree_u() + 1), from, to).value();
  };
  return {part(false, start(), {u, end().y()}), part(true, {u, start().y()}, end())};
}

std::pair<BezierSurface, BezierSurface> BezierSurface::split_v(double v) const {
  assert(start().y() < v && v < end().y());
  const Points net(points().begin(), points().end());
  const auto part = [&](bool behind, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return make(degree_u(), degree_v(), part_of_rows(net, spline_.knots_v(), v, behind), from, to).value();
  };
  return {part(false, start(), {end().x(), v}), part(true, {start().x(), v}, end())};
}

}  // namespace knotwork
