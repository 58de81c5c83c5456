#include "knotwork/curve/least_squares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "knotwork/curve/parameterization.h"
#include "unit/oracle.h"

namespace knotwork::least_squares_test {
using namespace test;
namespace {

std::vector<Eigen::Vector3d> vectors(const nlohmann::json& list) {
  std::vector<Eigen::Vector3d> out;
  for (const nlohmann::json& item : list) out.push_back(vector3(item));
  return out;
}

std::vector<double> numbers(const nlohmann::json& list) { return list.get<std::vector<double>>(); }

/// Points, parameters and knots that fit, for tests that then spoil one of them.
struct Example {
  KnotVector knots = KnotVector::uniform(3, 6, Topology::open, 0, 3).value();
  std::vector<Eigen::Vector3d> points;
  std::vector<double> parameters;

  explicit Example(int count = 12) {
    for (int j = 0; j < count; ++j) {
      parameters.push_back(3.0 * j / (count - 1));
      points.emplace_back(j, j % 3, -j % 2);
    }
  }
  Result<LeastSquaresFit> fit(const LeastSquaresOptions& options = {}) const {
    return fit_least_squares(knots, points, parameters, options);
  }
  std::string error_path(const LeastSquaresOptions& options = {}) const {
    const Result<LeastSquaresFit> result = fit(options);
    return result ? "no error" : result.error().path;
  }
};

/// The control points, the root mean square and the greatest residual of an oracle's case.
void compare(const LeastSquaresFit& fit, const nlohmann::json& expected, double size) {
  REQUIRE(fit.curve.points().size() == expected["control_points"].size());
  for (std::size_t i = 0; i < fit.curve.points().size(); ++i) {
    const Eigen::Vector3d point = vector3(expected["control_points"][i]);
    CHECK(close(fit.curve.points()[i], point, oracle_tolerance, point.isZero() ? size : 0));
  }
  // Residuals are differences of curve and data, and have the rounding errors of these.
  CHECK(close(fit.rms, expected["rms"].get<double>(), oracle_tolerance, 1e-3 * size));
  if (expected.contains("max_residual"))
    CHECK(close(fit.maximum, expected["max_residual"].get<double>(), oracle_tolerance, 1e-3 * size));
  CHECK(fit.maximum == *std::max_element(fit.residuals.begin(), fit.residuals.end()));
}

}  // namespace

TEST_CASE("least squares fits of a circle meet oracle 03: open, closed, with interpolated ends") {
  const nlohmann::json& oracle = load_oracle("03_least_squares.json");
  REQUIRE(oracle.contains("cases"));
  int open = 0, closed = 0, constrained = 0, refused = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    read_case(entry);
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    const nlohmann::json& inputs = entry["inputs"];
    const Topology topology = inputs.contains("domain") ? Topology::closed : Topology::open;
    const KnotVector knots = KnotVector::make(inputs["degree"].get<int>(), topology, numbers(inputs["knots"])).value();
    const std::vector<double> parameters = numbers(inputs["parameters"]);
    if (!inputs.contains("points")) {
      const std::vector<Eigen::Vector3d> points(parameters.size(), Eigen::Vector3d::Ones());
      const Result<LeastSquaresFit> fit = fit_least_squares(knots, points, parameters);
      REQUIRE_FALSE(fit);
      CHECK(fit.error().path == "parameters");
      CHECK(fit.error().message.find("No data supports the 5 basis functions 5 to 9") == 0);
      ++refused;
      continue;
    }
    const bool ends = inputs.contains("constraint");
    const std::vector<Eigen::Vector3d> points = vectors(inputs["points"]);
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, points, parameters, {.interpolate_ends = ends});
    REQUIRE(fit);
    compare(fit.value(), entry, 5);
    if (ends) {
      CHECK(fit.value().curve(knots.start()) == points.front());
      CHECK(fit.value().curve(knots.end()) == points.back());
    }
    if (entry.contains("max_radial_error_of_curve_401_samples")) {
      double radial = 0;
      for (int k = 0; k <= 400; ++k) {
        const double t = std::lerp(knots.start(), knots.end(), k / 400.0);
        radial = std::max(radial, std::abs(fit.value().curve(t).norm() - 5));
      }
      CHECK(close(radial, entry["max_radial_error_of_curve_401_samples"].get<double>(), oracle_tolerance, 5e-3));
    }
    ++(ends ? constrained : topology == Topology::open ? open : closed);
  }
  CHECK(open == 5);
  CHECK(closed == 5);
  CHECK(constrained == 2);
  CHECK(refused == 1);
}

TEST_CASE("fits over averaged knots meet oracle 12") {
  const nlohmann::json& oracle = load_oracle("12_parameterization.json");
  REQUIRE(oracle.contains("fits"));
  const std::vector<Eigen::Vector3d> points = vectors(oracle["points_12"]);
  int compared = 0;
  for (const nlohmann::json& entry : oracle["fits"]) {
    read_case(entry);
    const KnotVector knots = KnotVector::make(3, Topology::open, numbers(entry["knots"])).value();
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, points, numbers(entry["parameters"]));
    REQUIRE(fit);
    compare(fit.value(), entry, 10);
    ++compared;
  }
  CHECK(compared == 9);
}

TEST_CASE("closed curves through points meet oracle 02") {
  const nlohmann::json& oracle = load_oracle("02_bspline_periodic.json");
  REQUIRE(oracle.contains("cases"));
  int compared = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    if (!inputs.contains("conditions")) continue;
    std::vector<double> parameters = numbers(inputs["parameters"]);
    const double period = parameters.back() - parameters.front();
    parameters.pop_back();
    const std::vector<Eigen::Vector3d> points = vectors(inputs["points"]);
    const KnotVector knots =
        averaged_knots(3, static_cast<int>(points.size()), Topology::closed, parameters, period).value();
    const std::vector<double> expected_knots = numbers(inputs["knots"]);
    REQUIRE(knots.knots().size() == expected_knots.size());
    for (std::size_t i = 0; i < expected_knots.size(); ++i)
      CHECK(close(knots.knots()[i], expected_knots[i], oracle_tolerance));
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, points, parameters);
    REQUIRE(fit);
    CHECK(fit.value().maximum < 1e-13);
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(close(fit.value().curve.points()[i], vector3(entry["control_points"][i]), oracle_tolerance));
    ++compared;
  }
  CHECK(compared == 3);
}

TEST_CASE("the report's experiment, closed as it ought to be: 20 points on a circle, 6 and 8 control points") {
  // From the points alone: parameters, then knots, then the fit. The numbers are oracle 03's.
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j < 20; ++j) {
    const double angle = 2 * 3.14159265358979323846 * j / 20;
    points.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  const std::vector<double> parameters = parameterize(points, uniform_exponent, Topology::closed, 0, 1).value();
  const auto rms = [&](int count) {
    const KnotVector knots = averaged_knots(3, count, Topology::closed, parameters, 1).value();
    return fit_least_squares(knots, points, parameters).value().rms;
  };
  CHECK(close(rms(6), 0.008276639456982048, oracle_tolerance, 5e-3));
  CHECK(close(rms(8), 0.002226905293844486, oracle_tolerance, 5e-3));
}

TEST_CASE("fewer points than control points: refused with a way out, or smoothed") {
  const Example example(5);
  const Result<LeastSquaresFit> fit = example.fit();
  REQUIRE_FALSE(fit);
  CHECK(fit.error().path == "points");
  CHECK(fit.error().message ==
        "There are 5 points for 6 control points: give more points, use fewer control points, or smooth.");
  CHECK(example.fit({.smoothing = 0.1}));
  CHECK(Example(6).fit());
  CHECK(Example(6).error_path({.interpolate_ends = true}) == "no error");
}

TEST_CASE("points of weight 0 are measured, but neither count nor support anything") {
  Example example(9);
  std::vector<double> weights(9, 1.0);
  weights[2] = weights[3] = weights[5] = 0;
  const LeastSquaresFit fit = example.fit({.weights = weights}).value();
  CHECK(fit.rms < 1e-13);
  for (std::size_t j = 0; j < 9; ++j) CHECK((fit.residuals[j] > 1e-3) == (weights[j] == 0));
  CHECK(fit.maximum == *std::max_element(fit.residuals.begin(), fit.residuals.end()));
  weights[7] = 0;
  CHECK(example.error_path({.weights = weights}) == "points");
  std::fill(weights.begin(), weights.end(), 0.0);
  CHECK(example.error_path({.weights = weights}) == "points");
  CHECK(example.error_path({.smoothing = 1, .weights = weights}) == "parameters");
}

TEST_CASE("every input that is no data is refused, with the place") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {nan, infinity, -infinity, 1e51}) {
    Example example;
    example.points[4].z() = wrong;
    CHECK(example.error_path() == "points[4]");
  }
  for (const double wrong : {nan, infinity, -infinity, -1e-9, 3.0000001}) {
    Example example;
    example.parameters[7] = wrong;
    CHECK(example.error_path() == "parameters[7]");
  }
  const Example example;
  CHECK(example.error_path() == "no error");
  for (const double wrong : {nan, infinity, -infinity, -1e-300, 1e51}) {
    std::vector<double> weights(12, 1.0);
    weights[11] = wrong;
    CHECK(example.error_path({.weights = weights}) == "weights[11]");
    CHECK(example.error_path({.smoothing = wrong}) == "smoothing");
  }
  CHECK(example.error_path({.weights = std::vector<double>(11, 1.0)}) == "weights");

  Example fewer;
  fewer.parameters.pop_back();
  CHECK(fewer.error_path() == "points");
  fewer.parameters.clear();
  fewer.points.clear();
  CHECK(fewer.error_path() == "points");
  CHECK(fewer.error_path({.smoothing = 1}) == "points");

  Example closed;
  closed.knots = KnotVector::uniform(3, 6, Topology::closed, 0, 3).value();
  CHECK(closed.error_path() == "no error");
  CHECK(closed.error_path({.interpolate_ends = true}) == "interpolate_ends");
  closed.parameters[3] = nan;
  CHECK(closed.error_path() == "parameters[3]");
  Example loose;
  loose.knots = KnotVector::make(2, Topology::open, {-1, 0, 0, 1, 2, 3, 4, 5}).value();
  CHECK(loose.error_path({.interpolate_ends = true}) == "interpolate_ends");
  loose.knots = KnotVector::make(2, Topology::open, {-1, 0, 0, 1, 2, 3, 3, 5}).value();
  CHECK(loose.error_path({.interpolate_ends = true}) == "no error");
}

TEST_CASE("all data in one place leave everything undetermined") {
  Example example;
  std::fill(example.parameters.begin(), example.parameters.end(), 1.5);
  const Result<LeastSquaresFit> fit = example.fit();
  REQUIRE_FALSE(fit);
  CHECK(fit.error().path == "parameters");
  CHECK(fit.error().message.find("Only one parameter supports the 6 basis functions 0 to 5") == 0);
  // One place fixes a point of a straight line, not its direction.
  CHECK(example.error_path({.smoothing = 1}) == "parameters");
  example.parameters[0] = 1.25;
  CHECK(example.error_path({.smoothing = 1}) == "no error");
}

TEST_CASE("data that hardly support a control point are as good as none") {
  // Schoenberg and Whitney are content: the last parameter is inside the support of the last function. The value there
  // is 1e-10 to the power of 16.
  Example example(0);
  example.knots = KnotVector::uniform(16, 20, Topology::open, 0, 4).value();
  for (int j = 0; j < 19; ++j) {
    example.parameters.push_back(3.0 * j / 19);
    example.points.emplace_back(j, 1, 0);
  }
  example.parameters.push_back(3 + 1e-10);
  example.points.emplace_back(0, 0, 0);
  const Result<LeastSquaresFit> fit = example.fit();
  REQUIRE_FALSE(fit);
  CHECK(fit.error().path == "parameters");
  CHECK(fit.error().message.find("The data determine control point") == 0);
}

}  // namespace knotwork::least_squares_test
