#pragma once

#include <vector>

#include "knotwork/curve/curve_catalogue.h"
#include "knotwork/curve/parametric_curve.h"

namespace knotwork::scene {

/// A curve of the catalogue as the measures see it. The curve must outlive it.
CurveView view_of(const CatalogueCurve& curve);

/// Ascending parameters from `from` to `to`, both included, at which a curve drawn as a polygon looks smooth: `least`
/// even steps, each halved (five times at most) until the curve's places in between lie within `tolerance` (model units)
/// of its chord.
std::vector<double> drawing_parameters(const CurveView& curve, double from, double to, int least, double tolerance);

/// Half the diagonal of a coarse box: the size that tolerances are relative to. Never 0.
double drawn_size(const CurveView& curve);

/// Steps of a whole model curve that resolve each of its oscillations.
int least_steps(const CatalogueCurve& curve);

}  // namespace knotwork::scene
