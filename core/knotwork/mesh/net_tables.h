#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/surface/bspline_surface.h"

namespace knotwork {

/// The static part of a B-spline surface on a grid, for the vertex shader: it never changes while only control points
/// move. Nothing a vertex, only a column and a row of the grid.
struct NetTables {
  SampleGrid grid;
  int degree_u = 1, degree_v = 1;
  /// Rows of four floats a column of the grid (basis_v: a row of it): first the index of the first function that is not
  /// zero, which in a closed direction goes round, then for each of the p+1 functions b_k, b_k', 0, 0.
  std::vector<float> basis_u, basis_v;
};
/// Precondition: the grid is of the surface's knots.
NetTables net_tables(const BSplineSurface& surface, SampleGrid grid);

/// The moving part: x y z 0 of c_ij at i * n_v + j.
std::vector<float> point_table(const BSplineSurface& surface);

}  // namespace knotwork
