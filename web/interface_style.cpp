#include "web/interface_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <imgui.h>

#include "web/language.h"

namespace knotwork::web {
namespace {

// First and last code points in pairs: ASCII with Latin-1, general punctuation (dashes, quotes, primes), the minus
// sign, not greater and not less. Subscript figures are drawn as small lowered ones, since few subset fonts hold them.
constexpr std::array<ImWchar, 9> glyph_ranges{0x20, 0xFF, 0x2010, 0x2044, 0x2212, 0x2212, 0x2264, 0x2265, 0};

// Another language may have any letters; the page's fonts hold those of its words alone.
constexpr std::array<ImWchar, 3> all_glyphs{0x20, 0xFFFD, 0};

ImFont* add_face(const std::vector<std::uint8_t>& bytes, float height, float pixel_ratio) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.SizePixels = std::round(height * pixel_ratio);
  // Two horizontal positions a pixel keep letter spacing even; vertical ones would only soften the stems.
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  void* copy = ImGui::MemAlloc(bytes.size());
  std::memcpy(copy, bytes.data(), bytes.size());
  // The atlas owns the copy: newer releases of ImGui rasterise glyphs when they are first drawn.
  return atlas.AddFontFromMemoryTTF(copy, static_cast<int>(bytes.size()), config.SizePixels, &config,
                                    translates() ? all_glyphs.data() : glyph_ranges.data());
}

#if IMGUI_VERSION_NUM < 19200
/// Gives all figures the width of the widest, each centred in it, so that numbers do not tremble while they change.
void make_figures_tabular(ImFont& font) {
  float widest = 0;
  for (const ImFontGlyph& glyph : font.Glyphs)
    if (glyph.Codepoint >= '0' && glyph.Codepoint <= '9') widest = std::max(widest, glyph.AdvanceX);
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
    const float shift = (widest - glyph.AdvanceX) / 2;
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = widest;
    font.IndexAdvanceX[static_cast<int>(glyph.Codepoint)] = widest;
  }
}
#endif

ImVec4 rgba(const Colour& colour, float opacity) { return {colour[0], colour[1], colour[2], opacity}; }

}  // namespace

InterfaceFonts load_interface_fonts(const std::vector<std::uint8_t>& regular, const std::vector<std::uint8_t>& bold,
                                    double pixel_ratio) {
  ImGuiIO& io = ImGui::GetIO();
  const float ratio = static_cast<float>(std::clamp(pixel_ratio, 0.5, 4.0));
  io.Fonts->Clear();
#if IMGUI_VERSION_NUM < 19200
  io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors;
  const InterfaceFonts fonts{add_face(regular, text_height, ratio), add_face(bold, text_height, ratio),
                             add_face(regular, small_text_height, ratio)};
  io.Fonts->Build();
  for (ImFont* font : {fonts.regular, fonts.bold, fonts.small}) make_figures_tabular(*font);
  io.FontGlobalScale = 1 / ratio;
#else
  // From 1.92 on, glyphs are rasterised at io.DisplayFramebufferScale on their own.
  const InterfaceFonts fonts{add_face(regular, text_height, 1), add_face(bold, text_height, 1),
                             add_face(regular, small_text_height, 1)};
#endif
  return fonts;
}

InterfaceFonts interface_fonts() {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  if (fonts.empty()) return {};
  const auto face = [&](int i) { return fonts[std::min(i, fonts.Size - 1)]; };
  return {face(0), face(1), face(2)};
}

void apply_interface_style(const Theme& theme) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {0, 0};
  style.WindowMinSize = {1, 1};
  style.WindowBorderSize = 0;
  style.WindowRounding = 10;
  style.ChildRounding = 10;
  style.ChildBorderSize = 0;
  style.PopupRounding = 10;
  style.PopupBorderSize = 0;
  style.FrameRounding = 7;
  style.FramePadding = {10, 6};
  style.FrameBorderSize = 0;
  style.ItemSpacing = {0, 0};
  style.ItemInnerSpacing = {8, 4};
  style.ScrollbarSize = 8;
  style.ScrollbarRounding = 4;
  style.GrabRounding = 8;
  style.GrabMinSize = 16;
  style.DisplaySafeAreaPadding = {0, 0};
  style.DisplayWindowPadding = {0, 0};
  style.CircleTessellationMaxError = 0.12F;
  style.CurveTessellationTol = 0.4F;
  style.DisabledAlpha = 0.45F;

  // Every colour first gets a quiet ink, so that none keeps ImGui's grey, whatever colours a release adds.
  for (ImVec4& colour : style.Colors) colour = rgba(theme.ink, 0.12F);
  const auto set = [&](ImGuiCol which, const Colour& colour, float opacity) {
    style.Colors[which] = rgba(colour, opacity);
  };
  set(ImGuiCol_Text, theme.ink, 1);
  set(ImGuiCol_TextDisabled, theme.ink_soft, 1);
  set(ImGuiCol_TextSelectedBg, theme.focus, 0.3F);
  set(ImGuiCol_WindowBg, theme.panel, theme.panel_opacity);
  set(ImGuiCol_ChildBg, theme.panel, 0);
  set(ImGuiCol_PopupBg, theme.panel, 1);
  set(ImGuiCol_Border, theme.rule, 1);
  set(ImGuiCol_BorderShadow, theme.rule, 0);
  set(ImGuiCol_FrameBg, theme.ink, 0.05F);
  set(ImGuiCol_FrameBgHovered, theme.ink, 0.09F);
  set(ImGuiCol_FrameBgActive, theme.ink, 0.14F);
  set(ImGuiCol_ScrollbarBg, theme.panel, 0);
  set(ImGuiCol_ScrollbarGrab, theme.ink, 0.16F);
  set(ImGuiCol_ScrollbarGrabHovered, theme.ink, 0.3F);
  set(ImGuiCol_ScrollbarGrabActive, theme.accent, 0.8F);
  set(ImGuiCol_CheckMark, theme.ink, 1);
  set(ImGuiCol_SliderGrab, theme.ink, 1);
  set(ImGuiCol_SliderGrabActive, theme.accent, 1);
  set(ImGuiCol_Button, theme.ink, 0.05F);
  set(ImGuiCol_ButtonHovered, theme.ink, 0.1F);
  set(ImGuiCol_ButtonActive, theme.ink, 0.16F);
  set(ImGuiCol_Header, theme.ink, 0.08F);
  set(ImGuiCol_HeaderHovered, theme.ink, 0.08F);
  set(ImGuiCol_HeaderActive, theme.ink, 0.14F);
  set(ImGuiCol_Separator, theme.rule, 1);
  set(ImGuiCol_SeparatorHovered, theme.accent, 0.6F);
  set(ImGuiCol_SeparatorActive, theme.accent, 1);
  set(ImGuiCol_PlotLines, theme.local[0], 1);
  set(ImGuiCol_PlotLinesHovered, theme.accent, 1);
  set(ImGuiCol_PlotHistogram, theme.local[1], 1);
  set(ImGuiCol_PlotHistogramHovered, theme.accent, 1);
  set(ImGuiCol_DragDropTarget, theme.focus, 0.9F);
#if IMGUI_VERSION_NUM >= 19140
  set(ImGuiCol_NavCursor, theme.focus, 1);
#else
  set(ImGuiCol_NavHighlight, theme.focus, 1);
#endif
}

}  // namespace knotwork::web
