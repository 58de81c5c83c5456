#include "knotwork/basis/blending_function.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "unit/oracle.h"

namespace knotwork::blending_function_test {
using namespace test;

namespace {

BlendingFunction make(BlendingKind kind, int parameter = 0) { return BlendingFunction::make(kind, parameter).value(); }

/// The oracle's `rational2` is the family `rational` with p = 2; the other names are ids.
BlendingFunction from_oracle_name(const std::string& name) {
  if (name.starts_with("rational")) return make(BlendingKind::rational, std::stoi(name.substr(8)));
  const BlendingFamily* family = find_blending_family(name);
  REQUIRE(family != nullptr);
  return make(family->kind);
}

/// Oracle 05 writes 0 for what is exactly 0 and for values below about 1e-30.
constexpr double oracle_zero = 1e-28;

void check_row(const BlendingValue& actual, const nlohmann::json& row, double scale) {
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    const double expected = row[k + 1].get<double>();
    CAPTURE(row[0].get<double>());
    CAPTURE(k);
    if (expected == 0) {
      CHECK(std::abs(actual[k]) <= oracle_zero);
    } else {
      CHECK(close(actual[k], expected, oracle_tolerance, scale));
    }
  }
}

}  // namespace

TEST_CASE("oracle 05: eleven B-functions with three derivatives") {
  const nlohmann::json& oracle = load_oracle("05_blending_functions.json");
  REQUIRE(oracle["functions"].size() == 11);
  for (const nlohmann::json& function : oracle["functions"]) {
    read_case(function);
    const std::string name = function["name"];
    CAPTURE(name);
    const BlendingFunction b = from_oracle_name(name);
    REQUIRE(function["rows_t_B_B1_B2_B3"].size() == 32);
    for (const nlohmann::json& row : function["rows_t_B_B1_B2_B3"]) {
      check_row(b(row[0].get<double>()), row, 0);
    }
    if (function["order"].is_number()) {
      CHECK(b.order() == function["order"].get<int>());
    } else {
      CHECK(b.order() == smooth_order);
    }
    CHECK(b.symmetric() == function["symmetric"].get<bool>());
  }
}

TEST_CASE("oracle 05: expo-rational constants") {
  const nlohmann::json& constants = read_case(load_oracle("05_blending_functions.json")["expo_rational_constants"]);
  const BlendingFunction b = make(BlendingKind::expo_rational);
  CHECK(close(b.expo_rational_scale(), constants["S_d = 1/int_0^1 phi"].get<double>(), oracle_tolerance));
  CHECK(close(1 / b.expo_rational_scale(), constants["int_0^1 phi"].get<double>(), oracle_tolerance));
  const BlendingValue half = b(0.5);
  CHECK(close(half[0], constants["B(1/2)"].get<double>(), oracle_tolerance));
  CHECK(close(half[1], constants["B'(1/2)"].get<double>(), oracle_tolerance));
  CHECK(half[2] == 0);
  CHECK(close(half[3], constants["B'''(1/2)"].get<double>(), oracle_tolerance));
}

TEST_CASE("oracle 05: expo-rational functions with other intrinsic parameters") {
  const nlohmann::json& cases = load_oracle("05_blending_functions.json")["expo_rational_general_intrinsic_parameters"];
  REQUIRE(cases.size() == 5);
  for (const nlohmann::json& entry : cases) {
    read_case(entry);
    const ExpoRationalParameters parameters{entry["alpha"], entry["beta"], entry["gamma"], entry["lambda"]};
    const BlendingFunction b = BlendingFunction::make(parameters).value();
    CAPTURE(entry["lambda"].get<double>());
    CHECK(close(b.expo_rational_scale(), entry["S"].get<double>(), oracle_tolerance));
    CHECK(b.symmetric() == (parameters.lambda == 0.5 && parameters.gamma == 1));
    for (const nlohmann::json& row : entry["rows_t_B_B1_B2"]) {
      // B'' is 0 at lambda, where the oracle keeps the rounding of its lambda: magnitude B'/(distance 1/2).
      check_row(b(row[0].get<double>()), row, row[0].get<double>() == parameters.lambda ? 1.0 : 0.0);
    }
  }
}

TEST_CASE("oracle 05: polynomials of order m") {
  const nlohmann::json& cases = load_oracle("05_blending_functions.json")["beta_function_b_functions"];
  REQUIRE(cases.size() == 5);
  for (const nlohmann::json& entry : cases) {
    read_case(entry);
    const int m = entry["m"];
    CAPTURE(m);
    const BlendingFunction b = make(BlendingKind::polynomial_m, m);
    CHECK(b.order() == m);
    CHECK(b.parameter() == m);
    for (const nlohmann::json& row : entry["rows_t_B"]) check_row(b(row[0].get<double>()), row, 0);
  }
}

TEST_CASE("polynomials of order 0 to 3 are the named ones") {
  const BlendingKind named[] = {BlendingKind::linear, BlendingKind::polynomial1, BlendingKind::polynomial2,
                                BlendingKind::polynomial3};
  for (int m = 0; m <= 3; ++m) {
    const BlendingFunction a = make(BlendingKind::polynomial_m, m), b = make(named[m]);
    for (int k = 0; k <= 16; ++k) CHECK(a(k / 16.0) == b(k / 16.0));
  }
}

TEST_CASE("the families are a table in the order of their kinds") {
  const std::span<const BlendingFamily> families = blending_families();
  REQUIRE(families.size() == 11);
  std::set<std::string_view> ids;
  for (std::size_t k = 0; k < families.size(); ++k) {
    const BlendingFamily& family = families[k];
    CHECK(static_cast<std::size_t>(family.kind) == k);
    CHECK(find_blending_family(family.id) == &family);
    CHECK(&blending_family(family.kind) == &family);
    CHECK_FALSE(family.label.empty());
    CHECK_FALSE(family.formula.empty());
    ids.insert(family.id);
    const BlendingFunction b = make(family.kind, family.parameter_default);
    CHECK(b.kind() == family.kind);
    CHECK(b.symmetric() == family.symmetric);
    if (family.order >= 0) CHECK(b.order() == family.order);
  }
  CHECK(ids.size() == families.size());
  CHECK(find_blending_family("cubic") == nullptr);
  CHECK(find_blending_family("") == nullptr);
}

TEST_CASE("a parameter out of range is refused with its range") {
  for (const BlendingFamily& family : blending_families()) {
    if (family.parameter_max == 0) {
      CHECK(BlendingFunction::make(family.kind, 99).value().parameter() == 0);
      continue;
    }
    for (const int parameter : {family.parameter_min - 1, family.parameter_max + 1, -1000000000, 1000000000}) {
      const Result<BlendingFunction> result = BlendingFunction::make(family.kind, parameter);
      REQUIRE_FALSE(result.has_value());
      CHECK(result.error().path == "parameter");
      CHECK(result.error().message.find(std::to_string(family.parameter_max)) != std::string::npos);
    }
    CHECK(BlendingFunction::make(family.kind, family.parameter_min).has_value());
    CHECK(BlendingFunction::make(family.kind, family.parameter_max).has_value());
  }
  CHECK(BlendingFunction::make(static_cast<BlendingKind>(200)).error().path == "kind");
}

TEST_CASE("intrinsic parameters out of range are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto path = [](const ExpoRationalParameters& parameters) {
    const Result<BlendingFunction> result = BlendingFunction::make(parameters);
    return result.has_value() ? std::string("no error") : result.error().path;
  };
  for (const double bad : {0.0, -1.0, 17.0, nan, inf}) {
    CHECK(path({bad, 1, 1, 0.5}) == "alpha");
    CHECK(path({1, bad, 1, 0.5}) == "beta");
    CHECK(path({1, 1, bad, 0.5}) == "gamma");
  }
  for (const double bad : {-0.1, 1.1, nan, inf}) CHECK(path({1, 1, 1, bad}) == "lambda");
  CHECK(path({16, 16, 16, 1}) == "no error");
  CHECK(path({1.0 / 16, 1.0 / 16, 1.0 / 16, 0}) == "no error");
}

TEST_CASE("lambda at an end of the interval leaves no vanishing derivative there") {
  const BlendingFunction at_start = BlendingFunction::make(ExpoRationalParameters{1, 1, 1, 0}).value();
  CHECK(at_start.order() == 0);
  CHECK(close(at_start(0)[1], at_start.expo_rational_scale(), 1e-12));
  const BlendingFunction at_end = BlendingFunction::make(ExpoRationalParameters{1, 1, 1, 1}).value();
  CHECK(at_end.order() == 0);
  CHECK(close(at_end(1)[1], at_end.expo_rational_scale(), 1e-12));
}

TEST_CASE("outside [0,1] w is clamped and the derivatives vanish") {
  for (const BlendingFamily& family : blending_families()) {
    const BlendingFunction b = make(family.kind, family.parameter_default);
    for (const double w : {-1e300, -1.0, -1e-300}) CHECK(b(w) == BlendingValue{0, 0, 0, 0});
    for (const double w : {std::nextafter(1.0, 2.0), 3.0, 1e300}) CHECK(b(w) == BlendingValue{1, 0, 0, 0});
  }
}

TEST_CASE("the batch form is the single form") {
  std::vector<double> w;
  for (int k = -2; k <= 22; ++k) w.push_back(k / 20.0);
  for (const BlendingFamily& family : blending_families()) {
    const BlendingFunction b = make(family.kind, family.parameter_default);
    std::vector<BlendingValue> out(w.size());
    b.evaluate(w, out);
    for (std::size_t k = 0; k < w.size(); ++k) CHECK(out[k] == b(w[k]));
  }
}

TEST_CASE("only expo-rational functions have a scale") {
  CHECK(make(BlendingKind::linear).expo_rational_scale() == 1);
  CHECK(make(BlendingKind::logistic_expo_rational).expo_rational_scale() == 1);
}

}  // namespace knotwork::blending_function_test
