#include "knotwork/surface/taylor2.h"

namespace knotwork {
namespace {

/// Below this |x| the closed forms of the derivatives cancel; there 14 terms of the power series are exact to rounding.
constexpr double series_limit = 2.0;
constexpr int series_terms = 14;

/// sum_k (-1)^k x^(2k) / (2k + shift)! with its first two derivatives, for |x| <= series_limit.
Taylor2 even_series(const Taylor2& f, int shift) {
  const double x = f.value;
  double factorial = 1;
  for (int k = 2; k <= shift; ++k) factorial *= k;
  double coefficient = 1 / factorial;
  double y = coefficient, y1 = 0, y2 = 0;
  double x_power = 1;  // x^(2k-2)
  for (int k = 1; k < series_terms; ++k) {
    coefficient /= -static_cast<double>((2 * k + shift) * (2 * k + shift - 1));
    y += coefficient * x_power * x * x;
    y1 += 2 * k * coefficient * x_power * x;
    y2 += 2 * k * (2 * k - 1) * coefficient * x_power;
    x_power *= x * x;
  }
  return compose(f, y, y1, y2);
}

}  // namespace

Taylor2 sinc(const Taylor2& f) {
  const double x = f.value;
  if (std::abs(x) < series_limit) return even_series(f, 1);
  const double y = std::sin(x) / x;
  const double y1 = (std::cos(x) - y) / x;
  return compose(f, y, y1, -y - 2 * y1 / x);
}

Taylor2 cosc(const Taylor2& f) {
  const double x = f.value;
  if (std::abs(x) < series_limit) return even_series(f, 2);
  const double half = std::sin(x / 2);
  const double y = 2 * half * half / (x * x);
  const double y1 = (std::sin(x) / x - 2 * y) / x;
  return compose(f, y, y1, (std::cos(x) - 4 * x * y1 - 2 * y) / (x * x));
}

}  // namespace knotwork
