#include "web/theme.h"

#include <cmath>

namespace knotwork::web {
namespace {

constexpr Colour rgb(unsigned hex) {
  return {static_cast<float>((hex >> 16) & 255u) / 255.0F, static_cast<float>((hex >> 8) & 255u) / 255.0F,
          static_cast<float>(hex & 255u) / 255.0F};
}

}  // namespace

Theme make_theme(bool dark) {
  Theme theme;
  theme.dark = dark;
  if (dark) {
    theme.paper = rgb(0x15171a);
    theme.panel = rgb(0x1e2125);
    theme.panel_opacity = 0.92F;
    theme.ink = rgb(0xe8e6e1);
    theme.ink_soft = rgb(0xa2a7ad);
    theme.rule = rgb(0x2c3036);
    theme.stage = rgb(0x101214);
    theme.stage_edge = rgb(0x1b1e22);
    theme.accent = rgb(0xf0875f);
    theme.focus = rgb(0x6db3ff);
    theme.local = {rgb(0x5aa9e0), rgb(0xf2aa4b), rgb(0x66c092), rgb(0xd98bc3)};
  } else {
    theme.paper = rgb(0xfbfaf7);
    theme.panel = rgb(0xffffff);
    theme.panel_opacity = 0.9F;
    theme.ink = rgb(0x22262b);
    theme.ink_soft = rgb(0x5d656e);
    theme.rule = rgb(0xe4e1da);
    theme.stage = rgb(0xf1efe9);
    theme.stage_edge = rgb(0xe6e3db);
    theme.accent = rgb(0xb4431f);
    theme.focus = rgb(0x0b62c4);
    theme.local = {rgb(0x2f7fb8), rgb(0xe08a1e), rgb(0x3f9a6b), rgb(0xb65a9c)};
  }
  return theme;
}

Colour mixed(const Colour& from, const Colour& to, float share) {
  return {std::lerp(from[0], to[0], share), std::lerp(from[1], to[1], share), std::lerp(from[2], to[2], share)};
}

}  // namespace knotwork::web
