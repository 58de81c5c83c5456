#pragma once

#include "knotwork/surface/parametric_surface.h"

namespace knotwork {

/// The area of a surface, the integral of |S_u x S_v|, and a bound by experience on the error of `value`.
///
/// Gauss-Legendre (16 x 16 points) on every smooth cell; the cell with the largest error, by which its quarters differ
/// from it, is cut into quarters until the errors add up to less than 1e-13 of the area: relative accuracy 1e-12, with
/// poles at the ends of the domain too. Where S_u x S_v vanishes inside cells its length has an edge there, and the
/// cutting ends at 4096 cells more than 4 to each smooth one: `error` then says how near that came. Source: THEORY 2.9.
struct SurfaceArea {
  double value, error;
};
SurfaceArea surface_area(const SurfaceView& surface);

}  // namespace knotwork
