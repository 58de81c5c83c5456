#include "knotwork/result.h"

#include <memory>
#include <vector>

#include <doctest/doctest.h>

namespace knotwork::result_test {
namespace {

Result<int> half(int x) {
  if (x % 2 != 0) return Error{"x", "The number must be even."};
  return x / 2;
}

}  // namespace

TEST_CASE("a Result holds a value or an error with path and sentence") {
  const Result<int> good = half(6);
  CHECK(good.has_value());
  CHECK(static_cast<bool>(good));
  CHECK(good.value() == 3);

  const Result<int> bad = half(7);
  CHECK_FALSE(bad.has_value());
  CHECK(bad.error().path == "x");
  CHECK(bad.error().message == "The number must be even.");
}

TEST_CASE("a Result gives up a move-only value") {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = std::move(result).value();
  CHECK(*taken == 5);
}

TEST_CASE("a temporary Result's value outlives the Result") {
  const auto numbers = [] { return Result<std::vector<int>>(std::vector<int>(1000, 7)); };
  int sum = 0;
  for (const int x : numbers().value()) sum += x;  // a reference would dangle here, as the sanitizers tell
  CHECK(sum == 7000);
}

TEST_CASE("a Result's value can be changed in place") {
  Result<int> result = half(4);
  result.value() += 1;
  CHECK(result.value() == 3);
}

TEST_CASE("Status is success without a value") {
  CHECK(success().has_value());
  const Status failure = Error{"", "No."};
  CHECK_FALSE(failure.has_value());
}

}  // namespace knotwork::result_test
