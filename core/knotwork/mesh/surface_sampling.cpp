#include "knotwork/mesh/surface_sampling.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

std::vector<int> even_steps(const KnotVector& knots, int samples) {
  const auto intervals = static_cast<int>(knot_intervals(knots).size());
  const int least = knots.closed() ? 3 : 1;
  const int wanted = std::clamp(samples, least, max_samples);
  return std::vector<int>(static_cast<std::size_t>(intervals), (wanted + intervals - 1) / intervals);
}

void add_samples(std::vector<double>& t, std::vector<int>& starts, const KnotVector& knots, std::span<const int> steps,
                 Seam seam) {
  const int count = std::accumulate(steps.begin(), steps.end(), 0);
  t.reserve(static_cast<std::size_t>(count) + 1);
  starts.reserve(steps.size() + 1);
  for (const Interval& interval : knot_intervals(knots)) {
    const int here = steps[starts.size()];
    starts.push_back(static_cast<int>(t.size()));
    for (int k = 0; k < here; ++k)
      t.push_back(interval.start + (interval.end - interval.start) * (static_cast<double>(k) / here));
  }
  starts.push_back(count);
  if (!knots.closed() || seam == Seam::repeated) t.push_back(knots.end());
}

void part(std::vector<double>& samples, std::vector<int>& starts, bool closed) {
  std::vector<double> parted;
  parted.reserve(samples.size() + starts.size());
  const std::size_t last = starts.size() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    const auto first = static_cast<std::size_t>(starts[k]), end = static_cast<std::size_t>(starts[k + 1]);
    starts[k] = static_cast<int>(parted.size());
    for (std::size_t i = first; i < end; ++i) parted.push_back(samples[i]);
    if (k + 1 < last) parted.push_back(just_before(samples[end]));
  }
  starts[last] = static_cast<int>(parted.size());
  parted.push_back(closed ? just_before(samples.back()) : samples.back());
  samples = std::move(parted);
}

void append(std::vector<float>& out, const Eigen::Vector3d& x) {
  for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(x[k]));
}

}  // namespace

SampleGrid sample_grid(const KnotVector& knots_u, const KnotVector& knots_v, const GridSteps& steps, Seam seam) {
  SampleGrid grid;
  add_samples(grid.u, grid.starts_u, knots_u, steps.u, seam);
  add_samples(grid.v, grid.starts_v, knots_v, steps.v, seam);
  return grid;
}

GridSteps even_steps(const KnotVector& knots_u, const KnotVector& knots_v, int samples_u, int samples_v) {
  return {even_steps(knots_u, samples_u), even_steps(knots_v, samples_v)};
}

SampleGrid sample_grid(const KnotVector& knots_u, const KnotVector& knots_v, int samples_u, int samples_v, Seam seam) {
  return sample_grid(knots_u, knots_v, even_steps(knots_u, knots_v, samples_u, samples_v), seam);
}

SampleGrid parted_at_knots(SampleGrid grid, const KnotVector& knots_u, const KnotVector& knots_v) {
  part(grid.u, grid.starts_u, knots_u.closed());
  part(grid.v, grid.starts_v, knots_v.closed());
  grid.parted = true;
  return grid;
}

std::vector<std::uint32_t> grid_indices(int columns, int rows, bool wrap_u, bool wrap_v) {
  return grid_indices(columns, rows, GridWrap{wrap_u}, GridWrap{wrap_v});
}

std::vector<std::uint32_t> grid_indices(int columns, int rows, GridWrap wrap_u, GridWrap wrap_v) {
  assert(columns >= 1 && rows >= 1);
  const int cells_u = wrap_u.wraps ? columns : columns - 1, cells_v = wrap_v.wraps ? rows : rows - 1;
  std::vector<std::uint32_t> indices;
  indices.reserve(6 * static_cast<std::size_t>(cells_u) * static_cast<std::size_t>(cells_v));
  const auto vertex = [&](int a, int b) {
    int column = a % columns, row = b % rows;
    if (a == columns && wrap_u.mirror >= 0) row = (wrap_u.mirror - row + rows) % rows;
    if (b == rows && wrap_v.mirror >= 0) column = (wrap_v.mirror - column + columns) % columns;
    return static_cast<std::uint32_t>(column) * static_cast<std::uint32_t>(rows) + static_cast<std::uint32_t>(row);
  };
  for (int a = 0; a < cells_u; ++a) {
    for (int b = 0; b < cells_v; ++b) {
      const std::uint32_t v00 = vertex(a, b), v10 = vertex(a + 1, b), v01 = vertex(a, b + 1),
                          v11 = vertex(a + 1, b + 1);
      indices.insert(indices.end(), {v00, v10, v11, v00, v11, v01});
    }
  }
  return indices;
}

MeshData sample(const BlendingSurface& surface, int samples_u, int samples_v, Seam seam) {
  const SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), samples_u, samples_v, seam);
  const std::size_t columns = grid.u.size(), rows = grid.v.size(), vertices = columns * rows;
  const bool joined = seam == Seam::joined;
  MeshData mesh;
  mesh.positions.reserve(3 * vertices);
  mesh.normals.reserve(3 * vertices);
  mesh.parameters.reserve(2 * vertices);
  // A twist reflects whole steps as it reflects locals: the knots are symmetric.
  const auto wrap = [&](const KnotVector& knots, const std::optional<BlendingSurface::Twist>& twist,
                        const std::vector<int>& other_starts) {
    return GridWrap{joined && knots.closed(), twist ? other_starts[static_cast<std::size_t>(twist->mirror)] : -1};
  };
  mesh.indices = grid_indices(static_cast<int>(columns), static_cast<int>(rows),
                              wrap(surface.knots_u(), surface.twist_u(), grid.starts_v),
                              wrap(surface.knots_v(), surface.twist_v(), grid.starts_u));

  // A strip of columns at a time bounds the memory of the double-precision jets.
  constexpr std::size_t jets_at_once = 16384;
  const std::size_t strip = std::clamp<std::size_t>(jets_at_once / rows, 1, columns);
  std::vector<SurfaceJet> jets(strip * rows);
  for (std::size_t first = 0; first < columns; first += strip) {
    const std::span<const double> u = std::span(grid.u).subspan(first, std::min(strip, columns - first));
    surface.evaluate_grid(u, grid.v, std::span(jets).first(u.size() * rows));
    for (std::size_t a = 0; a < u.size(); ++a) {
      for (std::size_t b = 0; b < rows; ++b) {
        const SurfaceJet& jet = jets[a * rows + b];
        append(mesh.positions, jet.s);
        append(mesh.normals, unit_normal(jet));
        mesh.parameters.push_back(static_cast<float>(u[a]));
        mesh.parameters.push_back(static_cast<float>(grid.v[b]));
      }
    }
  }
  return mesh;
}

}  // namespace knotwork
