// Agreement with SciPy on random splines: the numbers of tests/data/scipy_reference.json, which
// tests/data/make_scipy_reference.py computes. The oracles beside it are exact and few; this file covers degrees 1 to 9.
//
// Tolerances are relative to the terms that a number is the sum of. SciPy's own rounding is in them: positions,
// derivatives, integrals and inserted knots agree to 1e-12; least squares to 1e-11, as SciPy solves the normal
// equations, which lose the square of the condition number; lengths to 1e-11, as its quadrature is adaptive.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/least_squares.h"
#include "unit/bspline_cases.h"

namespace knotwork::scipy_reference_test {
using namespace test;
namespace {

const nlohmann::json& cases(const char* list) {
  const nlohmann::json& reference = load_oracle("scipy_reference.json");
  REQUIRE(reference.contains(list));
  return reference[list];
}

KnotVector knots_of(const nlohmann::json& entry, const char* degree, const char* knots, Topology topology) {
  return KnotVector::make(entry[degree].get<int>(), topology, entry[knots].get<std::vector<double>>()).value();
}

BSplineCurve curve_of(const nlohmann::json& entry, Topology topology) {
  return BSplineCurve::make(knots_of(entry, "degree", "knots", topology), vectors(entry["points"])).value();
}

void check_points(std::span<const Eigen::Vector3d> actual, const nlohmann::json& expected, double tolerance,
                  double size) {
  REQUIRE(actual.size() == expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) CHECK(close(actual[i], vector3(expected[i]), tolerance, size));
}

void check_derivatives(const nlohmann::json& entry, const BSplineCurve& curve) {
  for (std::size_t m = 0; m < entry["t"].size(); ++m) {
    const double t = entry["t"][m].get<double>();
    const nlohmann::json& expected = entry["derivatives"][m];
    CAPTURE(curve.degree());
    CAPTURE(t);
    std::vector<Eigen::Vector3d> out(expected.size());
    curve.evaluate(t, out);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double size = derivative_size(curve, t, static_cast<int>(k));
      CHECK(close(out[k], vector3(expected[k]), oracle_tolerance, size));
    }
  }
}

/// The integral of a curve is a spline of one degree more: point i+1 minus point i is c_i (t_{i+p+1} - t_i) / (p+1).
BSplineCurve integral(const BSplineCurve& curve) {
  const KnotVector& knots = curve.knots();
  const int p = curve.degree();
  std::vector<double> more(knots.knots().begin(), knots.knots().end());
  more.insert(more.begin(), more.front());
  more.push_back(more.back());
  std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Zero()};
  for (int i = 0; i < knots.count(); ++i)
    points.emplace_back(points.back() + (knots[i + p + 1] - knots[i]) / (p + 1) * curve.point(i));
  return BSplineCurve::make(KnotVector::make(p + 1, Topology::open, more).value(), points).value();
}

}  // namespace

TEST_CASE("SciPy: open curves of degree 1 to 9, repeated knots, clamped or not") {
  REQUIRE(cases("open_curves").size() == 18);
  for (const nlohmann::json& entry : cases("open_curves")) {
    const BSplineCurve curve = curve_of(entry, Topology::open);
    check_derivatives(entry, curve);
    CHECK(close(arc_length(curve_view(curve)), entry["length"].get<double>(), 1e-11));

    const BSplineCurve primitive = integral(curve);
    const Eigen::Vector3d start = primitive(curve.knots().start());
    for (std::size_t m = 0; m < entry["t"].size(); ++m) {
      const double t = entry["t"][m].get<double>();
      CHECK(close(primitive(t) - start, vector3(entry["integrals"][m]), oracle_tolerance, polygon_size(primitive)));
    }
  }
}

TEST_CASE("SciPy: closed curves of degree 1 to 9") {
  REQUIRE(cases("closed_curves").size() == 9);
  for (const nlohmann::json& entry : cases("closed_curves"))
    check_derivatives(entry, curve_of(entry, Topology::closed));
}

TEST_CASE("SciPy: tensor-product surfaces with partials") {
  REQUIRE(cases("surfaces").size() == 7);
  constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
  for (const nlohmann::json& entry : cases("surfaces")) {
    const KnotVector u = knots_of(entry, "degree_u", "knots_u", Topology::open);
    const KnotVector v = knots_of(entry, "degree_v", "knots_v", Topology::open);
    std::vector<Eigen::Vector3d> points;
    double largest = 0;
    for (const nlohmann::json& row : entry["net"]) {
      for (const nlohmann::json& point : row) {
        points.push_back(vector3(point));
        largest = std::max(largest, points.back().norm());
      }
    }
    const BSplineSurface surface = BSplineSurface::make(u, v, points).value();
    for (std::size_t m = 0; m < entry["u"].size(); ++m) {
      const double a = entry["u"][m].get<double>(), b = entry["v"][m].get<double>();
      const SurfaceJet jet = surface.evaluate(a, b);
      CAPTURE(u.degree());
      CAPTURE(v.degree());
      for (int k = 0; k < 6; ++k) {
        const double size = largest * basis_size(u, a, orders[k][0]) * basis_size(v, b, orders[k][1]);
        CHECK(close(jet_part(jet, k), vector3(entry["jets"][m][static_cast<std::size_t>(k)]), oracle_tolerance, size));
      }
    }
  }
}

TEST_CASE("SciPy: least squares, with and without weights") {
  REQUIRE(cases("least_squares").size() == 7);
  for (const nlohmann::json& entry : cases("least_squares")) {
    const KnotVector knots = knots_of(entry, "degree", "knots", Topology::open);
    const std::vector<Eigen::Vector3d> data = vectors(entry["data"]);
    const std::vector<double> x = entry["x"].get<std::vector<double>>();
    const std::vector<double> weights = entry["weights"].get<std::vector<double>>();
    CAPTURE(knots.degree());
    const Result<LeastSquaresFit> plain = fit_least_squares(knots, data, x);
    const Result<LeastSquaresFit> weighted = fit_least_squares(knots, data, x, {.weights = weights});
    REQUIRE(plain);
    REQUIRE(weighted);
    check_points(plain.value().curve.points(), entry["points"], 1e-11, polygon_size(plain.value().curve));
    check_points(weighted.value().curve.points(), entry["weighted_points"], 1e-11,
                 polygon_size(weighted.value().curve));
  }
}

TEST_CASE("SciPy (FITPACK): knot insertion") {
  REQUIRE(cases("insertions").size() == 5);
  for (const nlohmann::json& entry : cases("insertions")) {
    const BSplineCurve curve = curve_of(entry, Topology::open);
    const BSplineCurve refined = curve.with_knot(entry["t"].get<double>()).value();
    const std::vector<double> knots(refined.knots().knots().begin(), refined.knots().knots().end());
    CHECK(knots == entry["new_knots"].get<std::vector<double>>());
    check_points(refined.points(), entry["new_points"], oracle_tolerance, polygon_size(curve));
  }
}

}  // namespace knotwork::scipy_reference_test
