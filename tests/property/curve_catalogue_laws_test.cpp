#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/curve_catalogue.h"
#include "unit/catalogue_cases.h"

namespace knotwork::curve_catalogue_laws_test {
using namespace test;

namespace {

using Derivatives = std::array<Eigen::Vector3d, 4>;

Derivatives at(const CatalogueCurve& curve, double t) {
  Derivatives out;
  evaluate(curve, t, out);
  return out;
}

/// The standard curve of each row and some with other measures.
std::vector<CatalogueCurve> curves() {
  std::mt19937 random(9);
  std::vector<CatalogueCurve> all;
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    all.push_back(make_catalogue_curve(row.id).value());
    for (int k = 0; k < 8; ++k) {
      all.push_back(make_catalogue_curve(row.id, random_measures(row.measures, random)).value());
    }
  }
  return all;
}
const CatalogueCurveRow& row_of(const CatalogueCurve& curve) {
  return curve_catalogue()[static_cast<std::size_t>(curve.row)];
}

/// A step that, as its multiples, is exact: a difference quotient then has no error from its parameters.
constexpr double step = 0x1p-13;

std::vector<double> parameters(const CatalogueCurve& curve) {
  const Interval where = domain(curve);
  std::vector<double> t(40);
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double share = (static_cast<double>(k) + 0.4) / static_cast<double>(t.size());
    t[k] = std::round((where.start + share * (where.end - where.start)) / step) * step;
  }
  return t;
}

/// The largest norm of each derivative: its natural magnitude on this curve.
std::array<double, 4> magnitudes(const CatalogueCurve& curve) {
  std::array<double, 4> largest{};
  for (const double t : parameters(curve)) {
    const Derivatives c = at(curve, t);
    for (std::size_t k = 0; k < 4; ++k) largest[k] = std::max(largest[k], c[k].norm());
  }
  return largest;
}

/// Derivative k at each parameter against an eighth-order central difference of derivative k-1. `factor` spoils it.
bool derivative_agrees(const CatalogueCurve& curve, std::size_t k, double factor) {
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  const std::array<double, 4> magnitude = magnitudes(curve);
  // A derivative far below the one before it (of a line, the second) cannot be told from 0 by differences.
  const double scale = std::max(magnitude[k], 1e-2 * magnitude[k - 1]);
  for (const double t : parameters(curve)) {
    Eigen::Vector3d difference = Eigen::Vector3d::Zero();
    for (int j = 1; j <= 4; ++j) {
      difference += weights[j - 1] / step * (at(curve, t + j * step)[k - 1] - at(curve, t - j * step)[k - 1]);
    }
    if (!close(Eigen::Vector3d(factor * at(curve, t)[k]), difference, 1e-7, scale)) return false;
  }
  return true;
}

/// Whether the whole curve repeats after that time, in all derivatives.
bool repeats_after(const CatalogueCurve& curve, double period) {
  const std::array<double, 4> magnitude = magnitudes(curve);
  for (const double t : parameters(curve)) {
    const Derivatives here = at(curve, t), there = at(curve, t + period);
    for (std::size_t k = 0; k < 4; ++k) {
      if (!close(there[k], here[k], 1e-10, magnitude[k])) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("a catalogue curve's derivatives are those of its points; a wrong one is rejected") {
  for (const CatalogueCurve& curve : curves()) {
    CAPTURE(row_of(curve).id);
    const std::array<double, 4> magnitude = magnitudes(curve);
    for (std::size_t k = 1; k < 4; ++k) {
      CAPTURE(k);
      CHECK(derivative_agrees(curve, k, 1));
      if (magnitude[k] > 1e-3 * magnitude[k - 1]) CHECK_FALSE(derivative_agrees(curve, k, 1.0001));
    }
  }
}

TEST_CASE("a curve flagged closed is closed in value and derivatives, one flagged open is not") {
  for (const CatalogueCurve& curve : curves()) {
    CAPTURE(row_of(curve).id);
    const Interval where = domain(curve);
    const Derivatives start = at(curve, where.start), end = at(curve, where.end);
    const std::array<double, 4> magnitude = magnitudes(curve);
    if (row_of(curve).topology == Topology::closed) {
      for (std::size_t k = 0; k < 4; ++k) CHECK(close(end[k], start[k], 1e-10, magnitude[k]));
      CHECK(repeats_after(curve, where.end - where.start));
    } else {
      CHECK((end[0] - start[0]).norm() > 1e-3);
    }
  }
}

TEST_CASE("rose, epitrochoid, butterfly and chrysanthemum repeat no sooner") {
  for (const CatalogueCurve& curve : curves()) {
    const std::string_view id = row_of(curve).id;
    if (id != "rose" && id != "epitrochoid" && id != "butterfly" && id != "chrysanthemum") continue;
    CAPTURE(id);
    CAPTURE(curve.measures[0]);
    CAPTURE(curve.measures[1]);
    const Interval where = domain(curve);
    for (const int part : {2, 3, 5, 7, 11, 13, 17, 19, 23}) {
      CHECK_FALSE(repeats_after(curve, (where.end - where.start) / part));
    }
    // The literature plots the chrysanthemum over 21 pi.
    if (id == "chrysanthemum")
      CHECK((at(curve, 21 * std::acos(-1.0))[0] - at(curve, 0)[0]).norm() > 0.1 * curve.measures[0]);
  }
}

TEST_CASE("curves with known equations obey them") {
  for (const CatalogueCurve& curve : curves()) {
    const std::string_view id = row_of(curve).id;
    const CatalogueMeasures& m = curve.measures;
    for (const double t : parameters(curve)) {
      const Eigen::Vector3d c = at(curve, t)[0];
      if (id == "circle") CHECK(close(c.norm(), m[0], 1e-14));
      if (id == "arc") CHECK(close((c - Eigen::Vector3d(0, 1 / m[1], 0)).norm(), 1 / m[1], 1e-14));
      if (id == "arc") CHECK(close(at(curve, t)[1].norm(), m[0], 1e-14));
      if (id == "clelia") CHECK(close(c.norm(), m[0], 1e-14));
      if (id == "viviani") CHECK(close(c.norm(), 2 * m[0], 1e-14));
      if (id == "viviani") CHECK(close(std::hypot(c.x() - m[0], c.y()), m[0], 1e-14));
      if (id == "astroid")
        CHECK(close(std::cbrt(c.x() * c.x()) + std::cbrt(c.y() * c.y()), std::cbrt(m[0] * m[0]), 1e-13));
      if (id == "torus-knot" && m[3] < m[2])
        CHECK(close(std::hypot(std::hypot(c.x(), c.y()) - m[2], c.z()), m[3], 1e-13, m[2]));
      // The report's curve is point-symmetric: half a period on it is at its own negative.
      if (id == "report-curve") CHECK(close(at(curve, t + std::acos(-1.0))[0], Eigen::Vector3d(-c), 1e-13, m[0]));
    }
  }
}

TEST_CASE("at the limits of its measures a curve is still finite") {
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CAPTURE(row.id);
    for (int pattern = 0; pattern < 4; ++pattern) {
      std::vector<double> values;
      for (std::size_t k = 0; k < row.measures.size(); ++k) {
        const bool greatest = pattern < 2 ? pattern == 1 : (k + static_cast<std::size_t>(pattern)) % 2 == 0;
        values.push_back(greatest ? row.measures[k].greatest : row.measures[k].least);
      }
      const CatalogueCurve curve = make_catalogue_curve(row.id, values).value();
      const Interval where = domain(curve);
      for (const double share : {0.0, 0.3, 1.0}) {
        for (const Eigen::Vector3d& part : at(curve, where.start + share * (where.end - where.start))) {
          for (const double coordinate : part) CHECK(std::isfinite(coordinate));
        }
      }
    }
  }
}

}  // namespace knotwork::curve_catalogue_laws_test
