#include "knotwork/surface/mixed_series.h"

#include <cmath>

namespace knotwork {
namespace {

/// The powers of a series without constant term that are not 0 yet.
constexpr std::size_t composed_terms = 2 * MixedSeries::degree + 1;
using Composed = std::array<double, composed_terms>;

/// y(f), where y(f.value() + h) = sum y[k] h^k.
MixedSeries composed(const MixedSeries& f, const Composed& y) {
  MixedSeries step = f;
  step.coefficient(0, 0) = 0;
  MixedSeries sum = y.back();
  for (std::size_t k = composed_terms - 1; k-- > 0;) sum = sum * step + y[k];
  return sum;
}

/// From the derivatives, of which the one after the fourth is the first again.
MixedSeries composed_periodic(const MixedSeries& f, const std::array<double, 4>& derivatives) {
  Composed y;
  double factorial = 1;
  for (std::size_t k = 0; k < composed_terms; ++k) {
    if (k > 1) factorial *= static_cast<double>(k);
    y[k] = derivatives[k % 4] / factorial;
  }
  return composed(f, y);
}

/// sum (-1)^k f^(2k) / (2k + shift)!, exact to rounding for |f.value()| <= 1.
MixedSeries alternating_series(const MixedSeries& f, int shift) {
  // The terms left out stay below rounding in all coefficients, for whose sake there are more than a value needs.
  constexpr int terms = 14;
  const MixedSeries square = f * f;
  // Horner's rule with the quotients of neighbouring terms.
  MixedSeries sum = 1.0;
  for (int k = terms; k > 0; --k) sum = 1.0 - square * (1.0 / ((2 * k + shift) * (2 * k + shift - 1))) * sum;
  return shift == 2 ? 0.5 * sum : sum;
}

}  // namespace

MixedSeries MixedSeries::variable_u(double u) {
  MixedSeries series = u;
  series.coefficient(1, 0) = 1;
  return series;
}

MixedSeries MixedSeries::variable_v(double v) {
  MixedSeries series = v;
  series.coefficient(0, 1) = 1;
  return series;
}

MixedSeries operator-(const MixedSeries& f) { return -1.0 * f; }

MixedSeries operator+(const MixedSeries& f, const MixedSeries& g) {
  MixedSeries sum = f;
  for (std::size_t p = 0; p < MixedSeries::size; ++p) {
    for (std::size_t q = 0; q < MixedSeries::size; ++q) sum.coefficient(p, q) += g.coefficient(p, q);
  }
  return sum;
}

MixedSeries operator-(const MixedSeries& f, const MixedSeries& g) { return f + -g; }

MixedSeries operator*(const MixedSeries& f, const MixedSeries& g) {
  MixedSeries product;
  for (std::size_t p = 0; p < MixedSeries::size; ++p) {
    for (std::size_t q = 0; q < MixedSeries::size; ++q) {
      double sum = 0;
      for (std::size_t i = 0; i <= p; ++i) {
        for (std::size_t j = 0; j <= q; ++j) sum += f.coefficient(i, j) * g.coefficient(p - i, q - j);
      }
      product.coefficient(p, q) = sum;
    }
  }
  return product;
}

MixedSeries operator*(double c, const MixedSeries& f) {
  MixedSeries product = f;
  for (std::size_t p = 0; p < MixedSeries::size; ++p) {
    for (std::size_t q = 0; q < MixedSeries::size; ++q) product.coefficient(p, q) *= c;
  }
  return product;
}

MixedSeries operator/(const MixedSeries& f, const MixedSeries& g) {
  Composed reciprocal;
  reciprocal[0] = 1 / g.value();
  for (std::size_t k = 1; k < composed_terms; ++k) reciprocal[k] = -reciprocal[k - 1] / g.value();
  return f * composed(g, reciprocal);
}

MixedSeries sin(const MixedSeries& f) {
  const double s = std::sin(f.value()), c = std::cos(f.value());
  return composed_periodic(f, {s, c, -s, -c});
}

MixedSeries cos(const MixedSeries& f) {
  const double s = std::sin(f.value()), c = std::cos(f.value());
  return composed_periodic(f, {c, -s, -c, s});
}

MixedSeries exp(const MixedSeries& f) {
  const double e = std::exp(f.value());
  return composed_periodic(f, {e, e, e, e});
}

MixedSeries log(const MixedSeries& f) {
  Composed y;
  y[0] = std::log(f.value());
  double power = -1;
  for (std::size_t k = 1; k < composed_terms; ++k) {
    power /= -f.value();
    y[k] = power / static_cast<double>(k);
  }
  return composed(f, y);
}

MixedSeries sqrt(const MixedSeries& f) {
  Composed y;
  y[0] = std::sqrt(f.value());
  for (std::size_t k = 1; k < composed_terms; ++k) {
    y[k] = y[k - 1] * (1.5 - static_cast<double>(k)) / (static_cast<double>(k) * f.value());
  }
  return composed(f, y);
}

MixedSeries sinc(const MixedSeries& f) { return std::abs(f.value()) < 1 ? alternating_series(f, 1) : sin(f) / f; }

MixedSeries cosc(const MixedSeries& f) {
  if (std::abs(f.value()) < 1) return alternating_series(f, 2);
  const MixedSeries s = sin(0.5 * f) / f;
  return 2.0 * s * s;
}

}  // namespace knotwork
