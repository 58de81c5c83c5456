#include "knotwork/scene/parameters.h"

#include <algorithm>
#include <cmath>

#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document_members.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

template <class Class, class T>
Class class_of(T Class::*);

/// The member in the part of the document that has it.
template <auto Member, class D>
auto& field(D& document) {
  using Class = decltype(class_of(Member));
  if constexpr (std::same_as<Class, BlendingSurfaceObject>) {
    return blending_surface(document).*Member;
  } else if constexpr (std::same_as<Class, Display>) {
    return document.display.*Member;
  } else {
    static_assert(std::same_as<Class, Animation>);
    return document.animation.*Member;
  }
}

std::string never_disabled(const Document&) { return {}; }

template <class... Objects>
bool on_stage(const Document& document) {
  return (std::holds_alternative<Objects>(stage_shape(document)) || ...);
}

/// The index of the choice, or the sentence about what may be chosen.
Result<int> choice_index(const ChoiceIds& ids, const ParameterValue& value) {
  const std::string* id = std::get_if<std::string>(&value);
  const int index = id == nullptr ? -1 : find_choice(ids, *id);
  if (index < 0) return Error{"", choice_message(ids)};
  return index;
}

Parameter row(std::string_view id, std::string_view label, std::string_view group, ParameterKind kind) {
  Parameter row;
  row.applies = on_stage<BlendingSurfaceObject>;
  row.id = id;
  row.label = label;
  row.group = group;
  row.kind = kind;
  row.disabled = never_disabled;
  return row;
}

struct Scale {
  double step, soft_max;
  std::string_view unit{};
};

template <auto Member, const Limits& Range>
Parameter number(std::string_view id, std::string_view label, std::string_view group, Scale scale) {
  Parameter result = row(id, label, group, ParameterKind::number);
  result.min = Range.min;
  result.max = Range.max;
  result.step = scale.step;
  result.soft_max = scale.soft_max;
  result.unit = scale.unit;
  result.get = [](const Document& document) -> ParameterValue { return field<Member>(document); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const double* x = std::get_if<double>(&value);
    if (x == nullptr || !Range.contains(*x)) return Error{"", number_message(Range)};
    field<Member>(document) = *x;
    return success();
  };
  return result;
}

Status set_integer(int& member, const Limits& range, const ParameterValue& value) {
  const double* x = std::get_if<double>(&value);
  if (x == nullptr || !range.contains(*x) || *x != std::floor(*x)) return Error{"", integer_message(range)};
  member = static_cast<int>(*x);
  return success();
}

template <auto Member, const Limits& Range>
Parameter integer(std::string_view id, std::string_view label, std::string_view group, Scale scale) {
  Parameter result = row(id, label, group, ParameterKind::integer);
  result.min = Range.min;
  result.max = Range.max;
  result.step = scale.step;
  result.soft_max = scale.soft_max;
  result.unit = scale.unit;
  result.get = [](const Document& document) -> ParameterValue { return static_cast<double>(field<Member>(document)); };
  result.set = [](Document& document, const ParameterValue& value) {
    return set_integer(field<Member>(document), Range, value);
  };
  return result;
}

template <auto Member>
Parameter toggle(std::string_view id, std::string_view label, std::string_view group) {
  Parameter result = row(id, label, group, ParameterKind::toggle);
  result.get = [](const Document& document) -> ParameterValue { return field<Member>(document); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const bool* on = std::get_if<bool>(&value);
    if (on == nullptr) return Error{"", "Must be true or false."};
    field<Member>(document) = *on;
    return success();
  };
  return result;
}

template <auto Member>
Parameter choice(std::string_view id, std::string_view label, std::string_view group, std::vector<Choice> choices) {
  Parameter result = row(id, label, group, ParameterKind::choice);
  result.choices = std::move(choices);
  result.get = [](const Document& document) -> ParameterValue { return std::string(id_of(field<Member>(document))); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    auto& member = field<Member>(document);
    const Result<int> index = choice_index(ids_of(member), value);
    if (!index) return index.error();
    member = static_cast<std::remove_reference_t<decltype(member)>>(index.value());
    return success();
  };
  return result;
}

/// "The plane is not closed in u", empty where the model can close.
std::string cannot_close(const ModelSurface& model, char direction) {
  if (direction == 'u' ? closes_u(model) : closes_v(model)) return {};
  return "The " + std::string(model_row(model_kind(model)).id) + " is not closed in " + direction;
}

std::string refused_closure(const Document& document, char direction) {
  const std::string reason = cannot_close(blending_surface(document).model, direction);
  return reason.empty() ? reason : reason + ", so its " + direction + " direction can only be open.";
}

template <auto Member, char Direction>
Parameter topology(std::string_view id, std::string_view label) {
  Parameter result = choice<Member>(id, label, "Topology", {{"open", "open"}, {"closed", "closed"}});
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(Topology{}), value);
    if (!index) return index.error();
    const auto wanted = static_cast<Topology>(index.value());
    if (wanted == Topology::closed) {
      if (std::string reason = refused_closure(document, Direction); !reason.empty()) return Error{"", reason};
    }
    field<Member>(document) = wanted;
    return success();
  };
  return result;
}

/// A direction that the new model cannot close falls open in the same step, so that one undo brings both back.
Parameter model() {
  Parameter result = row("model", "model", "Topology", ParameterKind::choice);
  for (const ModelRow& kind : model_kinds()) result.choices.push_back({std::string(kind.id), std::string(kind.label)});
  result.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(model_kind(blending_surface(document).model)));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(ModelKind{}), value);
    if (!index) return index.error();
    BlendingSurfaceObject& object = blending_surface(document);
    const auto kind = static_cast<ModelKind>(index.value());
    if (kind == model_kind(object.model)) return success();
    object.model = make_model(kind);
    if (!closes_u(object.model)) object.topology_u = Topology::open;
    if (!closes_v(object.model)) object.topology_v = Topology::open;
    return success();
  };
  return result;
}

/// A new B-function starts with its own default parameter.
Parameter blending_function() {
  std::vector<Choice> choices;
  for (const BlendingFamily& family : blending_families()) {
    choices.push_back({std::string(family.id), std::string(family.label)});
  }
  Parameter result = choice<&BlendingSurfaceObject::blending>("blending.function", "B-function", "Blending function",
                                                              std::move(choices));
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(BlendingKind{}), value);
    if (!index) return index.error();
    BlendingSurfaceObject& object = blending_surface(document);
    const auto kind = static_cast<BlendingKind>(index.value());
    if (kind == object.blending) return success();
    object.blending = kind;
    object.blending_parameter = blending_family(kind).parameter_default;
    return success();
  };
  return result;
}

Limits family_range(const Document& document) {
  const BlendingFamily& family = blending_family(blending_surface(document).blending);
  return {static_cast<double>(family.parameter_min), static_cast<double>(family.parameter_max)};
}

Parameter blending_parameter() {
  Parameter result = integer<&BlendingSurfaceObject::blending_parameter, limits::blending_parameter>(
      "blending.parameter", "parameter", "Blending function", {1, 0});
  // The widest that any family allows; which one holds depends on the function.
  result.max = 0;
  for (const BlendingFamily& family : blending_families()) {
    result.max = std::max(result.max, static_cast<double>(family.parameter_max));
  }
  result.soft_max = result.max;
  result.disabled = [](const Document& document) -> std::string {
    return family_range(document).max > 0 ? "" : "This B-function has no parameter.";
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Limits range = family_range(document);
    if (range.max == 0) return Error{"", "This B-function has no parameter."};
    return set_integer(blending_surface(document).blending_parameter, range, value);
  };
  return result;
}

Parameter without_history(Parameter row) {
  row.in_history = false;
  return row;
}

/// A row that is about other shapes than the blending surface alone.
template <class... Objects>
Parameter about(Parameter row) {
  row.applies = on_stage<Objects...>;
  return row;
}

/// Degree and topology of a B-spline curve, which take new knots with them.
BSplineCurveObject& bspline(Document& document) { return *std::get_if<BSplineCurveObject>(&stage_shape(document)); }
const BSplineCurveObject& bspline(const Document& document) {
  return *std::get_if<BSplineCurveObject>(&stage_shape(document));
}

/// The error of an edit as a parameter's: apply() says which.
Status without_path(const Status& status) { return status ? success() : Status(Error{"", status.error().message}); }

Limits degrees_of(const Document& document) {
  const BSplineCurveObject& curve = bspline(document);
  const auto points = static_cast<double>(curve.points.size());
  const double most = curve.topology == Topology::closed ? points : points - 1;
  return {limits::degree.min, std::min(limits::degree.max, most)};
}

Parameter curve_degree() {
  Parameter result = about<BSplineCurveObject>(row("curve.degree", "degree", "Curve", ParameterKind::integer));
  result.min = limits::degree.min;
  result.max = result.soft_max = limits::degree.max;
  result.step = 1;
  result.get = [](const Document& document) -> ParameterValue { return static_cast<double>(bspline(document).degree); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    int degree = bspline(document).degree;
    if (Status status = set_integer(degree, limits::degree, value); !status) return status;
    if (degree == bspline(document).degree) return success();
    return without_path(set_degree(bspline(document), degree));
  };
  return result;
}

Parameter curve_topology() {
  Parameter result = about<BSplineCurveObject>(row("curve.topology", "curve", "Topology", ParameterKind::choice));
  result.choices = {{"open", "open"}, {"closed", "closed"}};
  result.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(bspline(document).topology));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(Topology{}), value);
    if (!index) return index.error();
    const auto wanted = static_cast<Topology>(index.value());
    if (wanted == bspline(document).topology) return success();
    return without_path(set_topology(bspline(document), wanted));
  };
  return result;
}

/// The domain of the curve on the stage; a Bezier curve's is [0,1].
Limits curve_domain(const Document& document) {
  const auto* curve = std::get_if<BSplineCurveObject>(&stage_shape(document));
  if (curve == nullptr) return limits::share;
  const std::size_t p = static_cast<std::size_t>(curve->degree), n = curve->points.size();
  return {curve->knots[p], curve->knots[curve->topology == Topology::closed ? n + p : n]};
}

/// The member `parameter` of any curve: a share of its domain.
template <class D>
auto& curve_share(D& document) {
  auto& shape = stage_shape(document);
  auto* bezier = std::get_if<BezierCurveObject>(&shape);
  return bezier != nullptr ? bezier->parameter : std::get_if<BSplineCurveObject>(&shape)->parameter;
}

Parameter curve_parameter() {
  Parameter result =
      about<BezierCurveObject, BSplineCurveObject>(row("curve.parameter", "t", "Curve", ParameterKind::number));
  result.min = limits::coordinate.min;
  result.max = result.soft_max = limits::coordinate.max;
  result.step = 0.01;
  result.get = [](const Document& document) -> ParameterValue {
    const Limits domain = curve_domain(document);
    return std::lerp(domain.min, domain.max, curve_share(document));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const double* x = std::get_if<double>(&value);
    const Limits domain = curve_domain(document);
    if (x == nullptr || !domain.contains(*x)) return Error{"", number_message(domain)};
    curve_share(document) = std::clamp((*x - domain.min) / (domain.max - domain.min), 0.0, 1.0);
    return success();
  };
  return result;
}

std::vector<Parameter> make_table() {
  using Surface = BlendingSurfaceObject;
  using Bezier = BezierCurveObject;
  using BSpline = BSplineCurveObject;
  return {
      topology<&Surface::topology_u, 'u'>("topology.u", "u"),
      topology<&Surface::topology_v, 'v'>("topology.v", "v"),
      model(),
      integer<&Surface::locals_u, limits::locals>("locals.u", "locals u", "Local patches", {1, 12}),
      integer<&Surface::locals_v, limits::locals>("locals.v", "locals v", "Local patches", {1, 12}),
      blending_function(),
      blending_parameter(),
      integer<&Surface::samples_u, limits::samples>("samples.u", "samples u", "Sampling", {8, 256}),
      integer<&Surface::samples_v, limits::samples>("samples.v", "samples v", "Sampling", {8, 256}),
      curve_topology(),
      curve_degree(),
      curve_parameter(),
      toggle<&Display::surface>("display.surface", "surface", "Show"),
      about<Surface, Bezier, BSpline>(toggle<&Display::patch_colours>("display.colours", "colours", "Show")),
      about<Surface, BSpline>(toggle<&Display::knot_lines>("display.knots", "knots", "Show")),
      toggle<&Display::wireframe>("display.wireframe", "wireframe", "Show"),
      toggle<&Display::local_patches>("display.locals", "local patches", "Show"),
      toggle<&Display::frames>("display.frames", "frames", "Show"),
      toggle<&Display::normals>("display.normals", "normals", "Show"),
      about<Bezier, BSpline>(toggle<&Display::polygon>("display.polygon", "control polygon", "Show")),
      about<Bezier, BSpline>(toggle<&Display::construction>("display.construction", "construction", "Show")),
      about<Surface, Bezier, BSpline>(toggle<&Display::handles>("display.handles", "handles", "Show")),
      without_history(toggle<&Animation::playing>("animation.playing", "playing", "Animation")),
      without_history(
          number<&Animation::time, limits::time>("animation.time", "time", "Animation", {0.01, clock_period, "s"})),
      number<&Animation::speed, limits::speed>("animation.speed", "speed", "Animation", {0.1, 4, "×"}),
      choice<&Animation::motion>("motion.kind", "motion", "Motion",
                                 {{"breathe", "breathe"}, {"report", "as in the report"}}),
      number<&Animation::amplitude, limits::amplitude>("motion.amplitude", "amplitude", "Motion", {0.01, 0.5}),
      number<&Animation::translation, limits::share>("motion.translation", "translation", "Motion", {0.01, 1}),
      number<&Animation::rotation, limits::share>("motion.rotation", "rotation", "Motion", {0.5, 1}),
  };
}

}  // namespace

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> table = make_table();
  return table;
}

const Parameter* find_parameter(std::string_view id) {
  const std::span<const Parameter> table = parameters();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Parameter& row) { return row.id == id; });
  return found == table.end() ? nullptr : &*found;
}

std::string refused_choice(const Document& document, const Parameter& parameter, std::string_view choice) {
  if (choice != id_of(Topology::closed)) return {};
  if (parameter.id == "topology.u") return refused_closure(document, 'u');
  if (parameter.id == "topology.v") return refused_closure(document, 'v');
  return {};
}

Limits range_of(const Document& document, const Parameter& parameter) {
  if (parameter.id == "curve.degree") return degrees_of(document);
  if (parameter.id == "curve.parameter") return curve_domain(document);
  const bool of_family = parameter.id == "blending.parameter" && family_range(document).max > 0;
  if (of_family) return family_range(document);
  return {parameter.min, parameter.max};
}

std::string side_effect(const Document& document, const Parameter& parameter, const ParameterValue& value) {
  const bool new_knots = parameter.id == "curve.degree" || parameter.id == "curve.topology";
  if (new_knots && applies(document, parameter)) {
    Document after = document;
    if (!parameter.set(after, value) || after == document || knots_are_even(bspline(document))) return {};
    return "The knots are evenly spaced again.";
  }
  if (parameter.id != "model" || !applies(document, parameter)) return {};
  Document after = document;
  if (!parameter.set(after, value)) return {};
  const BlendingSurfaceObject &was = blending_surface(document), &is = blending_surface(after);
  const bool u = was.topology_u != is.topology_u, v = was.topology_v != is.topology_v;
  if (!u && !v) return {};
  const std::string directions = u && v ? "u and v" : u ? "u" : "v";
  return "The " + std::string(model_row(model_kind(is.model)).id) + " is not closed in " + directions + ", so " +
         directions + (u && v ? " open." : " opens.");
}

}  // namespace knotwork::scene
