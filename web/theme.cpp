#include "web/theme.h"

#include <algorithm>
#include <cmath>

namespace knotwork::web {
namespace {

constexpr Colour rgb(unsigned hex) {
  return {static_cast<float>((hex >> 16) & 255u) / 255.0F, static_cast<float>((hex >> 8) & 255u) / 255.0F,
          static_cast<float>(hex & 255u) / 255.0F};
}

float linear_from_srgb(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }

float srgb_from_linear(float c) {
  const float limited = std::clamp(c, 0.0F, 1.0F);
  return limited <= 0.0031308F ? 12.92F * limited : 1.055F * std::pow(limited, 1 / 2.4F) - 0.055F;
}

}  // namespace

glm::vec3 oklab(const Colour& colour) {
  const float r = linear_from_srgb(colour[0]), g = linear_from_srgb(colour[1]), b = linear_from_srgb(colour[2]);
  const float l = std::cbrt(0.4122214708F * r + 0.5363325363F * g + 0.0514459929F * b);
  const float m = std::cbrt(0.2119034982F * r + 0.6806995451F * g + 0.1073969566F * b);
  const float s = std::cbrt(0.0883024619F * r + 0.2817188376F * g + 0.6299787005F * b);
  return {0.2104542553F * l + 0.7936177850F * m - 0.0040720468F * s,
          1.9779984951F * l - 2.4285922050F * m + 0.4505937099F * s,
          0.0259040371F * l + 0.7827717662F * m - 0.8086757660F * s};
}

Colour srgb(const glm::vec3& oklab) {
  const auto cube = [](float x) { return x * x * x; };
  const float l = cube(oklab.x + 0.3963377774F * oklab.y + 0.2158037573F * oklab.z);
  const float m = cube(oklab.x - 0.1055613458F * oklab.y - 0.0638541728F * oklab.z);
  const float s = cube(oklab.x - 0.0894841775F * oklab.y - 1.2914855480F * oklab.z);
  return {srgb_from_linear(4.0767416621F * l - 3.3077115913F * m + 0.2309699292F * s),
          srgb_from_linear(-1.2684380046F * l + 2.6097574011F * m - 0.3413193965F * s),
          srgb_from_linear(-0.0041960863F * l - 0.7034186147F * m + 1.7076147010F * s)};
}

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
