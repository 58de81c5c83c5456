#pragma once

// The oracles' numbers and the one rule by which results are held to them.
//
// The rule: |actual - expected| <= tolerance * max(|expected|, scale). The comparison is relative. `scale` is 0 unless
// the expected number is small only because larger terms cancel in it (a curvature that is 0, a second partial of a
// plane); then it is the natural magnitude of those terms, which the test states. A vector counts as one quantity: its
// norm is compared, because no coordinate is better known than the vector. The tolerance against an oracle is 1e-12 in
// every build.

#include <cmath>
#include <fstream>
#include <ostream>
#include <string>

#include <doctest/doctest.h>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "knotwork/surface/surface_jet.h"

namespace knotwork::test {

inline constexpr double oracle_tolerance = 1e-12;

/// The outcome of a comparison; prints the numbers when a CHECK of it fails.
struct Closeness {
  bool within;
  double error, bound;
  explicit operator bool() const { return within; }
};
inline std::ostream& operator<<(std::ostream& out, const Closeness& c) {
  return out << "error " << c.error << ", bound " << c.bound;
}

/// The comparison that is quiet about a NaN, and false.
inline Closeness closeness(double error, double bound) { return {std::islessequal(error, bound), error, bound}; }

inline Closeness close(double actual, double expected, double tolerance, double scale = 0) {
  const double error = std::abs(actual - expected), bound = tolerance * std::max(std::abs(expected), scale);
  return closeness(error, bound);
}
inline Closeness close(const Eigen::Vector3d& actual, const Eigen::Vector3d& expected, double tolerance,
                       double scale = 0) {
  const double error = (actual - expected).norm(), bound = tolerance * std::max(expected.norm(), scale);
  return closeness(error, bound);
}

/// The six vectors of a jet in a fixed order, so that tests need not name each.
inline constexpr const char* jet_names[6] = {"S", "Su", "Sv", "Suu", "Suv", "Svv"};
inline const Eigen::Vector3d& jet_part(const SurfaceJet& jet, int k) {
  const Eigen::Vector3d* parts[6] = {&jet.s, &jet.su, &jet.sv, &jet.suu, &jet.suv, &jet.svv};
  return *parts[k];
}

inline Eigen::Vector3d vector3(const nlohmann::json& a) {
  return {a[0].get<double>(), a[1].get<double>(), a[2].get<double>()};
}

/// A 4x4 matrix, row by row, without its last row.
inline Eigen::Affine3d affine3(const nlohmann::json& matrix) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) {
      map.matrix()(r, c) = matrix[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
    }
  }
  return map;
}

/// A file of tests/data; an empty object when it cannot be read, which the calling test notices by REQUIRE.
inline nlohmann::json load_oracle(const std::string& name) {
  std::ifstream file(std::string(KNOTWORK_TEST_DATA_DIR) + "/" + name);
  nlohmann::json value = nlohmann::json::parse(file, nullptr, false);
  return value.is_discarded() ? nlohmann::json::object() : value;
}

}  // namespace knotwork::test
