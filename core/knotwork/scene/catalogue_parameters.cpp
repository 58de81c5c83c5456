#include "knotwork/scene/catalogue_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/document_members.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

constexpr std::string_view curve_prefix = "curve.";
constexpr double soft_factor = 4, soft_count = 12, soft_coordinate = 3;  // of sliders

/// A measure as a row: ids and labels are kept here, for rows only refer to them.
struct MeasureName {
  std::string id, label;  ///< "curve.tubeRadius", "tube radius"
};

std::string in_words(std::string_view id) {
  std::string words;
  for (const char c : id) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper) words += ' ';
    words += upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

const std::vector<MeasureName>& measure_names() {
  static const std::vector<MeasureName> names = [] {
    std::vector<MeasureName> found;
    for (const CatalogueCurveRow& row : curve_catalogue()) {
      for (const CatalogueMeasure& measure : row.measures) {
        const std::string id = std::string(curve_prefix) + std::string(measure.id);
        const bool known =
            std::any_of(found.begin(), found.end(), [&](const MeasureName& name) { return name.id == id; });
        if (!known) found.push_back({id, in_words(measure.id)});
      }
    }
    return found;
  }();
  return names;
}

/// Where the curve on the stage has the measure of this row; the number of its measures where it has not.
std::size_t curve_measure_place(const CatalogueCurve& curve, std::string_view id) {
  const std::span<const CatalogueMeasure> measures = curve_catalogue()[static_cast<std::size_t>(curve.row)].measures;
  const auto found = std::find_if(measures.begin(), measures.end(), [&](const CatalogueMeasure& measure) {
    return id.substr(curve_prefix.size()) == measure.id;
  });
  return static_cast<std::size_t>(found - measures.begin());
}

const CatalogueMeasure& measure_of(const CatalogueCurve& curve, std::string_view id) {
  return curve_catalogue()[static_cast<std::size_t>(curve.row)].measures[curve_measure_place(curve, id)];
}

/// The object on the stage that has a curve of the catalogue.
template <class D, class F>
auto with_model_curve(D& document, F act) {
  auto& shape = stage_shape(document);
  if (auto* blending = std::get_if<BlendingCurveObject>(&shape)) return act(*blending);
  return act(*std::get_if<ModelCurveObject>(&shape));
}

bool has_curve_measure(std::size_t name, const Document& document) {
  const CatalogueCurve* curve = stage_model_curve(document);
  if (curve == nullptr) return false;
  return curve_measure_place(*curve, measure_names()[name].id) <
         curve_catalogue()[static_cast<std::size_t>(curve->row)].measures.size();
}

ParameterValue measure_value(std::size_t name, const Document& document) {
  const CatalogueCurve& curve = *stage_model_curve(document);
  return curve.measures[curve_measure_place(curve, measure_names()[name].id)];
}

/// The error of an edit as a parameter's: apply() says which.
Status pathless(const Status& status) { return status ? success() : Status(Error{"", status.error().message}); }

KNOTWORK_LATER Status set_measure_value(std::size_t name, Document& document, const ParameterValue& value) {
  const std::string& id = measure_names()[name].id;
  const CatalogueCurve& curve = *stage_model_curve(document);
  const CatalogueMeasure& measure = measure_of(curve, id);
  const Limits range{measure.least, measure.greatest};
  const double* x = std::get_if<double>(&value);
  if (x == nullptr || !range.contains(*x) || (measure.integer && *x != std::floor(*x)))
    return Error{"", measure.integer ? integer_message(range) : number_message(range)};
  const std::size_t place = curve_measure_place(curve, id);
  return with_model_curve(document, [&](auto& object) { return pathless(set_measure(object, place, *x)); });
}

std::string not_disabled(const Document&) { return {}; }
bool has_model_curve(const Document& document) { return stage_model_curve(document) != nullptr; }

Limits measure_range(std::size_t name, const Document& document) {
  const CatalogueMeasure& measure = measure_of(*stage_model_curve(document), measure_names()[name].id);
  return {measure.least, measure.greatest};
}

Limits measure_soft_range(std::size_t name, const Document& document) {
  const CatalogueMeasure& measure = measure_of(*stage_model_curve(document), measure_names()[name].id);
  if (measure.integer) return {measure.least, std::min(soft_count, measure.greatest)};
  if (measure.least > 0) return {measure.standard / soft_factor, measure.standard * soft_factor};
  return {std::max(-soft_coordinate, measure.least), std::min(soft_coordinate, measure.greatest)};
}

/// The row of measure_names()[index].
Parameter measure_row(std::size_t index) {
  Parameter row;
  const MeasureName& name = measure_names()[index];
  row.id = name.id;
  row.label = name.label;
  row.group = "Curve";
  // The widest that any curve allows; which limits hold depends on the curve.
  bool whole = true;
  row.min = longest_length;
  row.max = -longest_length;
  for (const CatalogueCurveRow& curve : curve_catalogue()) {
    for (const CatalogueMeasure& measure : curve.measures) {
      if (name.id.substr(curve_prefix.size()) != measure.id) continue;
      row.min = std::min(row.min, measure.least);
      row.max = std::max(row.max, measure.greatest);
      whole = whole && measure.integer;
    }
  }
  row.kind = whole ? ParameterKind::integer : ParameterKind::number;
  row.step = whole ? 1 : 0.01;
  row.soft_max = row.max;
  row.get = {measure_value, index};
  row.set = {set_measure_value, index};
  row.applies = {has_curve_measure, index};
  row.range = {measure_range, index};
  row.soft_range = {measure_soft_range, index};
  row.disabled = not_disabled;
  return row;
}

KNOTWORK_LATER_ROW Parameter curve_row() {
  Parameter row;
  row.id = "curve.model";
  row.label = "model";
  row.group = "Curve";
  row.kind = ParameterKind::choice;
  for (const CatalogueCurveRow& curve : curve_catalogue())
    row.choices.push_back({std::string(curve.id), std::string(curve.label)});
  row.get = [](const Document& document) -> ParameterValue {
    return std::string(curve_catalogue()[static_cast<std::size_t>(stage_model_curve(document)->row)].id);
  };
  row.set = [](Document& document, const ParameterValue& value) -> Status {
    const std::string* id = std::get_if<std::string>(&value);
    const int index = id == nullptr ? -1 : find_choice(ids_of(CurveRow{}), *id);
    if (index < 0) return Error{"", choice_message(ids_of(CurveRow{}))};
    return with_model_curve(document, [&](auto& object) { return pathless(set_model(object, index)); });
  };
  row.applies = has_model_curve;
  row.disabled = not_disabled;
  return row;
}

BlendingCurveObject& blending_curve(Document& document) {
  return *std::get_if<BlendingCurveObject>(&stage_shape(document));
}
const BlendingCurveObject& blending_curve(const Document& document) {
  return *std::get_if<BlendingCurveObject>(&stage_shape(document));
}

Parameter local_row(std::string_view id, std::string_view label, ParameterKind kind) {
  Parameter row;
  row.id = id;
  row.label = label;
  row.group = "Local curves";
  row.kind = kind;
  row.applies = [](const Document& document) {
    return std::holds_alternative<BlendingCurveObject>(stage_shape(document));
  };
  row.disabled = not_disabled;
  return row;
}

/// A whole number within the limits, or the sentence about what may be set.
Result<int> whole_number(const ParameterValue& value, const Limits& range) {
  const double* x = std::get_if<double>(&value);
  if (x == nullptr || !range.contains(*x) || *x != std::floor(*x)) return Error{"", integer_message(range)};
  return static_cast<int>(*x);
}

KNOTWORK_LATER_ROW Parameter count_row() {
  Parameter row = local_row("locals.count", "locals", ParameterKind::integer);
  row.min = limits::curve_locals.min;
  row.max = limits::curve_locals.max;
  row.step = 1;
  row.soft_max = 24;
  row.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(blending_curve(document).locals);
  };
  row.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> count = whole_number(value, limits::curve_locals);
    return count ? pathless(set_local_count(blending_curve(document), count.value())) : Status(count.error());
  };
  return row;
}

KNOTWORK_LATER_ROW Parameter kind_row() {
  Parameter row = local_row("locals.kind", "kind", ParameterKind::choice);
  row.choices = {{"sub-curve", "sub-curve"}, {"bezier-hermite", "Bézier"}, {"arc", "arc"}};
  row.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(blending_curve(document).local_kind));
  };
  row.set = [](Document& document, const ParameterValue& value) -> Status {
    const std::string* id = std::get_if<std::string>(&value);
    const ChoiceIds ids = ids_of(LocalCurveKind{});
    const int index = id == nullptr ? -1 : find_choice(ids, *id);
    if (index < 0) return Error{"", choice_message(ids)};
    blending_curve(document).local_kind = static_cast<LocalCurveKind>(index);
    return success();
  };
  return row;
}

KNOTWORK_LATER_ROW Parameter degree_row() {
  Parameter row = local_row("locals.degree", "degree", ParameterKind::integer);
  row.min = limits::local_degree.min;
  row.max = row.soft_max = limits::local_degree.max;
  row.step = 1;
  row.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(blending_curve(document).local_degree);
  };
  row.disabled = [](const Document& document) -> std::string {
    const bool used = blending_curve(document).local_kind == LocalCurveKind::bezier_hermite;
    return used ? "" : "Only Bézier curves have a degree to choose.";
  };
  row.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> degree = whole_number(value, limits::local_degree);
    if (!degree) return degree.error();
    blending_curve(document).local_degree = degree.value();
    return success();
  };
  return row;
}

}  // namespace

std::vector<Parameter> catalogue_curve_rows() {
  std::vector<Parameter> rows{curve_row()};
  for (std::size_t index = 0; index < measure_names().size(); ++index) rows.push_back(measure_row(index));
  return rows;
}

std::vector<Parameter> local_curve_rows() { return {count_row(), kind_row(), degree_row()}; }

const CatalogueCurve* stage_model_curve(const Document& document) {
  const Shape& shape = stage_shape(document);
  if (const auto* blending = std::get_if<BlendingCurveObject>(&shape)) return &blending->model;
  const auto* model = std::get_if<ModelCurveObject>(&shape);
  return model != nullptr ? &model->model : nullptr;
}

std::string blending_curve_side_effect(const BlendingCurveObject& before, const BlendingCurveObject& after) {
  if (!(before.model.row == after.model.row) && before.topology != after.topology) {
    const std::string_view label = curve_catalogue()[static_cast<std::size_t>(after.model.row)].label;
    return std::string(label) + " is not closed, so the blending curve opens.";
  }
  return !before.knots.empty() && after.knots.empty() ? "The knots are evenly spaced again." : "";
}

}  // namespace knotwork::scene
