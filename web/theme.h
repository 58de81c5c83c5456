#pragma once

#include <glm/vec3.hpp>

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

/// OKLab (Ottosson 2020) of an sRGB colour: mixtures in it stay clear. Its way back is limited to sRGB.
glm::vec3 oklab(const Colour& colour);
Colour srgb(const glm::vec3& oklab);

/// From one colour to another, share 0 to 1, each component for itself.
Colour mixed(const Colour& from, const Colour& to, float share);

}  // namespace knotwork::web
