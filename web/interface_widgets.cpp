#include "web/interface_widgets.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <numbers>
#include <utility>

namespace knotwork::web {
namespace {

constexpr float half_turn = std::numbers::pi_v<float>;
constexpr float segment_padding = 9;  ///< CSS pixels at either side of a segment's word
constexpr float inset = 2;            ///< of the chosen segment in its track

ImFont* font_of(const Interface& ui, Face face) {
  switch (face) {
    case Face::bold:
      return ui.fonts.bold;
    case Face::small:
      return ui.fonts.small;
    case Face::regular:
      break;
  }
  return ui.fonts.regular;
}

float size_of(const Interface& ui, Face face) {
  const float size = face == Face::small ? small_text_height : text_height;
  return ui.touch ? size + 1 : size;
}

/// A stretch of text on the line, or one lowered or raised figure as a plain one.
struct Run {
  std::string_view words;
  int level;  ///< -1 lowered, 0, 1 raised
};

/// Lowered figures are the bytes E2 82 80 .. E2 82 89; raised ones E2 81 B0, E2 81 B4 .. B9, and in Latin-1 C2 B9 (1),
/// C2 B2 (2) and C2 B3 (3).
template <class Visit>
void each_run(std::string_view text, Visit visit) {
  constexpr std::string_view figures = "0123456789";
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
  std::size_t plain = 0;  // where what is on the line begins
  for (std::size_t i = 0; i < text.size();) {
    const bool low = byte(i) == 0xE2 && byte(i + 1) == 0x82 && byte(i + 2) >= 0x80 && byte(i + 2) <= 0x89;
    const bool high = byte(i) == 0xE2 && byte(i + 1) == 0x81 && byte(i + 2) >= 0xB0 && byte(i + 2) <= 0xB9;
    const bool latin = byte(i) == 0xC2 && (byte(i + 1) == 0xB9 || byte(i + 1) == 0xB2 || byte(i + 1) == 0xB3);
    if (!low && !high && !latin) {
      ++i;
      continue;
    }
    const unsigned figure = low                   ? byte(i + 2) - 0x80
                            : high                ? byte(i + 2) - 0xB0
                            : byte(i + 1) == 0xB9 ? 1
                                                  : byte(i + 1) - 0xB0;
    if (i > plain) visit(Run{text.substr(plain, i - plain), 0});
    visit(Run{figures.substr(figure, 1), low ? -1 : 1});
    plain = i += latin ? 2 : 3;
  }
  if (plain < text.size()) visit(Run{text.substr(plain), 0});
}

constexpr float small_figure_share = 0.72F;

float run_width(const Interface& ui, Face face, const Run& run) {
  const float size = size_of(ui, face) * (run.level != 0 ? small_figure_share : 1);
  return font_of(ui, face)->CalcTextSizeA(size, FLT_MAX, 0, run.words.data(), run.words.data() + run.words.size()).x;
}

void push(WidgetName name) {
  ImGui::PushID(name.word.data(), name.word.data() + name.word.size());
  ImGui::PushID(name.choice.data(), name.choice.data() + name.choice.size());
}

void pop() {
  ImGui::PopID();
  ImGui::PopID();
}

/// Of what ImGui keeps for a part of a widget.
ImGuiID id_of(WidgetName name, const char* part) {
  push(name);
  const ImGuiID id = ImGui::GetID(part);
  pop();
  return id;
}

ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }

void fill(ImDrawList& list, const Rect& rect, ImU32 ink, float rounding) {
  list.AddRectFilled(rect.min(), rect.max(), ink, rounding);
}

/// A line of one CSS pixel that lies on whole pixels.
void outline(ImDrawList& list, const Rect& rect, ImU32 ink, float rounding, float thickness = 1) {
  const float half = thickness / 2;
  list.AddRect({rect.x + half, rect.y + half}, {rect.x + rect.width - half, rect.y + rect.height - half}, ink,
               rounding - half, 0, thickness);
}

/// A field whose short sides are half circles; ImGui's own rounding stops short of that.
void capsule_path(ImDrawList& list, const Rect& rect) {
  const float radius = rect.height / 2, y = rect.y + radius;
  list.PathArcTo({rect.x + radius, y}, radius, half_turn / 2, 3 * half_turn / 2);
  list.PathArcTo({rect.x + rect.width - radius, y}, radius, -half_turn / 2, half_turn / 2);
}

void fill_capsule(ImDrawList& list, const Rect& rect, ImU32 ink) {
  capsule_path(list, rect);
  list.PathFillConvex(ink);
}

void outline_capsule(ImDrawList& list, const Rect& rect, ImU32 ink) {
  capsule_path(list, {rect.x + 0.5F, rect.y + 0.5F, rect.width - 1, rect.height - 1});
  list.PathStroke(ink, ImDrawFlags_Closed, 1);
}

/// A polyline given on a grid of 16 x 16 that is centred at `centre`.
template <std::size_t n>
void strokes(ImDrawList& list, ImVec2 centre, float unit, const std::array<ImVec2, n>& points, ImU32 ink,
             float thickness) {
  for (const ImVec2& point : points)
    list.PathLineTo({centre.x + (point.x - 8) * unit, centre.y + (point.y - 8) * unit});
  list.PathStroke(ink, 0, thickness);
}

void chevron(ImDrawList& list, ImVec2 centre, float size, float turn, ImU32 ink) {
  // Points down at turn 0 and up at turn 1.
  const float flip = 1 - 2 * turn;
  list.PathLineTo({centre.x - size, centre.y - size / 2 * flip});
  list.PathLineTo({centre.x, centre.y + size / 2 * flip});
  list.PathLineTo({centre.x + size, centre.y - size / 2 * flip});
  list.PathStroke(ink, 0, 1.5F);
}

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float unit, ImU32 ink) {
  const float thickness = 1.5F * unit;
  const auto at = [&](float x, float y) { return ImVec2{centre.x + (x - 8) * unit, centre.y + (y - 8) * unit}; };
  switch (icon) {
    case Icon::undo:
      list.PathLineTo(at(3, 6));
      list.PathArcTo(at(9.5F, 9.5F), 3.5F * unit, -half_turn / 2, half_turn / 2, 16);
      list.PathLineTo(at(6, 13));
      list.PathStroke(ink, 0, thickness);
      strokes<3>(list, centre, unit, {{{6, 3}, {3, 6}, {6, 9}}}, ink, thickness);
      break;
    case Icon::redo:
      list.PathLineTo(at(13, 6));
      list.PathArcTo(at(6.5F, 9.5F), 3.5F * unit, -half_turn / 2, -3 * half_turn / 2, 16);
      list.PathLineTo(at(10, 13));
      list.PathStroke(ink, 0, thickness);
      strokes<3>(list, centre, unit, {{{10, 3}, {13, 6}, {10, 9}}}, ink, thickness);
      break;
    case Icon::reset:
      list.PathArcTo(at(8, 8), 5 * unit, -half_turn * 0.75F, half_turn * 0.92F, 28);
      list.PathStroke(ink, 0, thickness);
      strokes<3>(list, centre, unit, {{{3.4F, 1.6F}, {4.2F, 5.0F}, {7.7F, 4.6F}}}, ink, thickness);
      break;
    case Icon::frame:
      strokes<3>(list, centre, unit, {{{2.5F, 5.5F}, {2.5F, 2.5F}, {5.5F, 2.5F}}}, ink, thickness);
      strokes<3>(list, centre, unit, {{{10.5F, 2.5F}, {13.5F, 2.5F}, {13.5F, 5.5F}}}, ink, thickness);
      strokes<3>(list, centre, unit, {{{13.5F, 10.5F}, {13.5F, 13.5F}, {10.5F, 13.5F}}}, ink, thickness);
      strokes<3>(list, centre, unit, {{{5.5F, 13.5F}, {2.5F, 13.5F}, {2.5F, 10.5F}}}, ink, thickness);
      list.AddCircleFilled(centre, 1.6F * unit, ink);
      break;
    case Icon::close:
      strokes<2>(list, centre, unit, {{{4, 4}, {12, 12}}}, ink, thickness);
      strokes<2>(list, centre, unit, {{{12, 4}, {4, 12}}}, ink, thickness);
      break;
    case Icon::add:
      strokes<2>(list, centre, unit, {{{8, 3}, {8, 13}}}, ink, thickness);
      strokes<2>(list, centre, unit, {{{3, 8}, {13, 8}}}, ink, thickness);
      break;
    case Icon::remove:
      strokes<2>(list, centre, unit, {{{3, 8}, {13, 8}}}, ink, thickness);
      break;
    case Icon::pencil:
      strokes<5>(list, centre, unit, {{{3, 13}, {3.9F, 9.7F}, {10.8F, 2.8F}, {13.2F, 5.2F}, {6.3F, 12.1F}}}, ink,
                 thickness);
      strokes<2>(list, centre, unit, {{{6.3F, 12.1F}, {3, 13}}}, ink, thickness);
      break;
    case Icon::back:
      strokes<3>(list, centre, unit, {{{10.5F, 3.5F}, {6, 8}, {10.5F, 12.5F}}}, ink, thickness);
      strokes<2>(list, centre, unit, {{{3.5F, 3.5F}, {3.5F, 12.5F}}}, ink, thickness);
      break;
    case Icon::onwards:
      strokes<3>(list, centre, unit, {{{5.5F, 3.5F}, {10, 8}, {5.5F, 12.5F}}}, ink, thickness);
      strokes<2>(list, centre, unit, {{{12.5F, 3.5F}, {12.5F, 12.5F}}}, ink, thickness);
      break;
    case Icon::play:
      list.AddTriangleFilled(at(5, 3), at(13, 8), at(5, 13), ink);
      break;
    case Icon::pause:
      list.AddRectFilled(at(4.5F, 3.5F), at(7, 12.5F), ink, unit);
      list.AddRectFilled(at(9, 3.5F), at(11.5F, 12.5F), ink, unit);
      break;
    case Icon::sliders:
      strokes<2>(list, centre, unit, {{{2, 5}, {14, 5}}}, ink, thickness);
      strokes<2>(list, centre, unit, {{{2, 11}, {14, 11}}}, ink, thickness);
      list.AddCircleFilled(at(10, 5), 2.4F * unit, ink);
      list.AddCircleFilled(at(5.5F, 11), 2.4F * unit, ink);
      break;
  }
}

/// How strongly an item answers to the pointer, eased: 0 at rest, 1 hovered.
float warmth(Interface& ui, WidgetName id, const Press& press) {
  return eased(ui, id_of(id, "warmth"), press.hovered || press.held ? 1.0F : 0.0F);
}

}  // namespace

ImU32 colour(const Colour& srgb, float opacity) {
  return ImGui::ColorConvertFloat4ToU32({srgb[0], srgb[1], srgb[2], opacity});
}

Colour as_text(const Theme& theme, const Colour& hue) { return mixed(hue, theme.ink, theme.dark ? 0.08F : 0.32F); }

float eased(Interface& ui, float& value, float target, float seconds) {
  if (ui.reduced_motion) value = target;
  const float step = ui.step / seconds;
  value = value < target ? std::min(target, value + step) : std::max(target, value - step);
  if (value != target) ui.wants_frame = true;
  return value;
}

float eased(Interface& ui, ImGuiID id, float target, float seconds) {
  return eased(ui, *ImGui::GetStateStorage()->GetFloatRef(id, target), target, seconds);
}

float smooth(float share) { return share * share * (3 - 2 * share); }

void sharpen(const Interface& ui, ImDrawList& list) { list._FringeScale = 1 / ui.pixel_ratio; }

void soft_shadow(const Interface& ui, ImDrawList& list, const Rect& card, float rounding, float opacity) {
  constexpr int reach = 20;
  const float strength = (ui.theme.dark ? 0.045F : 0.013F) * opacity;
  const Colour shade = ui.theme.dark ? Colour{0, 0, 0} : ui.theme.ink;
  for (int ring = 0; ring < reach; ++ring) {
    const float out = static_cast<float>(ring) + 0.5F;
    const float fall = 1 - out / reach;
    // The light comes from above: the shadow lies a little lower.
    list.AddRect({card.x - out, card.y - out + 0.3F * out},
                 {card.x + card.width + out, card.y + card.height + 1.3F * out},
                 colour(shade, 4 * strength * fall * fall), rounding + out, 0, 1.35F);
  }
}

float text_width(const Interface& ui, Face face, Said text) {
  float width = 0;
  each_run(text, [&](const Run& run) { width += run_width(ui, face, run); });
  return width;
}

void text(const Interface& ui, Face face, ImVec2 position, ImU32 ink, Said text, Align align) {
  heard(text);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float size = size_of(ui, face);
  float x = position.x;
  if (align != Align::left) x -= text_width(ui, face, text) / (align == Align::centre ? 2 : 1);
  each_run(text, [&](const Run& run) {
    const float run_size = size * (run.level != 0 ? small_figure_share : 1);
    const float y = position.y - size / 2 + (run.level < 0 ? size * 0.36F : run.level > 0 ? -size * 0.04F : 0);
    list.AddText(font_of(ui, face), run_size, {std::round(x), std::round(y)}, ink, run.words.data(),
                 run.words.data() + run.words.size());
    x += run_width(ui, face, run);
  });
}

namespace {

KNOTWORK_LATER void shortened_text(Interface& ui, Face face, ImVec2 position, ImU32 ink, Said text, float room,
                                   Align align) {
  std::string_view words = text;
  Words cut;
  do {
    while (!words.empty() && (static_cast<unsigned char>(words.back()) & 0xC0U) == 0x80) words.remove_suffix(1);
    if (!words.empty()) words.remove_suffix(1);
    cut = Words().add(words).add("…");
  } while (!words.empty() && text_width(ui, face, as_is(cut)) > room);
  web::text(ui, face, position, ink, as_is(cut), align);
  const float left = position.x - (align == Align::left ? 0 : align == Align::centre ? room / 2 : room);
  const Rect place{left, position.y - text_height / 2, room, text_height};
  if (!ui.hint && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(place.min(), place.max()))
    set_hint(ui, text, place);
}

}  // namespace

void fitted_text(Interface& ui, Face face, ImVec2 position, ImU32 ink, Said words, float room, Align align) {
  // English has room, and its first figure comes before what shortens words.
  if (!translates() || text_width(ui, face, words) <= room + 0.5F)
    text(ui, face, position, ink, words, align);
  else
    shortened_text(ui, face, position, ink, words, room, align);
}

float behind(const Interface& ui, Face face, float x, Said text, float usual) {
  return std::max(usual, std::ceil(x + text_width(ui, face, text) + 6));
}

Paragraph balanced(const Interface& ui, Face face, Said text, float widest) {
  const std::string_view words = text;
  const auto extent = [&](float wrap) {
    return font_of(ui, face)->CalcTextSizeA(size_of(ui, face), FLT_MAX, wrap, words.data(),
                                            words.data() + words.size());
  };
  Paragraph best{widest, extent(widest)};
  for (float wrap = widest - 8; wrap > widest / 2; wrap -= 8) {
    const ImVec2 narrower = extent(wrap);
    if (narrower.y > best.extent.y) break;
    best = {wrap, narrower};
  }
  return best;
}

void paragraph(const Interface& ui, ImDrawList& list, Face face, ImVec2 corner, ImU32 ink, Said text, float wrap) {
  heard(text);
  const std::string_view words = text;
  list.AddText(font_of(ui, face), size_of(ui, face), corner, ink, words.data(), words.data() + words.size(), wrap);
}

Press press_area(Interface& ui, WidgetName name, const Rect& rect) {
  ImGui::SetCursorScreenPos(rect.min());
  push(name);
  Press press;
  press.clicked = ImGui::InvisibleButton("press", {rect.width, rect.height}) && ui.listening;
  press.hovered = ImGui::IsItemHovered() && ui.listening;
  press.held = ImGui::IsItemActive();
  press.taken = ImGui::IsItemActivated();
  press.let_go = ImGui::IsItemDeactivated();
  pop();
  if (press.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);

  const ImVec2 clip_min = ImGui::GetWindowDrawList()->GetClipRectMin();
  const ImVec2 clip_max = ImGui::GetWindowDrawList()->GetClipRectMax();
  const float left = std::max(rect.x, clip_min.x), right = std::min(rect.x + rect.width, clip_max.x);
  const float top = std::max(rect.y, clip_min.y), bottom = std::min(rect.y + rect.height, clip_max.y);
  // A sliver that scrolling leaves at an edge is nothing to aim at.
  constexpr float least = 16;
  if (right - left >= std::min(least, rect.width) && bottom - top >= std::min(least, rect.height))
    ui.record(name, {left, top, right - left, bottom - top});
  return press;
}

float segmented_width(const Interface& ui, std::span<const Segment> segments) {
  float width = 2 * inset;
  for (const Segment& segment : segments) width += text_width(ui, Face::bold, segment.label) + 2 * segment_padding;
  return width;
}

std::optional<std::size_t> segmented(Interface& ui, std::string_view id, const Rect& rect,
                                     std::span<const Segment> segments) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = ui.theme;
  fill(list, rect, colour(theme.ink, 0.045F), 8);
  outline(list, rect, colour(theme.rule), 8);

  // Words of unequal length share what room is left evenly.
  const float spare = (rect.width - segmented_width(ui, segments)) / static_cast<float>(segments.size());
  std::array<Rect, most_segments> places;
  float x = rect.x + inset;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const float end = x + text_width(ui, Face::bold, segments[i].label) + 2 * segment_padding + spare;
    places[i] = {std::round(x), rect.y, std::round(end) - std::round(x), rect.height};
    x = end;
  }

  std::optional<std::size_t> clicked;
  std::array<Press, most_segments> presses;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    presses[i] = press_area(ui, segments[i].widget, places[i]);
    if (presses[i].clicked) clicked = i;
    if (presses[i].hovered && !segments[i].refusal.empty()) set_hint(ui, say(segments[i].refusal), places[i]);
  }

  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].chosen) continue;
    // The chosen field slides from one word to the next.
    const float travel = std::max(rect.width, 1.0F);
    const float left = travel * eased(ui, id_of(id, "left"), (places[i].x - rect.x) / travel);
    const float width = travel * eased(ui, id_of(id, "width"), places[i].width / travel);
    fill(list, {rect.x + left, rect.y + inset, width, rect.height - 2 * inset}, colour(theme.ink), 6);
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const float warm = warmth(ui, segment.widget, presses[i]);
    const float chosen = eased(ui, id_of(segment.widget, "chosen"), segment.chosen ? 1.0F : 0.0F);
    const bool refused = !segment.refusal.empty() && !segment.chosen;
    Colour ink = mixed(mixed(theme.ink_soft, theme.ink, refused ? 0 : warm), theme.paper, chosen);
    text(ui, segment.chosen ? Face::bold : Face::regular, places[i].centre(), colour(ink, refused ? 0.5F : 1),
         segment.label, Align::centre);
  }
  return clicked;
}

double SliderScale::value_at(double share) const {
  share = std::clamp(share, 0.0, 1.0);
  const double exact = logarithmic ? min * std::pow(max / min, share) : min + (max - min) * share;
  if (step <= 0) return std::clamp(exact, min, max);
  // Counted from 0, not from min, so that a step of 0.25 gives 1 on a range that starts at 0.1.
  return std::clamp(std::round(exact / step) * step, min, max);
}

double SliderScale::share_of(double value) const {
  if (!(max > min)) return 0;
  const double share =
      logarithmic ? std::log(std::max(value, min) / min) / std::log(max / min) : (value - min) / (max - min);
  return std::clamp(share, 0.0, 1.0);
}

namespace {

enum class Taking : unsigned char { not_yet, now, earlier };

/// When a press takes a slider: a mouse's at once; a finger's when it goes sideways, or by a tap, as one that goes up or
/// down scrolls the rows that the slider is among.
Taking taken(const Interface& ui, std::string_view id, const Press& press) {
  if (!ui.touch) return press.taken ? Taking::now : Taking::earlier;
  constexpr float slop = 6;
  bool& undecided = *ImGui::GetStateStorage()->GetBoolRef(id_of(id, "undecided"), false);
  if (press.taken) undecided = true;
  if (!undecided) return Taking::earlier;
  const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
  const bool sideways = press.held && std::abs(way.x) > slop && std::abs(way.x) >= std::abs(way.y);
  const bool tapped = press.let_go && std::max(std::abs(way.x), std::abs(way.y)) <= slop;
  if (press.let_go || sideways) undecided = false;
  return ui.listening && (sideways || tapped) ? Taking::now : Taking::not_yet;
}

}  // namespace

SliderEvent slider(Interface& ui, std::string_view id, const Rect& rect, const SliderScale& scale, double value,
                   bool enabled) {
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float radius = ui.touch ? 9 : 7;
  const float start = rect.x + radius + 1, length = std::max(rect.width - 2 * radius - 2, 1.0F);

  SliderEvent event;
  event.value = value;
  if (enabled) {
    // Where on the thumb the pointer holds it, so that it does not jump when it is taken.
    float& grip = *ImGui::GetStateStorage()->GetFloatRef(id_of(id, "grip"), 0);
    const float pointer = ImGui::GetIO().MousePos.x;
    const Taking taking = taken(ui, id, press);
    event.taken = taking == Taking::now;
    if (event.taken) {
      const float off =
          ImGui::GetIO().MouseClickedPos[0].x - (start + length * static_cast<float>(scale.share_of(value)));
      grip = std::abs(off) <= radius + 2 ? off : 0;
    }
    const bool jumps = event.taken && grip == 0;
    const bool follows = press.held && taking != Taking::not_yet && ImGui::GetIO().MouseDelta.x != 0;
    if (jumps || follows) event.value = scale.value_at(static_cast<double>((pointer - grip - start) / length));
    event.moved = event.value != value;
  }
  event.let_go = press.let_go;

  const float warm = enabled ? warmth(ui, id, press) : 0;
  const float held = eased(ui, id_of(id, "held"), press.held && enabled ? 1.0F : 0.0F);
  const float opacity = enabled ? 1 : 0.35F;
  const float y = std::floor(rect.y + rect.height / 2) + 0.5F;  // three pixels' middle, so that the track is crisp
  const float x = start + length * static_cast<float>(scale.share_of(event.value));
  const Colour ink = mixed(theme.ink, theme.accent, held);
  const float half = 1.5F;
  fill_capsule(list, {rect.x + 1, y - half, rect.width - 2, 2 * half}, colour(theme.ink, theme.dark ? 0.16F : 0.12F));
  fill_capsule(list, {rect.x + 1, y - half, x - rect.x, 2 * half}, colour(ink, opacity));
  list.AddCircleFilled({x, y}, radius + 5 * std::max(warm * 0.6F, held), colour(ink, 0.1F * std::max(warm, held)));
  list.AddCircleFilled({x, y}, radius, colour(mixed(theme.ink, ink, held), 1));
  if (!enabled) list.AddCircleFilled({x, y}, radius, colour(theme.panel, 0.6F));
  list.AddCircleFilled({x, y}, radius - 2, colour(theme.dark ? theme.stage : theme.panel));
  return event;
}

bool chip(Interface& ui, std::string_view id, const Rect& rect, Said label, bool on, bool enabled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = ui.theme;
  const Press press = press_area(ui, id, rect);
  const float warm = enabled ? warmth(ui, id, press) : 0;
  const float lit = eased(ui, id_of(id, "lit"), on ? 1.0F : 0.0F);
  const float opacity = enabled ? 1 : 0.4F;
  const Rect field = ui.touch ? Rect{rect.x, rect.y + 4, rect.width, rect.height - 8} : rect;
  fill_capsule(list, field, colour(theme.ink, (0.04F * warm * (1 - lit) + lit * (1 - 0.12F * warm)) * opacity));
  outline_capsule(list, field, colour(mixed(theme.rule, theme.ink_soft, 0.25F + warm * 0.5F), (1 - lit) * opacity));
  const Colour ink = mixed(mixed(theme.ink_soft, theme.ink, warm), theme.paper, lit);
  fitted_text(ui, Face::small, rect.centre(), colour(ink, opacity), label, rect.width - 16, Align::centre);
  return press.clicked && enabled;
}

bool icon_button(Interface& ui, std::string_view id, const Rect& rect, Icon icon, bool enabled, Said hint) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press) * (enabled ? 1.0F : 0.3F);
  const float strength = eased(ui, id_of(id, "enabled"), enabled ? 1.0F : 0.32F);
  list.AddCircleFilled(rect.centre(), std::min(rect.width, rect.height) / 2 - 1, colour(ui.theme.ink, 0.08F * warm));
  const Colour ink = press.held && enabled ? ui.theme.accent : mixed(ui.theme.ink_soft, ui.theme.ink, warm);
  draw_icon(list, icon, rect.centre(), ui.touch ? 1.15F : 1, colour(ink, strength));
  if (press.hovered && !press.held && !ui.touch) set_hint(ui, hint, rect);
  return press.clicked && enabled;
}

bool play_button(Interface& ui, std::string_view id, const Rect& rect, bool playing) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press);
  const float pressed = eased(ui, id_of(id, "pressed"), press.held ? 1.0F : 0.0F);
  const float radius = 19 + warm - 1.5F * pressed;
  const ImVec2 centre = rect.centre();
  list.AddCircleFilled(centre, radius, colour(ui.theme.ink));
  const ImU32 ink = colour(ui.theme.paper);
  if (playing) {
    for (const float x : {-6.0F, 2.0F})
      list.AddRectFilled({centre.x + x, centre.y - 6.5F}, {centre.x + x + 4, centre.y + 6.5F}, ink, 1.2F);
  } else {
    // The triangle's centre of mass, not that of its box, sits in the disc's centre. A stroke rounds its corners.
    const std::array<ImVec2, 3> corners{
        {{centre.x - 4, centre.y - 6.2F}, {centre.x + 7, centre.y}, {centre.x - 4, centre.y + 6.2F}}};
    list.AddTriangleFilled(corners[0], corners[1], corners[2], ink);
    list.AddPolyline(corners.data(), 3, ink, ImDrawFlags_Closed, 1.5F);
  }
  return press.clicked;
}

bool pill_button(Interface& ui, std::string_view id, const Rect& rect, Icon icon, Said label) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press);
  const Rect field{rect.x, rect.y + 3, rect.width, rect.height - 6};
  list.PushClipRectFullScreen();
  soft_shadow(ui, list, field, field.height / 2, 0.5F);
  list.PopClipRect();
  fill_capsule(list, field, colour(mixed(ui.theme.panel, ui.theme.ink, 0.06F * warm), 0.96F));
  draw_icon(list, icon, {field.x + 20, field.y + field.height / 2}, 0.95F, colour(ui.theme.ink));
  fitted_text(ui, Face::bold, {field.x + 34, field.y + field.height / 2}, colour(ui.theme.ink), label,
              field.width - 48);
  return press.clicked;
}

bool fold_button(Interface& ui, std::string_view id, const Rect& rect, Said label, bool open) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press);
  const float turn = smooth(eased(ui, id_of(id, "turn"), open ? 1.0F : 0.0F));
  const ImU32 ink = colour(mixed(ui.theme.ink_soft, ui.theme.ink, warm));
  fitted_text(ui, Face::regular, {rect.x, rect.y + rect.height / 2}, ink, label, rect.width - 22);
  chevron(list, {rect.x + rect.width - 7, rect.y + rect.height / 2}, 4, turn, ink);
  return press.clicked;
}

bool combo_button(Interface& ui, std::string_view id, const Rect& rect, Said label, bool open) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press);
  const float turn = smooth(eased(ui, id_of(id, "turn"), open ? 1.0F : 0.0F));
  fill(list, rect, colour(ui.theme.ink, 0.045F + 0.035F * warm), 8);
  outline(list, rect, colour(mixed(ui.theme.rule, ui.theme.ink_soft, 0.5F * warm)), 8);
  list.PushClipRect(rect.min(), {rect.x + rect.width - 22, rect.y + rect.height}, true);
  fitted_text(ui, Face::regular, {rect.x + 10, rect.y + rect.height / 2}, colour(ui.theme.ink), label, rect.width - 32);
  list.PopClipRect();
  chevron(list, {rect.x + rect.width - 14, rect.y + rect.height / 2}, 3.5F, turn, colour(ui.theme.ink_soft));
  return press.clicked;
}

bool menu_item(Interface& ui, WidgetName id, const Rect& rect, Said label, bool chosen, Said refusal,
               std::span<const float> curve) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = ui.theme;
  const Press press = press_area(ui, id, rect);
  const float warm = warmth(ui, id, press);
  fill(list, rect, chosen ? colour(theme.ink) : colour(theme.ink, 0.08F * warm), 6);
  const Colour ink = chosen ? theme.paper : mixed(theme.ink_soft, theme.ink, 0.5F + 0.5F * warm);
  if (press.hovered) set_hint(ui, refusal, rect);
  fitted_text(ui, chosen ? Face::bold : Face::regular, {rect.x + 10, rect.y + rect.height / 2},
              colour(ink, refusal.empty() ? 1 : 0.5F), label, rect.width - (curve.size() > 1 ? 58 : 16));
  if (curve.size() > 1) {
    const float width = 34, height = std::min(rect.height - 14, 18.0F);
    const float x = rect.x + rect.width - width - 10, y = rect.y + (rect.height + height) / 2;
    for (std::size_t i = 0; i < curve.size(); ++i)
      list.PathLineTo(
          {x + width * static_cast<float>(i) / static_cast<float>(curve.size() - 1), y - height * curve[i]});
    list.PathStroke(colour(theme.local[1]), 0, 1.5F);
  }
  return press.clicked;
}

void blending_plot(Interface& ui, const Rect& rect, const BlendingFunction& blending, std::optional<double> w,
                   const std::array<Colour, 2>& hues) {
  constexpr std::size_t count = 81;
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rect area{rect.x + 1, rect.y + 4, rect.width - 2, rect.height - 8};
  const auto at = [&](double share, double value) {
    return ImVec2{area.x + area.width * static_cast<float>(share),
                  area.y + area.height * static_cast<float>(1 - value)};
  };

  std::array<double, count> where{};
  std::array<BlendingValue, count> values{};
  for (std::size_t i = 0; i < count; ++i) where[i] = static_cast<double>(i) / (count - 1);
  blending.evaluate(where, values);

  // B' to its own scale: its place and shape tell where the handing over happens, its height would leave the plot.
  double steepest = 1e-9;
  for (const BlendingValue& value : values) steepest = std::max(steepest, value[1]);
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // else the strips' soft edges would show as seams
  for (std::size_t i = 0; i + 1 < count; ++i)
    list.AddQuadFilled(at(where[i], 0), at(where[i], 0.8 * values[i][1] / steepest),
                       at(where[i + 1], 0.8 * values[i + 1][1] / steepest), at(where[i + 1], 0),
                       colour(theme.ink, theme.dark ? 0.07F : 0.05F));
  list.Flags = flags;

  list.AddLine(at(0, 0) + ImVec2{0, 0.5F}, at(1, 0) + ImVec2{0, 0.5F}, colour(theme.rule), 1);
  list.AddLine(at(0, 1) + ImVec2{0, -0.5F}, at(1, 1) + ImVec2{0, -0.5F}, colour(theme.rule, 0.7F), 1);
  const auto curve = [&](auto value_of, const Colour& hue) {
    for (std::size_t i = 0; i < count; ++i) list.PathLineTo(at(where[i], value_of(values[i][0])));
    list.PathStroke(colour(hue), 0, 2);
  };
  curve([](double b) { return 1 - b; }, hues[0]);
  curve([](double b) { return b; }, hues[1]);

  if (!w) return;
  const double b = blending(*w)[0];
  list.AddLine(at(*w, 0), at(*w, 1), colour(theme.ink, 0.35F), 1);
  for (const auto& [value, hue] : {std::pair{1 - b, hues[0]}, std::pair{b, hues[1]}}) {
    list.AddCircleFilled(at(*w, value), 4.5F, colour(theme.panel));
    list.AddCircleFilled(at(*w, value), 3.5F, colour(hue));
  }
}

void set_hint(Interface& ui, Said words, const Rect& item) {
  if (!words.empty()) ui.hint = Widget{std::string(words), {item.x, item.y, item.width, item.height}};
}

void draw_hint(Interface& ui, const Rect& stage) {
  if (!ui.hint || ui.hint->label.empty()) return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  sharpen(ui, list);
  const auto& item = ui.hint->rect;
  const Said words = as_is(ui.hint->label);
  const auto [wrap, extent] = balanced(ui, Face::small, words, std::min(220.0F, stage.width - 48));
  Rect box{0, 0, std::ceil(extent.x) + 18, std::ceil(extent.y) + 12};
  box.x = std::round(static_cast<float>(item[0] + item[2] / 2) - box.width / 2);
  box.x = std::clamp(box.x, stage.x + 8, std::max(stage.x + 8, stage.x + stage.width - box.width - 8));
  box.y = std::round(static_cast<float>(item[1] + item[3])) + 6;
  if (box.y + box.height > stage.y + stage.height - 8) box.y = std::round(static_cast<float>(item[1])) - box.height - 6;
  fill(list, box, colour(ui.theme.ink, 0.95F), 6);
  paragraph(ui, list, Face::small, {box.x + 9, box.y + 6}, colour(ui.theme.paper), words, wrap);
}

}  // namespace knotwork::web
