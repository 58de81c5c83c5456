#pragma once

#include "knotwork/later.h"
#include "web/figure_picture.h"

namespace knotwork::web {

/// The curvature comb of a curve: at many places a hair away from the centre of curvature, as long as the curvature
/// there times a fixed share of the curve's size squared, and a line along the tips. Where pieces of the curve meet the
/// comb shows both sides: a step in it is a curvature that jumps. Nothing for surfaces.
KNOTWORK_LATER void add_curvature_comb(Picture& picture, const Figure& figure);

}  // namespace knotwork::web
