#include <cmath>
#include <string>
#include <vector>

#include "knotwork/basis/blending_function.h"
#include "unit/oracle.h"

namespace knotwork::blending_function_laws_test {
using namespace test;

namespace {

struct Named {
  std::string name;
  BlendingFunction b;
};

/// Every family, with every parameter of those that have one, and a spread of intrinsic parameters.
std::vector<Named> every_function() {
  std::vector<Named> all;
  for (const BlendingFamily& family : blending_families()) {
    for (int p = family.parameter_min; p <= family.parameter_max; ++p) {
      all.push_back({std::string(family.id) + " " + std::to_string(p), BlendingFunction::make(family.kind, p).value()});
    }
  }
  for (const ExpoRationalParameters& p : {ExpoRationalParameters{1, 2, 1, 0.5},
                                          {2, 1, 1, 0.5},
                                          {1, 1, 2, 0.5},
                                          {1, 1, 1, 0.3},
                                          {0.5, 1, 0.7, 0.6},
                                          {1, 1, 1, 0},
                                          {1, 1, 1, 1},
                                          {16, 16, 16, 0.5},
                                          {0.0625, 0.0625, 0.0625, 0.5},
                                          {3, 0.1, 0.2, 0.9}}) {
    all.push_back({"intrinsic " + std::to_string(p.alpha) + " " + std::to_string(p.beta) + " " +
                       std::to_string(p.gamma) + " " + std::to_string(p.lambda),
                   BlendingFunction::make(p).value()});
  }
  return all;
}

/// Parameters dense towards both ends, where the functions span hundreds of orders of magnitude.
std::vector<double> sample_parameters() {
  std::vector<double> t{0, 1};
  for (int k = 1; k < 200; ++k) t.push_back(k / 200.0);
  for (int k = 4; k <= 1070; k += 6) t.push_back(std::ldexp(1.0, -k));
  for (int k = 4; k <= 53; ++k) t.push_back(1 - std::ldexp(1.0, -k));
  return t;
}

}  // namespace

TEST_CASE("a B-function runs from 0 to 1 without turning back") {
  for (const Named& entry : every_function()) {
    const BlendingFunction& b = entry.b;
    CAPTURE(entry.name);
    CHECK(b(0)[0] == 0);
    CHECK(close(b(1)[0], 1, 1e-15));
    double previous = 0;
    for (int k = 0; k <= 1000; ++k) {
      const BlendingValue value = b(k / 1000.0);
      REQUIRE(value[0] >= previous - 4e-16);
      REQUIRE(value[0] <= 1 + 4e-16);
      REQUIRE(value[1] >= 0);
      previous = value[0];
    }
  }
}

TEST_CASE("values and derivatives are finite everywhere, the ends' neighbourhoods included") {
  for (const Named& entry : every_function()) {
    const BlendingFunction& b = entry.b;
    CAPTURE(entry.name);
    for (const double t : sample_parameters()) {
      CAPTURE(t);
      for (const double x : b(t)) REQUIRE(std::isfinite(x));
    }
  }
}

TEST_CASE("symmetric functions satisfy B(t) + B(1-t) = 1 and its derivatives") {
  for (const Named& entry : every_function()) {
    const BlendingFunction& b = entry.b;
    CAPTURE(entry.name);
    double defect = 0;
    for (int k = 1; k < 64; ++k) {
      const BlendingValue x = b(k / 64.0), y = b(1 - k / 64.0);
      defect = std::max(defect, std::abs(x[0] + y[0] - 1));
      if (!b.symmetric()) continue;
      CHECK(close(x[0] + y[0], 1, 1e-14));
      CHECK(close(x[1], y[1], 1e-12));
      CHECK(close(x[2], -y[2], 1e-12, 1e-13));
      CHECK(close(x[3], y[3], 1e-12, 1e-10));
    }
    if (!b.symmetric()) CHECK(defect > 1e-4);
  }
}

TEST_CASE("derivatives up to the order vanish at both ends and the next does not") {
  for (const Named& entry : every_function()) {
    const BlendingFunction& b = entry.b;
    CAPTURE(entry.name);
    const BlendingValue start = b(0), end = b(1);
    for (int k = 1; k <= 3; ++k) {
      CAPTURE(k);
      const auto index = static_cast<std::size_t>(k);
      if (k <= b.order()) {
        CHECK(start[index] == 0);
        CHECK(end[index] == 0);
      } else if (k == b.order() + 1) {
        CHECK((start[index] != 0 || end[index] != 0));
      }
    }
  }
}

TEST_CASE("each derivative is the derivative of the one before, relative to its size") {
  // Eighth-order central differences; the check sees a derivative that is wrong by a factor 1 + 1e-5.
  const auto difference = [](const BlendingFunction& b, double t, double h, std::size_t k) {
    constexpr double c[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    double sum = 0;
    for (int j = 1; j <= 4; ++j) sum += c[j - 1] * (b(t + j * h)[k] - b(t - j * h)[k]);
    return sum / h;
  };
  for (const BlendingFamily& family : blending_families()) {
    CAPTURE(family.id);
    const BlendingFunction b = BlendingFunction::make(family.kind, family.parameter_default).value();
    for (int n = 3; n <= 29; ++n) {
      const double t = n / 32.0, h = std::min(t, 1 - t) / 64;
      CAPTURE(t);
      const BlendingValue value = b(t);
      for (std::size_t k = 1; k <= 3; ++k) {
        // Near a zero of the derivative the difference is only as good as the function's own rounding over h.
        const double scale = std::abs(value[k - 1]) * 1e-8 / h;
        const double numeric = difference(b, t, h, k - 1);
        CHECK(close(value[k], numeric, 1e-6, scale));
        if (std::abs(value[k]) > scale) CHECK_FALSE(close(value[k] * (1 + 1e-5), numeric, 1e-6, scale));
        if (std::abs(value[k]) > scale) CHECK_FALSE(close(value[k] / 2, numeric, 1e-6, scale));
      }
    }
  }
}

TEST_CASE("tiny values next to 0 keep relative accuracy: B is the integral of B'") {
  // Integrating backwards over one e-fold with Simpson's rule in many steps, where B itself is 1e-10 to 1e-150.
  for (const BlendingKind kind : {BlendingKind::expo_rational, BlendingKind::logistic_expo_rational}) {
    const BlendingFunction b = BlendingFunction::make(kind).value();
    for (const double t : {0.001, 0.003, 0.01, 0.03}) {
      const BlendingValue end = b(t);
      if (end[0] < 1e-200) continue;
      const double from = t - std::min(0.5 * t, end[0] / end[1]);
      constexpr int steps = 400;
      const double h = (t - from) / steps;
      double sum = 0;
      for (int k = 0; k <= steps; ++k) {
        sum += (k == 0 || k == steps ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0)) * b(from + k * h)[1];
      }
      CAPTURE(t);
      CHECK(close(end[0] - b(from)[0], sum * h / 3, 1e-9));
    }
  }
}

}  // namespace knotwork::blending_function_laws_test
