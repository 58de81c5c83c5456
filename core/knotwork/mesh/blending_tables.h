#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"

namespace knotwork {

/// The static part of a blending surface on a grid, for the vertex shader's fast path (DESIGN "Blending surface, fast
/// path"): model points and partials never change while only the local maps move.
struct BlendingTables {
  int columns = 0, rows = 0;  ///< vertices in u and v, seam repeated
  int steps_u = 1, steps_v = 1;
  /// x y z 0 a vertex, vertex a * rows + b for (u[a], v[b]).
  std::vector<float> points, partials_u, partials_v;
  /// Four floats a column (row): B(w), B'(w) delta, first local index, second local index.
  std::vector<float> blend_u, blend_v;
  std::vector<double> u, v;  ///< the grid's parameters
};
BlendingTables blending_tables(const BlendingSurface& surface, int samples_u, int samples_v);

/// The dynamic part: 12 floats a local (i,j) at index i * n_v + j, the rows of the 3x4 map M^_ij.
std::vector<float> map_table(const BlendingSurface& surface);

}  // namespace knotwork
