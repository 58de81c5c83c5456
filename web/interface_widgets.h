#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "web/interface_style.h"
#include "web/language.h"
#include "web/panels.h"

namespace knotwork::web {

/// CSS pixels of the stage.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;

  ImVec2 min() const { return {x, y}; }
  ImVec2 max() const { return {x + width, y + height}; }
  ImVec2 centre() const { return {x + width / 2, y + height / 2}; }
};

enum class Face : unsigned char { regular, bold, small };
enum class Align : unsigned char { left, centre, right };

/// What a widget is called: a word, or a word and a choice, read as "word: choice". They are kept apart, as putting them
/// together would take memory in every frame.
struct WidgetName {
  std::string_view word, choice;

  // NOLINTBEGIN(google-explicit-constructor): most widgets are called by a word
  WidgetName(std::string_view of) : word(of) {}
  WidgetName(const std::string& of) : word(of) {}
  WidgetName(const char* of) : word(of) {}
  // NOLINTEND(google-explicit-constructor)
  WidgetName(std::string_view of, std::string_view chosen) : word(of), choice(chosen) {}
};

/// What the widgets of one frame draw with and report to. They lay nothing out: each is given its rectangle, which is
/// also where it can be clicked.
struct Interface {
  const Theme& theme;
  InterfaceFonts fonts;
  float pixel_ratio = 1;
  bool touch = false;            ///< type and thumbs are larger under a finger
  bool reduced_motion = false;   ///< nothing eases then
  float step = 1.0F / 60;        ///< seconds that what moves has moved on since the last frame
  bool listening = true;         ///< false while a finger scrolls: letting go is no click then
  bool wants_frame = false;      ///< something is still moving
  std::vector<Widget>& widgets;  ///< the items drawn, for the script interface; behind `drawn` those of the last frame
  std::size_t drawn = 0;
  std::optional<Widget> hint;  ///< the words to show beside the item under the pointer

  /// Into the last frame's memory.
  void record(WidgetName name, const std::array<double, 4>& rect) {
    if (drawn == widgets.size()) widgets.emplace_back();
    Widget& widget = widgets[drawn++];
    widget.label = name.word;
    if (!name.choice.empty()) widget.label.append(": ").append(name.choice);
    widget.rect = rect;
  }
};

// Colours for ImGui's draw lists.
ImU32 colour(const Colour& srgb, float opacity = 1);
/// A hue as text: a tint nearer to the ink, which keeps its contrast on stage and card.
Colour as_text(const Theme& theme, const Colour& hue);

/// A value on its way to `target` at constant speed, `seconds` for a way of 1; asks for frames until it is there.
float eased(Interface& ui, float& value, float target, float seconds = 0.12F);
/// The same, kept by ImGui under the id of a widget; it starts at its first target.
float eased(Interface& ui, ImGuiID id, float target, float seconds = 0.12F);
/// Slow at both ends: 3t^2 - 2t^3.
float smooth(float share);

/// Antialiased edges one device pixel wide, whatever the pixel ratio; after Begin, which starts a fresh list.
void sharpen(const Interface& ui, ImDrawList& list);
/// Rings of falling opacity round a card; inside it nothing, so that a translucent card stays clean.
void soft_shadow(const Interface& ui, ImDrawList& list, const Rect& card, float rounding, float opacity = 1);

// Type. Positions are of the line's vertical centre; subscript figures (U+2080..2089) are drawn small and
// low, raised ones (U+2070, 2074..2079) small and high.
float text_width(const Interface& ui, Face face, Said text);
void text(const Interface& ui, Face face, ImVec2 position, ImU32 ink, Said text, Align align = Align::left);
/// The same where only `room` CSS pixels are free: longer words end with "…", and the pointer on them shows them whole.
void fitted_text(Interface& ui, Face face, ImVec2 position, ImU32 ink, Said words, float room,
                 Align align = Align::left);
/// Where what follows words at `x` begins: at its usual place, or behind longer words.
float behind(const Interface& ui, Face face, float x, Said text, float usual);

/// Words in lines of even length that are no longer than `widest`: the width to wrap at, and the extent.
struct Paragraph {
  float wrap = 0;
  ImVec2 extent;
};
Paragraph balanced(const Interface& ui, Face face, Said words, float widest);
void paragraph(const Interface& ui, ImDrawList& list, Face face, ImVec2 corner, ImU32 ink, Said words, float wrap);

/// One press area with the record of it; the base of all widgets.
struct Press {
  bool hovered = false, held = false, clicked = false, taken = false, let_go = false;
};
Press press_area(Interface& ui, WidgetName name, const Rect& rect);

/// One segment of a switch; `refusal` says in English why it cannot be chosen now.
struct Segment {
  Said label = as_is("");
  WidgetName widget{""};
  bool chosen = false;
  std::string refusal{};
};
inline constexpr std::size_t most_segments = 4;  ///< more choices are a list
/// The width that a switch needs for its words.
float segmented_width(const Interface& ui, std::span<const Segment> segments);
/// Up to four choices side by side. Returns the clicked one, refused ones too: the refusal is then told by whoever
/// applies the command.
std::optional<std::size_t> segmented(Interface& ui, std::string_view id, const Rect& rect,
                                     std::span<const Segment> segments);

/// What a slider runs over. Logarithmic where the range spans orders of magnitude.
struct SliderScale {
  double min = 0, max = 1, step = 0;
  bool logarithmic = false;

  double value_at(double share) const;
  double share_of(double value) const;
};
struct SliderEvent {
  bool taken = false, moved = false, let_go = false;
  double value = 0;
};
/// A thin track with a round thumb; a press on the track brings the thumb there, a press on the thumb takes it as it is.
SliderEvent slider(Interface& ui, std::string_view id, const Rect& rect, const SliderScale& scale, double value,
                   bool enabled = true);

bool chip(Interface& ui, std::string_view id, const Rect& rect, Said label, bool on, bool enabled = true);

enum class Icon : unsigned char {
  undo,
  redo,
  reset,
  frame,
  close,
  sliders,
  add,
  remove,
  pencil,
  back,
  onwards,
  play,
  pause
};
bool icon_button(Interface& ui, std::string_view id, const Rect& rect, Icon icon, bool enabled, Said hint);
bool play_button(Interface& ui, std::string_view id, const Rect& rect, bool playing);
/// A pill with an icon and a word.
bool pill_button(Interface& ui, std::string_view id, const Rect& rect, Icon icon, Said label);
/// A line of text with a chevron that turns when `open`.
bool fold_button(Interface& ui, std::string_view id, const Rect& rect, Said label, bool open);
/// The closed form of a list of choices.
bool combo_button(Interface& ui, std::string_view id, const Rect& rect, Said label, bool open);
/// A row of an open list, with a small plot of `curve` (values in [0,1]) at its right.
bool menu_item(Interface& ui, WidgetName id, const Rect& rect, Said label, bool chosen, Said refusal,
               std::span<const float> curve);

/// B and 1-B over [0,1] in the hues of the two locals that they weigh, B' faintly behind; `w` is where the probe is.
void blending_plot(Interface& ui, const Rect& rect, const BlendingFunction& blending, std::optional<double> w,
                   const std::array<Colour, 2>& hues);

/// Words to show beside an item, if there are any.
void set_hint(Interface& ui, Said words, const Rect& item);
/// Draws the hint of this frame, if there is one, above everything.
void draw_hint(Interface& ui, const Rect& stage);

}  // namespace knotwork::web
