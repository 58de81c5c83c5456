#include "knotwork/basis/blending_function.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "knotwork/basis/expo_rational_table.h"
#include "knotwork/basis/integer_power.h"

namespace knotwork {
namespace {

using std::numbers::pi;

constexpr std::array<BlendingFamily, 11> families{{
    {BlendingKind::linear, "linear", "Linear", "t", 0, true, 0, 0, 0},
    {BlendingKind::trigonometric, "trigonometric", "Trigonometric", R"(\sin^2\tfrac{\pi t}{2})", 1, true, 0, 0, 0},
    {BlendingKind::polynomial1, "polynomial1", "Polynomial, order 1", "3t^2-2t^3", 1, true, 0, 0, 0},
    {BlendingKind::polynomial2, "polynomial2", "Polynomial, order 2", "6t^5-15t^4+10t^3", 2, true, 0, 0, 0},
    {BlendingKind::polynomial3, "polynomial3", "Polynomial, order 3", "-20t^7+70t^6-84t^5+35t^4", 3, true, 0, 0, 0},
    {BlendingKind::polynomial_m, "polynomial_m", "Polynomial, order m", "I_t(m+1,m+1)", -1, true, 0, 16, 4},
    {BlendingKind::trigonometric2, "trigonometric2", "Trigonometric, order 2", R"(t-\tfrac{\sin 2\pi t}{2\pi})", 2,
     true, 0, 0, 0},
    {BlendingKind::trigonometric3, "trigonometric3", "Trigonometric, order 3",
     R"(\tfrac12-\tfrac{9\cos\pi t-\cos 3\pi t}{16})", 3, true, 0, 0, 0},
    {BlendingKind::rational, "rational", "Rational", R"(\tfrac{t^p}{t^p+(1-t)^p})", -1, true, 2, 16, 2},
    {BlendingKind::expo_rational, "expo_rational", "Expo-rational", R"(S\int_0^t e^{-\frac{(s-1/2)^2}{s(1-s)}}\,ds)",
     smooth_order, true, 0, 0, 0},
    {BlendingKind::logistic_expo_rational, "logistic_expo_rational", "Logistic expo-rational",
     R"(\tfrac{1}{1+e^{1/t-1/(1-t)}})", smooth_order, true, 0, 0, 0},
}};

// sin(pi t) and cos(pi t) on [0,1], exact at 0, 1/2 and 1, with full relative accuracy next to their zeros there.
double sin_pi(double t) { return std::sin(pi * (t <= 0.5 ? t : 1 - t)); }
double cos_pi(double t) { return std::sin(pi * (0.5 - t)); }

/// x - sin x, x >= 0, without the cancellation near 0.
double minus_sine(double x) {
  if (x > 1.5) return x - std::sin(x);
  double term = x, sum = 0;
  for (int k = 1; k <= 12; ++k) {
    term *= -x * x / static_cast<double>(2 * k * (2 * k + 1));
    sum -= term;
  }
  return sum;
}

BlendingValue trigonometric(double t) {
  const double half_sine = std::sin(pi * t / 2);
  return {half_sine * half_sine, pi / 2 * sin_pi(t), pi * pi / 2 * cos_pi(t), -pi * pi * pi / 2 * sin_pi(t)};
}

BlendingValue trigonometric2(double t) {
  const double s = sin_pi(t), c = cos_pi(t);
  const double b = t <= 0.5 ? minus_sine(2 * pi * t) / (2 * pi) : 1 - minus_sine(2 * pi * (1 - t)) / (2 * pi);
  return {b, 2 * s * s, 4 * pi * s * c, 4 * pi * pi * (c - s) * (c + s)};
}

/// With c = cos(pi t), s = sin(pi t): B = (1-c)^2 (2+c) / 4, because cos 3x = 4c^3 - 3c.
BlendingValue trigonometric3(double t) {
  const double s = sin_pi(t), c = cos_pi(t), half_sine = std::sin(pi * t / 2);
  const double one_minus_c = 2 * half_sine * half_sine;
  return {one_minus_c * one_minus_c * (2 + c) / 4, 3 * pi / 4 * s * s * s, 9 * pi * pi / 4 * s * s * c,
          9 * pi * pi * pi / 4 * s * (2 * c * c - s * s)};
}

/// I_t(m+1,m+1) = t^(m+1) sum_{k<=m} C(m+k,k) (1-t)^k, all terms positive; the right half by symmetry, so that B is
/// exactly 1 at 1 and does not turn back next to it.
BlendingValue polynomial(int m, double t) {
  const double r = 1 - t, q = t * r, slope = 1 - 2 * t;
  const double near = std::min(t, r), far = std::max(t, r);
  double sum = 0, term = 1;
  for (int k = 0; k <= m; ++k) {
    sum += term;
    term *= far * (m + k + 1) / (k + 1);
  }
  const double part = integer_power(near, m + 1) * sum;
  double inverse_beta = 2 * m + 1;  // 1 / Beta(m+1,m+1) = (2m+1) C(2m,m)
  for (int k = 1; k <= m; ++k) inverse_beta = inverse_beta * (m + k) / k;
  BlendingValue value{t <= 0.5 ? part : 1 - part, inverse_beta * integer_power(q, m), 0, 0};
  if (m >= 1) value[2] = inverse_beta * m * integer_power(q, m - 1) * slope;
  if (m == 1) value[3] = -2 * inverse_beta;
  if (m >= 2) {
    value[3] = inverse_beta * m * integer_power(q, m - 2) * ((m - 1) * slope * slope - 2 * q);
  }
  return value;
}

/// With D = t^p + (1-t)^p: B = t^p / D, B' = p q^(p-1) / D^2, and the product rule from there: unlike B' h and
/// B' (h^2 + h') of the literature nothing cancels towards the ends.
BlendingValue rational(int p, double t) {
  const double r = 1 - t, q = t * r, slope = 1 - 2 * t;
  const double d = integer_power(t, p) + integer_power(r, p);
  const double d1 = p * (integer_power(t, p - 1) - integer_power(r, p - 1)) / d;
  const double d2 = p * (p - 1) * (integer_power(t, p - 2) + integer_power(r, p - 2)) / d;
  const double q1 = integer_power(q, p - 1), q2 = (p - 1) * integer_power(q, p - 2);
  const double q3 = p > 2 ? (p - 2) * (p - 1) * integer_power(q, p - 3) : 0.0;
  const double scale = p / (d * d);
  return {integer_power(t, p) / d, scale * q1, scale * (q2 * slope - 2 * q1 * d1),
          scale * (q3 * slope * slope - 2 * q2 - 4 * q2 * slope * d1 + q1 * (6 * d1 * d1 - 2 * d2))};
}

BlendingValue logistic(double t) {
  // |g| > 700 there: B is 0 or 1 to 300 digits, and the powers of 1/t would overflow further on.
  constexpr double flat = 1.0 / 720;
  const double r = 1 - t;
  if (t < flat) return {0, 0, 0, 0};
  if (r < flat) return {1, 0, 0, 0};
  const double g = (1 - 2 * t) / (t * r), e = std::exp(-std::abs(g));
  const double b = g > 0 ? e / (1 + e) : 1 / (1 + e);
  const double product = e / ((1 + e) * (1 + e));             // Q = B (1-B)
  const double p = (g > 0 ? 1.0 : -1.0) * (1 - e) / (1 + e);  // 1 - 2B
  const double g1 = -1 / (t * t) - 1 / (r * r), g2 = 2 / (t * t * t) - 2 / (r * r * r);
  const double g3 = -6 / (t * t * t * t) - 6 / (r * r * r * r);
  return {b, -g1 * product, product * (g1 * g1 * p - g2),
          product * (-g1 * g1 * g1 * (1 - 6 * product) + 3 * g1 * g2 * p - g3)};
}

}  // namespace

struct BlendingFunction::ExpoRationalTable : knotwork::ExpoRationalTable {
  using knotwork::ExpoRationalTable::ExpoRationalTable;
};

std::span<const BlendingFamily> blending_families() { return families; }

const BlendingFamily& blending_family(BlendingKind kind) { return families[static_cast<std::size_t>(kind)]; }

const BlendingFamily* find_blending_family(std::string_view id) {
  for (const BlendingFamily& family : families) {
    if (family.id == id) return &family;
  }
  return nullptr;
}

BlendingFunction::BlendingFunction(BlendingKind kind, int parameter, std::shared_ptr<const ExpoRationalTable> table)
    : kind_(kind), parameter_(parameter), table_(std::move(table)) {}

Result<BlendingFunction> BlendingFunction::make(BlendingKind kind, int parameter) {
  if (static_cast<std::size_t>(kind) >= families.size()) {
    return Error{"kind", "There is no such blending function."};
  }
  if (kind == BlendingKind::expo_rational) return make(ExpoRationalParameters{});
  const BlendingFamily& family = blending_family(kind);
  if (family.parameter_max == 0) return BlendingFunction(kind, 0, nullptr);
  if (parameter < family.parameter_min || parameter > family.parameter_max) {
    return Error{"parameter", "The parameter of this blending function must lie between " +
                                  std::to_string(family.parameter_min) + " and " +
                                  std::to_string(family.parameter_max) + "."};
  }
  return BlendingFunction(kind, parameter, nullptr);
}

Result<BlendingFunction> BlendingFunction::make(const ExpoRationalParameters& parameters) {
  const auto in_range = [](double x) {
    // Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
    return std::isfinite(x) && x >= ExpoRationalParameters::least && x <= ExpoRationalParameters::greatest;
  };
  const char* range = "This intrinsic parameter must lie between 1/16 and 16.";
  if (!in_range(parameters.alpha)) return Error{"alpha", range};
  if (!in_range(parameters.beta)) return Error{"beta", range};
  if (!in_range(parameters.gamma)) return Error{"gamma", range};
  if (!std::isfinite(parameters.lambda) || parameters.lambda < 0 || parameters.lambda > 1) {
    return Error{"lambda", "Lambda must lie between 0 and 1."};
  }
  return BlendingFunction(BlendingKind::expo_rational, 0, std::make_shared<const ExpoRationalTable>(parameters));
}

int BlendingFunction::order() const {
  if (kind_ == BlendingKind::polynomial_m) return parameter_;
  if (kind_ == BlendingKind::rational) return parameter_ - 1;
  if (kind_ == BlendingKind::expo_rational) {
    const double lambda = table_->parameters().lambda;
    return lambda > 0 && lambda < 1 ? smooth_order : 0;
  }
  return blending_family(kind_).order;
}

bool BlendingFunction::symmetric() const {
  if (kind_ != BlendingKind::expo_rational) return blending_family(kind_).symmetric;
  return table_->parameters().lambda == 0.5 && table_->parameters().gamma == 1;
}

double BlendingFunction::expo_rational_scale() const { return table_ ? table_->scale() : 1.0; }

BlendingValue BlendingFunction::operator()(double w) const {
  assert(!std::isnan(w));
  if (w < 0) return {0, 0, 0, 0};
  if (w > 1) return {1, 0, 0, 0};
  switch (kind_) {
    case BlendingKind::linear:
      return {w, 1, 0, 0};
    case BlendingKind::trigonometric:
      return trigonometric(w);
    case BlendingKind::polynomial1:
      return polynomial(1, w);
    case BlendingKind::polynomial2:
      return polynomial(2, w);
    case BlendingKind::polynomial3:
      return polynomial(3, w);
    case BlendingKind::polynomial_m:
      return polynomial(parameter_, w);
    case BlendingKind::trigonometric2:
      return trigonometric2(w);
    case BlendingKind::trigonometric3:
      return trigonometric3(w);
    case BlendingKind::rational:
      return rational(parameter_, w);
    case BlendingKind::expo_rational:
      return (*table_)(w);
    case BlendingKind::logistic_expo_rational:
      return logistic(w);
  }
  return {0, 0, 0, 0};
}

void BlendingFunction::evaluate(std::span<const double> w, std::span<BlendingValue> out) const {
  assert(w.size() == out.size());
  for (std::size_t k = 0; k < w.size(); ++k) out[k] = (*this)(w[k]);
}

}  // namespace knotwork
