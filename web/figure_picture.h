#pragma once

#include <span>
#include <vector>

#include "web/composition.h"
#include "web/interaction.h"
#include "web/panels.h"
#include "web/renderer.h"

namespace knotwork::web {

/// What a picture of the figure looks at beside the figure itself.
struct Look {
  const scene::Document& document;
  const InteractionState& state;
  std::span<const Handle> handles;
  bool rolling = false;  ///< between two topologies
};

// What is drawn of the figure on the stage, as plain values added to a picture whose view, theme and display are set.
// Each kind of figure has functions of these names in its own <kind>_ornaments.h.

void add_to_picture(Picture& picture, const Figure& figure, const Look& look);
/// Whether what has names is shown: handles, or a model curve's frame.
bool shows_names(const Figure& figure, const scene::Display& display);
/// Names beside them, where there is a choice on a side where nothing covers them.
std::vector<StageLabel> labels_of(const Figure& figure, std::span<const Handle> handles, const View& view,
                                  const Theme& theme, const Obstacles& covered);

}  // namespace knotwork::web
