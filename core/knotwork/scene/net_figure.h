#pragma once

#include <vector>

#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/objects.h"
#include "knotwork/scene/surface_builder.h"
#include "knotwork/surface/bspline_surface.h"

namespace knotwork::scene {

/// A stretch of a direction's knot lines, counted in knot intervals that are not empty, from the domain's start on. In a
/// closed direction it may begin before 0 and goes round with the number of these intervals.
struct CellRange {
  double start, end;
};
/// Knot intervals of the domain that are not empty.
int cell_count(const KnotVector& knots);
/// Where b_i is not 0: between t_i and t_{i+p+1}, in an open direction within the domain.
CellRange support_cells(const KnotVector& knots, int i);

/// A direction's basis functions with knots and samples as a curve's figure has them; the curve itself is a point.
CurveFigure basis_figure(const SplineDirection& direction, int count);

/// What stands on the stage of a B-spline surface, at rest or on its way between two topologies.
struct NetFigure {
  explicit NetFigure(const BSplineSurfaceObject& object);
  NetFigure(const BSplineSurfaceObject& object, const SplineDirection& other_u, const SplineDirection& other_v,
            Roll roll);

  /// The same with other points; knots and counts have not changed, nor has the roll.
  void move(const BSplineSurfaceObject& object, const SplineDirection& other_u, const SplineDirection& other_v,
            Roll roll);

  BSplineSurface surface;
  int rows, columns;             ///< of the net; while a direction rolls, the surface has ghosts of its first lines too
  CurveFigure basis_u, basis_v;  ///< of the object at rest
};

}  // namespace knotwork::scene
