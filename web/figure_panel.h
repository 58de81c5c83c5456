#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knotwork/surface/surface_measures.h"
#include "web/panel_frame.h"

namespace knotwork::web {

/// A button in the row of tools: it performs its command, or acts as the key does on the stage.
struct Tool {
  std::string_view id;
  Icon icon = Icon::reset;
  bool enabled = false;
  std::string_view hint;  ///< in English
  std::optional<scene::Command> command;
  std::string_view key{};
};
using Tools = Few<Tool, 4>;

/// A place of a surface by its parameters, where it is and how the surface is curved there, four lines in an ink's share;
/// the next line's middle. On a phone all stands over the figure: then on a plate with room for `below` CSS pixels more.
float place_readout(Frame& frame, float left, float y, const SurfacePlace& place, float below, float share = 1);

// What the panel shows of the figure on the stage. Each kind of figure has functions of these names with the figure as
// one more argument, in its own <kind>_panel.h.

/// The size beside the title, as "6 × 4".
Sentence size_text(const Frame& frame);
/// The buttons that only this kind has.
Tools tools_of(const Frame& frame);
/// Rows of the card below the first parameters.
void draw_rows(Frame& frame, Column& column);
/// A table that is folded away where the stage is low.
bool has_table(const Frame& frame);
void draw_table(Frame& frame, Column& column);
/// The plot at the stage's foot; no height: none.
float strip_height(const Frame& frame);
void draw_strip(Frame& frame, const Rect& place);
/// What is selected and what is under the pointer, at the stage's upper left corner; `y` is the first line's middle.
void draw_readout(Frame& frame, float left, float y);

}  // namespace knotwork::web
