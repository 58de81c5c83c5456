#include "knotwork/scene/net_edits.h"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/history.h"
#include "knotwork/scene/knot_edits.h"

namespace knotwork::scene::net_edits_test {
namespace {

constexpr std::array<NetDirection, 2> both{NetDirection::u, NetDirection::v};

BSplineSurfaceObject start() {
  const Document document = find_chapter("tensor-surface")->start_document();
  return *std::get_if<BSplineSurfaceObject>(&stage_shape(document));
}

SplineDirection even_direction(int degree, int count, Topology topology) {
  const KnotVector knots = even_knots(degree, count, topology).value();
  return {degree, topology, {knots.knots().begin(), knots.knots().end()}};
}

BSplineSurfaceObject random_net(std::mt19937& random, const SplineDirection& u, int rows, const SplineDirection& v,
                                int columns) {
  std::uniform_real_distribution<double> coordinate(-2, 2);
  BSplineSurfaceObject object;
  object.u = u;
  object.v = v;
  object.net.assign(static_cast<std::size_t>(rows), std::vector<Eigen::Vector3d>(static_cast<std::size_t>(columns)));
  for (auto& row : object.net)
    for (Eigen::Vector3d& point : row) point = {coordinate(random), coordinate(random), coordinate(random)};
  return object;
}

/// The largest distance of two surfaces, at equal shares of their domains.
double distance(const BSplineSurfaceObject& a, const BSplineSurfaceObject& b) {
  const BSplineSurface s = build_net(a).value(), t = build_net(b).value();
  double largest = 0;
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < 24; ++j) {
      const auto at = [&](const BSplineSurface& x) {
        return x.evaluate(std::lerp(x.knots_u().start(), x.knots_u().end(), i / 23.5),
                          std::lerp(x.knots_v().start(), x.knots_v().end(), j / 23.5));
      };
      largest = std::max(largest, (at(s).s - at(t).s).norm());
    }
  }
  return largest;
}

std::string path_of(const Status& status) { return status ? "accepted" : status.error().path; }

}  // namespace

TEST_CASE("net edits: a line more keeps the surface, wherever its knot comes") {
  std::mt19937 random(3);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const int degree : {1, 2, 3, 5, 9}) {
      CAPTURE(degree);
      const SplineDirection spline = even_direction(degree, degree + 3, topology);
      const BSplineSurfaceObject object = random_net(random, spline, degree + 3, spline, degree + 3);
      for (const NetDirection direction : both) {
        for (int index = 0; index < degree + 3; ++index) {
          BSplineSurfaceObject finer = object;
          REQUIRE(insert_net_line(finer, direction, place_after(object, direction, index)));
          CHECK(line_count(finer, direction) == degree + 4);
          CHECK(distance(object, finer) < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("net edits: lines by number come without a change of the surface, and are taken back exactly") {
  for (const Topology topology : {Topology::open, Topology::closed}) {
    BSplineSurfaceObject object = start();
    REQUIRE(set_net_topology(object, NetDirection::u, topology));
    for (const NetDirection direction : both) {
      BSplineSurfaceObject finer = object;
      const int count = line_count(object, direction);
      REQUIRE(set_line_count(finer, direction, count + 5));
      CHECK(line_count(finer, direction) == count + 5);
      CHECK(distance(object, finer) < 1e-12);
      REQUIRE(set_line_count(finer, direction, count));
      CHECK(distance(object, finer) < 1e-10);
      CHECK(direction_of(finer, direction).knots.size() == direction_of(object, direction).knots.size());
    }
  }
  BSplineSurfaceObject object = start();
  const BSplineSurfaceObject before = object;
  CHECK(path_of(set_line_count(object, NetDirection::u, 3)) == "count");
  CHECK(path_of(set_line_count(object, NetDirection::v, max_net + 1)) == "count");
  CHECK(object == before);
  REQUIRE(set_line_count(object, NetDirection::u, 4));  // no inner knots are left: a Bezier surface's rows
  CHECK(object.u.knots == std::vector<double>{0, 0, 0, 0, 3, 3, 3, 3});
}

TEST_CASE("net edits: a line that goes leaves the other points where they are") {
  for (const NetDirection direction : both) {
    BSplineSurfaceObject object = start();
    REQUIRE(set_line_count(object, direction, 8));  // the knots are no longer even
    for (const int index : {0, 3, 7}) {
      BSplineSurfaceObject fewer = object;
      REQUIRE(remove_net_line(fewer, direction, index));
      REQUIRE(build_net(fewer).has_value());
      CHECK(line_count(fewer, direction) == 7);
      for (int k = 0; k < 7; ++k) {
        const std::size_t from = static_cast<std::size_t>(k < index ? k : k + 1), to = static_cast<std::size_t>(k);
        if (direction == NetDirection::u) CHECK(fewer.net[to] == object.net[from]);
        if (direction == NetDirection::v) CHECK(fewer.net[2][to] == object.net[2][from]);
      }
    }
    CHECK(path_of(remove_net_line(object, direction, 8)) == "index");
    CHECK(path_of(remove_net_line(object, direction, -1)) == "index");
  }
  BSplineSurfaceObject even = start();
  REQUIRE(remove_net_line(even, NetDirection::u, 2));
  CHECK(evenly_spaced(net_knots(even, NetDirection::u)));
  REQUIRE(remove_net_line(even, NetDirection::u, 0));
  CHECK(remove_net_line(even, NetDirection::u, 0).error().message ==
        "An open direction of degree 3 needs at least 4 rows.");
}

TEST_CASE("net edits: a degree takes the same points, and where they are too few it elevates the surface") {
  BSplineSurfaceObject object = start();
  REQUIRE(set_net_degree(object, NetDirection::u, 5));
  CHECK(object.net == start().net);
  CHECK(object.u.knots == std::vector<double>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  BSplineSurfaceObject raised = object;
  REQUIRE(set_net_degree(raised, NetDirection::u, 9));
  CHECK(raised.rows() == 10);
  CHECK(raised.u.degree == 9);
  CHECK(distance(object, raised) < 1e-12);
  BSplineSurfaceObject at_once = start();
  REQUIRE(set_net_degree(at_once, NetDirection::u, 9));  // whichever way a slider goes
  CHECK(distance(at_once, raised) < 1e-12);
  CHECK(at_once.rows() == raised.rows());

  BSplineSurfaceObject closed = start();
  REQUIRE(set_net_topology(closed, NetDirection::v, Topology::closed));
  REQUIRE(set_net_degree(closed, NetDirection::v, 5));
  const BSplineSurfaceObject before = closed;
  CHECK(set_net_degree(closed, NetDirection::v, 6).error().message ==
        "A closed direction of degree 6 needs at least 6 columns.");
  CHECK(path_of(set_net_degree(closed, NetDirection::v, 10)) == "degree");
  CHECK(path_of(set_net_degree(closed, NetDirection::v, 0)) == "degree");
  CHECK(path_of(set_net_topology(closed, NetDirection::v, Topology::open)) == "topology");
  CHECK(closed == before);
}

TEST_CASE("net edits: a point moves the surface within its support alone") {
  BSplineSurfaceObject object = start();
  const BSplineSurface before = build_net(object).value();
  REQUIRE(set_net_point(object, {5, 0}, {4, 4, 4}));
  const BSplineSurface after = build_net(object).value();
  // b_5 of u lives on [2,3], b_0 of v on [0,1].
  CHECK((after.evaluate(2.5, 0.5).s - before.evaluate(2.5, 0.5).s).norm() > 1e-3);
  CHECK(after.evaluate(1.9, 0.5).s == before.evaluate(1.9, 0.5).s);
  CHECK(after.evaluate(2.5, 1.1).s == before.evaluate(2.5, 1.1).s);
  CHECK(path_of(set_net_point(object, {6, 0}, {0, 0, 0})) == "point");
  CHECK(path_of(set_net_point(object, {0, -1}, {0, 0, 0})) == "point");
  CHECK(path_of(set_net_point(object, {0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0})) == "position");
  CHECK(path_of(set_net_point(object, {0, 0}, {0, 2e6, 0})) == "position");
}

TEST_CASE("net edits: a knot moves between its neighbours and takes its period with it") {
  BSplineSurfaceObject object = start();
  REQUIRE(set_net_knot(object, NetDirection::u, 4, 1.5));
  CHECK(object.u.knots[4] == 1.5);
  CHECK(path_of(set_net_knot(object, NetDirection::u, 4, 2.5)) == "value");
  CHECK(path_of(set_net_knot(object, NetDirection::u, 10, 2.5)) == "index");
  REQUIRE(set_net_topology(object, NetDirection::u, Topology::closed));
  REQUIRE(set_net_knot(object, NetDirection::u, 4, 1.25));
  CHECK(object.u.knots[10] == 1.25 + net_knots(object, NetDirection::u).period());
  REQUIRE(build_net(object).has_value());
}

TEST_CASE("net edits: as commands they are described, undone exactly, and refused where there is no net") {
  Document document = find_chapter("tensor-surface")->start_document();
  const Document before = document;
  History history;
  struct Edit {
    Command command;
    std::string words;
  };
  const std::vector<Edit> edits{
      {SetNetPoint{{1, 2}, {1, 2, 3}}, "Move point 1, 2"},
      {InsertNetLine{NetDirection::v, 0.5}, "Add a column"},
      {RemoveNetLine{NetDirection::u, 4}, "Delete row 4"},
      {SetNetKnot{NetDirection::v, 4, 0.25}, "Move knot 4 of v"},
      {SetParameter{"topology.u", "closed"}, "Close u"},
      {SetParameter{"net.u", 9.0}, "Set rows (u) to 9"},
      {SetParameter{"surface.degree.v", 5.0}, "Set degree v to 5"},
  };
  for (const Edit& edit : edits) {
    CAPTURE(edit.words);
    REQUIRE(history.perform(document, edit.command));
    CHECK(history.undo_label() == edit.words);
    CHECK(check(document));
  }
  while (history.undo(document)) {
  }
  CHECK(document == before);

  Document other = find_chapter("bspline-curve")->start_document();
  for (const auto& [command, words] : edits) CHECK_FALSE(apply(other, command));
  CHECK(path_of(apply(document, SetPoint{0, {0, 0, 0}})) == "index");
  CHECK(path_of(apply(document, InsertPoint{0, {0, 0, 0}})) == "index");
  CHECK(path_of(apply(document, InsertNetLine{NetDirection::u, 3.5})) == "at");
  CHECK(path_of(apply(document, InsertNetLine{NetDirection::u, std::numeric_limits<double>::quiet_NaN()})) == "at");
  CHECK(path_of(apply(document, InsertNetLine{NetDirection::u, 0})) == "at");
  CHECK(document == before);
}

TEST_CASE("net edits: the reader is told of knots that are even again and of rows that a degree adds") {
  Document document = find_chapter("tensor-surface")->start_document();
  CHECK(notice(document, SetParameter{"topology.u", "closed"}).empty());
  CHECK(notice(document, SetParameter{"surface.degree.u", 5.0}).empty());
  CHECK(notice(document, SetParameter{"surface.degree.u", 6.0}) ==
        "The degree rises without a change of the surface: now there are 7 rows.");
  REQUIRE(apply(document, SetParameter{"net.u", 7.0}));
  CHECK(notice(document, SetParameter{"topology.u", "closed"}) == "The knots are evenly spaced again.");
  CHECK(notice(document, SetParameter{"topology.v", "closed"}).empty());
}

TEST_CASE("net edits: what a document's net must be is said with a path") {
  const auto refusal = [](auto&& spoil) {
    Document document = find_chapter("tensor-surface")->start_document();
    spoil(*std::get_if<BSplineSurfaceObject>(&stage_shape(document)));
    const Status status = check(document);
    return status ? std::string("accepted") : status.error().path + ": " + status.error().message;
  };
  using Object = BSplineSurfaceObject;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal([](Object&) {}) == "accepted");
  CHECK(refusal([](Object& o) { o.net[2].pop_back(); }) ==
        "objects[0].net[2]: Must hold as many points as the first row: 5.");
  CHECK(refusal([&](Object& o) { o.net[2][1].y() = nan; }).starts_with("objects[0].net[2][1][1]: Must be a number"));
  CHECK(refusal([](Object& o) { o.net.resize(3); }) ==
        "objects[0].net: An open direction of degree 3 needs at least 4 rows.");
  CHECK(refusal([](Object& o) { o.net.clear(); }) == "objects[0].net: Must hold from 2 to 64 elements.");
  CHECK(refusal([](Object& o) { o.net.resize(65, o.net[0]); }) == "objects[0].net: Must hold from 2 to 64 elements.");
  CHECK(refusal([](Object& o) { o.u.degree = 10; }) == "objects[0].degree.u: Must be a whole number from 1 to 9.");
  CHECK(refusal([](Object& o) { o.v.degree = 4; }) ==
        "objects[0].knots.v: 5 columns of degree 4 need 10 knots, not 9.");
  CHECK(refusal([](Object& o) { std::swap(o.v.knots[3], o.v.knots[4]); }).starts_with("objects[0].knots.v[4]: "));
  CHECK(refusal([](Object& o) { o.u.knots[5] = o.u.knots[4] = 0; }).starts_with("objects[0].knots.u"));
  CHECK(refusal([&](Object& o) { o.u.knots[5] = nan; }).starts_with("objects[0].knots.u[5]: Must be a number"));
  CHECK(refusal([](Object& o) { o.u.topology = Topology::closed; }) ==
        "objects[0].knots.u: 6 rows of degree 3 need 13 knots, not 10.");
}

}  // namespace knotwork::scene::net_edits_test
