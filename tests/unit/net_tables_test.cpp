#include "knotwork/mesh/net_tables.h"

#include <cmath>
#include <vector>

#include "unit/even_grid.h"
#include "unit/oracle.h"

namespace knotwork::net_tables_test {
using namespace test;

namespace {

BSplineSurface surface_of(int p, int q, Topology topology_u, Topology topology_v) {
  const KnotVector u = KnotVector::uniform(p, 6, topology_u, 0, 2).value();
  const KnotVector v = KnotVector::uniform(q, 5, topology_v, -1, 1).value();
  std::vector<Eigen::Vector3d> points;
  points.reserve(30);
  for (int k = 0; k < 30; ++k) points.emplace_back(std::sin(1.0 * k), std::cos(2.0 * k), 0.1 * k);
  return BSplineSurface::make(u, v, std::move(points)).value();
}

/// What the vertex shader does, in float32.
struct ShaderVertex {
  Eigen::Vector3f s, su, sv;
};
ShaderVertex shade(const NetTables& tables, const std::vector<float>& net, int n_u, int n_v, std::size_t a,
                   std::size_t b) {
  const auto at = [](const std::vector<float>& table, std::size_t across, std::size_t place, int row) {
    return &table[4 * (static_cast<std::size_t>(row) * across + place)];
  };
  const std::size_t columns = tables.grid.u.size(), rows = tables.grid.v.size();
  const int first_u = static_cast<int>(at(tables.basis_u, columns, a, 0)[0]);
  const int first_v = static_cast<int>(at(tables.basis_v, rows, b, 0)[0]);
  ShaderVertex sum{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  for (int i = 0; i <= tables.degree_u; ++i) {
    for (int j = 0; j <= tables.degree_v; ++j) {
      const float *bu = at(tables.basis_u, columns, a, 1 + i), *bv = at(tables.basis_v, rows, b, 1 + j);
      const Eigen::Vector3f c(&net[4 * static_cast<std::size_t>((first_u + i) % n_u * n_v + (first_v + j) % n_v)]);
      sum.s += bu[0] * bv[0] * c;
      sum.su += bu[1] * bv[0] * c;
      sum.sv += bu[0] * bv[1] * c;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("the shader's arithmetic on a net's tables gives the surface to float precision") {
  constexpr Topology open = Topology::open, closed = Topology::closed;
  struct Row {
    int p, q;
    Topology topology_u, topology_v;
  };
  for (const Row& row :
       {Row{3, 3, open, open}, Row{3, 2, closed, open}, Row{1, 4, open, closed}, Row{5, 3, closed, closed}}) {
    const auto& [p, q, topology_u, topology_v] = row;
    CAPTURE(row.p);
    CAPTURE(row.q);
    const BSplineSurface surface = surface_of(p, q, topology_u, topology_v);
    const NetTables tables = net_tables(surface, test::grid_of(surface, 20, 15));
    const std::vector<float> net = point_table(surface);
    REQUIRE(net.size() == 4 * 30);
    REQUIRE(tables.basis_u.size() == 4 * static_cast<std::size_t>((p + 2) * tables.grid.columns()));
    REQUIRE(tables.basis_v.size() == 4 * static_cast<std::size_t>((q + 2) * tables.grid.rows()));
    for (std::size_t a = 0; a < tables.grid.u.size(); ++a) {
      for (std::size_t b = 0; b < tables.grid.v.size(); ++b) {
        const SurfaceJet jet = surface.evaluate(tables.grid.u[a], tables.grid.v[b]);
        const ShaderVertex vertex = shade(tables, net, 6, 5, a, b);
        REQUIRE(close(vertex.s.cast<double>(), jet.s, 1e-6, 3));
        REQUIRE(close(vertex.su.cast<double>(), jet.su, 2e-6, 10));
        REQUIRE(close(vertex.sv.cast<double>(), jet.sv, 2e-6, 10));
      }
    }
  }
}

TEST_CASE("a net's repeated seam is the same numbers twice, and only the points follow a moved one") {
  const BSplineSurface surface = surface_of(3, 2, Topology::closed, Topology::closed);
  const NetTables tables = net_tables(surface, test::grid_of(surface, 12, 10));
  const std::size_t columns = tables.grid.u.size();
  for (std::size_t row = 0; row < 5; ++row) {
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(tables.basis_u[4 * row * columns + k] == tables.basis_u[4 * ((row + 1) * columns - 1) + k]);
  }

  std::vector<Eigen::Vector3d> points(surface.points().begin(), surface.points().end());
  points[7].z() += 1;
  const BSplineSurface moved = BSplineSurface::make(surface.knots_u(), surface.knots_v(), points).value();
  CHECK(net_tables(moved, test::grid_of(moved, 12, 10)).basis_u == tables.basis_u);
  CHECK(net_tables(moved, test::grid_of(moved, 12, 10)).basis_v == tables.basis_v);
  const std::vector<float> before = point_table(surface), after = point_table(moved);
  for (std::size_t k = 0; k < before.size(); ++k) CHECK((before[k] != after[k]) == (k == 4 * 7 + 2));
}

}  // namespace knotwork::net_tables_test
