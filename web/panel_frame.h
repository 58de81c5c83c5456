#pragma once

#include "web/few.h"
#include "web/interface_widgets.h"
#include "web/words.h"

namespace knotwork::web {

// What the parts of the panel share: one frame's input and output, and where things go.

inline constexpr float clock_height = 64;  ///< from the stage's foot to the clock's upper edge
inline constexpr float tools_height = 46;  ///< of the row of buttons under a figure's plot
inline constexpr float wide_stage = 660;   ///< from here on there is room for the wide card
inline constexpr float tall_stage = 820;   ///< from here on a figure's table is always in view

struct Frame {
  PanelState& state;
  const PanelInput& input;
  PanelOutput& output;
  Interface& ui;
  Rect stage;

  const scene::Shape& shape() const { return scene::stage_shape(input.document); }
  bool tall() const { return stage.height >= tall_stage; }
  bool has_clock() const { return moves(shape()); }
  /// From the stage's foot to the upper edge of what stands there: the figure's plot, the clock or the row of buttons.
  float foot() const;
};

/// Where the next row goes, and how much of it is for the row's label.
struct Column {
  float x, width, y;
  float labels = 0;
};

/// Presses in here are the interface's, not the stage's.
void claim(Frame& frame, const Rect& rect);
/// A plain window of ImGui's at the rectangle; ImGui::End() closes it.
void begin(Frame& frame, const char* name, const Rect& rect, ImGuiWindowFlags flags);

/// A hold on something that changes the document over several frames is one step of the history.
void take_gesture(Frame& frame);
void end_gesture(Frame& frame);

}  // namespace knotwork::web
