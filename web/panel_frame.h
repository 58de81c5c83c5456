#pragma once

#include <array>
#include <string>
#include <string_view>

#include "web/few.h"
#include "web/interface_widgets.h"

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

/// printf's format for one number; without the sign of what rounds to zero, with the typographic minus.
std::string text_of(const char* format, double value);
/// Raised figures, from 0 to 9.
std::string superscript(int number);
/// Figures below the line.
std::string subscript(int number);

/// A few words put together without asking for memory; what is too long is cut off.
class Words {
 public:
  Words& add(std::string_view words);
  Words& add(int number);
  /// Figures below the line.
  Words& below(int number);
  const char* c_str() const { return text_.data(); }
  operator std::string_view() const { return {text_.data(), size_}; }  // NOLINT(google-explicit-constructor)

 private:
  std::array<char, 64> text_{};  ///< with a zero behind the words
  std::size_t size_ = 0;
};

/// Presses in here are the interface's, not the stage's.
void claim(Frame& frame, const Rect& rect);
/// A plain window of ImGui's at the rectangle; ImGui::End() closes it.
void begin(Frame& frame, const char* name, const Rect& rect, ImGuiWindowFlags flags);

/// A hold on something that changes the document over several frames is one step of the history.
void take_gesture(Frame& frame);
void end_gesture(Frame& frame);

}  // namespace knotwork::web
