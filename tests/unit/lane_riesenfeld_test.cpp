#include "knotwork/curve/lane_riesenfeld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "unit/oracle.h"

namespace knotwork::lane_riesenfeld_test {
using namespace test;
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

Polygon polygon(const nlohmann::json& list) {
  Polygon points;
  for (const nlohmann::json& item : list) points.push_back(vector3(item));
  return points;
}

LaneRiesenfeld oracle_scheme(const nlohmann::json& inputs) {
  return {inputs["degree"].get<int>(), inputs["closed"].get<bool>() ? Topology::closed : Topology::open};
}

Polygon random_polygon(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  Polygon points(count);
  for (Eigen::Vector3d& point : points)
    point = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

/// One level as it is told and drawn, step by step.
Polygon level_by_passes(const LaneRiesenfeld& scheme, const Polygon& points) {
  Polygon level = split_points(points);
  for (int pass = 0; pass < scheme.degree; ++pass) level = averaged_points(level, scheme.topology);
  return level;
}

/// One level as the mask 2^-d C(d+1, 2i+1-j).
Polygon level_by_mask(const LaneRiesenfeld& scheme, const Polygon& points) {
  const int d = scheme.degree, n = static_cast<int>(points.size());
  std::vector<double> binomials{1};
  for (int k = 1; k <= d + 1; ++k) binomials.push_back(binomials.back() * (d + 2 - k) / k);
  Polygon level(subdivided_count(scheme, points.size(), 1), Eigen::Vector3d::Zero());
  for (int j = 0; j < static_cast<int>(level.size()); ++j) {
    for (int i = j / 2; 2 * i + 1 - j <= d + 1; ++i) {
      if (2 * i + 1 - j < 0) continue;
      level[static_cast<std::size_t>(j)] +=
          std::ldexp(binomials[static_cast<std::size_t>(2 * i + 1 - j)], -d) * points[static_cast<std::size_t>(i % n)];
    }
  }
  return level;
}

/// The largest distance from the vertices to the limit curve at their parameters, within the domain.
double distance_to_limit(const LaneRiesenfeld& scheme, const Polygon& points, int level) {
  const BSplineCurve limit = limit_curve(scheme, points).value();
  const Polygon vertices = subdivide(scheme, points, level).value();
  double largest = 0;
  for (std::size_t j = 0; j < vertices.size(); ++j) {
    const double t = vertex_parameter(scheme, points.size(), level, j);
    if (t < limit.knots().start() || t > limit.knots().end()) continue;
    largest = std::max(largest, (vertices[j] - limit(t)).norm());
  }
  return largest;
}

constexpr Topology topologies[] = {Topology::open, Topology::closed};

}  // namespace

TEST_CASE("subdivision meets oracle 04, without any rounding") {
  const nlohmann::json& oracle = load_oracle("04_lane_riesenfeld.json");
  REQUIRE(oracle.contains("cases"));
  int compared = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    read_case(entry);
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    const LaneRiesenfeld scheme = oracle_scheme(entry["inputs"]);
    const Polygon points = polygon(entry["inputs"]["points"]);
    Polygon passed = points;
    for (const nlohmann::json& at : entry["levels"]) {
      const int level = at["level"].get<int>();
      CAPTURE(level);
      const Polygon expected = polygon(at["points"]);
      CHECK(subdivided_count(scheme, points.size(), level) == expected.size());
      passed = level_by_passes(scheme, passed);
      CHECK(passed == expected);
      CHECK(subdivide(scheme, points, level).value() == expected);
      compared += static_cast<int>(expected.size());
    }
  }
  CHECK(compared > 1500);
}

TEST_CASE("the distance to the limit curve meets oracle 04 and is a quarter a level") {
  const nlohmann::json& oracle = load_oracle("04_lane_riesenfeld.json");
  REQUIRE(oracle.contains("cases"));
  int compared = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    const LaneRiesenfeld scheme = oracle_scheme(entry["inputs"]);
    const Polygon points = polygon(entry["inputs"]["points"]);
    // A difference of points of size 10: relative to those.
    const auto check = [&](int level, double expected) {
      CAPTURE(level);
      CHECK(close(distance_to_limit(scheme, points, level), expected, oracle_tolerance, 10));
      ++compared;
    };
    if (scheme.topology == Topology::open) {
      check(4, entry["max_distance_to_limit_level_4_points_with_parameter_in_domain"].get<double>());
      continue;
    }
    const auto distances = entry["max_distance_to_limit_levels_1_to_6"].get<std::vector<double>>();
    for (std::size_t k = 0; k < distances.size(); ++k) check(static_cast<int>(k) + 1, distances[k]);
    if (scheme.degree == 1) continue;  // on the curve
    for (std::size_t k = 1; k < distances.size(); ++k) {
      const double ratio = distance_to_limit(scheme, points, static_cast<int>(k)) /
                           distance_to_limit(scheme, points, static_cast<int>(k) + 1);
      CHECK(close(ratio, entry["ratio"][k - 1].get<double>(), 1e-10));
      if (k >= 4) CHECK(std::abs(ratio - 4) < 0.01);
    }
  }
  CHECK(compared == 5 * 6 + 5);
}

TEST_CASE("a vertex lies off its curve point by (d+1)/24 of the second difference, for every degree from 2") {
  std::mt19937 random(1);
  for (const Topology topology : topologies) {
    for (int degree = 2; degree <= LaneRiesenfeld::max_degree; ++degree) {
      const LaneRiesenfeld scheme{degree, topology};
      CAPTURE(degree);
      const Polygon points = random_polygon(12, random);
      const BSplineCurve limit = limit_curve(scheme, points).value();
      double errors[2] = {};
      for (int more = 0; more < 2; ++more) {
        const int level = 4 + more;
        const Polygon vertices = subdivide(scheme, points, level).value();
        const std::size_t margin = static_cast<std::size_t>(degree);
        for (std::size_t j = margin; j + margin < vertices.size(); ++j) {
          const Eigen::Vector3d bend = vertices[j - 1] - 2 * vertices[j] + vertices[j + 1];
          const double t = vertex_parameter(scheme, points.size(), level, j);
          const Eigen::Vector3d rest = vertices[j] - limit(t) + (degree + 1) / 24.0 * bend;
          errors[more] = std::max(errors[more], rest.norm());
        }
      }
      if (degree <= 3) {
        // Nothing is left: a spline of degree 3 or less at the middle of its basis is a mask of three points.
        CHECK(errors[1] < 1e-12);
      } else {
        CHECK(errors[0] < 2e-3);
        CHECK(errors[0] / errors[1] > 10);
      }
    }
  }
}

TEST_CASE("the sweep is the passes bit for bit and the mask to rounding, all degrees, few and many points") {
  std::mt19937 random(2);
  for (const Topology topology : topologies) {
    for (int degree = 1; degree <= LaneRiesenfeld::max_degree; ++degree) {
      const LaneRiesenfeld scheme{degree, topology};
      const std::size_t least = topology == Topology::closed ? 1 : static_cast<std::size_t>(degree) + 1;
      for (std::size_t count = least; count < least + 14; ++count) {
        CAPTURE(degree);
        CAPTURE(count);
        const Polygon points = random_polygon(count, random);
        const Polygon once = subdivide(scheme, points, 1).value();
        CHECK(once == level_by_passes(scheme, points));
        const Polygon mask = level_by_mask(scheme, points);
        REQUIRE(once.size() == mask.size());
        for (std::size_t j = 0; j < mask.size(); ++j) CHECK(close(once[j], mask[j], 1e-15, 8));
        CHECK(subdivide(scheme, points, 3).value() == subdivide(scheme, subdivide(scheme, once, 1).value(), 1).value());
        CHECK(subdivide(scheme, points, 0).value() == points);
      }
    }
  }
}

TEST_CASE("long polygons of degree 3, whose levels are computed by the block, are the passes bit for bit") {
  std::mt19937 random(3);
  for (const Topology topology : topologies) {
    const LaneRiesenfeld scheme{3, topology};
    for (const std::size_t count : {255U, 256U, 257U, 258U, 287U, 288U, 289U, 290U, 319U, 1000U}) {
      CAPTURE(count);
      const Polygon points = random_polygon(count, random);
      CHECK(subdivide(scheme, points, 1).value() == level_by_passes(scheme, points));
      // Into room that holds something else.
      Polygon room(subdivided_count(scheme, count, 2), Eigen::Vector3d::Constant(7));
      subdivide(scheme, points, 2, room);
      CHECK(room == level_by_passes(scheme, level_by_passes(scheme, points)));
    }
  }
}

TEST_CASE("the split and one averaging pass") {
  const Polygon triangle{{0, 0, 0}, {4, 0, 0}, {0, 8, 2}};
  const Polygon split = split_points(triangle);
  CHECK(split == Polygon{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {0, 8, 2}, {0, 8, 2}});
  // The first pass over a split polygon inserts the midpoints.
  CHECK(averaged_points(split, Topology::closed) ==
        Polygon{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {2, 4, 1}, {0, 8, 2}, {0, 4, 1}});
  CHECK(averaged_points(split, Topology::open) == Polygon{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {2, 4, 1}, {0, 8, 2}});
  CHECK(split_points({}).empty());
  for (const Topology topology : topologies) CHECK(averaged_points({}, topology).empty());
  CHECK(averaged_points(Polygon{{1, 2, 3}}, Topology::open).empty());
  CHECK(averaged_points(Polygon{{1, 2, 3}}, Topology::closed) == Polygon{{1, 2, 3}});
}

TEST_CASE("points that agree stay, however large, and an open straight line stays one with its parameter") {
  const double largest = std::numeric_limits<double>::max();
  const Eigen::Vector3d odd(0.1, -1e-7 / 3, largest);
  for (int degree = 1; degree <= LaneRiesenfeld::max_degree; ++degree) {
    CAPTURE(degree);
    for (const Topology topology : topologies) {
      const LaneRiesenfeld scheme{degree, topology};
      const Polygon fine = subdivide(scheme, Polygon(10, odd), 5).value();
      CHECK(fine == Polygon(fine.size(), odd));
    }
    const LaneRiesenfeld open{degree, Topology::open};
    const Eigen::Vector3d origin(1, 2, 3), direction(2, -1, 0.5);
    Polygon line;
    // Point i at its own parameter, so that the limit is origin + t direction.
    for (std::size_t i = 0; i < 12; ++i) line.emplace_back(origin + vertex_parameter(open, 12, 0, i) * direction);
    const Polygon fine = subdivide(open, line, 4).value();
    for (std::size_t j = 0; j < fine.size(); ++j) {
      CHECK(fine[j] == origin + vertex_parameter(open, 12, 4, j) * direction);
    }
    const BSplineCurve limit = limit_curve(open, line).value();
    CHECK(close(limit(degree + 0.3), origin + (degree + 0.3) * direction, 1e-14));
  }
}

TEST_CASE("an affine map of the points maps every vertex") {
  std::mt19937 random(3);
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() << 1.2, 0.3, -0.4, 0.1, 0.7, 0.2, -0.5, 0.6, 1.4;
  map.translation() << 3, -2, 1;
  for (const Topology topology : topologies) {
    for (int degree = 1; degree <= LaneRiesenfeld::max_degree; ++degree) {
      const LaneRiesenfeld scheme{degree, topology};
      const Polygon points = random_polygon(11, random);
      Polygon mapped;
      mapped.reserve(points.size());
      for (const Eigen::Vector3d& point : points) mapped.emplace_back(map * point);
      const Polygon fine = subdivide(scheme, points, 4).value(), fine_mapped = subdivide(scheme, mapped, 4).value();
      for (std::size_t j = 0; j < fine.size(); ++j) CHECK(close(fine_mapped[j], map * fine[j], 1e-14, 10));
    }
  }
}

TEST_CASE("the parameters of the vertices: equidistant, closed ones in the domain, open ones centred on it") {
  const LaneRiesenfeld closed{4, Topology::closed}, open{4, Topology::open};
  CHECK(vertex_parameter(closed, 7, 0, 0) == 4 - 1.5 + 7);  // the support of c_0 is centred before the domain
  CHECK(vertex_parameter(closed, 7, 0, 2) == 4.5);
  CHECK(vertex_parameter(closed, 7, 2, 27) == 4 + 25.5 / 4);
  CHECK(vertex_parameter(open, 7, 0, 0) == 2.5);
  CHECK(vertex_parameter(open, 7, 1, 9) == 4 + 7.5 / 2);
  // One point alone: the parameter is taken into [9, 10) over four periods.
  CHECK(vertex_parameter({9, Topology::closed}, 1, 0, 0) == 9);
  for (int degree = 1; degree <= LaneRiesenfeld::max_degree; ++degree) {
    const LaneRiesenfeld round{degree, Topology::closed}, line{degree, Topology::open};
    const std::size_t n = 11, count = subdivided_count(line, n, 3);
    double outside = 0;
    for (std::size_t j = 0; j < count; ++j) {
      const double t = vertex_parameter(line, n, 3, j);
      CHECK(t + vertex_parameter(line, n, 3, count - 1 - j) == degree + 11);
      outside += t < degree || t > 11 ? 1 : 0;
    }
    CHECK(outside == 2 * (degree / 2));
    for (std::size_t j = 0; j < 8 * n; ++j) {
      const double t = vertex_parameter(round, n, 3, j);
      CHECK(t >= degree);
      CHECK(t < degree + 11);
    }
  }
}

TEST_CASE("few points on a closed polygon: the limit curve is there, and the subdivision tends to it") {
  std::mt19937 random(4);
  for (std::size_t count = 1; count <= 4; ++count) {
    for (int degree = 1; degree <= LaneRiesenfeld::max_degree; ++degree) {
      CAPTURE(count);
      CAPTURE(degree);
      const LaneRiesenfeld scheme{degree, Topology::closed};
      const Polygon points = random_polygon(count, random);
      const BSplineCurve limit = limit_curve(scheme, points).value();
      CHECK(limit.knots().start() == degree);
      CHECK(limit.knots().period() == static_cast<double>(count));
      CHECK(distance_to_limit(scheme, points, 9) < 1e-4);
    }
  }
}

TEST_CASE("as many levels as fit, and the message that names them") {
  for (const Topology topology : topologies) {
    const LaneRiesenfeld scheme{9, topology};
    const Polygon points(10, Eigen::Vector3d::Ones());
    const int most = max_levels(scheme, points.size());
    CHECK(most == (topology == Topology::closed ? 18 : 21));
    CHECK(subdivided_count(scheme, 10, most) <= LaneRiesenfeld::max_points);
    CHECK(subdivided_count(scheme, 10, most + 1) > LaneRiesenfeld::max_points);
    for (const int levels : {most + 1, 64, 1000, std::numeric_limits<int>::max()}) {
      const auto refused = subdivide(scheme, points, levels);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().path == "levels");
      CHECK(refused.error().message.find("At most " + std::to_string(most) + " levels") == 0);
    }
    CHECK(subdivide(scheme, points, -1).error().path == "levels");
  }
  CHECK(max_levels({1, Topology::closed}, LaneRiesenfeld::max_points) == 0);
  CHECK(max_levels({1, Topology::closed}, LaneRiesenfeld::max_points + 1) == -1);
}

TEST_CASE("what cannot be subdivided is refused, with the place") {
  const Polygon points(9, Eigen::Vector3d::Ones());
  for (const int degree : {-1, 0, 10}) {
    CHECK(subdivide({degree, Topology::closed}, points, 1).error().path == "degree");
    CHECK(limit_curve({degree, Topology::open}, points).error().path == "degree");
  }
  CHECK(subdivide({9, Topology::open}, points, 1).error().path == "points");
  CHECK(subdivide({9, Topology::open}, points, 1).error().message.find("10 to ") != std::string::npos);
  CHECK(subdivide({8, Topology::open}, points, 1).has_value());
  CHECK(subdivide({3, Topology::closed}, {}, 1).error().path == "points");
  CHECK(limit_curve({3, Topology::closed}, {}).error().path == "points");
  CHECK(limit_curve({9, Topology::open}, points).error().path == "points");
  Polygon many(LaneRiesenfeld::max_points + 1, Eigen::Vector3d::Ones());
  CHECK(subdivide({3, Topology::closed}, many, 0).error().path == "points");
  many.resize(static_cast<std::size_t>(KnotVector::max_count) + 1);
  CHECK(limit_curve({3, Topology::closed}, many).error().path == "points");
  many.pop_back();
  for (const Topology topology : topologies) CHECK(limit_curve({3, topology}, many).has_value());
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Polygon broken = points;
    broken[4].z() = bad;
    CHECK(subdivide({3, Topology::closed}, broken, 1).error().path == "points[4]");
    CHECK(limit_curve({3, Topology::closed}, broken).error().path == "points[4]");
  }
}

}  // namespace knotwork::lane_riesenfeld_test
