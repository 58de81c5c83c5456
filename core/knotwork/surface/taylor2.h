#pragma once

#include <cmath>

namespace knotwork {

/// A function of (u,v) near one point, truncated after order 2: its value and its partial derivatives (not divided by
/// factorials). Written once with this scalar, a formula yields the point and all partials to order 2.
struct Taylor2 {
  double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;

  constexpr Taylor2() = default;
  // Implicit on purpose: constants in a formula are constants.
  constexpr Taylor2(double constant) : value(constant) {}
  constexpr Taylor2(double f, double f_u, double f_v, double f_uu, double f_uv, double f_vv)
      : value(f), u(f_u), v(f_v), uu(f_uu), uv(f_uv), vv(f_vv) {}

  /// The coordinate functions u and v themselves.
  static constexpr Taylor2 variable_u(double u) { return {u, 1, 0, 0, 0, 0}; }
  static constexpr Taylor2 variable_v(double v) { return {v, 0, 1, 0, 0, 0}; }
};

constexpr Taylor2 operator-(const Taylor2& f) { return {-f.value, -f.u, -f.v, -f.uu, -f.uv, -f.vv}; }
constexpr Taylor2 operator+(const Taylor2& f, const Taylor2& g) {
  return {f.value + g.value, f.u + g.u, f.v + g.v, f.uu + g.uu, f.uv + g.uv, f.vv + g.vv};
}
constexpr Taylor2 operator-(const Taylor2& f, const Taylor2& g) { return f + (-g); }
constexpr Taylor2 operator*(const Taylor2& f, const Taylor2& g) {
  return {f.value * g.value,
          f.u * g.value + f.value * g.u,
          f.v * g.value + f.value * g.v,
          f.uu * g.value + 2 * f.u * g.u + f.value * g.uu,
          f.uv * g.value + f.u * g.v + f.v * g.u + f.value * g.uv,
          f.vv * g.value + 2 * f.v * g.v + f.value * g.vv};
}

// Constants have no partials to multiply and add: the same numbers from less code.
constexpr Taylor2 operator+(double c, const Taylor2& f) { return {c + f.value, f.u, f.v, f.uu, f.uv, f.vv}; }
constexpr Taylor2 operator*(double c, const Taylor2& f) {
  return {c * f.value, c * f.u, c * f.v, c * f.uu, c * f.uv, c * f.vv};
}

/// The chain rule: y(f) where y, y', y'' are given at f.value.
constexpr Taylor2 compose(const Taylor2& f, double y, double y1, double y2) {
  return {y, y1 * f.u, y1 * f.v, y1 * f.uu + y2 * f.u * f.u, y1 * f.uv + y2 * f.u * f.v, y1 * f.vv + y2 * f.v * f.v};
}

/// Precondition: g.value != 0.
constexpr Taylor2 operator/(const Taylor2& f, const Taylor2& g) {
  const double r = 1 / g.value;
  return f * compose(g, r, -r * r, 2 * r * r * r);
}

inline Taylor2 sin(const Taylor2& f) {
  const double s = std::sin(f.value);
  return compose(f, s, std::cos(f.value), -s);
}
inline Taylor2 cos(const Taylor2& f) {
  const double c = std::cos(f.value);
  return compose(f, c, -std::sin(f.value), -c);
}
inline Taylor2 exp(const Taylor2& f) {
  const double e = std::exp(f.value);
  return compose(f, e, e, e);
}
/// Precondition: f.value > 0.
inline Taylor2 log(const Taylor2& f) {
  const double r = 1 / f.value;
  return compose(f, std::log(f.value), r, -r * r);
}
/// Precondition: f.value > 0.
inline Taylor2 sqrt(const Taylor2& f) {
  const double s = std::sqrt(f.value);
  return compose(f, s, 0.5 / s, -0.25 / (s * f.value));
}

/// sin(x)/x, 1 at 0: entire. Value and both derivatives to full double accuracy (relative 1e-14 of the largest).
Taylor2 sinc(const Taylor2& f);
/// (1 - cos x)/x^2, 1/2 at 0: entire, as accurate as sinc.
Taylor2 cosc(const Taylor2& f);

}  // namespace knotwork
