#include "knotwork/scene/net_edits.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "knotwork/curve/bspline_refinement.h"
#include "knotwork/scene/knot_edits.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/messages.h"
#include "knotwork/scene/net_roll.h"
#include "knotwork/surface/net.h"

namespace knotwork::scene {

namespace {

std::string letter(NetDirection direction) { return direction == NetDirection::u ? "u" : "v"; }
std::string lines(NetDirection direction) { return direction == NetDirection::u ? "rows" : "columns"; }

SplineDirection& in_direction(BSplineSurfaceObject& object, NetDirection direction) {
  return direction == NetDirection::u ? object.u : object.v;
}

/// "A closed direction of degree 3 needs at least 3 rows."
std::string too_few(NetDirection direction, int degree, Topology topology) {
  return std::string(topology == Topology::closed ? "A closed" : "An open") + " direction of degree " +
         std::to_string(degree) + " needs at least " + std::to_string(least_points(degree, topology)) + " " +
         lines(direction) + ".";
}

/// Row by row.
std::vector<Eigen::Vector3d> flat(const Net& net) {
  std::vector<Eigen::Vector3d> points;
  for (const std::vector<Eigen::Vector3d>& row : net) points.insert(points.end(), row.begin(), row.end());
  return points;
}

Net in_rows(std::span<const Eigen::Vector3d> points, int columns) {
  Net net;
  const auto width = static_cast<std::size_t>(columns);
  for (std::size_t first = 0; first < points.size(); first += width) {
    const std::span<const Eigen::Vector3d> row = points.subspan(first, width);
    net.emplace_back(row.begin(), row.end());
  }
  return net;
}

Result<KnotVector> knots_in(const BSplineSurfaceObject& object, NetDirection direction) {
  const SplineDirection& spline = direction_of(object, direction);
  const int lines_here = line_count(object, direction), p = spline.degree;
  if (lines_here < least_points(p, spline.topology)) return Error{"net", too_few(direction, p, spline.topology)};
  const std::string place = "knots." + letter(direction);
  const std::size_t wanted =
      static_cast<std::size_t>(spline.topology == Topology::closed ? lines_here + 2 * p + 1 : lines_here + p + 1);
  if (spline.knots.size() != wanted) {
    return Error{place, std::to_string(lines_here) + " " + lines(direction) + " of degree " + std::to_string(p) +
                            " need " + std::to_string(wanted) + " knots, not " + std::to_string(spline.knots.size()) +
                            "."};
  }
  Result<KnotVector> knots = KnotVector::make(p, spline.topology, spline.knots);
  if (knots) return knots;
  const std::string& path = knots.error().path;
  return Error{path.starts_with("knots") ? place + path.substr(5) : place, knots.error().message};
}

void set_knots(BSplineSurfaceObject& object, NetDirection direction, const KnotVector& knots) {
  in_direction(object, direction) = {knots.degree(), knots.topology(), {knots.knots().begin(), knots.knots().end()}};
}

/// The curves that the lines across a direction's lines are the control polygons of: `change` makes another curve of
/// each. All keep to the same knots, since what becomes of these asks the knots alone.
template <class Change>
void change_curves(BSplineSurfaceObject& object, NetDirection direction, const Change& change) {
  const KnotVector knots = net_knots(object, direction);
  std::optional<KnotVector> changed;
  const auto change_line = [&](std::vector<Eigen::Vector3d> line) {
    const BSplineCurve curve = change(BSplineCurve::make(knots, std::move(line)).value());
    if (!changed) changed = curve.knots();
    return std::vector<Eigen::Vector3d>(curve.points().begin(), curve.points().end());
  };
  const bool along_u = direction == NetDirection::u;
  const std::vector<Eigen::Vector3d> points = flat(object.net);
  const std::vector<Eigen::Vector3d> finer = along_u ? changed_columns(points, object.columns(), change_line)
                                                     : changed_rows(points, object.columns(), change_line);
  object.net = in_rows(finer, along_u ? object.columns() : changed->count());
  set_knots(object, direction, *changed);
}

/// What the removal of a knot would cost: the greatest deviation of any line. Nothing where it cannot go.
std::optional<double> removal_cost(const BSplineSurfaceObject& object, NetDirection direction, double t) {
  const KnotVector knots = net_knots(object, direction);
  std::optional<double> cost;
  const bool along_u = direction == NetDirection::u;
  const int across = along_u ? object.columns() : object.rows();
  const std::vector<Eigen::Vector3d> lines_along =
      along_u ? transposed(flat(object.net), object.columns()) : flat(object.net);
  const auto length = static_cast<std::size_t>(knots.count());
  for (std::size_t k = 0; k < static_cast<std::size_t>(across); ++k) {
    const std::span<const Eigen::Vector3d> line = std::span(lines_along).subspan(k * length, length);
    const Result<KnotRemoval> removal = without_knot(BSplineCurve::make(knots, {line.begin(), line.end()}).value(), t);
    if (!removal) return std::nullopt;
    cost = std::max(cost.value_or(0), removal.value().deviation);
  }
  return cost;
}

double widest_middle(const KnotVector& knots) {
  int widest = knots.degree();
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    // Wider by more than rounding: of equal ones the first.
    if (knots[i + 1] - knots[i] > (1 + 1e-9) * (knots[widest + 1] - knots[widest])) widest = i;
  }
  return (knots[widest] + knots[widest + 1]) / 2;
}

Status add_line(BSplineSurfaceObject& object, NetDirection direction) {
  return insert_net_line(object, direction, widest_middle(net_knots(object, direction)));
}

Status take_line(BSplineSurfaceObject& object, NetDirection direction) {
  const KnotVector knots = net_knots(object, direction);
  std::optional<double> best;
  double place = 0;
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    if (i > knots.degree() && knots[i] == knots[i - 1]) continue;
    const std::optional<double> cost = removal_cost(object, direction, knots[i]);
    if (!cost || (best && *cost >= *best)) continue;
    best = cost;
    place = knots[i];
  }
  if (!best) return Error{"count", too_few(direction, knots.degree(), knots.topology())};
  change_curves(object, direction, [&](const BSplineCurve& curve) { return without_knot(curve, place).value().curve; });
  return success();
}

void erase_line(Net& net, NetDirection direction, int index) {
  if (direction == NetDirection::u) {
    net.erase(net.begin() + index);
  } else {
    for (std::vector<Eigen::Vector3d>& row : net) row.erase(row.begin() + index);
  }
}

}  // namespace

const SplineDirection& direction_of(const BSplineSurfaceObject& object, NetDirection direction) {
  return direction == NetDirection::u ? object.u : object.v;
}

int line_count(const BSplineSurfaceObject& object, NetDirection direction) {
  return direction == NetDirection::u ? object.rows() : object.columns();
}

Result<BSplineSurface> build_net(const BSplineSurfaceObject& object) {
  Result<KnotVector> u = knots_in(object, NetDirection::u), v = knots_in(object, NetDirection::v);
  if (!u) return u.error();
  if (!v) return v.error();
  return BSplineSurface::make(std::move(u).value(), std::move(v).value(), flat(object.net));
}

KnotVector net_knots(const BSplineSurfaceObject& object, NetDirection direction) {
  return knots_in(object, direction).value();
}

Status set_net_point(BSplineSurfaceObject& object, PatchIndex point, const Eigen::Vector3d& position) {
  const auto [i, j] = point;
  if (i < 0 || j < 0 || i >= object.rows() || j >= object.columns())
    return Error{"point", "There is no point " + std::to_string(i) + ", " + std::to_string(j) + "."};
  for (int k = 0; k < 3; ++k)
    if (!limits::coordinate.contains(position[k])) return Error{"position", number_message(limits::coordinate)};
  object.net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = position;
  return success();
}

Status insert_net_line(BSplineSurfaceObject& object, NetDirection direction, double at) {
  const KnotVector knots = net_knots(object, direction);
  if (line_count(object, direction) >= max_net)
    return Error{"at", "A net has at most " + std::to_string(max_net) + " " + lines(direction) + "."};
  if (!Limits{knots.start(), knots.end()}.contains(at))
    return Error{"at", number_message({knots.start(), knots.end()})};
  const int most = knots.closed() || (at > knots.start() && at < knots.end()) ? knots.degree() : knots.degree() + 1;
  if (knots.multiplicity(at) >= most) return Error{"at", "The knots here leave no room for another one."};
  change_curves(object, direction, [&](const BSplineCurve& curve) { return curve.with_knot(at).value(); });
  return success();
}

double place_after(const BSplineSurfaceObject& object, NetDirection direction, int index) {
  const KnotVector knots = net_knots(object, direction);
  const int n = knots.count();
  if (knots.closed()) {
    const double next = index + 1 < n ? greville(knots, index + 1) : greville(knots, 0) + knots.period();
    return knots.reduced((greville(knots, index) + next) / 2);
  }
  const int before = std::clamp(index, 0, n - 2);
  return std::clamp((greville(knots, before) + greville(knots, before + 1)) / 2, knots.start(), knots.end());
}

Status remove_net_line(BSplineSurfaceObject& object, NetDirection direction, int index) {
  const KnotVector knots = net_knots(object, direction);
  const int p = knots.degree(), n = knots.count();
  if (index < 0 || index >= n)
    return Error{"index", "There are no " + lines(direction) + " but 0 to " + std::to_string(n - 1) + "."};
  if (n - 1 < least_points(p, knots.topology())) return Error{"index", too_few(direction, p, knots.topology())};
  const Result<KnotVector> fewer =
      evenly_spaced(knots) ? even_knots(p, n - 1, knots.topology()) : without_knot_of(knots, index);
  if (!fewer) return Error{"index", fewer.error().message};
  set_knots(object, direction, fewer.value());
  erase_line(object.net, direction, index);
  return success();
}

Status set_line_count(BSplineSurfaceObject& object, NetDirection direction, int count) {
  if (!limits::net.contains(count)) return Error{"count", integer_message(limits::net)};
  BSplineSurfaceObject changed = object;
  while (line_count(changed, direction) != count) {
    const bool more = line_count(changed, direction) < count;
    if (const Status status = more ? add_line(changed, direction) : take_line(changed, direction); !status)
      return Error{"count", status.error().message};
  }
  object = std::move(changed);
  return success();
}

Status set_net_knot(BSplineSurfaceObject& object, NetDirection direction, int index, double value) {
  Result<std::vector<double>> moved = with_knot_moved(net_knots(object, direction), index, value);
  if (!moved) return moved.error();
  in_direction(object, direction).knots = std::move(moved).value();
  return success();
}

Status set_net_degree(BSplineSurfaceObject& object, NetDirection direction, int degree) {
  if (!limits::degree.contains(degree)) return Error{"degree", integer_message(limits::degree)};
  const Topology topology = direction_of(object, direction).topology;
  const int n = line_count(object, direction);
  const bool enough = n >= least_points(degree, topology);
  if (!enough && topology == Topology::closed) return Error{"degree", too_few(direction, degree, topology)};
  set_knots(object, direction, even_knots(enough ? degree : n - 1, n, topology).value());
  while (direction_of(object, direction).degree < degree)
    change_curves(object, direction, [](const BSplineCurve& curve) { return elevated(curve).value(); });
  return success();
}

Status set_net_topology(BSplineSurfaceObject& object, NetDirection direction, Topology topology) {
  const SplineDirection& spline = direction_of(object, direction);
  if (spline.topology == topology) return success();
  const int n = line_count(object, direction);
  if (n < least_points(spline.degree, topology)) return Error{"topology", too_few(direction, spline.degree, topology)};
  BSplineSurfaceObject rolled = object;
  set_knots(rolled, direction, even_knots(spline.degree, n, topology).value());
  rolled.net = carried_net(object, rolled);
  for (const std::vector<Eigen::Vector3d>& row : rolled.net) {
    for (const Eigen::Vector3d& point : row) {
      if (point.cwiseAbs().maxCoeff() > limits::coordinate.max)
        return Error{"topology", "A point of the net would leave the space that there is."};
    }
  }
  object = std::move(rolled);
  return success();
}

}  // namespace knotwork::scene
