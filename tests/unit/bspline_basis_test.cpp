#include "knotwork/basis/bspline_basis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "unit/bspline_cases.h"

namespace knotwork::bspline_basis_test {
using namespace test;

TEST_CASE("B-splines and their derivatives meet oracle 01") {
  int compared = 0;
  for (const CurveOracle& oracle : curve_oracles(Topology::open)) {
    const KnotVector& knots = oracle.curve.knots();
    for (const nlohmann::json& at : oracle.points) {
      const double t = at["t"].get<double>();
      const int span = knots.span(t);
      CHECK(span == at["span"].get<int>());
      const nlohmann::json& rows = at["basis_derivatives"];
      const std::size_t width = static_cast<std::size_t>(knots.degree()) + 1;
      std::vector<double> basis(width * rows.size());
      bspline_basis(knots, span, t, static_cast<int>(rows.size()) - 1, basis);
      for (std::size_t k = 0; k < rows.size(); ++k) {
        double scale = 0;
        for (const nlohmann::json& value : rows[k]) scale = std::max(scale, std::abs(value.get<double>()));
        for (std::size_t j = 0; j < width; ++j) {
          CAPTURE(t);
          CAPTURE(k);
          CHECK(close(basis[k * width + j], rows[k][j].get<double>(), oracle_tolerance, k == 0 ? 0 : scale));
          ++compared;
        }
      }
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("row 0 sums to 1 and the others to 0, on knots of every kind and size") {
  for (const double size : {1e-9, 1.0, 1e9}) {
    const KnotVector open =
        KnotVector::make(3, Topology::open,
                         {0, 0, 0, 0, size, size, 1.5 * size, 4 * size, 4 * size, 4 * size, 4 * size})
            .value();
    const KnotVector closed = KnotVector::uniform(4, 5, Topology::closed, -size, size).value();
    for (const KnotVector& knots : {open, closed}) {
      for (int step = 0; step <= 40; ++step) {
        const double t = knots.reduced(knots.start() + (knots.end() - knots.start()) * step / 40);
        const std::size_t width = static_cast<std::size_t>(knots.degree()) + 1;
        std::vector<double> basis(3 * width);
        bspline_basis(knots, knots.span(t), t, 2, basis);
        for (std::size_t k = 0; k < 3; ++k) {
          double sum = 0, scale = 0;
          for (std::size_t j = 0; j < width; ++j) {
            sum += basis[k * width + j];
            scale = std::max(scale, std::abs(basis[k * width + j]));
            if (k == 0) CHECK(basis[j] >= 0);
          }
          CHECK(close(sum, k == 0 ? 1.0 : 0.0, 1e-14, 8 * scale));
        }
      }
    }
  }
}

TEST_CASE("derivatives above the degree are 0") {
  const KnotVector knots = KnotVector::uniform(2, 4, Topology::open, 0, 2).value();
  std::vector<double> basis(3 * 6, 7.0);
  bspline_basis(knots, 2, 0.5, 5, basis);
  for (std::size_t k = 9; k < basis.size(); ++k) CHECK(basis[k] == 0);
}

TEST_CASE("the values of many parameters, column after column, are those of each") {
  std::mt19937 random(31);
  for (int degree = 1; degree <= KnotVector::max_degree; ++degree) {
    for (const double size : {1e-250, 1.0, 1e90}) {
      const KnotVector open = KnotVector::uniform(degree, degree + 3, Topology::open, 0, size).value();
      const KnotVector closed = KnotVector::uniform(degree, degree + 3, Topology::closed, -size, size).value();
      for (const KnotVector& knots : {open, closed}) {
        for (const std::size_t count : {1U, 7U, 8U, 29U}) {
          const int span = knots.degree() + 1;
          std::uniform_real_distribution<double> place(knots[span], knots[span + 1]);
          std::vector<double> t(count);
          for (double& x : t) x = place(random);
          t.front() = knots[span];
          t.back() = knots[span + 1];
          const std::size_t width = static_cast<std::size_t>(degree) + 1;
          std::vector<double> columns(width * count), one(width);
          bspline_basis_columns(knots, span, t, columns);
          for (std::size_t k = 0; k < count; ++k) {
            bspline_basis(knots, span, t[k], 0, one);
            for (std::size_t j = 0; j < width; ++j) CHECK(close(columns[j * count + k], one[j], 1e-14));
          }
        }
      }
    }
  }
}

}  // namespace knotwork::bspline_basis_test
