#pragma once

#include <span>

#include <Eigen/Core>

namespace knotwork {

/// A function of t near one point, truncated after order 3: its value and its derivatives (not divided by factorials).
/// Written once with this scalar, a formula yields the point and all derivatives to order 3. The one-variable sister of
/// Taylor2. The operations are out of line: formulas are many, and each would carry a copy.
struct Taylor3 {
  double value = 0, d1 = 0, d2 = 0, d3 = 0;

  constexpr Taylor3() = default;
  // Implicit on purpose: constants in a formula are constants.
  constexpr Taylor3(double constant) : value(constant) {}
  constexpr Taylor3(double f, double f1, double f2, double f3) : value(f), d1(f1), d2(f2), d3(f3) {}

  /// The coordinate function t itself.
  static constexpr Taylor3 variable(double t) { return {t, 1, 0, 0}; }
};

Taylor3 operator-(const Taylor3& f);
Taylor3 operator+(const Taylor3& f, const Taylor3& g);
Taylor3 operator-(const Taylor3& f, const Taylor3& g);
/// Leibniz' rule.
Taylor3 operator*(const Taylor3& f, const Taylor3& g);
// Constants have no derivatives to multiply and add: the same numbers from less code.
Taylor3 operator+(double c, const Taylor3& f);
Taylor3 operator*(double c, const Taylor3& f);
/// Precondition: g.value != 0.
Taylor3 operator/(const Taylor3& f, const Taylor3& g);

/// The chain rule (Faa di Bruno): y(f) where y, y', y'', y''' are given at f.value.
Taylor3 compose(const Taylor3& f, double y, double y1, double y2, double y3);

Taylor3 sin(const Taylor3& f);
Taylor3 cos(const Taylor3& f);
Taylor3 exp(const Taylor3& f);
/// Precondition: f.value > 0.
Taylor3 log(const Taylor3& f);
/// Precondition: f.value > 0.
Taylor3 sqrt(const Taylor3& f);

/// A point whose coordinates are functions of t.
struct Taylor3Point {
  Taylor3 x, y, z;
};

/// out[k] = the k-th derivative, k = 0 .. out.size()-1. Precondition: at most four.
void derivatives(const Taylor3Point& point, std::span<Eigen::Vector3d> out);

}  // namespace knotwork
