#pragma once

#include <cmath>

#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/taylor2_point.h"

namespace knotwork {

/// The sheet on any truncated series.
template <class Series>
PointOf<Series> sheet_formula(const Sheet& m, const Series& u, const Series& v) {
  const double a = m.bend_u, b = m.bend_v;
  const double radius_u = std::lerp(m.flat_radius_u, m.closed_radius_u, a);
  const double radius_v = std::lerp(m.flat_radius_v, m.closed_radius_v, b);
  const Series p = radius_v * b * (1 - v * v * cosc(b * v));
  const Series q = radius_v * v * sinc(b * v);
  return {radius_u * a * (1 - u * u * cosc(a * u)) + p * cos(a * u), radius_u * u * sinc(a * u) + p * sin(a * u), q};
}

}  // namespace knotwork
