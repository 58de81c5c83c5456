#include "knotwork/catalogue_measure.h"

#include <cmath>
#include <string>

namespace knotwork {

Result<CatalogueMeasures> read_measures(std::span<const CatalogueMeasure> measures, CatalogueCheck check,
                                        std::span<const double> values) {
  if (!values.empty() && values.size() != measures.size()) {
    return Error{"measures", "This model has " + std::to_string(measures.size()) + " measures, not " +
                                 std::to_string(values.size()) + "."};
  }
  CatalogueMeasures read{};
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const CatalogueMeasure& measure = measures[k];
    const double value = values.empty() ? measure.standard : values[k];
    // Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
    if (!std::isfinite(value) || value < measure.least || value > measure.greatest) {
      return Error{std::string(measure.id), "This measure is not within its limits."};
    }
    if (measure.integer && value != std::floor(value)) {
      return Error{std::string(measure.id), "This measure must be an integer."};
    }
    read[k] = value;
  }
  if (check != nullptr) {
    if (Status status = check(read.data()); !status) return status.error();
  }
  return read;
}

Status check_measures(std::span<const CatalogueMeasure> measures, CatalogueCheck check,
                      const CatalogueMeasures& values) {
  const Result<CatalogueMeasures> again = read_measures(measures, check, std::span(values).first(measures.size()));
  if (!again) return again.error();
  for (std::size_t k = measures.size(); k < values.size(); ++k) {
    if (!std::isfinite(values[k]) || values[k] != 0) {
      return Error{"measures", "Measures that this model does not have must be 0."};
    }
  }
  return success();
}

}  // namespace knotwork
