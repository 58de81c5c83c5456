#include "web/panels.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include "web/interface_widgets.h"
#include "web/knot_strip.h"

namespace knotwork::web {
namespace {

using scene::Parameter;
using scene::ParameterKind;

// Every word of the interface that is not in the parameter table.
namespace words {
constexpr std::string_view controls = "Controls", more = "Display, sampling, motion", display = "Display",
                           undo = "Undo", redo = "Redo", reset = "Put all patches back",
                           frame = "Show the whole figure", domain = "domain", knots = "knots", patches = "patches",
                           locals = "locals", selected = "patch", pointed = "under the pointer", tapped = "at the tap",
                           add = "Add a point after this one", remove = "Delete this point";
}  // namespace words

// The panel's only list of parameters: which rows are worth their place while the rest is folded away, and which live
// beside the clock. All others follow by themselves in the table's groups.
constexpr std::array<std::string_view, 9> first_rows{"topology.u",     "topology.v",        "locals.u",
                                                     "locals.v",       "blending.function", "blending.parameter",
                                                     "curve.topology", "curve.degree",      "curve.parameter"};
constexpr std::array<std::string_view, 3> clock_rows{"animation.playing", "animation.time", "animation.speed"};
constexpr std::size_t phone_clock_rows = 2;  ///< the speed has no room there

constexpr float padding = 16;       ///< inside the card
constexpr float foot_clip = 3;      ///< rows end this much before the foot of what they scroll in
constexpr float combo_margin = 40;  ///< beside the words of a closed list
constexpr float clock_height = 64;  ///< from the stage's foot to the clock's upper edge
constexpr float tools_height = 46;  ///< of the row of buttons under a curve's basis functions
constexpr float wide_stage = 660;   ///< from here on there is room for the wide card
constexpr float tall_stage = 820;   ///< from here on the report's table is always in view

/// A curve's basis functions and knots.
float strip_height(const Rect& stage) { return std::clamp(0.24F * stage.height, 128.0F, 200.0F); }

struct Frame {
  PanelState& state;
  const PanelInput& input;
  PanelOutput& output;
  Interface& ui;
  const scene::BlendingSurfaceObject* object;  ///< nullptr when a curve is on the stage
  Rect stage;

  bool tall() const { return stage.height >= tall_stage; }
  /// From the stage's foot to the upper edge of what stands there: the clock, or a curve's basis functions.
  float foot() const { return object ? clock_height : strip_height(stage) + (ui.touch ? 0.0F : tools_height); }
};

/// Where the next row goes.
struct Column {
  float x, width, y;
};

// Measures that a finger needs larger.
float row_height(const Frame& frame) { return frame.ui.touch ? 44.0F : 30.0F; }
float slider_height(const Frame& frame) { return frame.ui.touch ? 44.0F : 26.0F; }
float label_width(const Frame& frame) { return frame.stage.width < wide_stage && !frame.ui.touch ? 76.0F : 84.0F; }

Rect card_frame(const Frame& frame) {
  const Rect& stage = frame.stage;
  const bool wide = stage.width >= wide_stage;
  const float width = wide ? 276.0F : 252.0F, margin = wide ? 20.0F : 12.0F;
  return {stage.width - width - margin, margin, width, stage.height - frame.foot() - margin - 8};
}

bool listed(std::span<const std::string_view> ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

std::string text_of(const char* format, double value) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  std::string text(buffer.data());
  // A value that rounds to zero has no sign.
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  // The typographic minus is as wide as a figure.
  if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
  return text;
}

/// Raised figures, from 0 to 9.
std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> figures{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return std::string(figures[static_cast<std::size_t>(std::clamp(number, 0, 9))]);
}

/// With as many decimals as the step has.
std::string value_text(const Parameter& parameter, double value) {
  const bool whole = parameter.kind == ParameterKind::integer || parameter.step >= 1;
  std::string text = text_of(whole ? "%.0f" : parameter.step >= 0.1 ? "%.1f" : "%.2f", value);
  if (parameter.unit == "×") return text + "×";
  return text;
}

void set(Frame& frame, const Parameter& parameter, scene::ParameterValue value) {
  frame.output.commands.emplace_back(scene::SetParameter{std::string(parameter.id), std::move(value)});
}

double number(const Frame& frame, const Parameter& parameter) {
  const scene::ParameterValue value = parameter.get(frame.input.document);
  const double* found = std::get_if<double>(&value);
  return found ? *found : 0;
}

std::string choice(const Frame& frame, const Parameter& parameter) {
  const scene::ParameterValue value = parameter.get(frame.input.document);
  const std::string* found = std::get_if<std::string>(&value);
  return found ? *found : std::string();
}

bool switched_on(const Frame& frame, const Parameter& parameter) {
  const scene::ParameterValue value = parameter.get(frame.input.document);
  const bool* found = std::get_if<bool>(&value);
  return found && *found;
}

std::string why_disabled(const Frame& frame, const Parameter& parameter) {
  return parameter.disabled ? parameter.disabled(frame.input.document) : std::string();
}

/// The reason why a row cannot be changed, shown while the pointer rests on it.
void hint_if_hovered(Frame& frame, const Rect& rect, const std::string& reason) {
  if (reason.empty() || !ImGui::IsWindowHovered()) return;
  if (ImGui::IsMouseHoveringRect(rect.min(), rect.max()))
    frame.ui.hint = Widget{reason, {rect.x, rect.y, rect.width, rect.height}};
}

void take_slider(Frame& frame, const Parameter& parameter, const SliderEvent& event) {
  if (parameter.in_history && event.taken) {
    frame.output.begin_gesture = true;
    frame.state.slider_held = true;
  }
  if (event.moved) set(frame, parameter, event.value);
  if (event.let_go && frame.state.slider_held) {
    frame.output.end_gesture = true;
    frame.state.slider_held = false;
  }
}

/// A slider ends at the soft maximum; a larger value, typed or loaded, gives it the whole range, and it keeps that for as
/// long as the thumb is held.
SliderScale scale_of(Frame& frame, const Parameter& parameter, double value) {
  const scene::Limits range = scene::range_of(frame.input.document, parameter);
  const double soft = parameter.soft_max > range.min ? std::min(parameter.soft_max, range.max) : range.max;
  const std::string key = std::string(parameter.id) + "#whole";
  bool& whole = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(key.c_str()), false);
  if (!frame.state.slider_held) whole = value > soft;
  SliderScale scale{range.min, whole ? range.max : soft, parameter.step, false};
  scale.logarithmic = scale.min > 0 && scale.max >= 16 * scale.min;
  return scale;
}

void number_row(Frame& frame, Column& column, const Parameter& parameter, std::string_view label) {
  const float height = slider_height(frame), labels = label_width(frame), values = frame.ui.touch ? 44.0F : 38.0F;
  const Rect row{column.x, column.y, column.width, height};
  const std::string reason = why_disabled(frame, parameter);
  const bool enabled = reason.empty();
  const double value = number(frame, parameter);
  const SliderEvent event = slider(frame.ui, parameter.id, {row.x + labels, row.y, row.width - labels - values, height},
                                   scale_of(frame, parameter, value), value, enabled);
  take_slider(frame, parameter, event);

  const float middle = row.y + height / 2, strength = enabled ? 1 : 0.5F;
  text(frame.ui, Face::regular, {row.x, middle}, colour(frame.input.theme.ink_soft, strength), label);
  text(frame.ui, Face::regular, {row.x + row.width, middle}, colour(frame.input.theme.ink, strength),
       value_text(parameter, event.value), Align::right);
  hint_if_hovered(frame, row, reason);
  column.y += height;
}

/// Rows that go on below the edge fade into it.
void fade_foot(Frame& frame, const Rect& card, float rounding) {
  if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1) return;
  const ImU32 clear = colour(frame.input.theme.panel, 0), full = colour(frame.input.theme.panel, 1);
  const float foot = card.y + card.height, solid = rounding > 0 ? rounding : 4;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilledMultiColor({card.x + 1, foot - solid - 24}, {card.x + card.width - 9, foot - solid}, clear, clear,
                               full, full);
  list.AddRectFilled({card.x + 1, foot - solid}, {card.x + card.width - 9, foot}, full, rounding,
                     ImDrawFlags_RoundCornersBottomLeft);
}

/// Scrolls the current window with a finger; ImGui itself knows only wheels and bars.
void scroll_by_finger(Frame& frame, std::string_view window) {
  PanelState::FingerScroll& finger = frame.state.finger;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
      ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem | ImGuiHoveredFlags_ChildWindows))
    finger = {std::string(window), pointer.y, ImGui::GetScrollY(), false};
  if (finger.window != window) return;
  constexpr float slop = 6;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && !frame.state.slider_held && ImGui::GetScrollMaxY() > 0) {
    if (std::abs(pointer.y - finger.start) > slop) finger.moving = true;
    if (finger.moving)
      ImGui::SetScrollY(std::clamp(finger.scroll_at_start - (pointer.y - finger.start), 0.0F, ImGui::GetScrollMaxY()));
  }
}

std::vector<float> thumbnail(std::string_view family) {
  std::vector<float> curve;
  const BlendingFamily* row = find_blending_family(family);
  if (!row) return curve;
  const Result<BlendingFunction> function = BlendingFunction::make(row->kind, row->parameter_default);
  if (!function) return curve;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i)
    curve.push_back(static_cast<float>(function.value()(static_cast<double>(i) / steps)[0]));
  return curve;
}

/// Presses in here are the interface's, not the stage's.
void claim(Frame& frame, const Rect& rect) {
  frame.output.regions.push_back({rect.x, rect.y, rect.width, rect.height});
}

void choice_list(Frame& frame, const Parameter& parameter, const Rect& button) {
  Interface& ui = frame.ui;
  const std::string popup = std::string(parameter.id) + " list";
  const bool curves = parameter.id == "blending.function";
  const float item = ui.touch ? 42.0F : 30.0F, edge = 6;
  float width = button.width;
  for (const scene::Choice& option : parameter.choices)
    width = std::max(width, text_width(ui, Face::bold, option.label) + (curves ? 76.0F : 40.0F));
  width = std::min(width, frame.stage.width - 16);
  const float wanted = item * static_cast<float>(parameter.choices.size()) + 2 * edge;
  Rect box{button.x + button.width - width, button.y + button.height + 4, width,
           std::min(wanted, frame.stage.height - 16)};
  box.y = std::clamp(box.y, 8.0F, std::max(8.0F, frame.stage.height - 8 - box.height));
  box.x = std::max(box.x, 8.0F);

  ImGui::SetNextWindowPos(box.min());
  ImGui::SetNextWindowSize({box.width, box.height});
  if (!ImGui::BeginPopup(popup.c_str(), ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                                            (wanted > box.height ? 0 : ImGuiWindowFlags_NoScrollbar)))
    return;
  frame.state.list_open = true;
  bool stays = !ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  sharpen(ui, list);
  list.PushClipRectFullScreen();
  soft_shadow(ui, list, box, 10);
  list.AddRectFilled(box.min(), box.max(), colour(ui.theme.panel), 10);
  list.AddRect({box.x + 0.5F, box.y + 0.5F}, {box.x + box.width - 0.5F, box.y + box.height - 0.5F},
               colour(ui.theme.rule), 9.5F);
  list.PopClipRect();
  if (ui.touch) scroll_by_finger(frame, popup);

  if (curves && frame.state.thumbnails.size() != parameter.choices.size()) {
    frame.state.thumbnails.clear();
    for (const scene::Choice& option : parameter.choices) frame.state.thumbnails.push_back(thumbnail(option.id));
  }
  const std::string present = choice(frame, parameter);
  const bool scrolls = wanted > box.height;
  frame.output.takes_wheel = frame.output.takes_wheel || scrolls;
  const float items = box.width - 2 * edge - (scrolls ? ImGui::GetStyle().ScrollbarSize - 2 : 0);
  float y = box.y + edge - ImGui::GetScrollY();
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    const scene::Choice& option = parameter.choices[i];
    const std::string id = std::string(parameter.id) + ": " + option.id;
    const std::span<const float> curve =
        curves ? std::span<const float>(frame.state.thumbnails[i]) : std::span<const float>();
    if (scrolls && option.id == present && ImGui::IsWindowAppearing())
      ImGui::SetScrollY(y - box.y - (box.height - item) / 2);
    if (menu_item(ui, id, {box.x + edge, y, items, item}, option.label, option.id == present,
                  scene::refused_choice(frame.input.document, parameter, option.id), curve)) {
      if (option.id != present) set(frame, parameter, option.id);
      stays = false;
    }
    y += item;
  }
  ImGui::SetCursorScreenPos({box.x, y});
  ImGui::Dummy({1, edge});
  fade_foot(frame, box, 10);
  if (stays)
    claim(frame, frame.stage);  // a press beside the list closes it and does nothing else
  else
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void choice_row(Frame& frame, Column& column, const Parameter& parameter, std::string_view label) {
  const std::string present = choice(frame, parameter);
  std::vector<Segment> segments;
  for (const scene::Choice& option : parameter.choices)
    segments.push_back(
        {option.label, std::string(parameter.id) + ": " + option.id, option.id == present,
         option.id == present ? std::string() : scene::refused_choice(frame.input.document, parameter, option.id)});

  const float height = row_height(frame), gap = frame.ui.touch ? 4 : 6;
  float needed = segmented_width(frame.ui, segments);
  const bool as_list = segments.size() > 4 || needed > column.width;
  if (as_list) {
    needed = 0;
    for (const Segment& segment : segments)
      needed = std::max(needed, text_width(frame.ui, Face::regular, segment.label) + combo_margin);
  }
  // Words too wide to stand beside their label take the whole row; the words of choices speak for themselves.
  const bool alone = label.empty() || needed > column.width - label_width(frame);
  const float labels = alone ? 0 : label_width(frame);
  if (!alone)
    text(frame.ui, Face::regular, {column.x, column.y + height / 2}, colour(frame.input.theme.ink_soft), label);

  Rect rect{column.x + labels, column.y, column.width - labels, height};
  if (frame.ui.touch) rect = {rect.x, rect.y + 2, rect.width, rect.height - 4};
  if (as_list) {
    const std::string popup = std::string(parameter.id) + " list";
    std::string name = present;
    for (const scene::Choice& option : parameter.choices)
      if (option.id == present) name = option.label;
    if (combo_button(frame.ui, parameter.id, rect, name, ImGui::IsPopupOpen(popup.c_str())))
      ImGui::OpenPopup(popup.c_str());
    choice_list(frame, parameter, rect);
  } else if (const auto clicked = segmented(frame.ui, parameter.id, rect, segments)) {
    if (!segments[*clicked].chosen) set(frame, parameter, parameter.choices[*clicked].id);
  }
  column.y += height + gap;
}

void chip_rows(Frame& frame, Column& column, std::span<const Parameter* const> toggles) {
  const float height = frame.ui.touch ? 44.0F : 26.0F, gap = 6, line = frame.ui.touch ? 0 : gap;
  float x = column.x;
  for (const Parameter* toggle : toggles) {
    const float width = std::ceil(text_width(frame.ui, Face::small, toggle->label)) + (frame.ui.touch ? 28.0F : 20.0F);
    if (x > column.x && x + width > column.x + column.width) {
      x = column.x;
      column.y += height + line;
    }
    const Rect rect{x, column.y, width, height};
    const std::string reason = why_disabled(frame, *toggle);
    const bool on = switched_on(frame, *toggle);
    if (chip(frame.ui, toggle->id, rect, toggle->label, on, reason.empty())) set(frame, *toggle, !on);
    hint_if_hovered(frame, rect, reason);
    x += width + gap;
  }
  column.y += height + line;
}

void parameter_row(Frame& frame, Column& column, const Parameter& parameter, std::string_view label) {
  if (parameter.kind == ParameterKind::choice)
    choice_row(frame, column, parameter, label);
  else if (parameter.kind == ParameterKind::toggle) {
    const Parameter* one = &parameter;
    chip_rows(frame, column, {&one, 1});
  } else
    number_row(frame, column, parameter, label);
}

void rule(Frame& frame, Column& column, float space) {
  column.y += space;
  const float y = std::round(column.y) + 0.5F;
  ImGui::GetWindowDrawList()->AddLine({column.x, y}, {column.x + column.width, y}, colour(frame.input.theme.rule));
  column.y += space + 1;
}

void heading(Frame& frame, Column& column, std::string_view words) {
  text(frame.ui, Face::bold, {column.x, column.y + 12}, colour(frame.input.theme.ink), words);
  column.y += 27;
}

/// The legend names the two weights in their hues; under the pointer it gives their values.
void plot_row(Frame& frame, Column& column) {
  const Theme& theme = frame.input.theme;
  const std::optional<double> w = frame.input.probe ? std::optional(frame.input.probe->blend_w_u) : std::nullopt;
  const float middle = column.y + 9, centre = column.x + column.width / 2;
  const ImU32 first = colour(as_text(theme, theme.local[0])), second = colour(as_text(theme, theme.local[1]));
  std::string left = "1 − B", right = "B";
  if (w) {
    const double b = frame.input.surface->blending()(*w)[0];
    left += "  " + text_of("%.2f", 1 - b);
    right = text_of("%.2f", b) + "  " + right;
    text(frame.ui, Face::small, {centre, middle}, colour(theme.ink_soft), "w " + text_of("%.2f", *w), Align::centre);
  } else {
    ImGui::GetWindowDrawList()->AddRectFilled({centre - 14, middle - 4}, {centre - 4, middle + 4},
                                              colour(theme.ink, 0.12F), 2);
    text(frame.ui, Face::small, {centre + 1, middle}, colour(theme.ink_soft), "B′");
  }
  text(frame.ui, Face::small, {column.x, middle}, first, left);
  text(frame.ui, Face::small, {column.x + column.width, middle}, second, right, Align::right);
  column.y += 18;
  blending_plot(frame.ui, {column.x, column.y, column.width, 64}, frame.input.surface->blending(), w);
  column.y += 68;
}

/// The report's table. From the document, not from the surface: while a sheet rolls, the surface is a mixture of the two.
void table(Frame& frame, Column& column) {
  const Theme& theme = frame.input.theme;
  const float line = 20, width = column.width;
  const std::array<float, 4> ends{0.43F, 0.61F, 0.83F, 1};
  const std::array<std::string_view, 4> heads{words::domain, words::knots, words::patches, words::locals};
  const float first = column.x + 20;
  for (std::size_t k = 0; k < heads.size(); ++k)
    text(frame.ui, Face::small, {k == 0 ? first : column.x + ends[k] * width, column.y + 8}, colour(theme.ink_soft),
         heads[k], k == 0 ? Align::left : Align::right);
  column.y += line;

  const auto row = [&](std::string_view letter, int locals, Topology topology) {
    const Result<KnotVector> made = KnotVector::uniform(1, locals, topology, 0, 1);
    if (!made) return;
    const KnotVector& knots = made.value();
    const auto subscript = [](int value) {
      std::string out;
      for (const char figure : std::to_string(value))
        out += std::string("\xE2\x82") + static_cast<char>(0x80 + (figure - '0'));
      return out;
    };
    const std::string domain = "[" + std::string(letter) + subscript(knots.degree()) + ", " + std::string(letter) +
                               subscript(knots.last_span() + 1) + (knots.closed() ? ")" : "]");
    const std::array<std::string, 3> counts{std::to_string(knots.knots().size()),
                                            std::to_string(knots.interval_count()), std::to_string(knots.count())};
    ImGui::GetWindowDrawList()->AddLine({column.x, column.y - 1.5F}, {column.x + width, column.y - 1.5F},
                                        colour(theme.rule, 0.8F));
    text(frame.ui, Face::bold, {column.x, column.y + 8}, colour(theme.ink), letter);
    text(frame.ui, Face::regular, {first, column.y + 8}, colour(theme.ink), domain);
    for (std::size_t k = 0; k < counts.size(); ++k)
      text(frame.ui, Face::regular, {column.x + ends[k + 1] * width, column.y + 8}, colour(theme.ink), counts[k],
           Align::right);
    column.y += line;
  };
  row("u", frame.object->locals_u, frame.object->topology_u);
  row("v", frame.object->locals_v, frame.object->topology_v);
}

void title_row(Frame& frame, Column& column, float right) {
  const float middle = column.y + 10;
  const scene::Shape& shape = scene::stage_shape(frame.input.document);
  text(frame.ui, Face::bold, {column.x, middle}, colour(frame.input.theme.ink),
       scene::shape_kinds()[shape.index()].label);
  const std::string size = frame.object
                               ? std::to_string(frame.object->locals_u) + " × " + std::to_string(frame.object->locals_v)
                               : std::to_string(frame.input.curve->curve.points().size()) + " points";
  text(frame.ui, Face::regular, {column.x + column.width - right, middle}, colour(frame.input.theme.ink_soft), size,
       Align::right);
  column.y += 30;
}

void first_part(Frame& frame, Column& column) {
  for (const std::string_view id : first_rows) {
    const Parameter* parameter = scene::find_parameter(id);
    if (!parameter || !scene::applies(frame.input.document, *parameter)) continue;
    // A row that most blending functions have no use for takes up no room.
    if (id == "blending.parameter" && !why_disabled(frame, *parameter).empty()) continue;
    if (id == "blending.function") column.y += 4;
    parameter_row(frame, column, *parameter, parameter->label);
  }
  column.y += 2;
  if (frame.object) plot_row(frame, column);
}

/// All rows of the table that have no place of their own, group by group; groups of switches first, as they are used most.
void other_parts(Frame& frame, Column& column) {
  const std::span<const std::string_view> beside_clock =
      std::span(clock_rows).first(frame.ui.touch ? phone_clock_rows : clock_rows.size());
  const auto other = [&](const Parameter& parameter) {
    return scene::applies(frame.input.document, parameter) && !listed(first_rows, parameter.id) &&
           !listed(beside_clock, parameter.id);
  };
  std::vector<std::string_view> groups;
  for (const bool switches : {true, false})
    for (const Parameter& parameter : scene::parameters())
      if (other(parameter) && (parameter.kind == ParameterKind::toggle) == switches &&
          std::find(groups.begin(), groups.end(), parameter.group) == groups.end())
        groups.push_back(parameter.group);

  for (const std::string_view group : groups) {
    std::vector<const Parameter*> toggles, rows;
    for (const Parameter& parameter : scene::parameters())
      if (parameter.group == group && other(parameter))
        (parameter.kind == ParameterKind::toggle ? toggles : rows).push_back(&parameter);
    // Numbers, and a row by itself, say enough with their own labels.
    const bool headed =
        toggles.size() + rows.size() > 1 && (!toggles.empty() || rows.front()->kind == ParameterKind::choice);
    column.y += group == groups.front() ? 0 : 8;
    if (headed) heading(frame, column, group);
    if (!toggles.empty()) chip_rows(frame, column, toggles);
    for (const Parameter* row : rows) parameter_row(frame, column, *row, row->label);
  }
}

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav;

void begin(Frame& frame, const char* name, const Rect& rect, ImGuiWindowFlags flags) {
  if (!(flags & ImGuiWindowFlags_NoInputs)) claim(frame, rect);
  ImGui::SetNextWindowPos(rect.min());
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::Begin(name, nullptr, plain | flags);
  sharpen(frame.ui, *ImGui::GetWindowDrawList());
}

void card_background(Frame& frame, const Rect& card, float opacity) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  soft_shadow(frame.ui, list, card, 12);
  list.AddRectFilled(card.min(), card.max(), colour(frame.input.theme.panel, opacity), 12);
  // On a dark stage a shadow alone does not part the card from it.
  if (frame.input.theme.dark)
    list.AddRect({card.x + 0.5F, card.y + 0.5F}, {card.x + card.width - 0.5F, card.y + card.height - 0.5F},
                 colour(frame.input.theme.rule), 11.5F);
  list.PopClipRect();
}

void card(Frame& frame) {
  const Rect place = card_frame(frame);
  const float wanted = frame.state.card_height > 0 ? frame.state.card_height : 330.0F;
  const Rect rect{place.x, place.y, place.width, std::min(wanted, place.height)};
  const bool scrolls = wanted > place.height + 0.5F && frame.state.show_more;
  frame.output.takes_wheel = frame.output.takes_wheel || scrolls;
  begin(frame, "panel", rect, scrolls ? 0 : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!frame.state.show_more && ImGui::GetScrollY() > 0) ImGui::SetScrollY(0);
  // Unfolded it lies over the picture, which must not shine through the small rows.
  const float opacity = frame.input.theme.panel_opacity;
  card_background(frame, rect, opacity + (0.97F - opacity) * smooth(frame.state.more_share));
  // Where the pixel ratio is not whole, ImGui's clipping is a pixel off: rows end a little before the card does.
  ImGui::PushClipRect(rect.min(), {rect.x + rect.width, rect.y + rect.height - foot_clip}, true);
  const float top = rect.y - ImGui::GetScrollY();
  Column column{rect.x + padding, rect.width - 2 * padding, top + 12};
  title_row(frame, column, 0);
  first_part(frame, column);
  if (frame.object && frame.tall()) {
    rule(frame, column, 6);
    table(frame, column);
  }
  rule(frame, column, 4);
  const float share = smooth(eased(frame.ui, frame.state.more_share, frame.state.show_more ? 1.0F : 0.0F, 0.15F));
  if (fold_button(frame.ui, "more", {column.x, column.y, column.width, 28}, frame.object ? words::more : words::display,
                  frame.state.show_more)) {
    frame.state.show_more = !frame.state.show_more;
    frame.ui.wants_frame = true;
  }
  column.y += 28 + 6;
  const float folded = column.y - top;
  float unfolded = folded;
  if (share > 0) {
    other_parts(frame, column);
    if (frame.object && !frame.tall()) {
      heading(frame, column, words::domain);
      table(frame, column);
    }
    column.y += 10;
    unfolded = column.y - top;
  }
  ImGui::SetCursorScreenPos({rect.x, top + unfolded});
  ImGui::Dummy({1, 0});
  const float height = std::round(folded + (unfolded - folded) * share);
  if (height != frame.state.card_height) frame.ui.wants_frame = true;
  frame.state.card_height = height;
  ImGui::PopClipRect();
  if (scrolls) fade_foot(frame, rect, 12);
  ImGui::End();
}

/// The phone's form of the panel: a sheet over the stage's lower part.
void drawer(Frame& frame) {
  PanelState& state = frame.state;
  const Rect& stage = frame.stage;
  const bool appears = state.drawer_open && state.drawer_share == 0;
  const float share = smooth(eased(frame.ui, state.drawer_share, state.drawer_open ? 1.0F : 0.0F, 0.16F));
  if (share < 1) {
    const float width = text_width(frame.ui, Face::bold, words::controls) + 50;
    const Rect pill{stage.width - width - 12, 8, width, 44};
    begin(frame, "controls", {pill.x - 4, pill.y, pill.width + 8, pill.height + 4}, ImGuiWindowFlags_NoScrollbar);
    if (pill_button(frame.ui, "controls", pill, Icon::sliders, words::controls)) state.drawer_open = true;
    ImGui::End();
  }
  if (state.drawer_open && state.drawer_share == 0) frame.ui.wants_frame = true;
  if (share <= 0) return;

  const float height = std::round(stage.height * 0.6F);
  const Rect rect{0, std::round(stage.height - height * share), stage.width, height};
  // Above the clock, which is the window last touched when someone has just played.
  // Only once: taking the focus again would close a list that opens over the drawer.
  if (appears) ImGui::SetNextWindowFocus();
  begin(frame, "drawer", rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  card_background(frame, {rect.x - 1, rect.y, rect.width + 2, rect.height + 20}, 0.98F);
  Column head{rect.x + padding, rect.width - 2 * padding, rect.y + 14};
  title_row(frame, head, 44);
  if (icon_button(frame.ui, "controls", {rect.x + rect.width - 52, rect.y + 2, 44, 44}, Icon::close, true,
                  words::controls))
    state.drawer_open = false;

  const Rect body{rect.x, rect.y + 48, rect.width, stage.height - rect.y - 48};
  ImGui::SetCursorScreenPos(body.min());
  ImGui::BeginChild("drawer rows", {body.width, std::max(body.height, 1.0F)}, ImGuiChildFlags_None,
                    ImGuiWindowFlags_NoBackground);
  sharpen(frame.ui, *ImGui::GetWindowDrawList());
  scroll_by_finger(frame, "drawer");
  ImGui::PushClipRect(body.min(), {body.x + body.width, body.y + body.height - foot_clip}, true);
  Column column{body.x + padding, body.width - 2 * padding, body.y - ImGui::GetScrollY() + 2};
  first_part(frame, column);
  other_parts(frame, column);
  if (frame.object) {
    rule(frame, column, 8);
    table(frame, column);
  }
  column.y += 12;
  ImGui::SetCursorScreenPos({body.x, column.y});
  ImGui::Dummy({1, 0});
  ImGui::PopClipRect();
  fade_foot(frame, body, 0);
  ImGui::EndChild();
  ImGui::End();
}

/// The curve's point that is selected.
std::optional<int> selected_point(const Frame& frame) {
  const std::optional<HandleIndex>& selected = frame.input.selected;
  const bool point = selected && *selected != parameter_handle && frame.input.curve &&
                     selected->first < frame.input.curve->curve.knots().count();
  return point ? std::optional(selected->first) : std::nullopt;
}

void tools(Frame& frame, float x, float middle) {
  PanelOutput& output = frame.output;
  const float size = frame.ui.touch ? 40.0F : 32.0F;
  const auto place = [&](int k) { return Rect{x + size * static_cast<float>(k), middle - size / 2, size, size}; };
  const PanelInput& input = frame.input;
  output.undo = icon_button(frame.ui, "undo", place(0), Icon::undo, input.can_undo, words::undo);
  output.redo = icon_button(frame.ui, "redo", place(1), Icon::redo, input.can_redo, words::redo);
  int next = 2;
  if (frame.object) {
    output.reset_patches =
        icon_button(frame.ui, "reset", place(next++), Icon::reset, !frame.object->edits.empty(), words::reset);
  } else {
    const bool point = selected_point(frame).has_value();
    output.add_point = icon_button(frame.ui, "add", place(next++), Icon::add, point, words::add);
    output.remove_point = icon_button(frame.ui, "remove", place(next++), Icon::remove, point, words::remove);
  }
  output.frame_all = icon_button(frame.ui, "frame", place(next), Icon::frame, true, words::frame);
}

/// The foot of a curve's stage: its basis functions and knots, and below them the buttons.
void strip(Frame& frame) {
  const bool phone = frame.ui.touch;
  const float margin = phone ? 30 : frame.stage.width >= wide_stage ? 62.0F : 46.0F;
  const float top = frame.stage.height - frame.foot();
  begin(frame, "strip", {0, top, frame.stage.width, frame.foot()},
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const bool movable = std::holds_alternative<scene::BSplineCurveObject>(scene::stage_shape(frame.input.document));
  const Rect place{margin, top, frame.stage.width - 2 * margin, strip_height(frame.stage) - 6};
  const StripEvent event =
      knot_strip(frame.ui, place, *frame.input.curve, movable, selected_point(frame), frame.state.knot);
  if (event.taken) {
    frame.output.begin_gesture = true;
    frame.state.slider_held = true;
  }
  if (event.t) frame.output.commands.emplace_back(scene::SetParameter{"curve.parameter", *event.t});
  if (event.knot) frame.output.commands.emplace_back(scene::SetKnot{event.knot->first, event.knot->second});
  if (event.let_go && frame.state.slider_held) {
    frame.output.end_gesture = true;
    frame.state.slider_held = false;
  }
  if (!phone) tools(frame, frame.stage.width - 5 * 32.0F - 18, frame.stage.height - 26);
  ImGui::End();
}

void clock(Frame& frame) {
  const Parameter* playing = scene::find_parameter(clock_rows[0]);
  const Parameter* time = scene::find_parameter(clock_rows[1]);
  const Parameter* speed = scene::find_parameter(clock_rows[2]);
  if (!playing || !time || !speed) return;
  const bool phone = frame.ui.touch;
  const Theme& theme = frame.input.theme;
  const float margin = phone ? 10 : 18;
  const Rect rect{margin, frame.stage.height - clock_height, frame.stage.width - 2 * margin, 52};
  begin(frame, "clock", rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const float middle = rect.y + rect.height / 2 - 2;

  const bool runs = switched_on(frame, *playing);
  if (play_button(frame.ui, "play", {rect.x, middle - 22, 44, 44}, runs)) set(frame, *playing, !runs);

  float right = rect.x + rect.width;
  if (!phone) {
    right -= 4 * 32.0F;
    tools(frame, right + 4, middle);
    right -= 10;
    const double pace = number(frame, *speed);
    right -= 34;
    text(frame.ui, Face::small, {right + 8, middle}, colour(theme.ink_soft), value_text(*speed, pace));
    const float width = frame.stage.width >= wide_stage ? 72.0F : 52.0F;
    const SliderEvent event =
        slider(frame.ui, speed->id, {right - width, middle - 16, width, 32}, scale_of(frame, *speed, pace), pace);
    take_slider(frame, *speed, event);
    right -= width + 14;
  } else {
    right -= 4;
  }
  const double now = number(frame, *time);
  text(frame.ui, Face::regular, {right, middle}, colour(theme.ink_soft), text_of("%.1f s", now), Align::right);
  right -= 50;
  const float left = rect.x + 52;
  SliderScale scale = scale_of(frame, *time, now);
  scale.step = 0;  // the clock has no steps
  const SliderEvent event = slider(frame.ui, time->id, {left, middle - 22, right - left, 44}, scale, now);
  take_slider(frame, *time, event);
  ImGui::End();
}

/// Names of control points, under the panels.
void labels(Frame& frame) {
  begin(frame, "labels", frame.stage, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
  for (const StageLabel& label : frame.input.labels)
    text(frame.ui, Face::regular, {static_cast<float>(label.place.x), static_cast<float>(label.place.y)},
         colour(as_text(frame.input.theme, label.colour)), label.words, Align::centre);
  ImGui::End();
}

/// Of a curve: the parameter under the pointer, or else that of the construction; its interval, and how smooth the
/// curve is where knots coincide.
void curve_probe(Frame& frame, float left, float y) {
  const Theme& theme = frame.input.theme;
  const scene::CurveFigure& figure = *frame.input.curve;
  const KnotVector& knots = figure.curve.knots();
  const double t = frame.input.curve_t.value_or(figure.t);
  text(frame.ui, Face::bold, {left, y}, colour(theme.ink), "t " + text_of("%.2f", t));
  text(frame.ui, Face::regular, {left + 74, y}, colour(theme.ink_soft),
       "span " + std::to_string(knots.span(knots.reduced(t))));
  for (const scene::CurveFigure::Mark& mark : figure.marks) {
    const int multiplicity = mark.last - mark.first + 1;
    if (!mark.inner || multiplicity < 2) continue;
    y += 20;
    text(frame.ui, Face::regular, {left, y}, colour(theme.accent),
         "C" + superscript(knots.degree() - multiplicity) + " at t = " + text_of("%.2f", mark.t));
  }
}

/// What is under the pointer: the point, its curvatures, and the weights of the locals at work, in their hues.
void probe(Frame& frame) {
  PanelState& state = frame.state;
  const Theme& theme = frame.input.theme;
  const float left = frame.ui.touch ? 16 : 22, top = frame.ui.touch && !state.drawer_open ? 56 : 22;
  if (frame.input.probe) state.last_probe = frame.input.probe;
  const float share = smooth(eased(frame.ui, state.probe_share, frame.input.probe ? 1.0F : 0.0F));
  begin(frame, "probe", {left - 4, top - 4, std::min(300.0F, frame.stage.width - left), 140},
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float y = top + 8;
  if (!frame.object) {
    frame.output.readouts.push_back({0, 0, left + 132.0, top + 20.0});
    curve_probe(frame, left, y);
    ImGui::End();
    return;
  }
  if (frame.input.selected) {
    const scene::PatchIndex patch = *frame.input.selected;
    const Colour hue = scene::patch_hue(scene::patch_hue_index(*frame.object, patch), theme.dark);
    list.AddCircleFilled({left + 5, y}, 5, colour(hue));
    text(frame.ui, Face::bold, {left + 16, y}, colour(theme.ink),
         std::string(words::selected) + " " + std::to_string(patch.first) + ", " + std::to_string(patch.second));
    y += 26;
  }
  if (share > 0 && state.last_probe) {
    const Probe& point = *state.last_probe;
    // What is selected and what is pointed at are two things.
    if (frame.input.selected) {
      text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft, share),
           frame.ui.touch ? words::tapped : words::pointed);
      y += 18;
    }
    const auto pair = [&](Face face, const Colour& ink, const std::string& first, const std::string& second) {
      text(frame.ui, face, {left, y}, colour(ink, share), first);
      text(frame.ui, face, {left + 74, y}, colour(ink, share), second);
      y += 20;
    };
    pair(Face::bold, theme.ink, "u " + text_of("%.3f", point.u), "v " + text_of("%.3f", point.v));
    pair(Face::regular, theme.ink_soft, "K " + text_of("%.3f", point.gaussian), "H " + text_of("%.3f", point.mean));
    y += 2;

    // The bar is the partition of unity: its parts are the weights.
    const float width = 148, height = 6;
    float x = left, word = left;
    for (const BlendingSurface::Weight& weight : point.weights) {
      const Colour hue = scene::patch_hue(scene::patch_hue_index(*frame.object, {weight.i, weight.j}), theme.dark);
      const float part = width * static_cast<float>(std::clamp(weight.value, 0.0, 1.0));
      if (part > 0.25F) list.AddRectFilled({x, y - height / 2}, {x + part, y + height / 2}, colour(hue, share));
      x += part;
      text(frame.ui, Face::small, {word, y + 15}, colour(as_text(theme, hue), share), text_of("%.2f", weight.value));
      word += 38;
    }
  }
  ImGui::End();
}

void notice(Frame& frame) {
  PanelState& state = frame.state;
  if (!frame.input.notice.empty()) state.last_notice = frame.input.notice;
  const float share = smooth(eased(frame.ui, state.notice_share, frame.input.notice.empty() ? 0.0F : 1.0F, 0.15F));
  if (share <= 0 || state.last_notice.empty()) return;
  const Theme& theme = frame.input.theme;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  sharpen(frame.ui, list);
  const std::string& words = state.last_notice;
  // Beside the card where there is room: it is the card that a refusal is mostly about.
  const float free = frame.ui.touch ? frame.stage.width : card_frame(frame).x;
  const auto [wrap, extent] = balanced(frame.ui, Face::regular, words, std::min(360.0F, free - 72));
  Rect box{0, 0, std::ceil(extent.x) + 40, std::ceil(extent.y) + 20};
  box.x = std::round((free - box.width) / 2);
  box.y = std::round(frame.stage.height - frame.foot() - 12 - box.height + 8 * (1 - share));
  soft_shadow(frame.ui, list, box, 10, share);
  list.AddRectFilled(box.min(), box.max(), colour(theme.ink, share), 10);
  list.AddCircleFilled({box.x + 15, box.y + 10 + text_height / 2}, 3.5F,
                       colour(theme.dark ? Colour{0.70F, 0.26F, 0.12F} : Colour{0.94F, 0.53F, 0.37F}, share));
  paragraph(frame.ui, list, Face::regular, {box.x + 27, box.y + 10}, colour(theme.paper, share), words, wrap);
}

}  // namespace

PanelOutput draw_panels(PanelState& state, const PanelInput& input) {
  PanelOutput output;
  Interface ui{.theme = input.theme, .fonts = interface_fonts()};
  if (!ui.fonts.regular) ui.fonts = {ImGui::GetFont(), ImGui::GetFont(), ImGui::GetFont()};
  ui.pixel_ratio = static_cast<float>(std::max(input.viewport.pixel_ratio, 0.5));
  ui.touch = input.phone;
  ui.reduced_motion = input.reduced_motion;
  // After an idle time the first frame's delta is that of the idleness: a transition would be over before it began.
  const float delta = ImGui::GetIO().DeltaTime;
  ui.step = state.moving ? delta : std::min(delta, 1.0F / 60);
  ui.listening = !state.finger.moving;
  // Whole pixels: a card at a fraction of one would blur all its text.
  const Rect stage{0, 0, static_cast<float>(std::floor(input.viewport.width)),
                   static_cast<float>(std::floor(input.viewport.height))};
  Frame frame{state, input, output, ui, std::get_if<scene::BlendingSurfaceObject>(&scene::stage_shape(input.document)),
              stage};

  state.list_open = false;
  labels(frame);
  probe(frame);
  if (!input.phone || state.drawer_share < 1) frame.object ? clock(frame) : strip(frame);
  if (input.phone) {
    // Over an open drawer the little room there is belongs to the figure.
    if (!state.drawer_open) {
      begin(frame, "tools", {8, 8, frame.object ? 168.0F : 208.0F, 44}, ImGuiWindowFlags_NoScrollbar);
      tools(frame, 8, 30);
      ImGui::End();
    }
    drawer(frame);
  } else {
    card(frame);
  }
  notice(frame);
  draw_hint(ui, stage);

  // A slider that vanished while it was held (the drawer closed under it) has been let go.
  if (state.slider_held && !ImGui::IsAnyItemActive()) {
    output.end_gesture = true;
    state.slider_held = false;
  }
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) state.finger = {};

  output.wants_frame = state.moving = ui.wants_frame;
  output.widgets = std::move(ui.widgets);
  return output;
}

}  // namespace knotwork::web
