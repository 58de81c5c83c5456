#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>

#include "knotwork/result.h"

namespace knotwork {

/// A number that shapes a model of the catalogue, as its radius: what a document, a panel and a test know of it.
struct CatalogueMeasure {
  std::string_view id;     ///< in documents and error paths, as `tubeRadius`
  std::string_view label;  ///< for readers, as `Tube radius`
  double standard;         ///< in the picture that a reader sees first
  double least, greatest;  ///< limits, so wide that nothing computed within them overflows: no range for a slider
  bool integer = false;
};

/// The values, in the row's order; 0 behind the row's last.
inline constexpr std::size_t most_catalogue_measures = 9;
using CatalogueMeasures = std::array<double, most_catalogue_measures>;

inline constexpr double shortest_length = 1e-6, longest_length = 1e6;  ///< model units

// The four kinds. A length (a speed and a factor too) is positive; a count is an integer from 1 to 24; an angle, in
// radians, is a turn at most to either side.
constexpr CatalogueMeasure length_measure(std::string_view id, std::string_view label, double standard) {
  return {id, label, standard, shortest_length, longest_length};
}
constexpr CatalogueMeasure coordinate_measure(std::string_view id, std::string_view label, double standard) {
  return {id, label, standard, -longest_length, longest_length};
}
constexpr CatalogueMeasure count_measure(std::string_view id, std::string_view label, double standard) {
  return {id, label, standard, 1, 24, true};
}
constexpr CatalogueMeasure angle_measure(std::string_view id, std::string_view label, double standard) {
  return {id, label, standard, -2 * std::numbers::pi, 2 * std::numbers::pi};
}

/// A row's own check, for what no single measure can break; nullptr where there is nothing. Error path: a measure's id.
using CatalogueCheck = Status (*)(const double* measures);

/// One value for each measure, or none: then the standard ones. Error path: the measure's id where its value is not
/// finite, not within its limits or not an integer though it must be; that of the check; `measures` where the number of
/// values is wrong.
Result<CatalogueMeasures> read_measures(std::span<const CatalogueMeasure> measures, CatalogueCheck check,
                                        std::span<const double> values);

/// Whether these could have been read. Error path: moreover `measures` when one behind the row's last is not 0.
Status check_measures(std::span<const CatalogueMeasure> measures, CatalogueCheck check,
                      const CatalogueMeasures& values);

/// The row of this id; nullptr when there is none.
template <class Row>
const Row* find_row(std::span<const Row> rows, std::string_view id) {
  for (const Row& row : rows) {
    if (row.id == id) return &row;
  }
  return nullptr;
}

}  // namespace knotwork
