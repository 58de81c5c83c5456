#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"

namespace knotwork {

/// The static part of a blending surface on a grid, for the vertex shader's fast path (DESIGN "Blending surface, fast
/// path"): model points and partials never change while only the local maps move.
///
/// Bezier-Hermite locals do not share one model point. Their tables hold the points and partials of the surface itself,
/// as its maps have it now, and the maps are identities; indices and weights still mix the hues.
struct BlendingTables {
  int columns = 0, rows = 0;  ///< vertices in u and v, seam repeated
  int steps_u = 1, steps_v = 1;
  /// x y z 0 a vertex, vertex a * rows + b for (u[a], v[b]).
  std::vector<float> points, partials_u, partials_v;
  /// Four floats a column (row): B(w), B'(w) delta, first local index, second local index. The second one is 0 again
  /// where a closed direction wraps, but n at a twisted seam, beyond which other locals meet.
  std::vector<float> blend_u, blend_v;
  std::vector<double> u, v;  ///< the grid's parameters
};
BlendingTables blending_tables(const BlendingSurface& surface, int samples_u, int samples_v);

/// Whether the tables' points move with the local maps.
bool tables_follow_maps(const BlendingSurface& surface);

/// How many maps there are each way: n_u x n_v, and one row or column more at a twisted seam, for BlendingSurface's
/// wrapped locals of index n.
struct MapCounts {
  int u, v;
};
MapCounts map_counts(const BlendingSurface& surface);

/// The dynamic part: 12 floats a local (i,j) at index i * counts.v + j, the rows of the 3x4 map M^_ij.
std::vector<float> map_table(const BlendingSurface& surface);

}  // namespace knotwork
