#pragma once

#include <cstdint>
#include <vector>

#include "web/theme.h"

struct ImFont;

namespace knotwork::web {

/// The faces of the interface, loaded for one pixel ratio.
struct InterfaceFonts {
  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
  ImFont* small = nullptr;  ///< regular, for captions
};

/// Heights of the faces as ImGui counts them, from ascender to descender, CSS pixels: Inter at 13 and 11.5 px.
inline constexpr float text_height = 16, small_text_height = 14;

/// Fills ImGui's font atlas: TrueType bytes from the page, sharp at the pixel ratio, with figures of one width. Sizes are CSS pixels: glyphs are rasterised larger by the pixel ratio, and ImGui's global font
/// scale takes it back. The caller makes the backend take up the new atlas.
InterfaceFonts load_interface_fonts(const std::vector<std::uint8_t>& regular, const std::vector<std::uint8_t>& bold,
                                    double pixel_ratio);

/// The faces that load_interface_fonts put into the current atlas.
InterfaceFonts interface_fonts();

/// Colours, rounding, spacing of LOOK.md's panel; nothing of ImGui's default grey is left.
void apply_interface_style(const Theme& theme);

}  // namespace knotwork::web
