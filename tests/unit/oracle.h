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
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

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

/// The files of tests/data that have been asked for, and which of their cases tests have read. A file's lists (arrays and
/// objects of objects) consist of cases; an object of numbers is one case.
class OracleFiles {
 public:
  /// An empty object when it cannot be read, which the calling test notices by REQUIRE.
  const nlohmann::json& file(const std::string& name) {
    const auto found = files_.find(name);
    if (found != files_.end()) return found->second;
    std::ifstream stream(std::string(KNOTWORK_TEST_DATA_DIR) + "/" + name);
    nlohmann::json value = nlohmann::json::parse(stream, nullptr, false);
    if (value.is_discarded()) value = nlohmann::json::object();
    const nlohmann::json& file = files_.emplace(name, std::move(value)).first->second;
    for (const auto& list : file.items()) {
      const bool of_cases = !list.value().empty() && list.value().is_structured() && list.value().begin()->is_object();
      if (list.value().is_object() && !of_cases) unread_[&list.value()] = name + ": " + list.key();
      if (!of_cases) continue;
      for (const auto& entry : list.value().items()) {
        const nlohmann::json& one = entry.value();
        unread_[&one] = name + ": " + list.key() + "/" + (one.contains("name") ? one["name"].dump() : entry.key());
      }
    }
    return file;
  }
  void read(const nlohmann::json& entry) { unread_.erase(&entry); }
  /// Of the files asked for, in no special order.
  std::vector<std::string> unread() const {
    std::vector<std::string> names;
    for (const auto& entry : unread_) names.push_back(entry.second);
    return names;
  }

 private:
  std::map<std::string, nlohmann::json> files_;
  std::map<const nlohmann::json*, std::string> unread_;
};

inline OracleFiles& oracle_files() {
  static OracleFiles files;
  return files;
}

/// A file of tests/data; an empty object when it cannot be read, which the calling test notices by REQUIRE.
inline const nlohmann::json& load_oracle(const std::string& name) { return oracle_files().file(name); }

/// The case, and the note that a test compares with its numbers: `knotwork_tests --every-oracle-case` fails where a case
/// of a file has no such note. `entry` is an element of the file itself, not of a copy.
inline const nlohmann::json& read_case(const nlohmann::json& entry) {
  oracle_files().read(entry);
  return entry;
}

}  // namespace knotwork::test
