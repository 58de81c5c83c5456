#include "knotwork/curve/bezier_curve.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "unit/oracle.h"

namespace knotwork::bezier_curve_test {
using namespace test;
namespace {

BezierCurve random_curve(int degree, std::mt19937& random, double start = 0, double end = 1) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= degree; ++k) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return BezierCurve::make(std::move(points), start, end).value();
}

}  // namespace

TEST_CASE("a Bezier curve begins and ends in its outer points, along its outer legs") {
  std::mt19937 random(1);
  for (int degree = 1; degree <= max_bezier_degree; ++degree) {
    const BezierCurve curve = random_curve(degree, random, -2, 3);
    CHECK(curve(-2) == curve.points().front());
    CHECK(curve(3) == curve.points().back());
    std::array<Eigen::Vector3d, 2> at;
    curve.evaluate(-2, at);
    CHECK(close(at[1], Eigen::Vector3d(degree * (curve.points()[1] - curve.points()[0]) / 5), 1e-14));
  }
}

TEST_CASE("de Casteljau's last point is the curve's; outside, parameters are clamped") {
  std::mt19937 random(2);
  for (int degree = 0; degree <= max_bezier_degree; ++degree) {
    const BezierCurve curve = random_curve(degree, random);
    for (const double t : {0.0, 0.125, 0.7, 1.0}) {
      const PointTriangle triangle = curve.de_casteljau(t);
      REQUIRE(triangle.size() == static_cast<std::size_t>(degree) + 1);
      CHECK(triangle.back().size() == 1);
      CHECK(close(triangle.back().front(), curve(t), 1e-14, 5));
    }
    CHECK(curve(-7) == curve(0));
    CHECK(curve(1.5) == curve(1));
  }
}

TEST_CASE("derivatives of a Bezier curve are those of its hodograph") {
  std::mt19937 random(3);
  for (int degree = 1; degree <= max_bezier_degree; ++degree) {
    const BezierCurve curve = random_curve(degree, random, 0, 2);
    std::vector<Eigen::Vector3d> legs;
    for (std::size_t k = 0; k + 1 < curve.points().size(); ++k)
      legs.emplace_back(degree * (curve.points()[k + 1] - curve.points()[k]) / 2);
    const BezierCurve hodograph = BezierCurve::make(std::move(legs), 0, 2).value();
    for (const double t : {0.0, 0.3, 1.1, 2.0}) {
      std::array<Eigen::Vector3d, 4> whole;
      std::array<Eigen::Vector3d, 3> lower;
      curve.evaluate(t, whole);
      hodograph.evaluate(t, lower);
      for (std::size_t k = 0; k < lower.size(); ++k) {
        const double scale = 10 * std::pow(degree, static_cast<double>(k) + 1);
        CHECK(close(whole[k + 1], lower[k], 1e-13, scale));
        // The check sees a wrong factor.
        if (lower[k].norm() > 0.1 * scale)
          CHECK_FALSE(close(whole[k + 1], Eigen::Vector3d(1.001 * lower[k]), 1e-13, scale));
      }
    }
  }
}

TEST_CASE("elevation and splitting keep the curve") {
  std::mt19937 random(4);
  for (int degree = 1; degree < max_bezier_degree; ++degree) {
    const BezierCurve curve = random_curve(degree, random, 1, 4);
    const BezierCurve elevated = curve.elevated();
    CHECK(elevated.degree() == degree + 1);
    const auto [before, after] = curve.split(2.5);
    CHECK(before.end() == 2.5);
    CHECK(before.points().back() == after.points().front());
    for (const double t : {1.0, 1.3, 2.5, 3.9, 4.0}) {
      CHECK(close(elevated(t), curve(t), 1e-13, 5));
      CHECK(close((t < 2.5 ? before : after)(t), curve(t), 1e-13, 5));
    }
  }
}

TEST_CASE("a batch is the single evaluations") {
  std::mt19937 random(5);
  const BezierCurve curve = random_curve(5, random);
  const std::array<double, 3> t{0.9, 0.1, 0.5};
  std::array<Eigen::Vector3d, 9> batch;
  curve.evaluate(t, 2, batch);
  for (std::size_t m = 0; m < t.size(); ++m) {
    std::array<Eigen::Vector3d, 3> one;
    curve.evaluate(t[m], one);
    for (std::size_t k = 0; k < 3; ++k) CHECK(batch[3 * m + k] == one[k]);
  }
}

TEST_CASE("what is no Bezier curve is refused, with the place") {
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const auto path = [](std::vector<Eigen::Vector3d> points, double start, double end) {
    return BezierCurve::make(std::move(points), start, end).error().path;
  };
  CHECK(path({}, 0, 1) == "points");
  CHECK(path(std::vector<Eigen::Vector3d>(18, origin), 0, 1) == "points");
  CHECK(BezierCurve::make(std::vector<Eigen::Vector3d>(17, origin)).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK(path({origin, {0, nan, 0}}, 0, 1) == "points[1]");
  CHECK(path({origin, {infinity, 0, 0}}, 0, 1) == "points[1]");
  CHECK(path({origin, origin}, infinity, 1) == "start");
  CHECK(path({origin, origin}, 0, nan) == "end");
  CHECK(path({origin, origin}, 1, 1) == "end");
}

}  // namespace knotwork::bezier_curve_test
