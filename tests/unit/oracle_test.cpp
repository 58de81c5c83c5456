#include "unit/oracle.h"

#include <limits>

namespace knotwork::oracle_test {
using namespace test;

TEST_CASE("close is relative: it rejects small errors of small numbers") {
  CHECK(close(1.0, 1.0 + 5e-13, 1e-12));
  CHECK_FALSE(close(1.0, 1.0 + 2e-12, 1e-12));
  CHECK(close(1e-200, 1e-200, 1e-12));
  CHECK_FALSE(close(1e-200, 2e-200, 1e-12));
  CHECK_FALSE(close(0.5e-15, 1e-15, 1e-12));
  CHECK_FALSE(close(1e-300, 0.0, 1e-12));
  CHECK_FALSE(close(-1.0, 1.0, 1e-12));
}

TEST_CASE("close takes a natural magnitude where the expected number cancels") {
  CHECK(close(1e-13, 0.0, 1e-12, 1.0));
  CHECK_FALSE(close(1e-11, 0.0, 1e-12, 1.0));
  CHECK_FALSE(close(10 + 2e-11, 10.0, 1e-12, 1.0));
}

TEST_CASE("close rejects what is not a number") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(close(nan, 1.0, 1e-12));
}

TEST_CASE("close compares vectors by their norm") {
  CHECK(close(Eigen::Vector3d(1, 1e-13, 0), Eigen::Vector3d(1, 0, 0), 1e-12));
  CHECK_FALSE(close(Eigen::Vector3d(1, 1e-11, 0), Eigen::Vector3d(1, 0, 0), 1e-12));
  CHECK_FALSE(close(Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(1, 0, 0), 1e-12));
}

TEST_CASE("a missing oracle is an empty object") {
  CHECK(load_oracle("no_such_file.json").empty());
  CHECK_FALSE(load_oracle("05_blending_functions.json").empty());
}

TEST_CASE("a case counts as read once a test has said so") {
  OracleFiles files;
  const nlohmann::json& oracle = files.file("08_differential_geometry.json");
  REQUIRE(oracle["cases"].size() == 10);
  CHECK(files.unread().size() == 10);
  files.read(oracle["cases"]["sphere_r2"]);
  CHECK(files.unread().size() == 9);
  const nlohmann::json copy = oracle["cases"]["cylinder_r2"];
  files.read(copy);
  CHECK(files.unread().size() == 9);
  files.file("05_blending_functions.json");  // 11, 5 and 5 in lists, and the constants
  CHECK(files.unread().size() == 9 + 22);
}

}  // namespace knotwork::oracle_test
