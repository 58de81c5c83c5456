#pragma once

#include <vector>

#include "knotwork/scene/parameters.h"

namespace knotwork::scene {

/// A row `model.<measure's id>` for every measure that any model of a surface has, and `curve.<measure's id>` for those
/// of the catalogue's curves, made from the models' own tables. A row applies while the model on the stage has its
/// measure; measures of one id share a row, whose label is the shortest of theirs: the most general.
std::vector<Parameter> surface_measure_rows();
std::vector<Parameter> curve_measure_rows();

}  // namespace knotwork::scene
