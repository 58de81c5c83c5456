#include "knotwork/scene/model_parameters.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

constexpr std::string_view prefix = "model.";

/// A measure of one or more models under one id.
struct SharedMeasure {
  std::string parameter_id, label;
  Limits widest;
};

/// Every id once; of its labels the shortest, which is the most general.
std::vector<SharedMeasure> make_shared_measures() {
  std::vector<SharedMeasure> shared;
  for (const ModelRow& model : model_kinds()) {
    for (const CatalogueMeasure& measure : model_measures(model.kind)) {
      const std::string id = std::string(prefix) + std::string(measure.id);
      std::string label(measure.label);
      label[0] = static_cast<char>(label[0] - 'A' + 'a');
      const auto known = std::find_if(shared.begin(), shared.end(),
                                      [&](const SharedMeasure& other) { return other.parameter_id == id; });
      if (known == shared.end()) {
        shared.push_back({id, std::move(label), {measure.least, measure.greatest}});
        continue;
      }
      if (label.size() < known->label.size()) known->label = std::move(label);
      known->widest = {std::min(known->widest.min, measure.least), std::max(known->widest.max, measure.greatest)};
    }
  }
  return shared;
}

const std::vector<SharedMeasure>& shared_measures() {
  static const std::vector<SharedMeasure> table = make_shared_measures();
  return table;
}

/// The place of the measure of that id among the model's; as many as it has when there is none.
std::size_t place_of(std::string_view parameter_id, ModelKind kind) {
  const std::span<const CatalogueMeasure> measures = model_measures(kind);
  const auto found = std::find_if(measures.begin(), measures.end(), [&](const CatalogueMeasure& measure) {
    return measure.id == parameter_id.substr(prefix.size());
  });
  return static_cast<std::size_t>(found - measures.begin());
}

std::size_t place_of(std::size_t shared, const ModelSurface& model) {
  return place_of(shared_measures()[shared].parameter_id, model_kind(model));
}

bool has_measure(std::size_t shared, const Document& document) {
  const ModelSurface* model = stage_model(document);
  return model != nullptr && place_of(shared, *model) < model_measures(model_kind(*model)).size();
}

const CatalogueMeasure& measure_of(std::size_t shared, const Document& document) {
  const ModelSurface& model = *stage_model(document);
  return model_measures(model_kind(model))[place_of(shared, model)];
}

/// A slider goes some way to both sides of the picture that a reader sees first.
Limits slider_range(const CatalogueMeasure& measure) {
  constexpr double coordinates = 3;
  if (measure.least < 0) return {-coordinates, coordinates};
  return {measure.standard / 5, 3 * measure.standard};
}

ParameterValue value_of(std::size_t shared, const Document& document) {
  const ModelSurface& model = *stage_model(document);
  return model_measure(model, place_of(shared, model));
}

Status set_value(std::size_t shared, Document& document, const ParameterValue& value) {
  ModelSurface model = *stage_model(document);
  const std::size_t place = place_of(shared, model);
  const CatalogueMeasure& measure = measure_of(shared, document);
  const Limits range{measure.least, measure.greatest};
  const double* x = std::get_if<double>(&value);
  if (x == nullptr || !range.contains(*x)) return Error{"", number_message(range)};
  model_measure(model, place) = *x;
  if (const Status valid = validate(model); !valid) return Error{"", valid.error().message};
  *stage_model(document) = model;
  return success();
}

Limits range_now(std::size_t shared, const Document& document) {
  const CatalogueMeasure& measure = measure_of(shared, document);
  return {measure.least, measure.greatest};
}

Limits soft_range_now(std::size_t shared, const Document& document) {
  return slider_range(measure_of(shared, document));
}

Parameter measure_parameter(std::size_t shared) {
  const SharedMeasure& measure = shared_measures()[shared];
  Parameter row;
  row.id = measure.parameter_id;
  row.label = measure.label;
  row.group = "Model";
  row.kind = ParameterKind::number;
  row.min = measure.widest.min;
  row.max = row.soft_max = measure.widest.max;
  row.step = 0.01;
  row.get = {value_of, shared};
  row.set = {set_value, shared};
  row.range = {range_now, shared};
  row.soft_range = {soft_range_now, shared};
  row.applies = {has_measure, shared};
  row.disabled = [](const Document&) { return std::string(); };
  return row;
}

}  // namespace

void append_model_parameters(std::vector<Parameter>& table) {
  for (std::size_t shared = 0; shared < shared_measures().size(); ++shared) table.push_back(measure_parameter(shared));
}

}  // namespace knotwork::scene
