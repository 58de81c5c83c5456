#include "knotwork/mesh/net_tables.h"

#include <array>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/mesh/texel.h"

namespace knotwork {
namespace {

std::vector<float> basis_table(const KnotVector& knots, std::span<const double> t) {
  const std::size_t functions = static_cast<std::size_t>(knots.degree()) + 1, row = 4 * t.size();
  std::vector<float> table((functions + 1) * row);
  std::array<double, 2 * (KnotVector::max_degree + 1)> basis;
  int span = knots.degree();
  for (std::size_t a = 0; a < t.size(); ++a) {
    const double x = knots.reduced(t[a]);
    span = knots.span(x, span);
    bspline_basis(knots, span, x, 1, std::span(basis).first(2 * functions));
    table[4 * a] = static_cast<float>(span - knots.degree());
    for (std::size_t k = 0; k < functions; ++k) {
      float* texel = &table[(k + 1) * row + 4 * a];
      texel[0] = static_cast<float>(basis[k]);
      texel[1] = static_cast<float>(basis[functions + k]);
    }
  }
  return table;
}

}  // namespace

NetTables net_tables(const BSplineSurface& surface, SampleGrid grid) {
  NetTables tables;
  tables.degree_u = surface.knots_u().degree();
  tables.degree_v = surface.knots_v().degree();
  tables.basis_u = basis_table(surface.knots_u(), grid.u);
  tables.basis_v = basis_table(surface.knots_v(), grid.v);
  tables.grid = std::move(grid);
  return tables;
}

std::vector<float> point_table(const BSplineSurface& surface) {
  std::vector<float> table;
  table.reserve(4 * surface.points().size());
  for (const Eigen::Vector3d& point : surface.points()) append_texel(table, point);
  return table;
}

}  // namespace knotwork
