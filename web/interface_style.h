#pragma once

#include <cstdint>
#include <vector>

#include "web/theme.h"

struct ImFont;

namespace knotwork::web {

/// The two faces of the interface, loaded for one pixel ratio.
struct InterfaceFonts {
  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
};

/// Fills ImGui's font atlas: TrueType bytes from the page (empty: ImGui's own face), sharp at the pixel ratio. Sizes are
/// CSS pixels; the caller makes the backend take up the new atlas.
InterfaceFonts load_interface_fonts(const std::vector<std::uint8_t>& regular, const std::vector<std::uint8_t>& bold,
                                    double pixel_ratio);

/// Colours, rounding, spacing of LOOK.md's panel; nothing of ImGui's default grey is left.
void apply_interface_style(const Theme& theme);

}  // namespace knotwork::web
