#pragma once

#include <vector>

#include "knotwork/later.h"
#include "knotwork/scene/parameters.h"

namespace knotwork::scene {

/// The rows about a curve of the catalogue, as a figure of its own or under a blending curve: which one it is, and its
/// measures. Made from the catalogue: `curve.` and the measure's id, a row for each id that any curve has; it applies
/// while the chosen curve has it.
std::vector<Parameter> catalogue_curve_rows();

/// The rows about the local curves of a blending curve: their number, kind and degree.
std::vector<Parameter> local_curve_rows();

/// The catalogue's curve on the stage, of either kind of object; nullptr for others.
const CatalogueCurve* stage_model_curve(const Document& document);

/// What else the row changes on a blending curve: knots that are evenly spaced again, a curve that opens. Empty when
/// nothing.
KNOTWORK_LATER std::string blending_curve_side_effect(const BlendingCurveObject& before,
                                                      const BlendingCurveObject& after);

}  // namespace knotwork::scene
