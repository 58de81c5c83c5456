#include "knotwork/surface/taylor2.h"

#include <array>

namespace knotwork {
namespace {

/// Below this |x| the closed forms of the derivatives cancel; there the power series is exact to rounding.
constexpr double series_limit = 1.0;
constexpr int series_terms = 11;

/// sum_k (-1)^k x^(2k) / (2k + shift)!
template <int shift>
constexpr std::array<double, series_terms> series = [] {
  std::array<double, series_terms> c{};
  double factorial = 1;
  for (int f = 2; f <= shift; ++f) factorial *= f;
  for (int k = 0; k < series_terms; ++k) {
    if (k > 0) factorial *= (2 * k + shift) * (2 * k + shift - 1);
    c[static_cast<std::size_t>(k)] = (k % 2 == 0 ? 1 : -1) / factorial;
  }
  return c;
}();

/// The series with its first two derivatives by Horner's rule in x^2, for |x| <= series_limit.
Taylor2 even_series(const Taylor2& f, const std::array<double, series_terms>& c) {
  const double x = f.value, z = x * x;
  double y = 0, y1 = 0, y2 = 0;
  for (int k = series_terms - 1; k >= 1; --k) {
    const double ck = c[static_cast<std::size_t>(k)];
    y = y * z + ck;
    y1 = y1 * z + 2 * k * ck;
    y2 = y2 * z + 2 * k * (2 * k - 1) * ck;
  }
  return compose(f, y * z + c[0], y1 * x, y2);
}

}  // namespace

Taylor2 sinc(const Taylor2& f) {
  const double x = f.value;
  if (std::abs(x) < series_limit) return even_series(f, series<1>);
  const double y = std::sin(x) / x;
  const double y1 = (std::cos(x) - y) / x;
  return compose(f, y, y1, -y - 2 * y1 / x);
}

Taylor2 cosc(const Taylor2& f) {
  const double x = f.value;
  if (std::abs(x) < series_limit) return even_series(f, series<2>);
  const double half = std::sin(x / 2);
  const double y = 2 * half * half / (x * x);
  const double y1 = (std::sin(x) / x - 2 * y) / x;
  return compose(f, y, y1, (std::cos(x) - 4 * x * y1 - 2 * y) / (x * x));
}

}  // namespace knotwork
