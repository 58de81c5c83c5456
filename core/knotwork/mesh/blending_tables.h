#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"

namespace knotwork {

/// How many maps there are each way: n_u x n_v, and one row or column more at a twisted seam, for BlendingSurface's
/// wrapped locals of index n.
struct MapCounts {
  int u, v;
};
MapCounts map_counts(const BlendingSurface& surface);

/// The static part of a blending surface on a grid, for the vertex shader's fast path (DESIGN "Blending surface, fast
/// path"): it never changes while only the local maps move. Sub-surfaces need the model's points and partials at the
/// vertices, Bezier-Hermite locals their polynomials and nothing a vertex.
struct BlendingTables {
  SampleGrid grid;
  /// x y z 0 a vertex, vertex a * rows + b for (u[a], v[b]) of the grid. Of sub-surfaces only.
  std::vector<float> points, partials_u, partials_v;
  /// Two rows of four floats a column of the grid (blend_v: a row of it):
  ///   B(w), B'(w) delta, first local index, second local index;
  ///   u minus the centre of the first local, u minus that of the second, u, 0.
  /// The second index is 0 again where a closed direction wraps, but n at a twisted seam, beyond which other locals
  /// meet.
  std::vector<float> blend_u, blend_v;
  /// Degrees of the Bezier-Hermite locals, -1 of sub-surfaces.
  int degree_u = -1, degree_v = -1;
  /// x y z 0 of c_pq of local (i,j) at ((i (d_u+1) + p) counts.v + j) (d_v+1) + q, the locals counted as the maps are.
  /// Beyond a twisted seam a local sees the other parameter from the other side: its odd coefficients are negative.
  std::vector<float> coefficients;
  MapCounts counts{0, 0};
};
/// Precondition: the grid is of the surface's knots with the seam repeated, and as twisted seams need it: steps that a
/// seam reflects onto each other are equal.
BlendingTables blending_tables(const BlendingSurface& surface, SampleGrid grid);

/// The dynamic part: 12 floats a local (i,j) at index i * counts.v + j, the rows of the 3x4 map M^_ij of a sub-surface
/// or M_ij of a Bezier-Hermite local.
std::vector<float> map_table(const BlendingSurface& surface);
/// The same into memory that is there already, which grows only with the number of locals.
void map_table(const BlendingSurface& surface, std::vector<float>& table);

}  // namespace knotwork
