#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "knotwork/mesh/surface_sampling.h"
#include "property/surface_cases.h"

namespace knotwork::surface_sampling_laws_test {
using namespace test;

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Eigen::Vector3d point(const std::vector<float>& array, std::size_t vertex) {
  return {array[3 * vertex], array[3 * vertex + 1], array[3 * vertex + 2]};
}

/// How often each directed edge occurs.
std::map<Edge, int> directed_edges(const MeshData& mesh) {
  std::map<Edge, int> edges;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[t + k], mesh.indices[t + (k + 1) % 3]}];
  }
  return edges;
}

int euler_characteristic(const MeshData& mesh) {
  std::set<Edge> edges;
  for (const auto& [edge, count] : directed_edges(mesh)) {
    edges.insert({std::min(edge.first, edge.second), std::max(edge.first, edge.second)});
  }
  return static_cast<int>(mesh.vertex_count()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangle_count());
}

std::size_t boundary_edges(const std::map<Edge, int>& edges) {
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& entry) {
    return !edges.contains({entry.first.second, entry.first.first});
  }));
}

}  // namespace

TEST_CASE("joined meshes are watertight manifolds with the surface's topology") {
  for (const SurfaceCase& entry : surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    for (const int samples : {1, 7}) {
      const MeshData mesh = sample(surface, samples, samples, Seam::joined);
      const SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), samples, samples, Seam::joined);
      const std::map<Edge, int> edges = directed_edges(mesh);
      // Each directed edge once: no edge has more than two triangles, and neighbours turn the same way.
      CHECK(std::all_of(edges.begin(), edges.end(), [](const auto& counted) { return counted.second == 1; }));

      const bool u = surface.knots_u().closed(), v = surface.knots_v().closed();
      CHECK(euler_characteristic(mesh) == (u || v ? 0 : 1));
      const std::size_t rim_u = u ? 0 : grid.v.size() - (v ? 0 : 1), rim_v = v ? 0 : grid.u.size() - (u ? 0 : 1);
      CHECK(boundary_edges(edges) == 2 * (rim_u + rim_v));
      const auto largest = *std::max_element(mesh.indices.begin(), mesh.indices.end());
      CHECK(largest == mesh.vertex_count() - 1);
    }
  }
}

TEST_CASE("a repeated seam has the same positions and normals bit for bit, at both parameters") {
  int seams = 0;
  for (const SurfaceCase& entry : surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    CAPTURE(entry.name);
    const MeshData mesh = sample(surface, 6, 5, Seam::repeated);
    const SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), 6, 5, Seam::repeated);
    const std::size_t columns = grid.u.size(), rows = grid.v.size();
    const auto same = [&](std::size_t a, std::size_t b) {
      return point(mesh.positions, a) == point(mesh.positions, b) && point(mesh.normals, a) == point(mesh.normals, b);
    };
    if (surface.knots_u().closed()) {
      for (std::size_t b = 0; b < rows; ++b) CHECK(same(b, (columns - 1) * rows + b));
      CHECK(mesh.parameters[0] != mesh.parameters[2 * (columns - 1) * rows]);
      ++seams;
    }
    if (surface.knots_v().closed()) {
      for (std::size_t a = 0; a < columns; ++a) CHECK(same(a * rows, a * rows + rows - 1));
      CHECK(mesh.parameters[1] != mesh.parameters[2 * (rows - 1) + 1]);
      ++seams;
    }
  }
  CHECK(seams > 50);
}

TEST_CASE("normals are unit vectors and agree with the turn of the triangles") {
  for (const SurfaceCase& entry : surface_cases()) {
    // Gentle moves, so that a coarse mesh follows the surface: strong ones fold it.
    const BlendingSurface& moved_surface = entry.surface;
    BlendingSurface surface =
        unmoved(moved_surface.model(), moved_surface.knots_u(), moved_surface.knots_v(), moved_surface.blending());
    surface.set_local(0, 1, Eigen::Translation3d(0.02, 0.03, 0.02) * surface.local(0, 1));
    CAPTURE(entry.name);
    const MeshData mesh = sample(surface, 60, 60, Seam::joined);
    int wrong = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const std::size_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
      const Eigen::Vector3d turn = (point(mesh.positions, b) - point(mesh.positions, a))
                                       .cross(point(mesh.positions, c) - point(mesh.positions, a));
      for (const std::size_t vertex : {a, b, c}) wrong += turn.dot(point(mesh.normals, vertex)) > 0 ? 0 : 1;
    }
    CHECK(wrong == 0);
    for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
      REQUIRE(close(point(mesh.normals, k).norm(), 1, 1e-6));
    }
  }
}

TEST_CASE("every knot is a sample") {
  for (const SurfaceCase& entry : surface_cases()) {
    const BlendingSurface& surface = entry.surface;
    const SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), 10, 3, Seam::joined);
    for (int i = 0; i < surface.knots_u().count(); ++i) {
      CHECK(std::binary_search(grid.u.begin(), grid.u.end(), surface.centre(i, 0).x()));
    }
    for (int j = 0; j < surface.knots_v().count(); ++j) {
      CHECK(std::binary_search(grid.v.begin(), grid.v.end(), surface.centre(0, j).y()));
    }
    CHECK(std::is_sorted(grid.u.begin(), grid.u.end()));
    CHECK(std::is_sorted(grid.v.begin(), grid.v.end()));
  }
}

}  // namespace knotwork::surface_sampling_laws_test
