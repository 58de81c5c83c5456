#include "knotwork/scene/catalogue_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/document_members.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// The error of an edit as a parameter's: apply() says which.
Status pathless(const Status& status) { return status ? success() : Status(Error{"", status.error().message}); }

std::string_view not_disabled(const Document&) { return {}; }
bool has_model_curve(const Document& document) { return stage_model_curve(document) != nullptr; }

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
  row.disabled = [](const Document& document) -> std::string_view {
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

Parameter catalogue_curve_row() {
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
    Shape& shape = stage_shape(document);
    if (auto* blending = std::get_if<BlendingCurveObject>(&shape)) return pathless(set_model(*blending, index));
    return pathless(set_model(*std::get_if<ModelCurveObject>(&shape), index));
  };
  row.applies = has_model_curve;
  row.disabled = not_disabled;
  return row;
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
