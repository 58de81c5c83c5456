#pragma once

#include <array>

#include "knotwork/scene/document.h"

namespace knotwork::scene {

/// sRGB in [0,1].
using Colour = std::array<float, 3>;
inline constexpr int patch_hue_count = 8;

/// Eight hues, told apart by readers with any common colour vision (they differ in lightness too).
Colour patch_hue(int hue, bool dark_scheme);

/// The hue of patch (i, j): neighbours, diagonal ones and those across a closed seam included, differ.
int patch_hue_index(const BlendingSurfaceObject& object, PatchIndex patch);
/// The same of the control points of a net.
int patch_hue_index(const BSplineSurfaceObject& object, PatchIndex point);

}  // namespace knotwork::scene
