#include "knotwork/surface/taylor2.h"

#include <cmath>

#include "unit/oracle.h"

namespace knotwork::taylor2_test {
using namespace test;

namespace {

void check(const Taylor2& f, const Taylor2& expected, double tolerance = 1e-15) {
  const double actual_parts[] = {f.value, f.u, f.v, f.uu, f.uv, f.vv};
  const double expected_parts[] = {expected.value, expected.u, expected.v, expected.uu, expected.uv, expected.vv};
  double scale = 0;
  for (const double part : expected_parts) scale = std::max(scale, std::abs(part));
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    CHECK(close(actual_parts[k], expected_parts[k], tolerance, scale));
  }
}

const Taylor2 u = Taylor2::variable_u(0.7), v = Taylor2::variable_v(-0.4);
constexpr double x = 0.7, y = -0.4;

/// Derivative `order` of sum (-1)^k t^(2k) / (2k+shift)! term by term.
double entire(double t, int shift, int order) {
  long double sum = 0;
  for (int k = 0; k < 40; ++k) {
    long double term = k % 2 == 0 ? 1 : -1;
    for (int f = 2; f <= 2 * k + shift; ++f) term /= f;
    for (int d = 0; d < order; ++d) term *= 2 * k - d;
    const int power = 2 * k - order;
    if (power < 0) continue;
    for (int p = 0; p < power; ++p) term *= static_cast<long double>(t);
    sum += term;
  }
  return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("sums, products and quotients carry the partials of the function") {
  check(u + v, {x + y, 1, 1, 0, 0, 0});
  check(u - 2 * v, {x - 2 * y, 1, -2, 0, 0, 0});
  check(-u, {-x, -1, 0, 0, 0, 0});
  check(u * u * v, {x * x * y, 2 * x * y, x * x, 2 * y, 2 * x, 0});
  check(u / v, {x / y, 1 / y, -x / (y * y), 0, -1 / (y * y), 2 * x / (y * y * y)});
  check(1 / u, {1 / x, -1 / (x * x), 0, 2 / (x * x * x), 0, 0});
}

TEST_CASE("elementary functions obey the chain rule") {
  const double p = x * y, s = std::sin(p), c = std::cos(p), e = std::exp(p);
  check(sin(u * v), {s, y * c, x * c, -y * y * s, c - p * s, -x * x * s});
  check(cos(u * v), {c, -y * s, -x * s, -y * y * c, -s - p * c, -x * x * c});
  check(exp(u * v), {e, y * e, x * e, y * y * e, (1 + p) * e, x * x * e});
  check(log(u), {std::log(x), 1 / x, 0, -1 / (x * x), 0, 0});
  check(sqrt(u), {std::sqrt(x), 0.5 / std::sqrt(x), 0, -0.25 / (x * std::sqrt(x)), 0, 0});
  check(log(exp(u * v)), u * v, 4e-15);
  check(sqrt(exp(u) * exp(u)), exp(u), 4e-15);
}

TEST_CASE("sinc and cosc are accurate to rounding with both derivatives, at 0 and across the change of formula") {
  for (const double t : {0.0, 1e-300, 1e-20, 1e-8, 1e-4, 0.03, 0.5, 0.9999999, 1.0, 1.0000001, 1.5, 1.9999, 2.0001, 3.0,
                         3.14159265358979, 4.0, 6.28}) {
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(sign * t);
      const Taylor2 s = sinc(Taylor2::variable_u(sign * t)), c = cosc(Taylor2::variable_u(sign * t));
      CHECK(close(s.value, entire(sign * t, 1, 0), 2e-14, 1));
      CHECK(close(s.u, entire(sign * t, 1, 1), 2e-14, t < 0.5 ? 0 : 0.3));
      CHECK(close(s.uu, entire(sign * t, 1, 2), 2e-14, 0.3));
      CHECK(close(c.value, entire(sign * t, 2, 0), 2e-14, 0.5));
      CHECK(close(c.u, entire(sign * t, 2, 1), 2e-14, t < 0.5 ? 0 : 0.1));
      CHECK(close(c.uu, entire(sign * t, 2, 2), 2e-14, 0.1));
    }
  }
}

TEST_CASE("sinc and cosc take part in the chain rule") {
  const Taylor2 f = sinc(u * v), g = cosc(u * v);
  const Taylor2 direct_f = sin(u * v) / (u * v), direct_g = (1 - cos(u * v)) / (u * v * (u * v));
  check(f, direct_f, 1e-13);
  check(g, direct_g, 1e-13);
}

}  // namespace knotwork::taylor2_test
