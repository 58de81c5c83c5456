#include "knotwork/basis/bernstein.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/LU>

#include "unit/oracle.h"

namespace knotwork::bernstein_test {
using namespace test;
namespace {

std::vector<double> row(int degree, double t, int order = 0, double delta = 1) {
  std::vector<double> out(static_cast<std::size_t>(degree) + 1);
  bernstein_derivative(degree, t, order, delta, out);
  return out;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("Bernstein-Hermite matrices meet oracle 10") {
  const nlohmann::json& oracle = load_oracle("10_bernstein_hermite.json");
  REQUIRE(oracle.contains("bernstein_hermite"));
  int matrices = 0;
  for (const nlohmann::json& entry : oracle["bernstein_hermite"]) {
    read_case(entry);
    const int degree = entry["degree"].get<int>();
    const double t = entry["t"].get<double>(), delta = entry["delta"].get<double>();
    const Eigen::MatrixXd actual = bernstein_hermite(degree, t, delta);
    const nlohmann::json& expected = entry["matrix_row_r_is_delta^r_Dr_b_{d,k}(t)"];
    REQUIRE(actual.rows() == degree + 1);
    for (int r = 0; r <= degree; ++r) {
      CAPTURE(degree);
      CAPTURE(r);
      // Derivatives are differences of terms of the row's largest size.
      const double scale = r == 0 ? 0 : actual.row(r).cwiseAbs().maxCoeff();
      for (int k = 0; k <= degree; ++k) {
        CHECK(close(actual(r, k), expected[static_cast<std::size_t>(r)][static_cast<std::size_t>(k)].get<double>(),
                    oracle_tolerance, scale));
      }
    }
    ++matrices;
  }
  CHECK(matrices == 24);
}

TEST_CASE(
    "the cubic and quintic Hermite bases of oracle 10 are the Bernstein-Hermite matrices of both ends, inverted") {
  const nlohmann::json& oracle = load_oracle("10_bernstein_hermite.json");
  REQUIRE(oracle["hermite"].size() == 6);
  for (const nlohmann::json& entry : oracle["hermite"]) {
    read_case(entry);
    for (const int degree : {3, 5}) {
      // The data in the oracle's order: both points, both first derivatives, ...
      Eigen::MatrixXd ends(degree + 1, degree + 1);
      const Eigen::MatrixXd start = bernstein_hermite(degree, 0), end = bernstein_hermite(degree, 1);
      for (int r = 0; 2 * r <= degree; ++r) ends.row(2 * r) = start.row(r), ends.row(2 * r + 1) = end.row(r);
      const Eigen::MatrixXd basis = bernstein_hermite(degree, entry["t"].get<double>()) * ends.inverse();
      const nlohmann::json& expected = entry[degree == 3 ? "H3_rows_derivative_0_3" : "H5_rows_derivative_0_5"];
      for (int r = 0; r <= degree; ++r) {
        // Derivatives are differences of terms of the row's largest size.
        const double scale = std::max(basis.row(r).cwiseAbs().maxCoeff(), 1.0);
        for (int k = 0; k <= degree; ++k) {
          CAPTURE(degree);
          CAPTURE(r);
          const double value = expected[static_cast<std::size_t>(r)][static_cast<std::size_t>(k)].get<double>();
          CHECK(close(basis(r, k), value, oracle_tolerance, scale));
        }
      }
    }
  }
}

TEST_CASE("Bernstein polynomials are a partition of unity, and symmetric, up to the highest degree") {
  for (int degree = 0; degree <= max_bezier_degree; ++degree) {
    for (const double t : {0.0, 0x1p-30, 0.125, 0.5, 0.75, 1.0}) {
      const std::vector<double> b = row(degree, t), mirrored = row(degree, 1 - t);
      CHECK(close(sum(b), 1.0, 1e-14));
      for (std::size_t k = 0; k < b.size(); ++k) {
        CHECK(b[k] >= 0);
        CHECK(close(b[k], mirrored[b.size() - 1 - k], 1e-13));
      }
      if (degree > 0) CHECK(std::abs(sum(row(degree, t, 1))) <= 1e-13 * degree);
      CHECK(sum(row(degree, t, degree + 1)) == 0);
    }
  }
}

TEST_CASE("Hermite data at a point give back the Taylor polynomial's Bezier points") {
  // c(t) = (t-0.3)^2 on [0,1] has the Bezier points 0.09, -0.21, 0.49.
  const Eigen::Vector3d points(0.09, -0.21, 0.49);
  const Eigen::Vector3d hermite = bernstein_hermite(2, 0.8) * points;
  CHECK(close(hermite, Eigen::Vector3d(0.25, 1.0, 2.0), 1e-14));
  CHECK(close(Eigen::Vector3d(bernstein_hermite(2, 0.8).inverse() * Eigen::Vector3d(0.25, 1.0, 2.0)), points, 1e-13));
}

}  // namespace knotwork::bernstein_test
