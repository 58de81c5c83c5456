#include "knotwork/curve/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "unit/oracle.h"

namespace knotwork::curve_fit_test {
using namespace test;
namespace {

std::vector<Eigen::Vector3d> circle(int points, double steps) {
  std::vector<Eigen::Vector3d> list;
  for (int j = 0; j < points; ++j) {
    const double angle = 2 * std::numbers::pi * j / steps;
    list.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  return list;
}

/// Seventeen points on a bent line, none twice.
std::vector<Eigen::Vector3d> bent_line() {
  std::vector<Eigen::Vector3d> list;
  list.reserve(17);
  for (int j = 0; j < 17; ++j) list.emplace_back(j, std::sin(0.6 * j), 0.1 * j * j);
  return list;
}

Error refusal(std::span<const Eigen::Vector3d> points, const CurveFitSettings& settings) {
  const Result<CurveFit> fit = fit_curve(points, settings);
  REQUIRE_FALSE(fit);
  return fit.error();
}

}  // namespace

TEST_CASE("curve fit: one call gives oracle 03's fits of a circle, open, closed and with interpolated ends") {
  const nlohmann::json oracle = load_oracle("03_least_squares.json");
  REQUIRE(oracle.contains("cases"));
  int open = 0, closed = 0, constrained = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    if (!inputs.contains("points")) continue;
    CAPTURE(entry["name"].get<std::string>());
    std::vector<Eigen::Vector3d> points;
    for (const nlohmann::json& point : inputs["points"]) points.push_back(vector3(point));
    CurveFitSettings settings;
    settings.degree = inputs["degree"].get<int>();
    settings.count = static_cast<int>(entry["control_points"].size());
    settings.topology = inputs.contains("domain") ? Topology::closed : Topology::open;
    settings.interpolate_ends = inputs.contains("constraint");
    const Result<CurveFit> result = fit_curve(points, settings);
    REQUIRE(result);
    const LeastSquaresFit& fit = result.value().fit;
    REQUIRE(fit.curve.knots().count() == settings.count);
    for (int i = 0; i < settings.count; ++i) {
      const Eigen::Vector3d expected = vector3(entry["control_points"][static_cast<std::size_t>(i)]);
      CHECK(close(fit.curve.point(i), expected, oracle_tolerance, expected.isZero() ? 5 : 0));
    }
    // Residuals are differences of curve and data, and have the rounding errors of these.
    CHECK(close(fit.rms, entry["rms"].get<double>(), oracle_tolerance, 5e-3));
    REQUIRE(result.value().parameters.size() == points.size());
    const double shift = settings.topology == Topology::closed ? inputs["domain"][0].get<double>() : 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
      CHECK(close(result.value().parameters[j] + shift, inputs["parameters"][j].get<double>(), oracle_tolerance));
      const double distance = (fit.curve(result.value().parameters[j]) - points[j]).norm();
      CHECK(std::abs(distance - fit.residuals[j]) < 1e-13);
    }
    ++(settings.interpolate_ends ? constrained : settings.topology == Topology::open ? open : closed);
  }
  CHECK(open == 5);
  CHECK(closed == 5);
  CHECK(constrained == 2);
}

TEST_CASE("curve fit: a closed curve of 20 distinct points comes nearly ten times as close as the report's open one") {
  const CurveFitSettings open, closed{.topology = Topology::closed};
  const double report = fit_curve(circle(20, 19), open).value().fit.rms;
  const double corrected = fit_curve(circle(20, 20), closed).value().fit.rms;
  CHECK(report == doctest::Approx(0.01704228));
  CHECK(corrected == doctest::Approx(0.00222691));
  CHECK(report > 7 * corrected);
}

TEST_CASE("curve fit: every choice of parameters and knots keeps its promise") {
  std::vector<Eigen::Vector3d> points;  // round a circle in uneven steps
  for (int j = 0; j < 17; ++j) {
    const double angle = 2 * std::numbers::pi * (j + 0.3 * std::sin(j)) / 17;
    points.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0.1 * j);
  }
  for (const double exponent : {uniform_exponent, centripetal_exponent, chord_length_exponent}) {
    for (const KnotPlacement placement : {KnotPlacement::even, KnotPlacement::averaged}) {
      for (const Topology topology : {Topology::open, Topology::closed}) {
        CAPTURE(exponent);
        const Result<CurveFit> fit = fit_curve(
            points, {.degree = 3, .count = 9, .topology = topology, .exponent = exponent, .knots = placement});
        REQUIRE(fit);
        const KnotVector& knots = fit.value().fit.curve.knots();
        CHECK(knots.topology() == topology);
        CHECK(knots.count() == 9);
        CHECK(knots.period() == doctest::Approx(topology == Topology::open ? 6 : 9));
        const std::vector<double> expected =
            parameterize(points, exponent, topology, 0, topology == Topology::open ? 6 : 9).value();
        CHECK(fit.value().parameters == expected);
        if (placement == KnotPlacement::averaged) {
          const KnotVector averaged = averaged_knots(3, 9, topology, expected, 9).value();
          CHECK(std::equal(averaged.knots().begin(), averaged.knots().end(), knots.knots().begin()));
        }
      }
    }
  }
}

TEST_CASE("curve fit: as many control points as data interpolates, interpolated ends are met exactly") {
  const std::vector<Eigen::Vector3d> points = bent_line();
  CurveFitSettings settings{.count = 17, .exponent = chord_length_exponent, .knots = KnotPlacement::averaged};
  CHECK(fit_curve(points, settings).value().fit.maximum < 1e-11);
  settings = {.count = 6, .interpolate_ends = true};
  const CurveFit held = fit_curve(points, settings).value();
  CHECK(held.fit.curve.points().front() == points.front());
  CHECK(held.fit.curve.points().back() == points.back());
  CHECK(held.fit.rms > fit_curve(points, {.count = 6}).value().fit.rms);
}

TEST_CASE("curve fit: what cannot be fitted is refused in words about points, control points and basis functions") {
  const std::vector<Eigen::Vector3d> points = bent_line();
  CHECK(refusal(std::span(points).first(5), {.count = 8}).message ==
        "There are 5 points for 8 control points: give more points, use fewer control points, or smooth.");
  CHECK(refusal(std::span(points).first(5), {.count = 8}).path == "points");
  CHECK(refusal(std::span(points).first(5), {.count = 8, .knots = KnotPlacement::averaged, .smoothing = 1})
            .message.find("averaged knots need at least as many points") != std::string::npos);
  CHECK(fit_curve(std::span(points).first(5), {.count = 8, .smoothing = 1}));
  CHECK(refusal(std::span(points).first(1), {}).path == "points");
  CHECK(refusal({}, {}).path == "points");
  CHECK(refusal(points, {.degree = 0}).path == "degree");
  CHECK(refusal(points, {.degree = 17, .count = 17}).path == "degree");
  CHECK(refusal(points, {.degree = 3, .count = 3}).path == "count");
  CHECK(refusal(points, {.count = std::numeric_limits<int>::min()}).path == "count");
  CHECK(refusal(points, {.count = 1 << 30}).path == "count");
  CHECK(refusal(points, {.exponent = 2}).path == "exponent");
  CHECK(refusal(points, {.smoothing = -1}).path == "smoothing");
  CHECK(refusal(points, {.topology = Topology::closed, .interpolate_ends = true}).path == "interpolate_ends");
  // Even degree, an even number of points at even knots: the curve is not determined (least_squares.h).
  CHECK(refusal(std::span(points).first(16), {.degree = 2, .count = 16, .topology = Topology::closed}).path ==
        "parameters");
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e60}) {
    std::vector<Eigen::Vector3d> spoilt = points;
    spoilt[11].y() = wrong;
    CHECK(refusal(spoilt, {}).path == "points[11]");
  }
}

TEST_CASE("curve fit: data that coincide") {
  const std::vector<Eigen::Vector3d> one_place(12, Eigen::Vector3d(1, 2, 3));
  CHECK(fit_curve(one_place, {.count = 6}).value().fit.maximum < 1e-14);
  CHECK(refusal(one_place, {.count = 6, .exponent = chord_length_exponent}).message == "All points are in one place.");

  // Twelve points, of which the first nine coincide: chord lengths put nine parameters in one place.
  std::vector<Eigen::Vector3d> crowded = bent_line();
  crowded.resize(12);
  for (int j = 0; j < 9; ++j) crowded[static_cast<std::size_t>(j)] = crowded[0];
  CHECK(fit_curve(crowded, {.count = 8}));
  const Error unsupported = refusal(crowded, {.count = 8, .exponent = chord_length_exponent});
  CHECK(unsupported.path == "parameters");
  CHECK(unsupported.message.find("basis functions") != std::string::npos);
  const Error knots =
      refusal(crowded, {.count = 8, .exponent = chord_length_exponent, .knots = KnotPlacement::averaged});
  CHECK_FALSE(knots.message.empty());
}

TEST_CASE("curve fit: the errors for every n are those of the fits") {
  const std::vector<Eigen::Vector3d> points = circle(20, 19);
  const std::vector<CurveFitError> errors = fit_errors(points, {}, 20);
  REQUIRE(errors.size() == 17);
  CHECK(errors.front().count == 4);
  CHECK(errors.back().count == 20);
  CHECK(errors.back().maximum < 1e-12);
  for (const CurveFitError& error : errors) {
    const CurveFit fit = fit_curve(points, {.count = error.count}).value();
    CHECK(error.rms == fit.fit.rms);
    CHECK(error.maximum == fit.fit.maximum);
  }
  // More control points than data are left out.
  CHECK(fit_errors(points, {}, 40).size() == 17);
  CHECK(fit_errors(points, {.topology = Topology::closed}, 2).empty());
}

}  // namespace knotwork::curve_fit_test
