#pragma once

#include <cmath>

#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/taylor2_point.h"

namespace knotwork {

/// What of the sheet depends on u alone, and what on v alone: its point is (x + p cos, y + p sin, q).
template <class Series>
struct SheetAlongU {
  Series x, y, cos, sin;
};
template <class Series>
struct SheetAlongV {
  Series p, q;
};

template <class Series>
SheetAlongU<Series> sheet_along_u(const Sheet& m, const Series& u) {
  const double a = m.bend_u, radius = std::lerp(m.flat_radius_u, m.closed_radius_u, a);
  return {radius * a * (1 - u * u * cosc(a * u)), radius * u * sinc(a * u), cos(a * u), sin(a * u)};
}
template <class Series>
SheetAlongV<Series> sheet_along_v(const Sheet& m, const Series& v) {
  const double b = m.bend_v, radius = std::lerp(m.flat_radius_v, m.closed_radius_v, b);
  return {radius * b * (1 - v * v * cosc(b * v)), radius * v * sinc(b * v)};
}

/// The sheet on any truncated series.
template <class Series>
PointOf<Series> sheet_formula(const Sheet& m, const Series& u, const Series& v) {
  const SheetAlongU<Series> f = sheet_along_u(m, u);
  const SheetAlongV<Series> g = sheet_along_v(m, v);
  return {f.x + g.p * f.cos, f.y + g.p * f.sin, g.q};
}

}  // namespace knotwork
