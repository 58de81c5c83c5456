#include "knotwork/curve/interval_minimum.h"

#include <array>
#include <cmath>
#include <vector>

#include "unit/oracle.h"

namespace knotwork::interval_minimum_test {
using namespace test;
namespace {

/// `calls` counts how often it was asked.
struct Counted {
  ScalarJet (*formula)(double t);
  mutable int calls = 0;

  static ScalarJet at(const void* self, double t) {
    const Counted& counted = *static_cast<const Counted*>(self);
    ++counted.calls;
    return counted.formula(t);
  }
  IntervalMinimum least(const std::vector<double>& ends, int detail = 4, double constant = 1e-15) const {
    return interval_minimum({this, at}, ends, detail, constant, 0);
  }
};

}  // namespace

TEST_CASE("of two equal minima the first, of all others the least") {
  const Counted twice{[](double t) { return ScalarJet{std::pow(t * t - 1, 2), 4 * t * (t * t - 1), 12 * t * t - 4}; }};
  CHECK(close(twice.least({-2, 2}).t, -1, 1e-14));
  CHECK(close(twice.least({-2, 2}).value, 0, 1e-28, 1));
  CHECK(close(twice.least({-0.5, 2}).t, 1, 1e-14));
  CHECK(twice.least({2, 3}).t == 2);
  CHECK(twice.least({-5, -4}).t == -4);
  // Tilted by 1e-6 t the first is less; by -1e-6 t, the second; with rounding of 1e-5, again the first.
  const Counted tilted{[](double t) {
    return ScalarJet{std::pow(t * t - 1, 2) - 1e-6 * t, 4 * t * (t * t - 1) - 1e-6, 12 * t * t - 4};
  }};
  CHECK(close(tilted.least({-2, 2}).t, 1, 1e-6));
  CHECK(close(tilted.least({-2, 2}, 4, 1e-5).t, -1, 1e-6));
}

TEST_CASE("oscillations that the first cut does not resolve are found by halving") {
  // sin(20 t) + t / 10 on [0, 6]: least at the first trough behind 0, seen from 10 intervals.
  const Counted waves{[](double t) {
    return ScalarJet{std::sin(20 * t) + t / 10, 20 * std::cos(20 * t) + 0.1, -400 * std::sin(20 * t)};
  }};
  const double trough = (2 * std::acos(-1.0) - std::acos(-0.005)) / 20;
  CHECK(close(waves.least({0, 6}, 10).t, trough, 1e-13));
  CHECK(waves.calls < 600);
}

TEST_CASE("a constant is done at once, and yields its start; a flat minimum is found as far as it can be") {
  const Counted constant{[](double) { return ScalarJet{3, 0, 0}; }};
  CHECK(constant.least({-1, 0.5, 2}).t == -1);
  CHECK(constant.calls < 30);
  const Counted flat{[](double t) { return ScalarJet{std::pow(t, 4), 4 * t * t * t, 12 * t * t}; }};
  CHECK(close(flat.least({-1, 1.3}).t, 0, 1e-3, 1));
  CHECK(flat.calls < 300);
}

TEST_CASE("at a break the piece on the left has its own slope") {
  // |t - 1|: derivatives on the right at 1.
  const Counted corner{[](double t) { return t < 1 ? ScalarJet{1 - t, -1, 0} : ScalarJet{t - 1, 1, 0}; }};
  CHECK(corner.least({-1, 1, 4}).t == 1);
  CHECK(corner.least({-1, 1, 4}).value == 0);
}

TEST_CASE("noise above the rounding that was stated ends too") {
  const Counted noise{[](double t) {
    const double n = 1e-6 * std::sin(1e15 * t);
    return ScalarJet{1 + n, n, n};
  }};
  CHECK(close(noise.least({0, 1}).value, 1, 1e-5));
  CHECK(noise.calls < 100000);
}

}  // namespace knotwork::interval_minimum_test
