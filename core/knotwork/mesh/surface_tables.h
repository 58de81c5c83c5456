#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/surface/knotted_surface.h"

namespace knotwork {

/// A surface on a grid as float textures: what the vertex shader reads of a surface that is evaluated here and not on
/// the GPU.
struct SurfaceTables {
  int columns = 0, rows = 0;  ///< vertices in u and v, seam repeated
  int steps_u = 1, steps_v = 1;
  /// x y z 0 a vertex, vertex a * rows + b for (u[a], v[b]). Normals are unit_normal()'s, hence of length 1 at poles too.
  std::vector<float> points, normals;
  std::vector<double> u, v;  ///< the grid's parameters
};
SurfaceTables surface_tables(const KnottedSurface& surface, int samples_u, int samples_v);

}  // namespace knotwork
