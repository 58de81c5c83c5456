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

}  // namespace knotwork::scene
