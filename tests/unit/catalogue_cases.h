#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "knotwork/catalogue_measure.h"
#include "unit/oracle.h"

namespace knotwork::test {

inline std::vector<double> standard_measures(std::span<const CatalogueMeasure> measures) {
  std::vector<double> values;
  for (const CatalogueMeasure& measure : measures) values.push_back(measure.standard);
  return values;
}

/// Any integer and angle within the limits; lengths up to four times the standard or down to a quarter, coordinates as
/// large as 4: the picture changes, its proportions stay such that absolute gaps mean something.
inline std::vector<double> random_measures(std::span<const CatalogueMeasure> measures, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> values;
  for (const CatalogueMeasure& measure : measures) {
    const double any = unit(random);
    double value = measure.standard * std::exp2(2 * any);
    if (measure.integer) {
      value = std::floor(measure.least + (any + 1) / 2 * (measure.greatest - measure.least + 1));
    } else if (measure.least < 0) {
      value = std::min(4.0, measure.greatest) * any;
    }
    values.push_back(std::clamp(value, measure.least, measure.greatest));
  }
  return values;
}

/// What holds of a row's words and measures, and every way in which a measure can be wrong.
template <class Row, class Make>
void check_row(const Row& row, const Make& make) {
  CAPTURE(row.id);
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  CHECK(!row.label.empty());
  CHECK(lower(row.id.front()));
  CHECK(lower(row.id.back()));
  CHECK(std::all_of(row.id.begin(), row.id.end(), [&](char c) { return lower(c) || c == '-'; }));
  REQUIRE(!row.measures.empty());
  REQUIRE(row.measures.size() <= most_catalogue_measures);
  CHECK(make(row.id, std::vector<double>{}).has_value());
  CHECK(make(row.id, standard_measures(row.measures)).has_value());

  std::set<std::string_view> ids;
  const std::vector<double> standard = standard_measures(row.measures);
  for (std::size_t k = 0; k < row.measures.size(); ++k) {
    const CatalogueMeasure& measure = row.measures[k];
    CAPTURE(measure.id);
    CHECK(ids.insert(measure.id).second);
    CHECK(!measure.label.empty());
    CHECK(lower(measure.id.front()));
    CHECK(
        std::all_of(measure.id.begin(), measure.id.end(), [&](char c) { return lower(c) || (c >= 'A' && c <= 'Z'); }));
    CHECK((measure.least <= measure.standard && measure.standard <= measure.greatest));

    const auto error_path = [&](double value) -> std::string {
      std::vector<double> values = standard;
      values[k] = value;
      const auto made = make(row.id, values);
      return made.has_value() ? "no error" : made.error().path;
    };
    const double far = std::numeric_limits<double>::infinity();
    CHECK(error_path(measure.least) == "no error");
    CHECK(error_path(measure.greatest) == "no error");
    CHECK(error_path(std::nextafter(measure.least, -far)) == measure.id);
    CHECK(error_path(std::nextafter(measure.greatest, far)) == measure.id);
    CHECK(error_path(std::numeric_limits<double>::quiet_NaN()) == measure.id);
    CHECK(error_path(far) == measure.id);
    CHECK(error_path(-far) == measure.id);
    if (measure.integer) CHECK(error_path(measure.least + 0.5) == measure.id);
  }

  std::vector<double> too_many = standard;
  too_many.push_back(1);
  CHECK(make(row.id, too_many).error().path == "measures");
  if (standard.size() > 1) CHECK(make(row.id, std::vector<double>{1.0}).error().path == "measures");
}

/// What validate() sees in a model that nobody made.
template <class Model>
void check_unmade(Model model, std::span<const CatalogueMeasure> measures, int rows) {
  const auto path = [](const Model& m) { return validate(m).has_value() ? "no error" : validate(m).error().path; };
  CHECK(path(model) == "no error");
  Model other = model;
  for (const int row : {-1, rows, 1000}) {
    other.row = row;
    CHECK(path(other) == "row");
  }
  for (std::size_t k = 0; k < other.measures.size(); ++k) {
    for (const double bad : {1e7, std::numeric_limits<double>::quiet_NaN()}) {
      other = model;
      other.measures[k] = bad;
      CHECK(path(other) == (k < measures.size() ? std::string(measures[k].id) : "measures"));
      CHECK_FALSE(other == model);
    }
  }
}

}  // namespace knotwork::test
