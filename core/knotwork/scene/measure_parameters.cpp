#include "knotwork/scene/measure_parameters.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/catalogue_parameters.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// Models of one sort: those of surfaces, or the catalogue's curves.
struct ModelSort {
  std::string_view prefix, group;  ///< of the rows' ids, and theirs
  std::size_t (*count)();
  std::span<const CatalogueMeasure> (*measures)(std::size_t model);
  /// Which model of this sort is on the stage; the count when none is.
  std::size_t (*on_stage)(const Document& document);
  double (*value)(const Document& document, std::size_t place);
  Status (*set)(Document& document, std::size_t place, double value);
};

double surface_value(const Document& document, std::size_t place) {
  return model_measure(*stage_model(document), place);
}

Status set_surface_value(Document& document, std::size_t place, double value) {
  ModelSurface model = *stage_model(document);
  model_measure(model, place) = value;
  if (const Status valid = validate(model); !valid) return valid;
  *stage_model(document) = model;
  return success();
}

KNOTWORK_LATER Status set_curve_value(Document& document, std::size_t place, double value) {
  Shape& shape = stage_shape(document);
  if (auto* blending = std::get_if<BlendingCurveObject>(&shape)) return set_measure(*blending, place, value);
  return set_measure(*std::get_if<ModelCurveObject>(&shape), place, value);
}

constexpr ModelSort surfaces{"model.",
                             "Model",
                             [] { return model_kinds().size(); },
                             [](std::size_t model) { return model_measures(static_cast<ModelKind>(model)); },
                             [](const Document& document) {
                               const ModelSurface* model = stage_model(document);
                               return model == nullptr ? model_kinds().size()
                                                       : static_cast<std::size_t>(model_kind(*model));
                             },
                             surface_value,
                             set_surface_value};

constexpr ModelSort curves{
    "curve.",
    "Curve",
    [] { return curve_catalogue().size(); },
    [](std::size_t row) { return curve_catalogue()[row].measures; },
    [](const Document& document) {
      const CatalogueCurve* curve = stage_model_curve(document);
      return curve == nullptr ? curve_catalogue().size() : static_cast<std::size_t>(curve->row);
    },
    [](const Document& document, std::size_t place) { return stage_model_curve(document)->measures[place]; },
    set_curve_value};

/// A measure of one or more models under one id.
struct SharedMeasure {
  const ModelSort* sort;
  std::string id, label;  ///< as `curve.tubeRadius`, `tube radius`
  Limits widest;
  bool integer;  ///< in every model
};

void add_measures(std::vector<SharedMeasure>& shared, const ModelSort& sort) {
  for (std::size_t model = 0; model < sort.count(); ++model) {
    for (const CatalogueMeasure& measure : sort.measures(model)) {
      const std::string id = std::string(sort.prefix) + std::string(measure.id);
      std::string label(measure.label);
      label[0] = static_cast<char>(label[0] - 'A' + 'a');
      const auto known =
          std::find_if(shared.begin(), shared.end(), [&](const SharedMeasure& other) { return other.id == id; });
      if (known == shared.end()) {
        shared.push_back({&sort, id, std::move(label), {measure.least, measure.greatest}, measure.integer});
        continue;
      }
      if (label.size() < known->label.size()) known->label = std::move(label);
      known->widest = {std::min(known->widest.min, measure.least), std::max(known->widest.max, measure.greatest)};
      known->integer = known->integer && measure.integer;
    }
  }
}

const std::vector<SharedMeasure>& shared_measures() {
  static const std::vector<SharedMeasure> table = [] {
    std::vector<SharedMeasure> shared;
    add_measures(shared, surfaces);
    add_measures(shared, curves);
    return shared;
  }();
  return table;
}

/// Where the model on the stage has the measure; as many as it has when it has not.
std::size_t place_of(const SharedMeasure& shared, std::span<const CatalogueMeasure> measures) {
  const std::string_view id = std::string_view(shared.id).substr(shared.sort->prefix.size());
  const auto found =
      std::find_if(measures.begin(), measures.end(), [&](const CatalogueMeasure& measure) { return measure.id == id; });
  return static_cast<std::size_t>(found - measures.begin());
}

/// The measures of the model on the stage; none when another sort is there.
std::span<const CatalogueMeasure> present_measures(const ModelSort& sort, const Document& document) {
  const std::size_t model = sort.on_stage(document);
  if (model == sort.count()) return {};
  return sort.measures(model);
}

struct Present {
  const ModelSort& sort;
  std::size_t place;
  const CatalogueMeasure& measure;
};

Present present(std::size_t index, const Document& document) {
  const SharedMeasure& shared = shared_measures()[index];
  const std::span<const CatalogueMeasure> measures = present_measures(*shared.sort, document);
  const std::size_t place = place_of(shared, measures);
  return {*shared.sort, place, measures[place]};
}

bool has_measure(std::size_t index, const Document& document) {
  const SharedMeasure& shared = shared_measures()[index];
  const std::span<const CatalogueMeasure> measures = present_measures(*shared.sort, document);
  return place_of(shared, measures) < measures.size();
}

ParameterValue value_of(std::size_t index, const Document& document) {
  const Present now = present(index, document);
  return now.sort.value(document, now.place);
}

Status set_value(std::size_t index, Document& document, const ParameterValue& value) {
  const Present now = present(index, document);
  const Limits range{now.measure.least, now.measure.greatest};
  const double* x = std::get_if<double>(&value);
  if (x == nullptr || !range.contains(*x) || (now.measure.integer && *x != std::floor(*x)))
    return Error{"", now.measure.integer ? integer_message(range) : number_message(range)};
  const Status status = now.sort.set(document, now.place, *x);
  return status ? success() : Status(Error{"", status.error().message});
}

Limits range_now(std::size_t index, const Document& document) {
  const CatalogueMeasure& measure = present(index, document).measure;
  return {measure.least, measure.greatest};
}

/// A slider goes some way to both sides of the picture that a reader sees first.
Limits soft_range_now(std::size_t index, const Document& document) {
  constexpr double factor = 4, count = 12, coordinate = 3;
  const CatalogueMeasure& measure = present(index, document).measure;
  if (measure.integer) return {measure.least, std::min(count, measure.greatest)};
  if (measure.least > 0) return {measure.standard / factor, measure.standard * factor};
  return {std::max(-coordinate, measure.least), std::min(coordinate, measure.greatest)};
}

std::vector<Parameter> rows_of(const ModelSort& sort) {
  std::vector<Parameter> rows;
  for (std::size_t index = 0; index < shared_measures().size(); ++index) {
    const SharedMeasure& measure = shared_measures()[index];
    if (measure.sort != &sort) continue;
    Parameter row;
    row.id = measure.id;
    row.label = measure.label;
    row.group = sort.group;
    row.kind = measure.integer ? ParameterKind::integer : ParameterKind::number;
    row.min = measure.widest.min;
    row.max = row.soft_max = measure.widest.max;
    row.step = measure.integer ? 1 : 0.01;
    row.get = {value_of, index};
    row.set = {set_value, index};
    row.range = {range_now, index};
    row.soft_range = {soft_range_now, index};
    row.applies = {has_measure, index};
    row.disabled = [](const Document&) { return std::string_view(); };
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<Parameter> surface_measure_rows() { return rows_of(surfaces); }
std::vector<Parameter> curve_measure_rows() { return rows_of(curves); }

}  // namespace knotwork::scene
