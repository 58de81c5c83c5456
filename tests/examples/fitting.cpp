// Cut into the chapter on fitting.
#include "knotwork/curve/curve_fit.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

namespace knotwork::fitting_example {
namespace {

// [circle]
Result<CurveFit> fit_circle(int control_points) {
  std::vector<Eigen::Vector3d> data;
  for (int j = 0; j < 20; ++j) {
    const double angle = 2 * std::numbers::pi * j / 20;
    data.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  CurveFitSettings settings;
  settings.degree = 3;
  settings.count = control_points;
  settings.topology = Topology::closed;
  return fit_curve(data, settings);  // the curve, its error at each datum, their root mean square
}
// [/circle]

}  // namespace

TEST_CASE("example: the circle is fitted as closely as the chapter says") {
  CHECK(fit_circle(8).value().fit.rms == doctest::Approx(0.0022269).epsilon(1e-4));
  CHECK_FALSE(fit_circle(21));
}

}  // namespace knotwork::fitting_example
