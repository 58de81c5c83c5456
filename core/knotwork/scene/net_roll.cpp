#include "knotwork/scene/net_roll.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "knotwork/scene/knot_edits.h"
#include "knotwork/scene/net_edits.h"

namespace knotwork::scene {

namespace {

/// Below this share of the way, or above its complement, a direction counts as arrived.
constexpr double smallest_share = 1e-6;

/// Where a line is: its parameter on the sheet, and the two lines whose offsets it mixes.
struct CarriedLine {
  double parameter;
  int first, second;
  double share;  ///< of the second
};

double sheet_parameter(double place) { return std::numbers::pi * (2 * place - 1); }

/// The place of each line in [0,1], before the turn to the sheet's parameter.
std::vector<double> places(const KnotVector& knots) {
  const int n = knots.count();
  const double first = greville(knots, 0);
  const double length = knots.closed() ? knots.period() : greville(knots, n - 1) - first;
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) result.push_back((greville(knots, i) - first) / length);
  return result;
}

std::vector<CarriedLine> lines_at_rest(const KnotVector& knots) {
  std::vector<CarriedLine> lines;
  int i = 0;
  for (const double place : places(knots)) {
    lines.push_back({sheet_parameter(place), i, i, 0});
    ++i;
  }
  return lines;
}

/// One direction on its way.
struct RollingDirection {
  KnotVector knots;
  std::vector<CarriedLine> lines;
};

/// `open` is clamped at its end.
RollingDirection between(const KnotVector& open, const KnotVector& closed, double share) {
  const int n = open.count(), p = open.degree();
  std::vector<double> knots;
  // Each step of this sum keeps an order, so that the knots stay sorted.
  for (int i = 0; i <= n + 2 * p; ++i) knots.push_back((1 - share) * open[std::min(i, n + p)] + share * closed[i]);
  const std::vector<double> place_open = places(open), place_closed = places(closed);
  std::vector<CarriedLine> lines;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    lines.push_back({sheet_parameter(std::lerp(place_open[k], place_closed[k], share)), i, i, 0});
  }
  for (int i = 0; i < p; ++i) {
    const double place = std::lerp(1.0, 1 + place_closed[static_cast<std::size_t>(i)], share);
    lines.push_back({sheet_parameter(place), n - 1, i, share});
  }
  return {KnotVector::make(p, Topology::open, std::move(knots)).value(), std::move(lines)};
}

Sheet bent(Sheet sheet, Roll roll) {
  sheet.bend_u = roll.u;
  sheet.bend_v = roll.v;
  return sheet;
}

/// The offsets of all points from the sheet, each in the sheet's frame.
Net offsets(const BSplineSurfaceObject& object) {
  const ModelSurface sheet = bent(object.sheet, rest_roll(object));
  const std::vector<CarriedLine> u = lines_at_rest(net_knots(object, NetDirection::u));
  const std::vector<CarriedLine> v = lines_at_rest(net_knots(object, NetDirection::v));
  Net result = object.net;
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) {
      const SurfaceJet jet = evaluate(sheet, u[i].parameter, v[j].parameter);
      result[i][j] = tangent_frame(jet).transpose() * (object.net[i][j] - jet.s);
    }
  }
  return result;
}

Net carried(const Net& offsets, const std::vector<CarriedLine>& u, const std::vector<CarriedLine>& v,
            const ModelSurface& sheet) {
  const auto mixed = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double share) -> Eigen::Vector3d {
    return (1 - share) * a + share * b;
  };
  const auto in_row = [&](int i, const CarriedLine& line) {
    const std::vector<Eigen::Vector3d>& row = offsets[static_cast<std::size_t>(i)];
    return mixed(row[static_cast<std::size_t>(line.first)], row[static_cast<std::size_t>(line.second)], line.share);
  };
  Net net;
  for (const CarriedLine& a : u) {
    net.emplace_back();
    for (const CarriedLine& b : v) {
      const SurfaceJet jet = evaluate(sheet, a.parameter, b.parameter);
      const Eigen::Vector3d offset = mixed(in_row(a.first, b), in_row(a.second, b), a.share);
      net.back().push_back(jet.s + tangent_frame(jet) * offset);
    }
  }
  return net;
}

/// The knots that a direction has in the topology that it is not in.
KnotVector knots_of_other(const KnotVector& here, const SplineDirection& other) {
  const int p = here.degree(), n = here.count();
  const Topology topology = here.closed() ? Topology::open : Topology::closed;
  if (other.degree == p && other.topology == topology) {
    Result<KnotVector> knots = KnotVector::make(p, topology, other.knots);
    if (knots && knots.value().count() == n) return std::move(knots).value();
  }
  return even_knots(p, n, topology).value();
}

RollingDirection direction_at(const BSplineSurfaceObject& object, NetDirection direction, const SplineDirection& other,
                              double share) {
  KnotVector here = net_knots(object, direction);
  const double whole = here.closed() ? 1 : 0;
  const bool can_roll = here.count() > here.degree();  // else there is no open direction of so few points
  if (std::abs(share - whole) < smallest_share || !can_roll) {
    std::vector<CarriedLine> lines = lines_at_rest(here);
    return {std::move(here), std::move(lines)};
  }
  const KnotVector there = knots_of_other(here, other);
  const KnotVector& given = here.closed() ? there : here;
  const int n = given.count(), p = given.degree();
  const KnotVector open = given[n] == given[n + p] ? given : even_knots(p, n, Topology::open).value();
  const KnotVector& closed = here.closed() ? here : there;
  return between(open, closed, std::clamp(share, smallest_share, 1 - smallest_share));
}

}  // namespace

Roll rest_roll(const BSplineSurfaceObject& object) {
  const auto closed = [](const SplineDirection& spline) { return spline.topology == Topology::closed ? 1.0 : 0.0; };
  return {closed(object.u), closed(object.v)};
}

Net net_on_sheet(const BSplineSurfaceObject& object) {
  Net still = object.net;
  for (std::vector<Eigen::Vector3d>& row : still) std::fill(row.begin(), row.end(), Eigen::Vector3d::Zero());
  return carried(still, lines_at_rest(net_knots(object, NetDirection::u)),
                 lines_at_rest(net_knots(object, NetDirection::v)), bent(object.sheet, rest_roll(object)));
}

Net carried_net(const BSplineSurfaceObject& from, const BSplineSurfaceObject& to) {
  return carried(offsets(from), lines_at_rest(net_knots(to, NetDirection::u)),
                 lines_at_rest(net_knots(to, NetDirection::v)), bent(from.sheet, rest_roll(to)));
}

BSplineSurface rolled_net(const BSplineSurfaceObject& object, const SplineDirection& other_u,
                          const SplineDirection& other_v, Roll roll) {
  const RollingDirection u = direction_at(object, NetDirection::u, other_u, roll.u);
  const RollingDirection v = direction_at(object, NetDirection::v, other_v, roll.v);
  const Roll rest = rest_roll(object);
  if (rest.u == roll.u && rest.v == roll.v) return build_net(object).value();
  const Net net = carried(offsets(object), u.lines, v.lines, bent(object.sheet, roll));
  std::vector<Eigen::Vector3d> points;
  for (const std::vector<Eigen::Vector3d>& row : net) points.insert(points.end(), row.begin(), row.end());
  return BSplineSurface::make(u.knots, v.knots, std::move(points)).value();
}

}  // namespace knotwork::scene
