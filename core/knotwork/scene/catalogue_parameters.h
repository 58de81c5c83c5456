#pragma once

#include <vector>

#include "knotwork/later.h"
#include "knotwork/scene/parameters.h"

namespace knotwork::scene {

/// Which curve of the catalogue is on the stage, as a figure of its own or under a blending curve.
KNOTWORK_LATER_ROW Parameter catalogue_curve_row();

/// The rows about the local curves of a blending curve: their number, kind and degree.
std::vector<Parameter> local_curve_rows();

/// The catalogue's curve on the stage, of either kind of object; nullptr for others.
const CatalogueCurve* stage_model_curve(const Document& document);

/// What else the row changes on a blending curve: knots that are evenly spaced again, a curve that opens. Empty when
/// nothing.
KNOTWORK_LATER std::string blending_curve_side_effect(const BlendingCurveObject& before,
                                                      const BlendingCurveObject& after);

}  // namespace knotwork::scene
