#include "knotwork/scene/parameters.h"

#include <algorithm>
#include <cmath>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/catalogue_parameters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document_members.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/knot_edits.h"
#include "knotwork/scene/measure_parameters.h"
#include "knotwork/scene/messages.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/subdivision_edits.h"

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

std::string_view never_disabled(const Document&) { return {}; }

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
  result.chosen = [](const Document& document) { return static_cast<int>(field<Member>(document)); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    auto& member = field<Member>(document);
    const Result<int> index = choice_index(ids_of(member), value);
    if (!index) return index.error();
    member = static_cast<std::remove_reference_t<decltype(member)>>(index.value());
    return success();
  };
  return result;
}

/// The samples of whichever surface stands on the stage.
template <NetDirection Direction, class D>
auto& samples_of(D& document) {
  using Samples = std::conditional_t<std::is_const_v<D>, const int, int>;
  return *std::visit(
      [](auto& object) -> Samples* {
        if constexpr (requires { object.samples_u; })
          return Direction == NetDirection::u ? &object.samples_u : &object.samples_v;
        else
          return nullptr;  // a curve, which the row is not about
      },
      stage_shape(document));
}

template <NetDirection Direction>
Parameter samples(std::string_view id, std::string_view label) {
  Parameter result = row(id, label, "Sampling", ParameterKind::integer);
  result.applies = on_stage<BlendingSurfaceObject, BSplineSurfaceObject, ModelSurfaceObject>;
  result.min = limits::samples.min;
  result.max = limits::samples.max;
  result.step = 8;
  result.soft_max = 256;
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(samples_of<Direction>(document));
  };
  result.set = [](Document& document, const ParameterValue& value) {
    Status status = set_integer(samples_of<Direction>(document), limits::samples, value);
    if (status) document.display.adaptive = false;  // who says how many means so many
    return status;
  };
  result.disabled = [](const Document& document) -> std::string_view {
    return document.display.adaptive ? "The mesh is as fine as the screen asks for, until \"fit to screen\" is off."
                                     : "";
  };
  return result;
}

/// "The plane is not closed in u", empty where the model can close.
std::string cannot_close(const ModelSurface& model, char direction) {
  if (direction == 'u' ? closes_u(model) : closes_v(model)) return {};
  return "The " + std::string(model_name(model)) + " is not closed in " + direction;
}

/// The net on the stage; nullptr when something else stands there.
BSplineSurfaceObject* net_on(Document& document) { return std::get_if<BSplineSurfaceObject>(&stage_shape(document)); }
const BSplineSurfaceObject* net_on(const Document& document) {
  return std::get_if<BSplineSurfaceObject>(&stage_shape(document));
}

std::string refused_closure(const Document& document, char direction) {
  if (net_on(document) != nullptr) return {};
  const std::string reason = cannot_close(blending_surface(document).model, direction);
  return reason.empty() ? reason : reason + ", so its " + direction + " direction can only be open.";
}

KNOTWORK_LATER std::string refused_by_twist(const Document& document, char direction, Topology wanted) {
  BlendingSurfaceObject changed = blending_surface(document);
  (direction == 'u' ? changed.topology_u : changed.topology_v) = wanted;
  return seam_problem(changed).message;
}

/// Why the direction cannot become so, empty when it can.
std::string refused_topology(const Document& document, char direction, Topology wanted) {
  if (wanted == Topology::closed)
    if (std::string reason = refused_closure(document, direction); !reason.empty()) return reason;
  return twists(blending_surface(document).model) ? refused_by_twist(document, direction, wanted) : std::string();
}

/// Changes the surface unless its twisted seams would not hold.
template <class Change>
Status set_if_seams_hold(Document& document, Change change) {
  BlendingSurfaceObject changed = blending_surface(document);
  change(changed);
  if (SeamProblem seam = seam_problem(changed); !seam.message.empty()) return Error{"", seam.message};
  blending_surface(document) = std::move(changed);
  return success();
}
/// The error of an edit as a parameter's: apply() says which.
Status without_path(const Status& status) { return status ? success() : Status(Error{"", status.error().message}); }

template <auto Member, char Direction>
Parameter topology(std::string_view id, std::string_view label) {
  Parameter result = choice<Member>(id, label, "Topology", {{"open", "open"}, {"closed", "closed"}});
  constexpr NetDirection direction = Direction == 'u' ? NetDirection::u : NetDirection::v;
  result.applies = on_stage<BlendingSurfaceObject, BSplineSurfaceObject>;
  result.get = [](const Document& document) -> ParameterValue {
    const BSplineSurfaceObject* net = net_on(document);
    return std::string(id_of(net != nullptr ? direction_of(*net, direction).topology : field<Member>(document)));
  };
  result.chosen = [](const Document& document) {
    const BSplineSurfaceObject* net = net_on(document);
    return static_cast<int>(net != nullptr ? direction_of(*net, direction).topology : field<Member>(document));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(Topology{}), value);
    if (!index) return index.error();
    const auto wanted = static_cast<Topology>(index.value());
    if (BSplineSurfaceObject* net = net_on(document)) return without_path(set_net_topology(*net, direction, wanted));
    if (std::string reason = refused_topology(document, Direction, wanted); !reason.empty()) return Error{"", reason};
    field<Member>(document) = wanted;
    return success();
  };
  return result;
}

/// Fewest and most lines, and degrees, that the direction can be given now.
Limits line_counts(const BSplineSurfaceObject& object, NetDirection direction) {
  const SplineDirection& spline = direction_of(object, direction);
  const int least = std::max(least_points(spline.degree, spline.topology), static_cast<int>(limits::net.min));
  return {static_cast<double>(least), limits::net.max};
}
Limits net_degrees(const BSplineSurfaceObject& object, NetDirection direction) {
  const bool closed = direction_of(object, direction).topology == Topology::closed;
  const double lines = line_count(object, direction);
  return {limits::degree.min, closed ? std::min(lines, limits::degree.max) : limits::degree.max};
}

/// An integer of a direction of the net, with what it can be at the moment and an edit that sets it.
template <NetDirection Direction, const Limits& Range, Limits (*Now)(const BSplineSurfaceObject&, NetDirection),
          int (*Get)(const BSplineSurfaceObject&, NetDirection),
          Status (*Set)(BSplineSurfaceObject&, NetDirection, int)>
KNOTWORK_LATER_ROW Parameter of_net(std::string_view id, std::string_view label, std::string_view group,
                                    double soft_max) {
  Parameter result = row(id, label, group, ParameterKind::integer);
  result.applies = on_stage<BSplineSurfaceObject>;
  result.min = Range.min;
  result.max = Range.max;
  result.soft_max = soft_max;
  result.step = 1;
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(Get(*net_on(document), Direction));
  };
  result.range = [](const Document& document) { return Now(*net_on(document), Direction); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    BSplineSurfaceObject& object = *net_on(document);
    int wanted = Get(object, Direction);
    if (Status status = set_integer(wanted, Range, value); !status) return status;
    if (wanted == Get(object, Direction)) return success();
    return without_path(Set(object, Direction, wanted));
  };
  return result;
}

int net_degree(const BSplineSurfaceObject& object, NetDirection direction) {
  return direction_of(object, direction).degree;
}

/// A direction that the new model cannot close falls open in the same step, so that one undo brings both back; one that
/// the last model could not close, and so kept open whatever the reader had chosen, closes where the new one can.
Parameter model() {
  Parameter result = row("model", "model", "Topology", ParameterKind::choice);
  for (const ModelRow& kind : model_kinds()) result.choices.push_back({std::string(kind.id), std::string(kind.label)});
  result.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(model_kind(*stage_model(document))));
  };
  result.chosen = [](const Document& document) { return static_cast<int>(model_kind(*stage_model(document))); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(ModelKind{}), value);
    if (!index) return index.error();
    const auto kind = static_cast<ModelKind>(index.value());
    if (kind == model_kind(*stage_model(document))) return success();
    auto* blending = std::get_if<BlendingSurfaceObject>(&stage_shape(document));
    if (blending == nullptr && kind == ModelKind::sheet) return Error{"", std::string(sheet_alone)};
    const bool forced_u = !closes_u(*stage_model(document)), forced_v = !closes_v(*stage_model(document));
    *stage_model(document) = make_model(kind);
    if (blending != nullptr) {
      if (forced_u) blending->topology_u = Topology::closed;
      if (forced_v) blending->topology_v = Topology::closed;
      if (!closes_u(blending->model)) blending->topology_u = Topology::open;
      if (!closes_v(blending->model)) blending->topology_v = Topology::open;
    }
    if (blending != nullptr && !seam_problem(*blending).message.empty()) {
      const bool in_u = domain(blending->model).closure_u == Closure::twisted;
      (in_u ? blending->topology_u : blending->topology_v) = Topology::open;
    }
    return success();
  };
  return result;
}

template <auto Member>
Parameter local_count(std::string_view id, std::string_view label) {
  Parameter result = integer<Member, limits::locals>(id, label, "Local patches", {1, 12});
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    int count = 0;
    if (Status status = set_integer(count, limits::locals, value); !status) return status;
    return set_if_seams_hold(document, [&](BlendingSurfaceObject& object) { object.*Member = count; });
  };
  return result;
}

Parameter patch_kind() {
  Parameter result = row("patches.kind", "patches", "Local patches", ParameterKind::choice);
  result.choices = {{"sub-surface", "sub-surface"}, {"bezier-hermite", "Bézier"}};
  result.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(blending_surface(document).patches.kind));
  };
  result.chosen = [](const Document& document) { return static_cast<int>(blending_surface(document).patches.kind); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(LocalSurfaceKind{}), value);
    if (!index) return index.error();
    blending_surface(document).patches.kind = static_cast<LocalSurfaceKind>(index.value());
    return success();
  };
  return result;
}

template <auto Degree>
Parameter patch_degree(std::string_view id, std::string_view label) {
  Parameter result = row(id, label, "Local patches", ParameterKind::integer);
  result.min = limits::patch_degree.min;
  result.max = result.soft_max = limits::patch_degree.max;
  result.step = 1;
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(blending_surface(document).patches.*Degree);
  };
  result.disabled = [](const Document& document) -> std::string_view {
    const bool used = blending_surface(document).patches.kind == LocalSurfaceKind::bezier_hermite;
    return used ? "" : "Only Bézier patches have a degree to choose.";
  };
  result.set = [](Document& document, const ParameterValue& value) {
    return set_integer(blending_surface(document).patches.*Degree, limits::patch_degree, value);
  };
  return result;
}

/// The object on the stage that blends: its members `blending` and `blending_parameter`.
template <class D, class F>
auto with_blending(D& document, F act) {
  auto& shape = stage_shape(document);
  if (auto* curve = std::get_if<BlendingCurveObject>(&shape)) return act(*curve);
  return act(blending_surface(document));
}

BlendingKind stage_blending(const Document& document) {
  return with_blending(document, [](const auto& object) { return object.blending; });
}

/// A new B-function starts with its own default parameter.
Parameter blending_function() {
  std::vector<Choice> choices;
  for (const BlendingFamily& family : blending_families()) {
    choices.push_back({std::string(family.id), std::string(family.label)});
  }
  Parameter result = row("blending.function", "B-function", "Blending function", ParameterKind::choice);
  result.choices = std::move(choices);
  result.get = [](const Document& document) -> ParameterValue { return std::string(id_of(stage_blending(document))); };
  result.chosen = [](const Document& document) { return static_cast<int>(stage_blending(document)); };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(BlendingKind{}), value);
    if (!index) return index.error();
    const auto kind = static_cast<BlendingKind>(index.value());
    return with_blending(document, [kind](auto& object) {
      if (kind != object.blending) object.blending_parameter = blending_family(kind).parameter_default;
      object.blending = kind;
      return success();
    });
  };
  return result;
}

Limits family_range(const Document& document) {
  const BlendingFamily& family = blending_family(stage_blending(document));
  return {static_cast<double>(family.parameter_min), static_cast<double>(family.parameter_max)};
}

double most_of_families() {
  double most = 0;
  for (const BlendingFamily& family : blending_families())
    most = std::max(most, static_cast<double>(family.parameter_max));
  return most;
}

Parameter blending_parameter() {
  Parameter result = row("blending.parameter", "parameter", "Blending function", ParameterKind::integer);
  result.step = 1;
  result.get = [](const Document& document) -> ParameterValue {
    return with_blending(document, [](const auto& object) { return static_cast<double>(object.blending_parameter); });
  };
  // The widest that any family allows; which one holds depends on the function.
  result.max = most_of_families();
  result.soft_max = result.max;
  result.range = [](const Document& document) -> Limits {
    const Limits range = family_range(document);
    return range.max > 0 ? range : Limits{limits::blending_parameter.min, most_of_families()};
  };
  result.disabled = [](const Document& document) -> std::string_view {
    return family_range(document).max > 0 ? "" : "This B-function has no parameter.";
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Limits range = family_range(document);
    if (range.max == 0) return Error{"", "This B-function has no parameter."};
    return with_blending(document, [&](auto& object) { return set_integer(object.blending_parameter, range, value); });
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

/// The B-spline curve on the stage.
BSplineCurveObject& bspline(Document& document) { return *std::get_if<BSplineCurveObject>(&stage_shape(document)); }
const BSplineCurveObject& bspline(const Document& document) {
  return *std::get_if<BSplineCurveObject>(&stage_shape(document));
}

KNOTWORK_LATER_ROW Parameter curve_degree() {
  Parameter result = about<BSplineCurveObject, FittedCurveObject, SubdivisionCurveObject>(
      row("curve.degree", "degree", "Curve", ParameterKind::integer));
  result.min = limits::degree.min;
  result.max = result.soft_max = limits::degree.max;
  result.step = 1;
  result.range = [](const Document& document) { return degree_range(stage_shape(document)); };
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(degree_of(stage_shape(document)));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    Shape& shape = stage_shape(document);
    int degree = degree_of(shape);
    if (Status status = set_integer(degree, limits::degree, value); !status) return status;
    if (degree == degree_of(shape)) return success();
    return without_path(set_degree(shape, degree));
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter curve_topology() {
  Parameter result = about<BSplineCurveObject, FittedCurveObject, SubdivisionCurveObject, BlendingCurveObject>(
      row("curve.topology", "curve", "Topology", ParameterKind::choice));
  result.choices = {{"open", "open"}, {"closed", "closed"}};
  result.get = [](const Document& document) -> ParameterValue {
    const auto* blending = std::get_if<BlendingCurveObject>(&stage_shape(document));
    return std::string(id_of(blending != nullptr ? blending->topology : topology_of(stage_shape(document))));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const Result<int> index = choice_index(ids_of(Topology{}), value);
    if (!index) return index.error();
    const auto wanted = static_cast<Topology>(index.value());
    if (auto* blending = std::get_if<BlendingCurveObject>(&stage_shape(document)))
      return without_path(set_topology(*blending, wanted));
    Shape& shape = stage_shape(document);
    if (wanted == topology_of(shape)) return success();
    return without_path(set_topology(shape, wanted));
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter curve_ends() {
  Parameter result = about<BSplineCurveObject>(row("curve.ends", "ends", "Curve", ParameterKind::choice));
  result.choices = {{"clamped", "clamped"}, {"unclamped", "unclamped"}};
  result.get = [](const Document& document) -> ParameterValue {
    const BSplineCurveObject& curve = bspline(document);
    return std::string(curve.topology == Topology::closed || is_clamped(curve) ? "clamped" : "unclamped");
  };
  result.disabled = [](const Document& document) -> std::string_view {
    return bspline(document).topology == Topology::closed ? "A closed curve has no ends." : "";
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const std::string* id = std::get_if<std::string>(&value);
    if (id == nullptr || (*id != "clamped" && *id != "unclamped")) return Error{"", "Must be clamped or unclamped."};
    BSplineCurveObject& curve = bspline(document);
    if (curve.topology == Topology::closed) return Error{"", "A closed curve has no ends."};
    const bool clamped = *id == "clamped";
    return clamped == is_clamped(curve) ? success() : without_path(set_clamped(curve, clamped));
  };
  return result;
}

/// The domain of the curve on the stage; a Bezier curve's is [0,1].
Limits curve_domain(const Document& document) {
  if (const CatalogueCurve* model = stage_model_curve(document)) return {domain(*model).start, domain(*model).end};
  const auto* curve = std::get_if<BSplineCurveObject>(&stage_shape(document));
  if (curve == nullptr) return limits::share;
  const std::size_t p = static_cast<std::size_t>(curve->degree), n = curve->points.size();
  return {curve->knots[p], curve->knots[curve->topology == Topology::closed ? n + p : n]};
}

/// The member `parameter` of any curve: a share of its domain.
template <class D>
auto& curve_share(D& document) {
  using Share = std::conditional_t<std::is_const_v<D>, const double, double>;
  Share* share = std::visit(
      [](auto& object) -> Share* {
        if constexpr (requires { object.parameter; })
          return &object.parameter;
        else
          return nullptr;
      },
      stage_shape(document));
  return *share;
}

KNOTWORK_LATER_ROW Parameter curve_parameter() {
  Parameter result = about<BezierCurveObject, BSplineCurveObject, ModelCurveObject, BlendingCurveObject>(
      row("curve.parameter", "t", "Curve", ParameterKind::number));
  result.min = limits::coordinate.min;
  result.max = result.soft_max = limits::coordinate.max;
  result.step = 0.01;
  result.range = curve_domain;
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

/// The fitted curve or the subdivision on the stage. Precondition: it is that. `O` may be const.
template <class O, class D>
auto& on_stage_as(D& document) {
  return *std::get_if<O>(&stage_shape(document));
}

/// A change of the fitted curve, which its data must allow.
template <class Change>
Status refit_stage(Document& document, Change change) {
  return without_path(refit(on_stage_as<FittedCurveObject>(document), change));
}

KNOTWORK_LATER_ROW Parameter fitted_count() {
  Parameter result = about<FittedCurveObject>(row("fitted.count", "n", "Fit", ParameterKind::integer));
  result.min = limits::points.min;
  result.max = limits::points.max;
  result.soft_max = 60;
  result.step = 1;
  result.unit = "control points";
  result.range = [](const Document& document) { return control_point_range(on_stage_as<FittedCurveObject>(document)); };
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(on_stage_as<FittedCurveObject>(document).count);
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    int count = 0;
    if (Status status = set_integer(count, limits::points, value); !status) return status;
    return refit_stage(document, [&](FittedCurveObject& changed) { changed.count = count; });
  };
  return result;
}

template <auto Member>
KNOTWORK_LATER_ROW Parameter fitted_choice(std::string_view id, std::string_view label, std::vector<Choice> choices) {
  Parameter result = about<FittedCurveObject>(row(id, label, "Fit", ParameterKind::choice));
  result.choices = std::move(choices);
  result.get = [](const Document& document) -> ParameterValue {
    return std::string(id_of(on_stage_as<FittedCurveObject>(document).*Member));
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    using Choices = std::remove_reference_t<decltype(on_stage_as<FittedCurveObject>(document).*Member)>;
    const Result<int> index = choice_index(ids_of(Choices{}), value);
    if (!index) return index.error();
    return refit_stage(document,
                       [&](FittedCurveObject& changed) { changed.*Member = static_cast<Choices>(index.value()); });
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter fitted_ends() {
  Parameter result =
      fitted_choice<&FittedCurveObject::ends>("fitted.ends", "ends", {{"free", "free"}, {"interpolated", "held"}});
  result.disabled = [](const Document& document) -> std::string_view {
    return closes(stage_shape(document)) ? "A closed curve has no ends." : "";
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter fitted_smoothing() {
  Parameter result = about<FittedCurveObject>(row("fitted.smoothing", "smoothing", "Fit", ParameterKind::number));
  result.min = limits::smoothing.min;
  result.max = limits::smoothing.max;
  result.step = 0.01;
  result.soft_max = 10;
  result.get = [](const Document& document) -> ParameterValue {
    return on_stage_as<FittedCurveObject>(document).smoothing;
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const double* x = std::get_if<double>(&value);
    if (x == nullptr || !limits::smoothing.contains(*x)) return Error{"", number_message(limits::smoothing)};
    return refit_stage(document, [&](FittedCurveObject& changed) { changed.smoothing = *x; });
  };
  return result;
}

/// A whole number of the subdivision, set by one of its edits.
template <auto Member, Status (*Set)(SubdivisionCurveObject&, int), int (*Most)(const SubdivisionCurveObject&),
          const Limits& Range>
KNOTWORK_LATER_ROW Parameter subdivision_integer(std::string_view id, std::string_view label, double soft_max) {
  Parameter result = about<SubdivisionCurveObject>(row(id, label, "Subdivision", ParameterKind::integer));
  result.min = Range.min;
  result.max = Range.max;
  result.soft_max = soft_max;
  result.step = 1;
  result.range = [](const Document& document) -> Limits {
    return {0, static_cast<double>(Most(on_stage_as<SubdivisionCurveObject>(document)))};
  };
  result.get = [](const Document& document) -> ParameterValue {
    return static_cast<double>(on_stage_as<SubdivisionCurveObject>(document).*Member);
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    int wanted = 0;
    if (Status status = set_integer(wanted, Range, value); !status) return status;
    return without_path(Set(on_stage_as<SubdivisionCurveObject>(document), wanted));
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter subdivision_fraction() {
  Parameter result =
      about<SubdivisionCurveObject>(row("subdivision.fraction", "on its way", "Subdivision", ParameterKind::number));
  result.min = limits::share.min;
  result.max = result.soft_max = limits::share.max;
  result.step = 0.01;
  result.get = [](const Document& document) -> ParameterValue {
    return on_stage_as<SubdivisionCurveObject>(document).fraction;
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const double* x = std::get_if<double>(&value);
    if (x == nullptr) return Error{"", number_message(limits::share)};
    return without_path(set_fraction(on_stage_as<SubdivisionCurveObject>(document), *x));
  };
  result.disabled = [](const Document& document) -> std::string_view {
    const auto& object = on_stage_as<SubdivisionCurveObject>(document);
    return object.step == step_count(object) ? "The last step is done." : "";
  };
  return result;
}

KNOTWORK_LATER_ROW Parameter subdivision_limit() {
  Parameter result =
      about<SubdivisionCurveObject>(row("subdivision.limit", "limit curve", "Subdivision", ParameterKind::toggle));
  result.get = [](const Document& document) -> ParameterValue {
    return on_stage_as<SubdivisionCurveObject>(document).limit;
  };
  result.set = [](Document& document, const ParameterValue& value) -> Status {
    const bool* on = std::get_if<bool>(&value);
    if (on == nullptr) return Error{"", "Must be true or false."};
    on_stage_as<SubdivisionCurveObject>(document).limit = *on;
    return success();
  };
  return result;
}

/// Rows of the clock and of the motion: about what moves by itself.
Parameter moving(Parameter row) { return about<BlendingSurfaceObject, BlendingCurveObject>(std::move(row)); }
/// Knots that a new degree or topology has spaced evenly, or lines that it has added.
KNOTWORK_LATER std::string net_side_effect(const BSplineSurfaceObject& before, const Document& document,
                                           const Parameter& parameter, const ParameterValue& value) {
  const bool is_u = parameter.id.ends_with(".u");
  if (parameter.group != "Topology" && parameter.group != "Surface") return {};
  Document changed = document;
  if (!parameter.set(changed, value) || changed == document) return {};
  const NetDirection direction = is_u ? NetDirection::u : NetDirection::v;
  const BSplineSurfaceObject& after = *net_on(changed);
  if (line_count(after, direction) != line_count(before, direction)) {
    return "The degree rises without a change of the surface: now there are " +
           std::to_string(line_count(after, direction)) + (is_u ? " rows." : " columns.");
  }
  return evenly_spaced(net_knots(before, direction)) ? "" : "The knots are evenly spaced again.";
}

std::vector<Parameter> make_table() {
  using Surface = BlendingSurfaceObject;
  using Bezier = BezierCurveObject;
  using BSpline = BSplineCurveObject;
  using Fitted = FittedCurveObject;
  using Subdivision = SubdivisionCurveObject;
  using Model = ModelCurveObject;
  using Blending = BlendingCurveObject;
  using NetSurface = BSplineSurfaceObject;
  using Alone = ModelSurfaceObject;
  using enum NetDirection;
  std::vector<Parameter> table{
      topology<&Surface::topology_u, 'u'>("topology.u", "u"),
      topology<&Surface::topology_v, 'v'>("topology.v", "v"),
      about<Surface, Alone>(model()),
      local_count<&Surface::locals_u>("locals.u", "locals u"),
      local_count<&Surface::locals_v>("locals.v", "locals v"),
      patch_kind(),
      patch_degree<&LocalSurfaces::degree_u>("patches.degree.u", "degree u"),
      patch_degree<&LocalSurfaces::degree_v>("patches.degree.v", "degree v"),
      about<Surface, Blending>(blending_function()),
      about<Surface, Blending>(blending_parameter()),
      of_net<u, limits::degree, net_degrees, net_degree, set_net_degree>("surface.degree.u", "degree u", "Surface",
                                                                         max_degree),
      of_net<v, limits::degree, net_degrees, net_degree, set_net_degree>("surface.degree.v", "degree v", "Surface",
                                                                         max_degree),
      of_net<u, limits::net, line_counts, line_count, set_line_count>("net.u", "rows (u)", "Control net", 16),
      of_net<v, limits::net, line_counts, line_count, set_line_count>("net.v", "columns (v)", "Control net", 16),
      samples<u>("samples.u", "samples u"),
      samples<v>("samples.v", "samples v"),
      curve_topology(),
      curve_degree(),
      curve_ends(),
      curve_parameter(),
      fitted_count(),
      fitted_choice<&Fitted::parameters>(
          "fitted.parameters", "parameters",
          {{"uniform", "uniform"}, {"centripetal", "centripetal"}, {"chordLength", "chord length"}}),
      fitted_choice<&Fitted::knots>("fitted.knots", "knots", {{"even", "even"}, {"averaged", "averaged"}}),
      fitted_ends(),
      fitted_smoothing(),
      subdivision_integer<&Subdivision::levels, set_levels, most_levels, limits::levels>("subdivision.levels", "levels",
                                                                                         8),
      subdivision_integer<&Subdivision::step, set_step, step_count, limits::steps>("subdivision.step", "step", 40),
      subdivision_fraction(),
      subdivision_limit(),
      about<Surface, NetSurface, Alone>(toggle<&Display::surface>("display.surface", "surface", "Show")),
      about<Surface, Bezier, BSpline, Fitted, Subdivision, Blending, NetSurface, Alone>(
          toggle<&Display::patch_colours>("display.colours", "colours", "Show")),
      about<Surface, BSpline, Fitted, Blending, NetSurface, Alone>(
          toggle<&Display::knot_lines>("display.knots", "knots", "Show")),
      about<Surface, NetSurface, Alone>(toggle<&Display::wireframe>("display.wireframe", "wireframe", "Show")),
      about<Surface, Blending>(toggle<&Display::local_patches>("display.locals", "locals", "Show")),
      about<Surface, Model, Blending>(toggle<&Display::frames>("display.frames", "frames", "Show")),
      about<Surface, NetSurface, Alone>(toggle<&Display::normals>("display.normals", "normals", "Show")),
      about<Bezier, BSpline, Fitted, Subdivision>(
          toggle<&Display::polygon>("display.polygon", "control polygon", "Show")),
      // The same member under the name that it has for a surface.
      about<NetSurface>(toggle<&Display::polygon>("display.net", "control net", "Show")),
      about<Bezier, BSpline, Model, Blending>(
          toggle<&Display::construction>("display.construction", "construction", "Show")),
      about<Bezier, BSpline, Fitted, Subdivision, Model, Blending>(
          toggle<&Display::comb>("display.comb", "curvature comb", "Show")),
      about<Bezier, BSpline, Blending>(toggle<&Display::osculating>("display.osculating", "osculating circle", "Show")),
      about<Bezier, BSpline, Fitted, Model, Blending>(
          toggle<&Display::hodograph>("display.hodograph", "hodograph", "Show")),
      about<BSpline, Fitted, Blending>(toggle<&Display::continuity>("display.continuity", "continuity", "Show")),
      about<Surface, Bezier, BSpline, Fitted, Subdivision, Model, Blending, NetSurface>(
          toggle<&Display::handles>("display.handles", "handles", "Show")),
      about<Surface, NetSurface, Alone>(choice<&Display::shading>("display.shading", "shading", "Shading",
                                                                  {{"lit", "lit"},
                                                                   {"zebra", "zebra stripes"},
                                                                   {"isophotes", "isophotes"},
                                                                   {"gaussian", "Gaussian curvature"},
                                                                   {"mean", "mean curvature"}})),
      // Behind what is shown: the panel has groups with switches in the order of the table.
      about<Surface, NetSurface, Alone>(toggle<&Display::adaptive>("samples.adaptive", "fit to screen", "Sampling")),
      about<Surface, Blending, Subdivision>(
          without_history(toggle<&Animation::playing>("animation.playing", "playing", "Animation"))),
      moving(without_history(
          number<&Animation::time, limits::time>("animation.time", "time", "Animation", {0.01, clock_period, "s"}))),
      about<Surface, Blending, Subdivision>(
          number<&Animation::speed, limits::speed>("animation.speed", "speed", "Animation", {0.1, 4, "×"})),
      moving(choice<&Animation::motion>("motion.kind", "motion", "Motion",
                                        {{"breathe", "breathe"}, {"report", "as in the report"}})),
      moving(number<&Animation::amplitude, limits::amplitude>("motion.amplitude", "amplitude", "Motion", {0.01, 0.5})),
      moving(number<&Animation::translation, limits::share>("motion.translation", "translation", "Motion", {0.01, 1})),
      moving(number<&Animation::rotation, limits::share>("motion.rotation", "rotation", "Motion", {0.5, 1})),
  };
  const auto insert = [&table](std::vector<Parameter>::const_iterator at, const std::vector<Parameter>& rows) {
    table.insert(at, rows.begin(), rows.end());
  };
  insert(table.end(), surface_measure_rows());
  std::vector<Parameter> rows = curve_measure_rows();
  rows.insert(rows.begin(), catalogue_curve_row());
  for (const Parameter& row : local_curve_rows()) rows.push_back(row);
  insert(std::find_if(table.begin(), table.end(), [](const Parameter& row) { return row.id == "curve.parameter"; }),
         rows);
  return table;
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
  const bool rolls = parameter.id == "topology.u" || parameter.id == "topology.v";
  const bool alone = std::holds_alternative<ModelSurfaceObject>(stage_shape(document));
  if (alone && parameter.id == "model" && choice == id_of(ModelKind::sheet)) return std::string(sheet_alone);
  if (rolls && net_on(document) != nullptr) {
    Document changed = document;
    const Status status = parameter.set(changed, std::string(choice));
    return status ? std::string() : status.error().message;
  }
  const int wanted = find_choice(ids_of(Topology{}), choice);
  if (wanted < 0) return {};
  if (parameter.id == "topology.u") return refused_topology(document, 'u', static_cast<Topology>(wanted));
  if (parameter.id == "topology.v") return refused_topology(document, 'v', static_cast<Topology>(wanted));
  const auto* blending = std::get_if<BlendingCurveObject>(&stage_shape(document));
  const bool closes_curve = parameter.id == "curve.topology" && static_cast<Topology>(wanted) == Topology::closed;
  return closes_curve && blending != nullptr ? refused_closure(blending->model) : std::string();
}

Limits range_of(const Document& document, const Parameter& parameter) {
  return parameter.range ? parameter.range(document) : Limits{parameter.min, parameter.max};
}

Limits soft_range_of(const Document& document, const Parameter& parameter) {
  if (parameter.soft_range) return parameter.soft_range(document);
  const Limits range = range_of(document, parameter);
  return {range.min, parameter.soft_max > range.min ? std::min(parameter.soft_max, range.max) : range.max};
}

std::string side_effect(const Document& document, const Parameter& parameter, const ParameterValue& value) {
  if (const auto* blending = std::get_if<BlendingCurveObject>(&stage_shape(document))) {
    Document after = document;
    if (!applies(document, parameter) || !parameter.set(after, value)) return {};
    return blending_curve_side_effect(*blending, *std::get_if<BlendingCurveObject>(&stage_shape(after)));
  }
  const bool new_knots =
      parameter.id == "curve.degree" || parameter.id == "curve.topology" || parameter.id == "curve.ends";
  if (new_knots && std::holds_alternative<BSplineCurveObject>(stage_shape(document))) {
    Document after = document;
    if (!parameter.set(after, value) || after == document || knots_are_even(bspline(document))) return {};
    return "The knots are evenly spaced again.";
  }
  if (!applies(document, parameter)) return {};
  if (const BSplineSurfaceObject* net = net_on(document)) return net_side_effect(*net, document, parameter, value);
  if (parameter.id != "model" || !std::holds_alternative<BlendingSurfaceObject>(stage_shape(document))) return {};
  Document after = document;
  if (!parameter.set(after, value)) return {};
  const BlendingSurfaceObject &was = blending_surface(document), &is = blending_surface(after);
  const bool u = was.topology_u != is.topology_u, v = was.topology_v != is.topology_v;
  if (!u && !v) return {};
  if ((u && closes_u(is.model)) || (v && closes_v(is.model))) {
    BlendingSurfaceObject closed = is;
    (u ? closed.topology_u : closed.topology_v) = Topology::closed;
    return seam_problem(closed).message + (u ? " So u opens." : " So v opens.");
  }
  const std::string directions = u && v ? "u and v" : u ? "u" : "v";
  return "The " + std::string(model_name(is.model)) + " is not closed in " + directions + ", so " + directions +
         (u && v ? " open." : " opens.");
}

}  // namespace knotwork::scene
