#include "knotwork/mesh/surface_sampling.h"

#include <numbers>

#include "knotwork/surface/surface_measures.h"
#include "unit/oracle.h"

namespace knotwork::surface_sampling_test {
using namespace test;

namespace {

using std::numbers::pi;
using Indices = std::vector<std::uint32_t>;

KnotVector knots(int n, Topology topology, double start, double end) {
  return KnotVector::uniform(1, n, topology, start, end).value();
}

BlendingSurface surface_of(const ModelSurface& model, const KnotVector& u, const KnotVector& v) {
  return BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                               BlendingSurface::unmoved_locals(model, u, v))
      .value();
}

}  // namespace

TEST_CASE("a sample grid has whole steps in each interval and every knot") {
  const KnotVector open = KnotVector::make(1, Topology::open, {0, 0, 0.25, 1, 1}).value();
  const KnotVector closed = knots(4, Topology::closed, -2, 2);
  const SampleGrid grid = sample_grid(open, closed, 3, 5, Seam::repeated);
  CHECK(grid.starts_u == std::vector<int>{0, 2, 4});
  CHECK(grid.starts_v == std::vector<int>{0, 2, 4, 6, 8});
  CHECK(grid.u == std::vector<double>{0, 0.125, 0.25, 0.625, 1});
  CHECK(grid.v == std::vector<double>{-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2});
  const SampleGrid joined = sample_grid(open, closed, 3, 5, Seam::joined);
  CHECK(joined.starts_v == grid.starts_v);
  CHECK(joined.u == grid.u);
  CHECK(joined.v == std::vector<double>{-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5});
}

TEST_CASE("at least one step an interval, three round a closed direction, no more than the limit") {
  const KnotVector open = knots(5, Topology::open, 0, 1), closed = knots(2, Topology::closed, 0, 1);
  for (const int samples : {-2000000000, -1, 0, 1}) {
    const SampleGrid grid = sample_grid(open, closed, samples, samples, Seam::joined);
    CHECK(grid.u.size() == 5);
    CHECK(grid.v.size() == 4);
  }
  CHECK(sample_grid(open, closed, 2000000000, 3, Seam::joined).u.size() == max_samples + 1);
}

TEST_CASE("each interval may have steps of its own") {
  const KnotVector open = KnotVector::make(1, Topology::open, {0, 0, 0.25, 1, 1}).value();
  const KnotVector closed = knots(3, Topology::closed, 0, 3);
  const SampleGrid grid = sample_grid(open, closed, {{1, 3}, {2, 1, 4}}, Seam::repeated);
  CHECK(grid.u == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(grid.v == std::vector<double>{0, 0.5, 1, 2, 2.25, 2.5, 2.75, 3});
  CHECK(grid.starts_u == std::vector<int>{0, 1, 4});
  CHECK(grid.starts_v == std::vector<int>{0, 2, 3, 7});
  CHECK(grid.columns() == 5);
  CHECK(grid.rows() == 8);
}

TEST_CASE("empty knot intervals are not sampled") {
  const KnotVector repeated = KnotVector::make(2, Topology::open, {0, 0, 0, 1, 1, 3, 3, 3}).value();
  const SampleGrid grid = sample_grid(repeated, repeated, 4, 2, Seam::joined);
  CHECK(grid.u == std::vector<double>{0, 0.5, 1, 2, 3});
  CHECK(grid.v == std::vector<double>{0, 1, 3});
}

TEST_CASE("grid triangles turn from u to v and wrap where told") {
  CHECK(grid_indices(2, 2, false, false) == Indices{0, 2, 3, 0, 3, 1});
  CHECK(grid_indices(2, 3, false, false).size() == 12);
  CHECK(grid_indices(3, 2, true, false).size() == 18);
  CHECK(grid_indices(3, 3, true, true).size() == 54);
  CHECK(grid_indices(1, 5, false, false).empty());
  const Indices wrapped = grid_indices(3, 2, true, false);
  CHECK(Indices(wrapped.end() - 6, wrapped.end()) == Indices{4, 0, 1, 4, 1, 5});
}

TEST_CASE("positions, normals and parameters are the surface's") {
  BlendingSurface surface =
      surface_of(torus_surface(), knots(3, Topology::closed, 0, 2 * pi), knots(4, Topology::closed, 0, 2 * pi));
  surface.set_local(1, 1, Eigen::Affine3d(surface.local(1, 1) * Eigen::Scaling(1.5)));
  const MeshData mesh = sample(surface, 30, 20, Seam::repeated);
  const SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), 30, 20, Seam::repeated);
  REQUIRE(mesh.vertex_count() == grid.u.size() * grid.v.size());
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  REQUIRE(mesh.parameters.size() == 2 * mesh.vertex_count());
  CHECK(mesh.triangle_count() == 2 * (grid.u.size() - 1) * (grid.v.size() - 1));
  std::size_t n = 0;
  for (const double u : grid.u) {
    for (const double v : grid.v) {
      const SurfaceJet jet = surface.evaluate(u, v);
      const Eigen::Vector3d normal = unit_normal(jet);
      for (int k = 0; k < 3; ++k) {
        const std::size_t at = 3 * n + static_cast<std::size_t>(k);
        REQUIRE(mesh.positions[at] == static_cast<float>(jet.s[k]));
        REQUIRE(mesh.normals[at] == static_cast<float>(normal[k]));
      }
      REQUIRE(mesh.parameters[2 * n] == static_cast<float>(u));
      REQUIRE(mesh.parameters[2 * n + 1] == static_cast<float>(v));
      ++n;
    }
  }
}

TEST_CASE("64 x 64 patches and 1024 x 1024 samples are within the limits") {
  const BlendingSurface surface =
      surface_of(Sheet{}, knots(64, Topology::closed, -pi, pi), knots(64, Topology::closed, -pi, pi));
  const MeshData mesh = sample(surface, 1024, 1024, Seam::joined);
  CHECK(mesh.vertex_count() == 1024 * 1024);
  CHECK(mesh.triangle_count() == 2 * 1024 * 1024);
}

TEST_CASE("a joined twisted seam joins each vertex with its reflection") {
  const auto at = [](const MeshData& mesh, std::uint32_t n) {
    return Eigen::Vector3d(static_cast<double>(mesh.positions[3 * n]), static_cast<double>(mesh.positions[3 * n + 1]),
                           static_cast<double>(mesh.positions[3 * n + 2]));
  };
  for (const char* id : {"moebius", "figure-eight-klein-bottle", "steiner"}) {
    CAPTURE(id);
    const ModelSurface model = make_catalogue_surface(id).value();
    const SurfaceDomain where = domain(model);
    const auto direction = [&](const Interval& range, Closure closure) {
      return knots(4, closure == Closure::open ? Topology::open : Topology::closed, range.start, range.end);
    };
    const BlendingSurface surface =
        surface_of(model, direction(where.u, where.closure_u), direction(where.v, where.closure_v));
    const MeshData mesh = sample(surface, 64, 64, Seam::joined);
    double longest = 0;
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::Vector3d edge = at(mesh, mesh.indices[k + c]) - at(mesh, mesh.indices[k + (c + 1) % 3]);
        longest = std::max(longest, edge.norm());
      }
    }
    // Joined the wrong way round, an edge would cross the whole width.
    CHECK(longest < 0.4);
  }
}

}  // namespace knotwork::surface_sampling_test
