#pragma once

#include <span>
#include <vector>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/later.h"
#include "web/figure_picture.h"

namespace knotwork::web {

struct CombHair {
  glm::vec3 foot, tip;
  bool ends_piece;  ///< the next hair belongs to another piece of the curve
};

/// The curvature comb of a curve: at many places a hair away from the centre of curvature, as long as the curvature
/// there times a fixed share of the curve's size squared; what would be longer than 0.45 of the size is cut off. Where
/// pieces of the curve meet the comb has both sides: a step in it is a curvature that jumps.
KNOTWORK_LAST std::vector<CombHair> curvature_comb(const CurveView& curve);

/// The hairs, and a line along the tips of each piece.
KNOTWORK_LAST void add_comb(Picture& picture, std::span<const CombHair> comb);

}  // namespace knotwork::web
