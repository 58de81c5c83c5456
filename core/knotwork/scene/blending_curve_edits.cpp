#include "knotwork/scene/blending_curve_edits.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "knotwork/scene/document_members.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

const CatalogueCurveRow& row_of(const CatalogueCurve& curve) {
  return curve_catalogue()[static_cast<std::size_t>(curve.row)];
}

/// The shares of all knots of the domain, its ends included.
std::vector<double> knot_shares(const BlendingCurveObject& object) {
  const int inner = inner_knot_count(object.topology, object.locals);
  std::vector<double> shares{0};
  for (int k = 0; k < inner; ++k) {
    const double even = static_cast<double>(k + 1) / (inner + 1);
    shares.push_back(object.knots.empty() ? even : object.knots[static_cast<std::size_t>(k)]);
  }
  shares.push_back(1);
  return shares;
}

Status check_knots(const BlendingCurveObject& object) {
  const int inner = inner_knot_count(object.topology, object.locals);
  if (object.knots.empty()) return success();
  if (static_cast<int>(object.knots.size()) != inner) {
    return Error{"knots", "Must hold " + std::to_string(inner) + " knots, or none for evenly spaced ones."};
  }
  double before = 0;
  for (int k = 0; k < inner; ++k) {
    const double share = object.knots[static_cast<std::size_t>(k)];
    const bool last = k + 1 == inner;
    // Half a gap of tolerance: shares that come through parameters and back are rounded.
    if (share - before < 0.5 * least_knot_gap || (last && 1 - share < 0.5 * least_knot_gap)) {
      return Error{"knots[" + std::to_string(k) + "]",
                   "Must lie behind the knot before it and within 0 and 1, 0.001 "
                   "away at least."};
    }
    before = share;
  }
  return success();
}

Result<BlendingCurve> built(const BlendingCurveObject& object) {
  const ModelCurve model = model_of(object.model);
  const KnotVector knots = knots_of(object);
  const int parameter = blending_family(object.blending).parameter_max > 0 ? object.blending_parameter : 0;
  return BlendingCurve::make(model, knots, BlendingFunction::make(object.blending, parameter).value(),
                             {object.local_kind, object.local_degree}, BlendingCurve::unmoved_locals(model, knots));
}

/// The error of a measure, without the path in a document.
Status refused_measure(const Status& status) {
  return status ? success() : Status(Error{"measure", status.error().message});
}

}  // namespace

ChoiceIds ids_of(LocalCurveKind) {
  return {3, [](int i) {
            constexpr std::string_view ids[] = {"sub-curve", "bezier-hermite", "arc"};
            return ids[i];
          }};
}

ChoiceIds ids_of(CurveRow) {
  return {static_cast<int>(curve_catalogue().size()),
          [](int i) { return curve_catalogue()[static_cast<std::size_t>(i)].id; }};
}

CatalogueCurve standard_curve(int row) {
  return make_catalogue_curve(curve_catalogue()[static_cast<std::size_t>(row)].id).value();
}

CatalogueCurve standard_model_curve() { return make_catalogue_curve("report-curve").value(); }

Status check_model(const CatalogueCurve& model) {
  const Status status = validate(model);
  return status ? success() : Status(Error{"model." + status.error().path, status.error().message});
}

Status check_curve(const BlendingCurveObject& object) {
  if (const Status status = check_model(object.model); !status) return status;
  if (object.topology == Topology::closed && !is_closed(object.model))
    return Error{"topology", refused_closure(object.model)};
  if (const Status status = check_knots(object); !status) return status;
  for (const auto& [local, edit] : object.edits)
    if (local.second != 0) return Error{"edits", "A local curve has one number: j must be 0."};
  const Result<BlendingCurve> curve = built(object);
  if (!curve) return Error{curve.error().path == "shape.degree" ? "locals.degree" : "model", curve.error().message};
  return success();
}

ModelCurve model_of(const CatalogueCurve& curve) {
  const Interval where = domain(curve);
  return {where.start, where.end, row_of(curve).topology, 3,
          [curve](double t, std::span<Eigen::Vector3d> out) { evaluate(curve, t, out); }};
}

bool is_closed(const CatalogueCurve& curve) { return row_of(curve).topology == Topology::closed; }

KnotVector knots_of(const BlendingCurveObject& object) {
  const Interval where = domain(object.model);
  const bool closed = object.topology == Topology::closed;
  if (object.knots.empty())
    return KnotVector::uniform(1, object.locals, object.topology, where.start, where.end).value();
  const double length = where.end - where.start;
  std::vector<double> knots;
  const std::vector<double> shares = knot_shares(object);
  knots.reserve(shares.size() + 2);
  for (const double share : shares) knots.push_back(std::lerp(where.start, where.end, share));
  // One more at either end: the same again, or the neighbour from the other end of the period.
  const double first = closed ? knots[knots.size() - 2] - length : knots.front();
  const double last = closed ? knots[1] + length : knots.back();
  knots.insert(knots.begin(), first);
  knots.push_back(last);
  return KnotVector::make(1, object.topology, std::move(knots)).value();
}

BlendingCurve unmoved_curve(const BlendingCurveObject& object) { return built(object).value(); }

int inner_knot_count(Topology topology, int locals) { return topology == Topology::closed ? locals - 1 : locals - 2; }

const std::map<PatchIndex, PatchEdit>* local_edits(const Shape& shape) {
  if (const auto* surface = std::get_if<BlendingSurfaceObject>(&shape)) return &surface->edits;
  const auto* curve = std::get_if<BlendingCurveObject>(&shape);
  return curve != nullptr ? &curve->edits : nullptr;
}

Status set_model(ModelCurveObject& object, int row) {
  if (row != object.model.row) object.model = standard_curve(row);
  return success();
}

Status set_model(BlendingCurveObject& object, int row) {
  if (row == object.model.row) return success();
  object.model = standard_curve(row);
  return is_closed(object.model) ? success() : set_topology(object, Topology::open);
}

Status set_measure(ModelCurveObject& object, std::size_t k, double value) {
  CatalogueCurve changed = object.model;
  changed.measures[k] = value;
  if (const Status status = check_model(changed); !status) return refused_measure(status);
  object.model = changed;
  return success();
}

Status set_measure(BlendingCurveObject& object, std::size_t k, double value) {
  BlendingCurveObject changed = object;
  changed.model.measures[k] = value;
  if (const Status status = check_curve(changed); !status) return refused_measure(status);
  object.model = changed.model;
  return success();
}

Status set_topology(BlendingCurveObject& object, Topology topology) {
  if (topology == Topology::closed && !is_closed(object.model)) return Error{"topology", refused_closure(object.model)};
  if (topology == object.topology) return success();
  object.topology = topology;
  object.knots.clear();
  return success();
}

Status set_local_count(BlendingCurveObject& object, int count) {
  if (!limits::curve_locals.contains(count)) return Error{"count", integer_message(limits::curve_locals)};
  if (count == object.locals) return success();
  object.locals = count;
  object.knots.clear();
  return success();
}

Status set_knot(BlendingCurveObject& object, int index, double value) {
  const int inner = inner_knot_count(object.topology, object.locals), place = index - 1;
  if (place < 1 || place > inner) return Error{"index", "There is no knot " + std::to_string(index) + " to be moved."};
  if (!limits::coordinate.contains(value)) return Error{"value", number_message(limits::coordinate)};
  const Interval where = domain(object.model);
  std::vector<double> shares = knot_shares(object);
  const auto k = static_cast<std::size_t>(place);
  const double share = (value - where.start) / (where.end - where.start);
  if (share - shares[k - 1] < least_knot_gap || shares[k + 1] - share < least_knot_gap)
    return Error{"value", "Knots of a blending curve must not come together."};
  shares[k] = share;
  object.knots.assign(shares.begin() + 1, shares.end() - 1);
  return success();
}

Status set_local_edit(BlendingCurveObject& object, int local, const PatchEdit& edit) {
  if (local < 0 || local >= object.locals)
    return Error{"local", "There is no local curve " + std::to_string(local) + "."};
  if (Status status = check(edit); !status) return status;
  if (edit.is_identity()) {
    object.edits.erase({local, 0});
  } else {
    object.edits[{local, 0}] = edit;
  }
  return success();
}

std::string refused_closure(const CatalogueCurve& model) {
  if (is_closed(model)) return {};
  return std::string(row_of(model).label) + " is not closed, so a blending curve over it can only be open.";
}

}  // namespace knotwork::scene
