#pragma once

#include <array>
#include <cstddef>

namespace knotwork {

/// A function of (u,v) near one point as a truncated double power series sum c_pq h^p k^q with p, q <= degree: the
/// coefficients are D^(p,q)/(p! q!). The larger sister of Taylor2, for what needs mixed partials of higher order at a few
/// points. The operations are out of line: formulas are many, and each would carry a copy.
class MixedSeries {
 public:
  static constexpr int degree = 3;
  static constexpr std::size_t size = degree + 1;

  MixedSeries() = default;
  // Implicit on purpose: constants in a formula are constants.
  MixedSeries(double constant) { c_[0] = constant; }

  /// The coordinate functions u and v themselves.
  static MixedSeries variable_u(double u);
  static MixedSeries variable_v(double v);

  double value() const { return c_[0]; }
  double& coefficient(std::size_t p, std::size_t q) { return c_[p * size + q]; }
  double coefficient(std::size_t p, std::size_t q) const { return c_[p * size + q]; }

 private:
  std::array<double, size * size> c_{};
};

MixedSeries operator-(const MixedSeries& f);
MixedSeries operator+(const MixedSeries& f, const MixedSeries& g);
MixedSeries operator-(const MixedSeries& f, const MixedSeries& g);
MixedSeries operator*(const MixedSeries& f, const MixedSeries& g);
MixedSeries operator*(double c, const MixedSeries& f);
/// Precondition: g.value() != 0.
MixedSeries operator/(const MixedSeries& f, const MixedSeries& g);

MixedSeries sin(const MixedSeries& f);
MixedSeries cos(const MixedSeries& f);
MixedSeries exp(const MixedSeries& f);
/// Precondition: f.value() > 0.
MixedSeries log(const MixedSeries& f);
/// Precondition: f.value() > 0.
MixedSeries sqrt(const MixedSeries& f);
/// sin(x)/x, 1 at 0: entire.
MixedSeries sinc(const MixedSeries& f);
/// (1 - cos x)/x^2, 1/2 at 0: entire.
MixedSeries cosc(const MixedSeries& f);

}  // namespace knotwork
