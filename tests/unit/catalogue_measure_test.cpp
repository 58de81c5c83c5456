#include "knotwork/catalogue_measure.h"

#include <limits>

#include "unit/oracle.h"

namespace knotwork::catalogue_measure_test {

namespace {

constexpr CatalogueMeasure measures[] = {length_measure("radius", "Radius", 2), count_measure("turns", "Turns", 3),
                                         angle_measure("phase", "Phase", 0), coordinate_measure("x", "X", -1)};

Status no_large_radius_with_many_turns(const double* m) {
  if (m[0] * m[1] > 100) return Error{"turns", "Too long."};
  return success();
}

std::string error_path(std::span<const double> values, CatalogueCheck check = nullptr) {
  const Result<CatalogueMeasures> read = read_measures(measures, check, values);
  return read.has_value() ? "no error" : read.error().path;
}

}  // namespace

TEST_CASE("measures are read in the row's order, none are the standard ones, the rest is 0") {
  const double values[] = {0.5, 24, -1.5, 1e6};
  CHECK(read_measures(measures, nullptr, values).value() == CatalogueMeasures{0.5, 24, -1.5, 1e6});
  CHECK(read_measures(measures, nullptr, {}).value() == CatalogueMeasures{2, 3, 0, -1});
}

TEST_CASE("a wrong measure is refused by its name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_path(std::array{1.0, 2.0, 3.0}) == "measures");
  CHECK(error_path(std::array{1.0, 2.0, 3.0, 4.0, 5.0}) == "measures");
  CHECK(error_path(std::array{0.0, 2.0, 3.0, 4.0}) == "radius");
  CHECK(error_path(std::array{nan, nan, 3.0, 4.0}) == "radius");
  CHECK(error_path(std::array{1.0, 2.5, 3.0, 4.0}) == "turns");
  CHECK(error_path(std::array{1.0, 25.0, 3.0, 4.0}) == "turns");
  CHECK(error_path(std::array{1.0, 2.0, 7.0, 4.0}) == "phase");
  CHECK(error_path(std::array{1.0, 2.0, 3.0, -1e7}) == "x");
  CHECK(error_path(std::array{50.0, 2.0, 3.0, 4.0}, no_large_radius_with_many_turns) == "no error");
  CHECK(error_path(std::array{51.0, 2.0, 3.0, 4.0}, no_large_radius_with_many_turns) == "turns");
}

TEST_CASE("measures as they stand are held to the same, and those that the row does not have to 0") {
  const auto path = [](const CatalogueMeasures& values, CatalogueCheck check = nullptr) -> std::string {
    const Status status = check_measures(measures, check, values);
    return status.has_value() ? "no error" : status.error().path;
  };
  CHECK(path({1, 2, 3, 4}) == "no error");
  CHECK(path({1, 2, 9, 4}) == "phase");
  CHECK(path({1, 2, 3, 4, 5}) == "measures");
  CHECK(path({1, 2, 3, 4, 0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()}) == "measures");
  CHECK(path({51, 2, 3, 4}, no_large_radius_with_many_turns) == "turns");
}

TEST_CASE("a row is found by its id") {
  struct Row {
    std::string_view id;
  };
  constexpr Row rows[] = {{"one"}, {"two"}};
  CHECK(find_row(std::span<const Row>(rows), "two") == &rows[1]);
  CHECK(find_row(std::span<const Row>(rows), "three") == nullptr);
}

}  // namespace knotwork::catalogue_measure_test
