#pragma once

#include <vector>

#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/surface/knotted_surface.h"

namespace knotwork {

/// A surface on a grid as float textures: what the vertex shader reads of a surface that is evaluated here and not on
/// the GPU.
struct SurfaceTables {
  SampleGrid grid;
  /// x y z 0 a vertex, vertex a * rows + b for (u[a], v[b]) of the grid. Normals are unit_normal()'s, hence of length 1
  /// at poles too.
  std::vector<float> points, normals;
};
SurfaceTables surface_tables(const KnottedSurface& surface, SampleGrid grid);

}  // namespace knotwork
