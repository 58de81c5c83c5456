#pragma once

#include <map>

#include "knotwork/curve/blending_curve.h"
#include "knotwork/later.h"
#include "knotwork/scene/document.h"

namespace knotwork::scene {

// Model curves of the catalogue and blending curves over them, as documents have them.

/// Whether the measures are the row's and within its limits. Error path: `model.radius`.
KNOTWORK_LATER Status check_model(const CatalogueCurve& model);
/// Moreover whether a blending curve can be built: knots ascend with gaps of at least `least_knot_gap`, there are as
/// many as it takes, it closes only where its model does, and its edits are of locals (k, 0). Precondition: the
/// B-function exists. Error path: `topology`, `knots`, `knots[i]`, `edits`, or as above.
KNOTWORK_LATER Status check_curve(const BlendingCurveObject& object);

/// Shares of the domain between neighbouring knots.
inline constexpr double least_knot_gap = 1e-3;

/// The curve with all its derivatives to order 3, as a model to blend over.
KNOTWORK_LATER ModelCurve model_of(const CatalogueCurve& curve);
bool is_closed(const CatalogueCurve& curve);

/// The knot vector of degree 1 over the model's domain. Precondition: the object is valid.
KNOTWORK_LATER KnotVector knots_of(const BlendingCurveObject& object);
/// The curve with its locals unmoved. Precondition: the object is valid.
KNOTWORK_LATER BlendingCurve unmoved_curve(const BlendingCurveObject& object);
/// How many knots lie strictly within the domain: n-1 closed, n-2 open.
int inner_knot_count(Topology topology, int locals);

/// The edits of local patches or local curves; nullptr for shapes without.
const std::map<PatchIndex, PatchEdit>* local_edits(const Shape& shape);

// What a hand does. On an error nothing has changed.

/// Another curve of the catalogue with its standard measures. Where it is open, a blending curve opens with it.
KNOTWORK_LATER Status set_model(ModelCurveObject& object, int row);
KNOTWORK_LATER Status set_model(BlendingCurveObject& object, int row);
/// Measure k of the model. Refused where no curve is left to blend over. Error path: `measure`.
KNOTWORK_LATER Status set_measure(ModelCurveObject& object, std::size_t k, double value);
KNOTWORK_LATER Status set_measure(BlendingCurveObject& object, std::size_t k, double value);
/// Evenly spaced knots come with a new topology or count. Error path: `topology`, `count`.
KNOTWORK_LATER Status set_topology(BlendingCurveObject& object, Topology topology);
KNOTWORK_LATER Status set_local_count(BlendingCurveObject& object, int count);
/// Knot t_index, `value` a parameter, at least the gap away from its neighbours; the ends of the domain stay. Error
/// path: `index`, `value`.
KNOTWORK_LATER Status set_knot(BlendingCurveObject& object, int index, double value);
/// An identity edit removes it. Error path: `local`, or the edit's member.
KNOTWORK_LATER Status set_local_edit(BlendingCurveObject& object, int local, const PatchEdit& edit);

/// "Helix is not closed, so a blending curve over it can only be open.", empty where the model closes.
std::string refused_closure(const CatalogueCurve& model);

}  // namespace knotwork::scene
