#pragma once

#include <string>

#include "knotwork/scene/document.h"

namespace knotwork::web {

struct StillSize {
  double width = 720, height = 440;  ///< CSS pixels
  int pieces_u = 48, pieces_v = 32;  ///< about so many flat pieces each way of a surface
};

/// The figure on the stage as an SVG picture, without the interface: what stands for it before the module is there,
/// without it, and in print. Seen from where the document's camera looks from, as large as fits. It follows the colour
/// scheme of whoever shows it by itself. Surfaces are flat pieces painted from back to front (still_surface.h): where
/// large pieces cross, what is in front can come out wrong by one of them.
/// Precondition: the document passes check().
std::string still(const scene::Document& document, const StillSize& size = {});

}  // namespace knotwork::web
