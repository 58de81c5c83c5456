#include "knotwork/curve/taylor3.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "knotwork/basis/integer_power.h"
#include "knotwork/surface/taylor2.h"
#include "unit/oracle.h"

namespace knotwork::taylor3_test {
using namespace test;

namespace {

void check(const Taylor3& f, const Taylor3& expected, double tolerance = 2e-15) {
  const double actual_parts[] = {f.value, f.d1, f.d2, f.d3};
  const double expected_parts[] = {expected.value, expected.d1, expected.d2, expected.d3};
  double scale = 0;
  for (const double part : expected_parts) scale = std::max(scale, std::abs(part));
  for (int k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(close(actual_parts[k], expected_parts[k], tolerance, scale));
  }
}

constexpr double x = 0.7;
const Taylor3 t = Taylor3::variable(x);

}  // namespace

TEST_CASE("sums, products and quotients in t carry the derivatives of the function") {
  check(t + t * t, {x + x * x, 1 + 2 * x, 2, 0});
  check(t - t * t, {x - x * x, 1 - 2 * x, -2, 0});
  check(-t, {-x, -1, 0, 0});
  check(2 + 3 * t, {2 + 3 * x, 3, 0, 0});
  check(t * t * t * t, {x * x * x * x, 4 * x * x * x, 12 * x * x, 24 * x});
  check(1 / t, {1 / x, -1 / (x * x), 2 / (x * x * x), -6 / (x * x * x * x)});
  check(t * t / (1 + t), 1 / (1 / t + 1 / (t * t)), 1e-14);
}

TEST_CASE("elementary functions of t^2 obey the chain rule to order 3") {
  const double p = x * x, s = std::sin(p), c = std::cos(p), e = std::exp(p);
  check(sin(t * t), {s, 2 * x * c, 2 * c - 4 * p * s, -12 * x * s - 8 * x * p * c});
  check(cos(t * t), {c, -2 * x * s, -2 * s - 4 * p * c, -12 * x * c + 8 * x * p * s});
  check(exp(t * t), {e, 2 * x * e, (2 + 4 * p) * e, (12 * x + 8 * x * p) * e});
  check(log(t * t), {std::log(p), 2 / x, -2 / p, 4 / (p * x)});
  check(sqrt(t * t * t * t), {p, 2 * x, 2, 0}, 1e-14);
  check(log(exp(t * t)), t * t, 4e-15);
}

TEST_CASE("integer powers of numbers and Taylor series, of 0 and of negative ones too") {
  CHECK(integer_power(-2.0, 3) == -8);
  CHECK(integer_power(0.0, 0) == 1);
  CHECK(integer_power(0.0, 5) == 0);
  check(integer_power(t - 1, 3), {std::pow(x - 1, 3), 3 * (x - 1) * (x - 1), 6 * (x - 1), 6});
  check(integer_power(t - x, 2), {0, 0, 2, 0});
  check(integer_power(t - x, 0), 1);
  const Taylor2 square = integer_power(Taylor2::variable_u(-3), 2);
  CHECK(square.value == 9);
  CHECK(square.u == -6);
  CHECK(square.uu == 2);
}

TEST_CASE("a point of Taylor series gives as many derivatives as are asked for") {
  std::array<Eigen::Vector3d, 4> out;
  derivatives({t, t * t, t * t * t}, out);
  CHECK(out[0] == Eigen::Vector3d(x, x * x, x * x * x));
  CHECK(close(out[1], {1, 2 * x, 3 * x * x}, 1e-15));
  CHECK(close(out[2], {0, 2, 6 * x}, 1e-15));
  CHECK(out[3] == Eigen::Vector3d(0, 0, 6));
  Eigen::Vector3d point;
  derivatives({t, 0, 1}, {&point, 1});
  CHECK(point == Eigen::Vector3d(x, 0, 1));
  derivatives({t, 0, 1}, {});
}

}  // namespace knotwork::taylor3_test
