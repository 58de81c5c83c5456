#pragma once

#include <vector>

#include "knotwork/scene/parameters.h"

namespace knotwork::scene {

/// A row `model.<measure's id>` for every measure that any model has, made from the models' own tables: it is there
/// while the model on the stage has that measure.
void append_model_parameters(std::vector<Parameter>& table);

}  // namespace knotwork::scene
