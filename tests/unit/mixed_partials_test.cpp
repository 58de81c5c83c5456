#include "knotwork/surface/mixed_partials.h"

#include <cmath>
#include <vector>

#include "knotwork/surface/mixed_series.h"
#include "unit/oracle.h"

namespace knotwork::mixed_partials_test {
using namespace test;

namespace {

/// D^(p,q)/(p! q!) of f against the expected values for p, q <= 3.
template <class Expected>
void check_series(const MixedSeries& f, Expected expected, double tolerance = 1e-14) {
  for (int p = 0; p <= 3; ++p) {
    for (int q = 0; q <= 3; ++q) {
      CAPTURE(p);
      CAPTURE(q);
      CHECK(
          close(f.coefficient(static_cast<std::size_t>(p), static_cast<std::size_t>(q)), expected(p, q), tolerance, 1));
    }
  }
}

double power(double x, int n) { return std::pow(x, n); }
double factorial(int n) { return std::tgamma(n + 1.0); }

}  // namespace

TEST_CASE("mixed series: elementary functions of sums and products have their known coefficients") {
  const MixedSeries u = MixedSeries::variable_u(0.7), v = MixedSeries::variable_v(0.4);
  const double x = 0.7, y = 0.4, root = std::sqrt(x);
  const auto by_u = [](std::array<double, 4> c) {
    return [c](int p, int q) { return q == 0 ? c[static_cast<std::size_t>(p)] : 0.0; };
  };
  check_series(exp(u + 2.0 * v),
               [&](int p, int q) { return std::exp(x + 2 * y) * power(2, q) / (factorial(p) * factorial(q)); });
  check_series(sin(u - v), [&](int p, int q) {
    const int n = p + q;
    const double turned = std::sin(x - y + n * std::acos(-1.0) / 2);
    return turned * (q % 2 == 0 ? 1 : -1) / (factorial(p) * factorial(q));
  });
  check_series(cos(u - v), [&](int p, int q) {
    const double turned = std::cos(x - y + (p + q) * std::acos(-1.0) / 2);
    return turned * (q % 2 == 0 ? 1 : -1) / (factorial(p) * factorial(q));
  });
  check_series(log(u), by_u({std::log(x), 1 / x, -0.5 / (x * x), 1 / (3 * x * x * x)}));
  check_series(sqrt(u), by_u({root, 0.5 / root, -0.125 / (x * root), 0.0625 / (x * x * root)}));
  check_series(1.0 / u, by_u({1 / x, -1 / (x * x), 1 / (x * x * x), -1 / (x * x * x * x)}));
  check_series(u * u * v / v, by_u({x * x, 2 * x, 1, 0}));
  check_series(
      exp(log(u * v)) - u * v, [](int, int) { return 0.0; }, 1e-13);
}

TEST_CASE("mixed series: sinc and cosc are one function on both sides of the change of formula, and at 0") {
  for (const double x : {0.0, 1e-9, 0.3, 0.999, 1.001, 2.5, -1.5, -0.2}) {
    CAPTURE(x);
    const MixedSeries f = MixedSeries::variable_u(x) + MixedSeries::variable_v(0);
    const MixedSeries s = sinc(f), c = cosc(f);
    check_series(
        s * f - sin(f), [](int, int) { return 0.0; }, 1e-13);
    check_series(
        c * f * f + cos(f), [](int p, int q) { return p == 0 && q == 0 ? 1.0 : 0.0; }, 1e-13);
    const Taylor2 t = sinc(Taylor2::variable_u(x)), d = cosc(Taylor2::variable_u(x));
    CHECK(close(s.coefficient(1, 0), t.u, 1e-14, 1));
    CHECK(close(2 * s.coefficient(2, 0), t.uu, 1e-14, 1));
    CHECK(close(c.coefficient(1, 0), d.u, 1e-14, 1));
    CHECK(close(2 * c.coefficient(2, 0), d.uu, 1e-14, 1));
  }
  // sinc x = 1 - x^2/6 + x^4/120 - ..: the third derivatives in each direction of sinc(u+v) at 0 is -1/7.
  const MixedSeries at_zero = sinc(MixedSeries::variable_u(0) + MixedSeries::variable_v(0));
  CHECK(close(36 * at_zero.coefficient(3, 3), -1.0 / 7, 1e-14));
}

TEST_CASE("mixed partials to order 2 are those of the point's evaluation; higher ones are their differences") {
  std::vector<ModelSurface> models{Sheet{1, 1}, Sheet{0, 0.3}, Sheet{0.6, 1}};
  for (const CatalogueSurfaceRow& row : surface_catalogue())
    models.emplace_back(make_catalogue_surface(row.id).value());
  for (const ModelSurface& model : models) {
    CAPTURE(model_name(model));
    const SurfaceDomain where = domain(model);
    const double width_u = where.u.end - where.u.start, width_v = where.v.end - where.v.start;
    for (const double a : {0.21, 0.77}) {
      const double u = where.u.start + a * width_u, v = where.v.start + (a == 0.21 ? 0.3 : 0.83) * width_v;
      std::vector<Eigen::Vector3d> at(16);
      mixed_partials(model, u, v, 3, 3, at);
      const SurfaceJet jet = evaluate(model, u, v);
      const int place[6] = {0, 4, 1, 8, 5, 2};
      double largest = 0;
      for (int k = 0; k < 6; ++k) largest = std::max(largest, jet_part(jet, k).norm());
      for (int k = 0; k < 6; ++k) {
        CAPTURE(jet_names[k]);
        CHECK(close(at[static_cast<std::size_t>(place[k])], jet_part(jet, k), 1e-13, largest));
      }
      // D^(p+1,q) against an eighth-order difference of D^(p,q), and D^(p,q+1) likewise; a halved one is rejected.
      constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
      for (const bool in_u : {true, false}) {
        const double h = 1e-3 * (in_u ? width_u : width_v);
        std::vector<Eigen::Vector3d> difference(16, Eigen::Vector3d::Zero());
        for (int k = 1; k <= 4; ++k) {
          std::vector<Eigen::Vector3d> right(16), left(16);
          mixed_partials(model, in_u ? u + k * h : u, in_u ? v : v + k * h, 3, 3, right);
          mixed_partials(model, in_u ? u - k * h : u, in_u ? v : v - k * h, 3, 3, left);
          for (std::size_t n = 0; n < 16; ++n) difference[n] += weights[k - 1] / h * (right[n] - left[n]);
        }
        for (std::size_t n = 0; n < 16; ++n) {
          const std::size_t next = n + (in_u ? 4 : 1);
          if (in_u ? n >= 12 : n % 4 == 3) continue;
          const double scale = 1e-2 * at[n].norm() / (in_u ? width_u : width_v);
          CAPTURE(n);
          CHECK(close(at[next], difference[n], 1e-6, scale + 1e-3 * largest));
          if (at[next].norm() > 1e-2 * largest) CHECK_FALSE(close(0.5 * at[next], difference[n], 1e-6, 0));
        }
      }
    }
  }
}

TEST_CASE("mixed partials of fewer orders are the same numbers") {
  const ModelSurface model = torus_surface(1, 0.4, 0.6);
  std::vector<Eigen::Vector3d> all(16), some(6);
  mixed_partials(model, 0.3, 1.1, 3, 3, all);
  mixed_partials(model, 0.3, 1.1, 1, 2, some);
  for (std::size_t p = 0; p <= 1; ++p) {
    for (std::size_t q = 0; q <= 2; ++q) CHECK(some[p * 3 + q] == all[p * 4 + q]);
  }
}

}  // namespace knotwork::mixed_partials_test
