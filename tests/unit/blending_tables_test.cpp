#include "knotwork/mesh/blending_tables.h"

#include <numbers>
#include <string>

#include "unit/even_grid.h"
#include "unit/oracle.h"

namespace knotwork::blending_tables_test {
using namespace test;

namespace {

using std::numbers::pi;

BlendingSurface moved_surface(Topology topology_u, Topology topology_v) {
  const ModelSurface model = torus_surface(1, 0.4, 0.6);
  const KnotVector u = KnotVector::uniform(1, 3, topology_u, 0, 2 * pi).value();
  const KnotVector v = KnotVector::uniform(1, 4, topology_v, 0, 2 * pi).value();
  BlendingSurface surface =
      BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(model, u, v))
          .value();
  surface.set_local(0, 0, Eigen::Affine3d(Eigen::Translation3d(0.2, 0, 0.3) * surface.local(0, 0)));
  surface.set_local(2, 3, Eigen::Affine3d(surface.local(2, 3) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX())));
  return surface;
}

/// What the vertex shader does, in float32.
struct ShaderVertex {
  Eigen::Vector3f s, su, sv;
};

/// Bezier-Hermite locals: the four polynomials, each under its map, summed with the product rule.
ShaderVertex shade_polynomials(const BlendingTables& tables, const std::vector<float>& maps, int columns, std::size_t a,
                               std::size_t b) {
  const float *bu = &tables.blend_u[4 * a], *bv = &tables.blend_v[4 * b];
  const float* at_u = &tables.blend_u[4 * (a + static_cast<std::size_t>(tables.grid.columns()))];
  const float* at_v = &tables.blend_v[4 * (b + static_cast<std::size_t>(tables.grid.rows()))];
  ShaderVertex sum{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t l = 0; l < 2; ++l) {
      const int i = static_cast<int>(bu[2 + k]), j = static_cast<int>(bv[2 + l]);
      const float x = at_u[k], y = at_v[l];
      Eigen::Vector3f f = Eigen::Vector3f::Zero(), fu = f, fv = f;
      float x_power = 1, x_slope = 0;
      for (int p = 0; p <= tables.degree_u; ++p) {
        float y_power = 1, y_slope = 0;
        for (int q = 0; q <= tables.degree_v; ++q) {
          const int texel = ((i * (tables.degree_u + 1) + p) * columns + j) * (tables.degree_v + 1) + q;
          const Eigen::Vector3f c(&tables.coefficients[4 * static_cast<std::size_t>(texel)]);
          f += x_power * y_power * c;
          fu += x_slope * y_power * c;
          fv += x_power * y_slope * c;
          y_slope = y_slope * y + y_power;
          y_power *= y;
        }
        x_slope = x_slope * x + x_power;
        x_power *= x;
      }
      using Map = Eigen::Matrix<float, 3, 4, Eigen::RowMajor>;
      const Map map(&maps[12 * static_cast<std::size_t>(i * columns + j)]);
      const float wu = k == 0 ? 1 - bu[0] : bu[0], wv = l == 0 ? 1 - bv[0] : bv[0];
      const float wu_slope = k == 0 ? -bu[1] : bu[1], wv_slope = l == 0 ? -bv[1] : bv[1];
      const Eigen::Vector3f s = map.leftCols<3>() * f + map.col(3);
      sum.s += wu * wv * s;
      sum.su += wv * (wu_slope * s + wu * map.leftCols<3>() * fu);
      sum.sv += wu * (wv_slope * s + wv * map.leftCols<3>() * fv);
    }
  }
  return sum;
}

/// Sub-surfaces: the blend of four maps times the model point and its partials.
ShaderVertex shade(const BlendingTables& tables, const std::vector<float>& maps, int columns, std::size_t a,
                   std::size_t b) {
  if (tables.degree_u >= 0) return shade_polynomials(tables, maps, columns, a, b);
  const float *bu = &tables.blend_u[4 * a], *bv = &tables.blend_v[4 * b];
  const std::size_t vertex = 4 * (a * static_cast<std::size_t>(tables.grid.rows()) + b);
  using Map = Eigen::Matrix<float, 3, 4, Eigen::RowMajor>;
  const auto map = [&](float i, float j) {
    return Map(Eigen::Map<const Map>(
        &maps[12 * (static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(j))]));
  };
  const Map m00 = map(bu[2], bv[2]), m01 = map(bu[2], bv[3]), m10 = map(bu[3], bv[2]), m11 = map(bu[3], bv[3]);
  const Map low = (1 - bv[0]) * m00 + bv[0] * m01, high = (1 - bv[0]) * m10 + bv[0] * m11;
  const Map whole = (1 - bu[0]) * low + bu[0] * high, by_u = bu[1] * (high - low);
  const Map by_v = bv[1] * ((1 - bu[0]) * (m01 - m00) + bu[0] * (m11 - m10));
  const Eigen::Vector4f p(tables.points[vertex], tables.points[vertex + 1], tables.points[vertex + 2], 1);
  const Eigen::Vector3f pu(&tables.partials_u[vertex]), pv(&tables.partials_v[vertex]);
  return {whole * p, by_u * p + whole.leftCols<3>() * pu, by_v * p + whole.leftCols<3>() * pv};
}

}  // namespace

TEST_CASE("the shader's arithmetic on the tables gives the surface to float precision, in all four topologies") {
  for (const Topology topology_u : {Topology::open, Topology::closed}) {
    for (const Topology topology_v : {Topology::open, Topology::closed}) {
      const BlendingSurface surface = moved_surface(topology_u, topology_v);
      const BlendingTables tables = blending_tables(surface, test::grid_of(surface, 24, 20));
      const std::vector<float> maps = map_table(surface);
      REQUIRE(maps.size() == 12 * 12);
      REQUIRE(tables.grid.u.size() == static_cast<std::size_t>(tables.grid.columns()));
      REQUIRE(tables.grid.v.size() == static_cast<std::size_t>(tables.grid.rows()));
      REQUIRE(tables.blend_u.size() == 8 * tables.grid.u.size());
      REQUIRE(tables.blend_v.size() == 8 * tables.grid.v.size());
      REQUIRE(tables.points.size() == 4 * tables.grid.u.size() * tables.grid.v.size());
      CHECK(tables.grid.u.back() == surface.knots_u().end());
      CHECK(tables.grid.v.back() == surface.knots_v().end());
      for (std::size_t a = 0; a < tables.grid.u.size(); ++a) {
        for (std::size_t b = 0; b < tables.grid.v.size(); ++b) {
          const SurfaceJet jet = surface.evaluate(tables.grid.u[a], tables.grid.v[b]);
          const ShaderVertex vertex = shade(tables, maps, surface.knots_v().count(), a, b);
          REQUIRE(close(vertex.s.cast<double>(), jet.s, 1e-6, 1));
          REQUIRE(close(vertex.su.cast<double>(), jet.su, 2e-6, 1));
          REQUIRE(close(vertex.sv.cast<double>(), jet.sv, 2e-6, 1));
        }
      }
    }
  }
}

TEST_CASE("the shader's arithmetic over twisted seams: the model's point is shared, only the map is another's") {
  const double turn = 2 * pi;
  struct Row {
    const char* model;
    KnotVector u, v;
    int maps_u, maps_v;
  };
  const auto even = [](int n, Topology topology, double start, double end) {
    return KnotVector::uniform(1, n, topology, start, end).value();
  };
  const Row rows[] = {
      {"moebius", even(3, Topology::open, -1, 1), even(4, Topology::closed, -0.5 * pi, 1.5 * pi), 3, 5},
      {"figure-eight-klein-bottle", even(4, Topology::closed, 0, turn), even(3, Topology::closed, 0, turn), 5, 3},
      {"klein-bottle", even(3, Topology::closed, 0, turn), even(4, Topology::closed, 0, turn), 4, 4},
      {"cross-cap", even(3, Topology::closed, 0, pi), even(3, Topology::closed, 0, pi), 3, 4},
      {"moebius", even(3, Topology::open, -1, 1), even(4, Topology::open, -0.5 * pi, 1.5 * pi), 3, 4},
  };
  for (const Row& row : rows) {
    for (const LocalSurfaceKind kind : {LocalSurfaceKind::sub_surface, LocalSurfaceKind::bezier_hermite}) {
      CAPTURE(row.model);
      const ModelSurface model = make_catalogue_surface(row.model).value();
      BlendingSurface surface =
          BlendingSurface::make(model, row.u, row.v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                                BlendingSurface::unmoved_locals(model, row.u, row.v), {kind, 2, 3})
              .value();
      surface.set_local(0, 0, Eigen::Affine3d(Eigen::Translation3d(0.2, 0, 0.3) * surface.local(0, 0)));
      surface.set_local(2, 2, Eigen::Affine3d(surface.local(2, 2) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX())));
      const BlendingTables tables = blending_tables(surface, test::grid_of(surface, 24, 20));
      const MapCounts counts = map_counts(surface);
      CHECK(counts.u == row.maps_u);
      CHECK(counts.v == row.maps_v);
      CHECK(tables.points.empty() == (kind == LocalSurfaceKind::bezier_hermite));
      const std::vector<float> maps = map_table(surface);
      REQUIRE(maps.size() == static_cast<std::size_t>(12 * counts.u * counts.v));
      for (std::size_t a = 0; a < tables.grid.u.size(); ++a) {
        for (std::size_t b = 0; b < tables.grid.v.size(); ++b) {
          CAPTURE(a);
          CAPTURE(b);
          const SurfaceJet jet = surface.evaluate(tables.grid.u[a], tables.grid.v[b]);
          const ShaderVertex vertex = shade(tables, maps, counts.v, a, b);
          REQUIRE(close(vertex.s.cast<double>(), jet.s, 1e-6, 2));
          // The classic Klein bottle's partials jump where its pieces meet.
          if (row.model == std::string("klein-bottle")) continue;
          REQUIRE(close(vertex.su.cast<double>(), jet.su, 3e-6, 4));
          REQUIRE(close(vertex.sv.cast<double>(), jet.sv, 3e-6, 4));
          // The hues' weights: of the very locals that the CPU names.
          const auto weights = surface.weights(tables.grid.u[a], tables.grid.v[b]);
          double sum = 0;
          for (const BlendingSurface::Weight& w : weights) sum += w.value;
          REQUIRE(close(sum, 1, 1e-14));
        }
      }
      // Beyond a twisted seam the maps are those of the reflected locals.
      if (kind == LocalSurfaceKind::sub_surface && surface.twist_v()) {
        const auto row_of_maps = static_cast<std::size_t>(12 * counts.v);
        const std::size_t seam = 12 * static_cast<std::size_t>(row.v.count());
        const int image = surface.wrapped(0, row.v.count()).first;
        for (std::size_t k = 0; k < 12; ++k)
          CHECK(maps[seam + k] == maps[static_cast<std::size_t>(image) * row_of_maps + k]);
      }
    }
  }
}

TEST_CASE("a repeated seam is the same numbers twice") {
  const BlendingSurface surface = moved_surface(Topology::closed, Topology::closed);
  const BlendingTables tables = blending_tables(surface, test::grid_of(surface, 9, 8));
  const auto rows = static_cast<std::size_t>(tables.grid.rows()),
             last = static_cast<std::size_t>(tables.grid.columns()) - 1;
  for (std::size_t k = 0; k < 4 * rows; ++k) CHECK(tables.points[k] == tables.points[4 * last * rows + k]);
  for (std::size_t k = 0; k < 4; ++k) CHECK(tables.blend_u[k] == tables.blend_u[4 * last + k]);
  for (std::size_t k = 0; k < 4; ++k) CHECK(tables.blend_v[k] == tables.blend_v[4 * (rows - 1) + k]);
}

TEST_CASE("only the map table follows a moved local") {
  BlendingSurface surface = moved_surface(Topology::closed, Topology::open);
  const BlendingTables before = blending_tables(surface, test::grid_of(surface, 12, 12));
  const std::vector<float> maps_before = map_table(surface);
  surface.set_local(1, 2, Eigen::Affine3d(Eigen::Translation3d(0, 0, 1) * surface.local(1, 2)));
  const BlendingTables after = blending_tables(surface, test::grid_of(surface, 12, 12));
  CHECK(before.points == after.points);
  CHECK(before.partials_u == after.partials_u);
  CHECK(before.blend_v == after.blend_v);
  const std::vector<float> maps_after = map_table(surface);
  for (std::size_t k = 0; k < maps_after.size(); ++k) {
    const bool moved_entry = k == 12 * (1 * 4 + 2) + 11;
    CHECK((maps_after[k] != maps_before[k]) == moved_entry);
  }
}

}  // namespace knotwork::blending_tables_test
