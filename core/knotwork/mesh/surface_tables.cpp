#include "knotwork/mesh/surface_tables.h"

#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

void append_texel(std::vector<float>& out, const Eigen::Vector3d& x) {
  for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(x[k]));
  out.push_back(0);
}

}  // namespace

SurfaceTables surface_tables(const KnottedSurface& surface, int samples_u, int samples_v) {
  SampleGrid grid = sample_grid(*surface.knots_u, *surface.knots_v, samples_u, samples_v, Seam::repeated);
  SurfaceTables tables;
  tables.columns = static_cast<int>(grid.u.size());
  tables.rows = static_cast<int>(grid.v.size());
  tables.steps_u = grid.steps_u;
  tables.steps_v = grid.steps_v;
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
  tables.u = std::move(grid.u);
  tables.v = std::move(grid.v);
  return tables;
}

}  // namespace knotwork
