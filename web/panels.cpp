#include "web/panels.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <utility>

#include "knotwork/later.h"
#include "web/curvature_colours.h"
#include "web/few.h"
#include "web/figure_panel.h"

namespace knotwork::web {
namespace {

using scene::Parameter;
using scene::ParameterKind;

// Every word of the interface that is neither in the parameter table nor a figure's own.
namespace words {
constexpr std::string_view controls = "Controls", more = "Display, sampling, motion", display = "Display",
                           undo = "Undo", redo = "Redo", frame = "Show the whole figure", domain = "domain",
                           slopes = "angle to the vertical, every 10°", gaussian = "Gaussian curvature K",
                           mean = "mean curvature H";
}  // namespace words

// The panel's only list of parameters: which rows are worth their place while the rest is folded away, and which live
// beside the clock. All others follow by themselves in the table's groups.
constexpr std::array<std::string_view, 23> first_rows{"topology.u",
                                                      "topology.v",
                                                      "locals.u",
                                                      "locals.v",
                                                      "curve.model",
                                                      "curve.topology",
                                                      "locals.count",
                                                      "locals.kind",
                                                      "locals.degree",
                                                      "blending.function",
                                                      "blending.parameter",
                                                      "curve.degree",
                                                      "curve.parameter",
                                                      "fitted.count",
                                                      "fitted.parameters",
                                                      "fitted.knots",
                                                      "fitted.ends",
                                                      "subdivision.levels",
                                                      "subdivision.step",
                                                      "surface.degree.u",
                                                      "surface.degree.v",
                                                      "net.u",
                                                      "net.v"};
constexpr std::array<std::string_view, 3> clock_rows{"animation.playing", "animation.time", "animation.speed"};
constexpr std::size_t phone_clock_rows = 2;  ///< the speed has no room there

constexpr float padding = 16;           ///< inside the card
constexpr float foot_clip = 3;          ///< rows end this much before the foot of what they scroll in
constexpr float combo_margin = 40;      ///< beside the words of a closed list
constexpr float label_line = 20;        ///< of a label above its choices
constexpr float label_gap = 10;         ///< between a label and its slider
constexpr float longest_label = 0.52F;  ///< of a row: the slider needs the rest

// Measures that a finger needs larger.
float row_height(const Frame& frame) { return frame.ui.touch ? 44.0F : 30.0F; }
float slider_height(const Frame& frame) { return frame.ui.touch ? 44.0F : 26.0F; }
float label_width(const Frame& frame) { return frame.stage.width < wide_stage && !frame.ui.touch ? 82.0F : 84.0F; }

Rect card_frame(const Frame& frame) {
  const Rect& stage = frame.stage;
  const bool wide = stage.width >= wide_stage;
  const float width = wide ? 276.0F : 252.0F, margin = wide ? 20.0F : 12.0F;
  return {stage.width - width - margin, margin, width, stage.height - frame.foot() - margin - 8};
}

/// Of the table; more than have a place in any group.
using Rows = Few<const Parameter*, 40>;

bool listed(std::span<const std::string_view> ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
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

/// The index of the present choice.
std::size_t chosen(const Frame& frame, const Parameter& parameter) {
  if (parameter.chosen) return static_cast<std::size_t>(parameter.chosen(frame.input.document));
  const scene::ParameterValue value = parameter.get(frame.input.document);
  const std::string* id = std::get_if<std::string>(&value);
  const auto found = std::find_if(parameter.choices.begin(), parameter.choices.end(),
                                  [&](const scene::Choice& option) { return id && option.id == *id; });
  return static_cast<std::size_t>(found - parameter.choices.begin());
}

bool switched_on(const Frame& frame, const Parameter& parameter) {
  const scene::ParameterValue value = parameter.get(frame.input.document);
  const bool* found = std::get_if<bool>(&value);
  return found && *found;
}

std::string_view why_disabled(const Frame& frame, const Parameter& parameter) {
  return parameter.disabled ? parameter.disabled(frame.input.document) : std::string_view();
}

/// The reason why a row cannot be changed, shown while the pointer rests on it.
void hint_if_hovered(Frame& frame, const Rect& rect, std::string_view reason) {
  if (reason.empty() || !ImGui::IsWindowHovered()) return;
  if (ImGui::IsMouseHoveringRect(rect.min(), rect.max())) set_hint(frame.ui, say(reason), rect);
}

void take_slider(Frame& frame, const Parameter& parameter, const SliderEvent& event) {
  if (parameter.in_history && event.taken) take_gesture(frame);
  if (event.moved) set(frame, parameter, event.value);
  if (event.let_go) end_gesture(frame);
}

/// A slider goes over the soft range; a value beyond it, typed or loaded, gives it the whole range, and it keeps that for
/// as long as the thumb is held.
SliderScale scale_of(Frame& frame, const Parameter& parameter, double value) {
  const scene::Limits range = scene::range_of(frame.input.document, parameter);
  const scene::Limits soft = scene::soft_range_of(frame.input.document, parameter);
  // The plain id is the widget's own.
  const ImGuiID key = ImGui::GetID(parameter.id.data(), parameter.id.data() + parameter.id.size()) + 1;
  bool& whole = *ImGui::GetStateStorage()->GetBoolRef(key, false);
  if (!frame.state.slider_held) whole = !soft.contains(value);
  SliderScale scale{whole ? range.min : soft.min, whole ? range.max : soft.max, parameter.step, false};
  scale.logarithmic = scale.min > 0 && scale.max >= 16 * scale.min;
  return scale;
}

void number_row(Frame& frame, Column& column, const Parameter& parameter, Said label) {
  const float height = slider_height(frame), values = frame.ui.touch ? 44.0F : 38.0F;
  const float labels = column.labels;
  const Rect row{column.x, column.y, column.width, height};
  const std::string_view reason = why_disabled(frame, parameter);
  const bool enabled = reason.empty();
  const double value = number(frame, parameter);
  const SliderEvent event = slider(frame.ui, parameter.id, {row.x + labels, row.y, row.width - labels - values, height},
                                   scale_of(frame, parameter, value), value, enabled);
  take_slider(frame, parameter, event);

  const float middle = row.y + height / 2, strength = enabled ? 1 : 0.5F;
  fitted_text(frame.ui, Face::regular, {row.x, middle}, colour(frame.input.theme.ink_soft, strength), label,
              labels - label_gap);
  text(frame.ui, Face::regular, {row.x + row.width, middle}, colour(frame.input.theme.ink, strength),
       as_is(value_text(parameter, event.value)), Align::right);
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

KNOTWORK_LATER void choice_list(Frame& frame, const Parameter& parameter, const Rect& button, const Words& popup) {
  Interface& ui = frame.ui;
  const bool curves = parameter.id == "blending.function";
  const float item = ui.touch ? 42.0F : 30.0F, edge = 6;
  float width = button.width;
  for (const scene::Choice& option : parameter.choices)
    width = std::max(width, text_width(ui, Face::bold, say(option.label)) + (curves ? 76.0F : 40.0F));
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
  const std::size_t present = chosen(frame, parameter);
  const bool scrolls = wanted > box.height;
  frame.output.takes_wheel = frame.output.takes_wheel || scrolls;
  const float items = box.width - 2 * edge - (scrolls ? ImGui::GetStyle().ScrollbarSize - 2 : 0);
  float y = box.y + edge - ImGui::GetScrollY();
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    const scene::Choice& option = parameter.choices[i];
    const WidgetName id(parameter.id, option.id);
    const std::span<const float> curve =
        curves ? std::span<const float>(frame.state.thumbnails[i]) : std::span<const float>();
    if (scrolls && i == present && ImGui::IsWindowAppearing()) ImGui::SetScrollY(y - box.y - (box.height - item) / 2);
    if (menu_item(ui, id, {box.x + edge, y, items, item}, say(option.label), i == present,
                  say(scene::refused_choice(frame.input.document, parameter, option.id)), curve)) {
      if (i != present) set(frame, parameter, option.id);
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

/// English has few rows that stand without their labels, and none that would be taken for another; where words are
/// longer there may be many.
KNOTWORK_LATER void label_above(Frame& frame, Column& column, Said label) {
  fitted_text(frame.ui, Face::small, {column.x, column.y + label_line / 2}, colour(frame.input.theme.ink_soft), label,
              column.width);
  column.y += label_line;
}

void choice_row(Frame& frame, Column& column, const Parameter& parameter, Said label) {
  const std::size_t present = chosen(frame, parameter);
  std::array<Segment, most_segments> places;
  std::span<Segment> segments;
  if (parameter.choices.size() <= most_segments) {
    segments = std::span(places).first(parameter.choices.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const scene::Choice& option = parameter.choices[i];
      segments[i] = {say(option.label), {parameter.id, option.id}, i == present};
      if (!segments[i].chosen) segments[i].refusal = scene::refused_choice(frame.input.document, parameter, option.id);
    }
  }

  const float height = row_height(frame), gap = frame.ui.touch ? 4 : 6;
  float needed = segmented_width(frame.ui, segments);
  const bool as_list = segments.empty() || needed > column.width;
  if (as_list) {
    needed = 0;
    for (const scene::Choice& option : parameter.choices)
      needed = std::max(needed, text_width(frame.ui, Face::regular, say(option.label)) + combo_margin);
  }
  // Words too wide to stand beside their label take the whole row; the words of choices speak for themselves.
  const bool alone = label.empty() || needed > column.width - column.labels;
  const float labels = alone ? 0 : column.labels;
  if (!alone) {
    fitted_text(frame.ui, Face::regular, {column.x, column.y + height / 2}, colour(frame.input.theme.ink_soft), label,
                labels - label_gap / 2);
  } else if (translates() && !label.empty()) {
    label_above(frame, column, label);
  }

  Rect rect{column.x + labels, column.y, column.width - labels, height};
  if (frame.ui.touch) rect = {rect.x, rect.y + 2, rect.width, rect.height - 4};
  if (as_list) {
    const Words popup = Words().add(parameter.id).add(" list");
    const Said name = present < parameter.choices.size() ? say(parameter.choices[present].label) : as_is("");
    if (combo_button(frame.ui, parameter.id, rect, name, ImGui::IsPopupOpen(popup.c_str())))
      ImGui::OpenPopup(popup.c_str());
    if (ImGui::IsPopupOpen(popup.c_str())) choice_list(frame, parameter, rect, popup);
  } else if (const auto clicked = segmented(frame.ui, parameter.id, rect, segments)) {
    if (!segments[*clicked].chosen) set(frame, parameter, parameter.choices[*clicked].id);
  }
  column.y += height + gap;
}

void chip_rows(Frame& frame, Column& column, std::span<const Parameter* const> toggles) {
  const float height = frame.ui.touch ? 44.0F : 26.0F, gap = 6, line = frame.ui.touch ? 0 : gap;
  float x = column.x;
  for (const Parameter* toggle : toggles) {
    const Said label = say(toggle->label);
    const float width =
        std::min(std::ceil(text_width(frame.ui, Face::small, label)) + (frame.ui.touch ? 28.0F : 20.0F), column.width);
    if (x > column.x && x + width > column.x + column.width) {
      x = column.x;
      column.y += height + line;
    }
    const Rect rect{x, column.y, width, height};
    const std::string_view reason = why_disabled(frame, *toggle);
    const bool on = switched_on(frame, *toggle);
    if (chip(frame.ui, toggle->id, rect, label, on, reason.empty())) set(frame, *toggle, !on);
    hint_if_hovered(frame, rect, reason);
    x += width + gap;
  }
  column.y += height + line;
}

void parameter_row(Frame& frame, Column& column, const Parameter& parameter, Said label) {
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

void heading(Frame& frame, Column& column, Said words) {
  fitted_text(frame.ui, Face::bold, {column.x, column.y + 12}, colour(frame.input.theme.ink), words, column.width);
  column.y += 27;
}

void title_row(Frame& frame, Column& column, float right) {
  const float middle = column.y + 10;
  const Sentence size = size_text(frame);
  const float room = column.width - right - text_width(frame.ui, Face::regular, size) - 10;
  fitted_text(frame.ui, Face::bold, {column.x, middle}, colour(frame.input.theme.ink),
              say(scene::shape_kinds()[frame.shape().index()].label), room);
  text(frame.ui, Face::regular, {column.x + column.width - right, middle}, colour(frame.input.theme.ink_soft), size,
       Align::right);
  column.y += 30;
}

/// The measures of a model are what its card is for, where it stands alone.
bool is_own_measure(const Frame& frame, const Parameter& parameter) {
  const bool of_curve = std::holds_alternative<scene::ModelCurveObject>(frame.shape()) && parameter.group == "Curve";
  const bool of_surface = std::holds_alternative<scene::ModelSurfaceObject>(frame.shape()) &&
                          (parameter.id == "model" || parameter.id.starts_with("model."));
  return (of_curve || of_surface) && !listed(first_rows, parameter.id) &&
         scene::applies(frame.input.document, parameter);
}

/// The rows below each other, their labels in a column of their own.
void parameter_rows(Frame& frame, Column& column, std::span<const Parameter* const> rows) {
  column.labels = label_width(frame);
  for (const Parameter* row : rows)
    if (row->kind == ParameterKind::number || row->kind == ParameterKind::integer ||
        (row->kind == ParameterKind::choice && translates()))
      column.labels =
          std::max(column.labels, std::ceil(text_width(frame.ui, Face::regular, say(row->label))) + label_gap);
  column.labels = std::min(column.labels, std::round(longest_label * column.width));
  for (const Parameter* row : rows) {
    if (row->id == "blending.function") column.y += 4;
    parameter_row(frame, column, *row, say(row->label));
  }
}

void first_part(Frame& frame, Column& column) {
  Rows rows;
  for (const std::string_view id : first_rows) {
    const Parameter* parameter = scene::find_parameter(id);
    if (!parameter || !scene::applies(frame.input.document, *parameter)) continue;
    // A row that most blending functions have no use for takes up no room.
    const bool seldom = id == "blending.parameter" || id == "locals.degree";
    if (seldom && !why_disabled(frame, *parameter).empty()) continue;
    rows.push_back(parameter);
  }
  for (const Parameter& parameter : scene::parameters())
    if (is_own_measure(frame, parameter)) rows.push_back(&parameter);
  parameter_rows(frame, column, {rows.begin(), rows.size()});
  column.y += 2;
  draw_rows(frame, column);
}

/// All rows of the table that have no place of their own, group by group; groups of switches first, as they are used most.
KNOTWORK_LATER void other_parts(Frame& frame, Column& column) {
  const std::span<const std::string_view> beside_clock =
      std::span(clock_rows).first(frame.ui.touch ? phone_clock_rows : clock_rows.size());
  const auto other = [&](const Parameter& parameter) {
    return scene::applies(frame.input.document, parameter) && !listed(first_rows, parameter.id) &&
           !listed(beside_clock, parameter.id) && !is_own_measure(frame, parameter);
  };
  Few<std::string_view, 16> groups;
  for (const bool switches : {true, false})
    for (const Parameter& parameter : scene::parameters())
      if (other(parameter) && (parameter.kind == ParameterKind::toggle) == switches &&
          std::find(groups.begin(), groups.end(), parameter.group) == groups.end())
        groups.push_back(parameter.group);

  for (const std::string_view group : groups) {
    Rows toggles, rows;
    for (const Parameter& parameter : scene::parameters())
      if (parameter.group == group && other(parameter))
        (parameter.kind == ParameterKind::toggle ? toggles : rows).push_back(&parameter);
    // Numbers, and a row by itself, say enough with their own labels.
    const bool headed =
        toggles.size() + rows.size() > 1 && (!toggles.empty() || rows.front()->kind == ParameterKind::choice);
    column.y += group == groups.front() ? 0 : 8;
    if (headed) heading(frame, column, say(group));
    if (!toggles.empty()) chip_rows(frame, column, {toggles.begin(), toggles.size()});
    parameter_rows(frame, column, {rows.begin(), rows.size()});
  }
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
  if (has_table(frame) && frame.tall()) {
    rule(frame, column, 6);
    draw_table(frame, column);
  }
  rule(frame, column, 4);
  const float share = smooth(eased(frame.ui, frame.state.more_share, frame.state.show_more ? 1.0F : 0.0F, 0.15F));
  if (fold_button(frame.ui, "more", {column.x, column.y, column.width, 28},
                  say(frame.has_clock() ? words::more : words::display), frame.state.show_more)) {
    frame.state.show_more = !frame.state.show_more;
    frame.ui.wants_frame = true;
  }
  column.y += 28 + 6;
  const float folded = column.y - top;
  float unfolded = folded;
  if (share > 0) {
    other_parts(frame, column);
    if (has_table(frame) && !frame.tall()) {
      heading(frame, column, say(words::domain));
      draw_table(frame, column);
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

/// Of undo, redo, what the figure's kind has, and the view.
float tools_width(const Frame& frame) {
  return (frame.ui.touch ? 40.0F : 32.0F) * static_cast<float>(3 + tools_of(frame).size());
}

/// The phone's form of the panel: a sheet over the stage's lower part.
KNOTWORK_LATER void open_drawer(Frame& frame, float share, bool appears) {
  PanelState& state = frame.state;
  const Rect& stage = frame.stage;
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
                  say(words::controls)))
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
  if (has_table(frame)) {
    rule(frame, column, 8);
    draw_table(frame, column);
  }
  column.y += 12;
  ImGui::SetCursorScreenPos({body.x, column.y});
  ImGui::Dummy({1, 0});
  ImGui::PopClipRect();
  fade_foot(frame, body, 0);
  ImGui::EndChild();
  ImGui::End();
}

/// The button that opens it, while it is not open.
void drawer(Frame& frame) {
  PanelState& state = frame.state;
  const Rect& stage = frame.stage;
  const bool appears = state.drawer_open && state.drawer_share == 0;
  const float share = smooth(eased(frame.ui, state.drawer_share, state.drawer_open ? 1.0F : 0.0F, 0.16F));
  if (share < 1) {
    const float width =
        std::min(text_width(frame.ui, Face::bold, say(words::controls)) + 50, stage.width - tools_width(frame) - 28);
    const Rect pill{stage.width - width - 12, 8, width, 44};
    begin(frame, "controls", {pill.x - 4, pill.y, pill.width + 8, pill.height + 4}, ImGuiWindowFlags_NoScrollbar);
    if (pill_button(frame.ui, "controls", pill, Icon::sliders, say(words::controls))) state.drawer_open = true;
    ImGui::End();
  }
  if (state.drawer_open && state.drawer_share == 0) frame.ui.wants_frame = true;
  if (share > 0) open_drawer(frame, share, appears);
  // It has been told to close, and has yet to.
  if (!state.drawer_open && state.drawer_share > 0) frame.ui.wants_frame = true;
}

void tools(Frame& frame, float x, float middle) {
  PanelOutput& output = frame.output;
  const float size = frame.ui.touch ? 40.0F : 32.0F;
  int count = 0;
  const auto place = [&] { return Rect{x + size * static_cast<float>(count++), middle - size / 2, size, size}; };
  const PanelInput& input = frame.input;
  output.undo = icon_button(frame.ui, "undo", place(), Icon::undo, input.can_undo, say(words::undo));
  output.redo = icon_button(frame.ui, "redo", place(), Icon::redo, input.can_redo, say(words::redo));
  for (Tool& tool : tools_of(frame)) {
    if (!icon_button(frame.ui, tool.id, place(), tool.icon, tool.enabled, say(tool.hint))) continue;
    if (tool.command) output.commands.push_back(std::move(*tool.command));
    if (!tool.key.empty()) output.keys.emplace_back(tool.key);
  }
  output.frame_all = icon_button(frame.ui, "frame", place(), Icon::frame, true, say(words::frame));
}

/// The figure's plot at the stage's foot, and below it the buttons where no clock has them.
void figure_foot(Frame& frame) {
  const bool phone = frame.ui.touch;
  const float height = strip_height(frame), top = frame.stage.height - frame.foot();
  const bool buttons = !phone && !frame.has_clock();
  if (height <= 0 && !buttons) return;
  const float margin = phone ? 30 : frame.stage.width >= wide_stage ? 62.0F : 46.0F;
  begin(frame, "strip", {0, top, frame.stage.width, height + (buttons ? tools_height : 0.0F)},
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (height > 0) draw_strip(frame, {margin, top, frame.stage.width - 2 * margin, height - 6});
  if (buttons) tools(frame, frame.stage.width - tools_width(frame) - 18, frame.stage.height - 26);
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
    right -= tools_width(frame);
    tools(frame, right + 4, middle);
    right -= 10;
    const double pace = number(frame, *speed);
    right -= 34;
    text(frame.ui, Face::small, {right + 8, middle}, colour(theme.ink_soft), as_is(value_text(*speed, pace)));
    const float width = frame.stage.width >= wide_stage ? 72.0F : 52.0F;
    const SliderEvent event =
        slider(frame.ui, speed->id, {right - width, middle - 16, width, 32}, scale_of(frame, *speed, pace), pace);
    take_slider(frame, *speed, event);
    right -= width + 14;
  } else {
    right -= 4;
  }
  const double now = number(frame, *time);
  text(frame.ui, Face::regular, {right, middle}, colour(theme.ink_soft), as_is(text_of("%.1f s", now)), Align::right);
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
         colour(as_text(frame.input.theme, label.colour)), as_is(label.words), Align::centre);
  ImGui::End();
}

/// What is selected and pointed at.
void readout(Frame& frame) {
  const float left = frame.ui.touch ? 16 : 22, top = frame.ui.touch && !frame.state.drawer_open ? 56 : 22;
  begin(frame, "probe", {left - 8, top - 8, std::min(300.0F, frame.stage.width - left), 168},
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
  draw_readout(frame, left, top + 8);
  ImGui::End();
}

/// At the stage's lower left: the colours of a curvature with its scale, or what the lines mean; and what is left of
/// smoothness across knot lines.
KNOTWORK_LAST void legend(Frame& frame, const SurfaceQuality& quality) {
  const Theme& theme = frame.input.theme;
  const bool curved = quality.shading == scene::Shading::gaussian || quality.shading == scene::Shading::mean;
  const bool lines = quality.shading == scene::Shading::isophotes;
  // A model is one formula: nothing is to be said of pieces.
  const bool pieces = !std::holds_alternative<ModelSurfaceFigure>(frame.input.figure);
  const float left = frame.ui.touch ? 16 : 22, width = 176;
  const float height = (curved ? 42.0F : lines ? 18.0F : 0.0F) + (pieces ? 20.0F : 0.0F);
  if (height == 0) return;
  const Rect place{left, frame.stage.height - frame.foot() - height - 4, width, height};
  // The last line is the longest.
  const float longest = std::min(360.0F, frame.stage.width - left);
  begin(frame, "legend", {place.x - 4, place.y - 4, longest + 8, place.height + 8},
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
  if (curved || lines) frame.output.readouts.push_back({0, place.y - 4.0, place.x + width + 8.0, place.height + 8.0});
  if (pieces) frame.output.readouts.push_back({0, place.y + height - 20.0, left + 0.8 * longest, 24});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float y = place.y + 8;
  if (lines) {
    fitted_text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft), say(words::slopes), longest);
    y += 18;
  }
  if (curved) {
    fitted_text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft),
                say(quality.shading == scene::Shading::mean ? words::mean : words::gaussian), longest);
    const CurvatureColours colours;
    constexpr int parts = 44;
    const float top = y + 9, part = width / parts;
    for (int k = 0; k < parts; ++k) {
      const float share = 2 * (static_cast<float>(k) + 0.5F) / parts - 1;
      list.AddRectFilled({left + static_cast<float>(k) * part, top}, {left + static_cast<float>(k + 1) * part, top + 9},
                         colour(srgb(colours.at(share))));
    }
    for (int k = 0; k <= 8; ++k) {
      const float x = left + width * static_cast<float>(k) / 8;
      list.AddLine({x, top}, {x, top + (k % 4 == 0 ? 12.0F : 9.0F)}, colour(theme.ink, 0.35F));
    }
    const std::string end = text_of("%.3g", quality.scale);
    if (quality.known) {
      text(frame.ui, Face::small, {left, top + 19}, colour(theme.ink), as_is("−" + end));
      text(frame.ui, Face::small, {left + width, top + 19}, colour(theme.ink), as_is(end), Align::right);
    }
    text(frame.ui, Face::small, {left + width / 2, top + 19}, colour(theme.ink), as_is("0"), Align::centre);
    y = top + 36;
  }
  if (!quality.known) return ImGui::End();
  fitted_text(frame.ui, Face::small, {left, y}, colour(theme.ink_soft), as_is(quality.words), longest);
  ImGui::End();
}

KNOTWORK_LATER void draw_notice(Frame& frame, Said words, float share) {
  const Theme& theme = frame.input.theme;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  sharpen(frame.ui, list);
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

void notice(Frame& frame) {
  PanelState& state = frame.state;
  if (!frame.input.notice.empty() && frame.input.notice != state.last_notice) {
    state.last_notice = frame.input.notice;
    state.shown_notice = say_once(state.last_notice);
  }
  const float share = smooth(eased(frame.ui, state.notice_share, frame.input.notice.empty() ? 0.0F : 1.0F, 0.15F));
  if (share <= 0 || state.last_notice.empty()) return;
  draw_notice(frame, as_is(state.shown_notice), share);
}

}  // namespace

void draw_panels(PanelState& state, const PanelInput& input, PanelOutput& output) {
  output.clear();
  Interface ui{.theme = input.theme, .fonts = interface_fonts(), .widgets = output.widgets};
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
  Frame frame{state, input, output, ui, stage};

  state.list_open = false;
  labels(frame);
  readout(frame);
  if (input.quality && !(input.phone && state.drawer_open)) legend(frame, *input.quality);
  if (!input.phone || state.drawer_share < 1) {
    figure_foot(frame);
    if (frame.has_clock()) clock(frame);
  }
  if (input.phone) {
    // Over an open drawer the little room there is belongs to the figure.
    if (!state.drawer_open) {
      begin(frame, "tools", {8, 8, tools_width(frame) + 8, 44}, ImGuiWindowFlags_NoScrollbar);
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
  output.widgets.resize(ui.drawn);
}

}  // namespace knotwork::web
