#include "knotwork/scene/net_roll.h"

#include <cmath>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/net_figure.h"

namespace knotwork::scene::net_roll_test {
namespace {

BSplineSurfaceObject start() {
  const Document document = find_chapter("tensor-surface")->start_document();
  return *std::get_if<BSplineSurfaceObject>(&stage_shape(document));
}

BSplineSurfaceObject closed(BSplineSurfaceObject object, bool u, bool v) {
  if (u) REQUIRE(set_net_topology(object, NetDirection::u, Topology::closed));
  if (v) REQUIRE(set_net_topology(object, NetDirection::v, Topology::closed));
  return object;
}

/// The largest distance of two surfaces at equal shares of their domains.
double distance(const BSplineSurface& s, const BSplineSurface& t) {
  double largest = 0;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const auto at = [&](const BSplineSurface& x) {
        return x.evaluate(std::lerp(x.knots_u().start(), x.knots_u().end(), i / 20.0),
                          std::lerp(x.knots_v().start(), x.knots_v().end(), j / 20.0));
      };
      // A closed direction's end is its start.
      largest = std::max(largest, (at(s).s - at(t).s).norm());
    }
  }
  return largest;
}

double greatest(const Net& a, const Net& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j) largest = std::max(largest, (a[i][j] - b[i][j]).norm());
  return largest;
}

}  // namespace

TEST_CASE("net roll: a net on the sheet rolls to plane, cylinder and torus") {
  BSplineSurfaceObject flat = start();
  flat.net = net_on_sheet(flat);
  for (const auto& row : flat.net)
    for (const Eigen::Vector3d& point : row) CHECK(std::abs(point.x()) < 1e-14);
  const double ru = flat.sheet.closed_radius_u, rv = flat.sheet.closed_radius_v;
  for (const auto& row : closed(flat, true, false).net)
    for (const Eigen::Vector3d& point : row) CHECK(std::hypot(point.x(), point.y()) == doctest::Approx(ru));
  for (const auto& row : closed(flat, true, true).net) {
    for (const Eigen::Vector3d& point : row) {
      const double from_wheel = std::hypot(point.x(), point.y()) - ru;
      CHECK(std::hypot(from_wheel, point.z()) == doctest::Approx(rv));
    }
  }
}

TEST_CASE("net roll: there and back the net is what it was, in either order") {
  const BSplineSurfaceObject object = start();
  for (const bool u_first : {true, false}) {
    BSplineSurfaceObject rolled = object;
    const NetDirection first = u_first ? NetDirection::u : NetDirection::v;
    const NetDirection second = u_first ? NetDirection::v : NetDirection::u;
    REQUIRE(set_net_topology(rolled, first, Topology::closed));
    REQUIRE(set_net_topology(rolled, second, Topology::closed));
    CHECK(greatest(rolled.net, object.net) > 0.5);
    REQUIRE(set_net_topology(rolled, first, Topology::open));
    REQUIRE(set_net_topology(rolled, second, Topology::open));
    CHECK(greatest(rolled.net, object.net) < 1e-13);
    CHECK(rolled.u == object.u);
    CHECK(rolled.v == object.v);
  }
}

TEST_CASE("net roll: what was pulled outwards stays so in the sheet's own frame") {
  const BSplineSurfaceObject object = start();
  const BSplineSurfaceObject torus = closed(object, true, true);
  BSplineSurfaceObject plain = torus;
  plain.net = net_on_sheet(plain);
  const Eigen::Vector3d offset = torus.net[3][2] - plain.net[3][2];
  CHECK(offset.norm() == doctest::Approx(1.6));
  // Away from the middle of the tube.
  const Eigen::Vector3d wheel =
      torus.sheet.closed_radius_u * Eigen::Vector3d(plain.net[3][2].x(), plain.net[3][2].y(), 0).normalized();
  CHECK(offset.normalized().dot((plain.net[3][2] - wheel).normalized()) == doctest::Approx(1));
}

TEST_CASE("net roll: half way nothing jumps, at either end and in between") {
  for (const bool u : {true, false}) {
    for (const bool uneven : {false, true}) {
      CAPTURE(u);
      CAPTURE(uneven);
      BSplineSurfaceObject open = start();
      const NetDirection direction = u ? NetDirection::u : NetDirection::v;
      if (uneven) REQUIRE(set_line_count(open, direction, 7));
      const BSplineSurfaceObject shut = closed(open, u, !u);
      const SplineDirection none;
      const auto at = [&](const BSplineSurfaceObject& object, const SplineDirection& other, double share) {
        return rolled_net(object, u ? other : none, u ? none : other, {u ? share : 0, u ? 0 : share});
      };
      const SplineDirection& open_knots = direction_of(open, direction);
      CHECK(distance(at(shut, open_knots, 0), build_net(open).value()) < 1e-4);
      CHECK(distance(at(shut, open_knots, 1), build_net(shut).value()) == 0);
      CHECK(distance(at(open, direction_of(shut, direction), 1), build_net(shut).value()) < 1e-4);
      CHECK(distance(at(open, direction_of(shut, direction), 0), build_net(open).value()) == 0);
      double largest_step = 0;
      for (int k = 0; k < 200; ++k) {
        const BSplineSurface here = at(shut, open_knots, k / 200.0), next = at(shut, open_knots, (k + 1) / 200.0);
        if (k < 199) largest_step = std::max(largest_step, distance(here, next));
        CHECK(distance(at(open, direction_of(shut, direction), k / 200.0), here) < 1e-4);
      }
      CHECK(largest_step < 0.15);
    }
  }
}

TEST_CASE("net roll: a direction without room to open is shown as it is") {
  BSplineSurfaceObject object = closed(start(), true, true);
  REQUIRE(set_net_degree(object, NetDirection::v, 5));
  const BSplineSurface half = rolled_net(object, {}, {}, {1, 0.5});
  CHECK(half.knots_v().closed());
  CHECK(half.evaluate(0.2, 0.3).s.allFinite());
}

TEST_CASE("net figure: the support of a point in cells of the knot lines") {
  BSplineSurfaceObject object = start();
  const auto cells = [&](int i) {
    const CellRange range = support_cells(net_knots(object, NetDirection::u), i);
    return std::pair(range.start, range.end);
  };
  CHECK(cell_count(net_knots(object, NetDirection::u)) == 3);
  CHECK(cells(0) == std::pair(0.0, 1.0));
  CHECK(cells(3) == std::pair(0.0, 3.0));
  CHECK(cells(5) == std::pair(2.0, 3.0));
  object.u.knots[4] = 2;  // a double knot: one cell less
  CHECK(cell_count(net_knots(object, NetDirection::u)) == 2);
  CHECK(cells(5) == std::pair(1.0, 2.0));
  object = closed(object, true, false);
  CHECK(cell_count(net_knots(object, NetDirection::u)) == 6);
  CHECK(cells(0) == std::pair(-3.0, 1.0));
  CHECK(cells(5) == std::pair(2.0, 6.0));
}

TEST_CASE("net figure: basis functions sum to 1 and belong to the object's own knots") {
  const BSplineSurfaceObject object = closed(start(), false, true);
  const NetFigure figure(object);
  CHECK(figure.rows == 6);
  CHECK(figure.columns == 5);
  for (const CurveFigure* basis : {&figure.basis_u, &figure.basis_v}) {
    for (std::size_t k = 0; k < basis->samples.size(); ++k) {
      double sum = 0;
      for (int i = 0; i < basis->curve.knots().count(); ++i) sum += basis->weight(k, i);
      CHECK(std::abs(sum - 1) < 1e-13);
    }
  }
  CHECK(figure.basis_u.curve.knots().count() == 6);
  CHECK(figure.basis_v.curve.knots().closed());
}

}  // namespace knotwork::scene::net_roll_test
