#include "knotwork/mesh/surface_tables.h"

#include "knotwork/mesh/texel.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork {

SurfaceTables surface_tables(const KnottedSurface& surface, SampleGrid grid) {
  SurfaceTables tables;
  tables.points.reserve(4 * grid.u.size() * grid.v.size());
  tables.normals.reserve(4 * grid.u.size() * grid.v.size());
  std::vector<SurfaceJet> jets(grid.v.size());
  for (const double& u : grid.u) {
    surface.evaluate_grid({&u, 1}, grid.v, jets);
    for (const SurfaceJet& jet : jets) {
      append_texel(tables.points, jet.s);
      append_texel(tables.normals, unit_normal(jet));
    }
  }
  tables.grid = std::move(grid);
  return tables;
}

}  // namespace knotwork
