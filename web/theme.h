#pragma once

#include "knotwork/scene/palette.h"

namespace knotwork::web {

using Colour = scene::Colour;

/// The stage's share of shell/src/style/tokens.css: the same values, light and dark.
struct Theme {
  bool dark = false;
  Colour paper, panel, ink, ink_soft, rule, stage, stage_edge, accent, focus;
  std::array<Colour, 4> local;  ///< a, b, c, d
  float panel_opacity = 1;
};

Theme make_theme(bool dark);

}  // namespace knotwork::web
