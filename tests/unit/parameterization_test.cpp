#include "knotwork/curve/parameterization.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "unit/oracle.h"

namespace knotwork::parameterization_test {
using namespace test;
namespace {

std::vector<Eigen::Vector3d> vectors(const nlohmann::json& list) {
  std::vector<Eigen::Vector3d> out;
  for (const nlohmann::json& item : list) out.push_back(vector3(item));
  return out;
}

double exponent_of(const std::string& rule) {
  return rule == "uniform" ? uniform_exponent : rule == "centripetal" ? centripetal_exponent : chord_length_exponent;
}

void compare(std::span<const double> actual, const std::vector<double>& expected) {
  REQUIRE(actual.size() <= expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) CHECK(close(actual[i], expected[i], oracle_tolerance));
}

}  // namespace

TEST_CASE("parameters meet oracle 12, open and closed") {
  const nlohmann::json& oracle = load_oracle("12_parameterization.json");
  REQUIRE(oracle.contains("parameterisations"));
  const std::vector<Eigen::Vector3d> seven =
      vectors(load_oracle("01_bspline_clamped.json")["cases"][0]["inputs"]["control_points"]);
  int compared = 0;
  for (const nlohmann::json& entry : oracle["parameterisations"]) {
    read_case(entry);
    const std::string rule = entry["rule"].get<std::string>();
    CAPTURE(rule);
    const bool closed = entry["closed"].get<bool>();
    const std::vector<double> expected = entry["parameters_0_1"].get<std::vector<double>>();
    const std::vector<double> parameters =
        parameterize(seven, exponent_of(rule), closed ? Topology::closed : Topology::open, 0, 1).value();
    // Closed, the oracle adds the first point once more, at 1.
    CHECK(parameters.size() == expected.size() - (closed ? 1 : 0));
    CHECK((closed ? parameters.back() < 1 : parameters.back() == 1));
    compare(parameters, expected);
    ++compared;
  }
  CHECK(compared == 6);
}

TEST_CASE("averaged knots meet oracle 12") {
  const nlohmann::json& oracle = load_oracle("12_parameterization.json");
  REQUIRE(oracle.contains("fits"));
  const std::vector<Eigen::Vector3d> points = vectors(oracle["points_12"]);
  int compared = 0;
  for (const nlohmann::json& entry : oracle["fits"]) {
    const std::vector<double> parameters =
        parameterize(points, exponent_of(entry["rule"].get<std::string>()), Topology::open, 0, 1).value();
    compare(parameters, entry["parameters"].get<std::vector<double>>());
    const KnotVector knots = averaged_knots(3, entry["n"].get<int>(), Topology::open, parameters).value();
    CHECK(knots.count() == entry["n"].get<int>());
    compare(knots.knots(), entry["knots"].get<std::vector<double>>());
    ++compared;
  }
  CHECK(compared == 9);
}

TEST_CASE("parameters do not depend on where the points are and how large, and begin and end exactly") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  std::vector<Eigen::Vector3d> points;
  points.reserve(40);
  for (int j = 0; j < 40; ++j) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const double exponent : {0.0, 0.3, 0.5, 1.0}) {
      const std::vector<double> parameters = parameterize(points, exponent, topology, -2, 5).value();
      CHECK(parameters.front() == -2);
      if (topology == Topology::open) CHECK(parameters.back() == 5);
      CHECK(std::is_sorted(parameters.begin(), parameters.end()));
      for (const double size : {1e-300, 1e-12, 1e12, 5e307}) {
        std::vector<Eigen::Vector3d> scaled = points;
        for (Eigen::Vector3d& point : scaled) point = point / 3 * size;
        const std::vector<double> same = parameterize(scaled, exponent, topology, -2, 5).value();
        for (std::size_t j = 0; j < same.size(); ++j) CHECK(close(same[j], parameters[j], 1e-14, 7));
      }
    }
  }
}

TEST_CASE("chords are to parameter steps as the exponent says; the closing chord counts") {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}};
  compare(parameterize(points, chord_length_exponent, Topology::closed, 0, 10).value(), {0, 4, 5, 9});
  compare(parameterize(points, centripetal_exponent, Topology::closed, 0, 6).value(), {0, 2, 3, 5});
  compare(parameterize(points, uniform_exponent, Topology::closed, 0, 4).value(), {0, 1, 2, 3});
  compare(parameterize(points, chord_length_exponent, Topology::open, 0, 9).value(), {0, 4, 5, 9});
}

TEST_CASE("neighbours that coincide share their parameter, unless it is uniform") {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 0, 0}, {0, 0, 0}};
  compare(parameterize(points, chord_length_exponent, Topology::open, 0, 6).value(), {0, 0, 1, 3, 3, 6});
  compare(parameterize(points, chord_length_exponent, Topology::closed, 0, 6).value(), {0, 0, 1, 3, 3, 6});
  compare(parameterize(points, uniform_exponent, Topology::open, 0, 5).value(), {0, 1, 2, 3, 4, 5});
}

TEST_CASE("points and numbers that give no parameters are refused, with the place") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector3d> points(4, Eigen::Vector3d::Ones());
  const auto path = [&](double exponent, double start, double end) {
    const Result<std::vector<double>> result = parameterize(points, exponent, Topology::open, start, end);
    return result ? "no error" : result.error().path;
  };
  CHECK(path(1, 0, 1) == "points");
  CHECK(path(0, 0, 1) == "no error");
  points[2].x() = 0;
  CHECK(path(1, 0, 1) == "no error");
  for (const double wrong : {nan, infinity, -infinity, -0.1, 1.1}) CHECK(path(wrong, 0, 1) == "exponent");
  for (const double wrong : {nan, infinity, 1e101}) {
    CHECK(path(1, -wrong, 1) == "start");
    CHECK(path(1, 0, wrong) == "end");
  }
  CHECK(path(1, 1, 1) == "end");
  points[3].y() = nan;
  CHECK(path(1, 0, 1) == "points[3]");
  points.resize(1);
  CHECK(path(0, 0, 1) == "points");
}

TEST_CASE("averaged knots: every interval holds data, open and closed, and closed knots turn with the data") {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> place(0, 1);
  for (int degree = 1; degree <= 5; ++degree) {
    for (const int count : {6, 9, 13}) {
      for (const int size : {count, count + 1, 2 * count + 3, 100}) {
        std::vector<double> parameters;
        parameters.reserve(static_cast<std::size_t>(size));
        for (int j = 0; j < size; ++j) parameters.push_back(place(random));
        std::sort(parameters.begin(), parameters.end());
        CAPTURE(degree);
        CAPTURE(count);
        CAPTURE(size);
        const auto data_in = [&](double from, double to, double period) {
          return std::any_of(parameters.begin(), parameters.end(), [&](double x) {
            return (x >= from && x <= to) || (period > 0 && x + period >= from && x + period <= to) ||
                   (period > 0 && x - period >= from && x - period <= to);
          });
        };
        if (size > count) {
          const KnotVector open = averaged_knots(degree, count, Topology::open, parameters).value();
          CHECK(open.start() == parameters.front());
          CHECK(open.end() == parameters.back());
          for (int i = degree; i < count; ++i) CHECK(data_in(open[i], open[i + 1], 0));
        }
        const KnotVector closed = averaged_knots(degree, count, Topology::closed, parameters, 1.25).value();
        CHECK(closed.period() == doctest::Approx(1.25).epsilon(1e-15));
        if (size > count || degree % 2 == 1) CHECK(closed.start() == parameters.front());
        for (int i = degree; i < count + degree; ++i) CHECK(data_in(closed[i], closed[i + 1], 1.25));
      }
    }
  }
}

TEST_CASE("knots for interpolation: on the data for odd degrees, between them for even ones") {
  const std::vector<double> parameters = {0, 1, 3, 4};
  const KnotVector cubic = averaged_knots(3, 4, Topology::closed, parameters, 6).value();
  compare(cubic.knots(), {-5, -3, -2, 0, 1, 3, 4, 6, 7, 9, 10});
  const KnotVector quadratic = averaged_knots(2, 4, Topology::closed, parameters, 6).value();
  compare(quadratic.knots(), {-4, -2.5, -1, 0.5, 2, 3.5, 5, 6.5, 8});
  compare(averaged_knots(2, 4, Topology::open, parameters).value().knots(), {0, 0, 0, 2, 4, 4, 4});
}

TEST_CASE("parameters that give no knots are refused, with the place") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> parameters = {0, 1, 2, 3, 4, 5};
  const auto path = [&](int degree, int count, Topology topology, double period) {
    const Result<KnotVector> result = averaged_knots(degree, count, topology, parameters, period);
    return result ? "no error" : result.error().path;
  };
  CHECK(path(3, 6, Topology::open, 0) == "no error");
  CHECK(path(3, 6, Topology::closed, 5) == "no error");  // the last is the first again
  CHECK(path(0, 6, Topology::open, 0) == "degree");
  CHECK(path(17, 20, Topology::open, 0) == "degree");
  CHECK(path(3, 3, Topology::open, 0) == "count");
  CHECK(path(1, 1, Topology::closed, 6) == "count");
  CHECK(path(3, KnotVector::max_count + 1, Topology::open, 0) == "count");
  CHECK(path(3, 7, Topology::open, 0) == "parameters");
  for (const double wrong : {nan, 0.0, -6.0, 1e101}) CHECK(path(3, 5, Topology::closed, wrong) == "period");
  CHECK(path(3, 5, Topology::closed, 4.9) == "parameters[5]");
  parameters[2] = 0.5;
  CHECK(path(3, 6, Topology::open, 0) == "parameters[2]");
  parameters[2] = nan;
  CHECK(path(3, 6, Topology::open, 0) == "parameters[2]");
  std::fill(parameters.begin(), parameters.end(), 1.0);
  CHECK(path(3, 6, Topology::open, 0) == "knots[4]");
}

}  // namespace knotwork::parameterization_test
