#include "knotwork/curve/taylor3.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace knotwork {

Taylor3 operator-(const Taylor3& f) { return {-f.value, -f.d1, -f.d2, -f.d3}; }

Taylor3 operator+(const Taylor3& f, const Taylor3& g) {
  return {f.value + g.value, f.d1 + g.d1, f.d2 + g.d2, f.d3 + g.d3};
}

Taylor3 operator-(const Taylor3& f, const Taylor3& g) {
  return {f.value - g.value, f.d1 - g.d1, f.d2 - g.d2, f.d3 - g.d3};
}

Taylor3 operator*(const Taylor3& f, const Taylor3& g) {
  return {f.value * g.value, f.d1 * g.value + f.value * g.d1, f.d2 * g.value + 2 * f.d1 * g.d1 + f.value * g.d2,
          f.d3 * g.value + 3 * (f.d2 * g.d1 + f.d1 * g.d2) + f.value * g.d3};
}

Taylor3 operator+(double c, const Taylor3& f) { return {c + f.value, f.d1, f.d2, f.d3}; }

Taylor3 operator*(double c, const Taylor3& f) { return {c * f.value, c * f.d1, c * f.d2, c * f.d3}; }

Taylor3 operator/(const Taylor3& f, const Taylor3& g) {
  const double r = 1 / g.value;
  return f * compose(g, r, -r * r, 2 * r * r * r, -6 * r * r * r * r);
}

Taylor3 compose(const Taylor3& f, double y, double y1, double y2, double y3) {
  return {y, y1 * f.d1, y1 * f.d2 + y2 * f.d1 * f.d1, y1 * f.d3 + 3 * y2 * f.d1 * f.d2 + y3 * f.d1 * f.d1 * f.d1};
}

Taylor3 sin(const Taylor3& f) {
  const double s = std::sin(f.value), c = std::cos(f.value);
  return compose(f, s, c, -s, -c);
}

Taylor3 cos(const Taylor3& f) {
  const double s = std::sin(f.value), c = std::cos(f.value);
  return compose(f, c, -s, -c, s);
}

Taylor3 exp(const Taylor3& f) {
  const double e = std::exp(f.value);
  return compose(f, e, e, e, e);
}

Taylor3 log(const Taylor3& f) {
  const double r = 1 / f.value;
  return compose(f, std::log(f.value), r, -r * r, 2 * r * r * r);
}

Taylor3 sqrt(const Taylor3& f) {
  const double s = std::sqrt(f.value), r = 1 / f.value;
  return compose(f, s, 0.5 * s * r, -0.25 * s * r * r, 0.375 * s * r * r * r);
}

void derivatives(const Taylor3Point& point, std::span<Eigen::Vector3d> out) {
  constexpr double Taylor3::*parts[] = {&Taylor3::value, &Taylor3::d1, &Taylor3::d2, &Taylor3::d3};
  assert(out.size() <= std::size(parts));
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = {point.x.*parts[k], point.y.*parts[k], point.z.*parts[k]};
  }
}

}  // namespace knotwork
