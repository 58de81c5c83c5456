#include "knotwork/scene/net_figure.h"

#include <algorithm>
#include <utility>

#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/net_roll.h"

namespace knotwork::scene {

namespace {

/// Intervals that are not empty between the knots of two indices, negative when `to` is before `from`.
int cells_between(const KnotVector& knots, int from, int to) {
  int cells = 0;
  for (int k = std::min(from, to); k < std::max(from, to); ++k) cells += knots[k] < knots[k + 1] ? 1 : 0;
  return from <= to ? cells : -cells;
}

}  // namespace

int cell_count(const KnotVector& knots) { return cells_between(knots, knots.degree(), knots.last_span() + 1); }

CellRange support_cells(const KnotVector& knots, int i) {
  const int p = knots.degree();
  int first = i, last = i + p + 1;
  if (!knots.closed()) {
    first = std::clamp(first, p, knots.count());
    last = std::clamp(last, p, knots.count());
  }
  return {static_cast<double>(cells_between(knots, p, first)), static_cast<double>(cells_between(knots, p, last))};
}

CurveFigure basis_figure(const SplineDirection& direction, int count) {
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(count), Eigen::Vector3d::Zero());
  return CurveFigure(BSplineCurveObject{direction.degree, direction.topology, direction.knots, std::move(points)});
}

NetFigure::NetFigure(const BSplineSurfaceObject& object)
    : NetFigure(object, SplineDirection{}, SplineDirection{}, rest_roll(object)) {}

NetFigure::NetFigure(const BSplineSurfaceObject& object, const SplineDirection& other_u, const SplineDirection& other_v,
                     Roll roll)
    : surface(rolled_net(object, other_u, other_v, roll)),
      rows(object.rows()),
      columns(object.columns()),
      basis_u(basis_figure(object.u, object.rows())),
      basis_v(basis_figure(object.v, object.columns())) {}

void NetFigure::move(const BSplineSurfaceObject& object, const SplineDirection& other_u, const SplineDirection& other_v,
                     Roll roll) {
  surface = rolled_net(object, other_u, other_v, roll);
}

}  // namespace knotwork::scene
