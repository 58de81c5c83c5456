#pragma once

#include <cstdint>
#include <vector>

#include "knotwork/mesh/mesh_data.h"
#include "knotwork/surface/blending_surface.h"

namespace knotwork {

/// What happens where a closed direction meets itself: one shared column of vertices (watertight, for files and for
/// topology), or a repeated one (the same positions bit for bit, but both parameter values, as drawing needs; at a
/// twisted seam, which reflects the vertices along it, the same to rounding).
enum class Seam : unsigned char { joined, repeated };

/// The parameters of a sampling grid: every knot is sampled, `steps` equal steps in each knot interval.
struct SampleGrid {
  /// Sorted; a closed direction ends with its end parameter when repeated, one before when joined.
  std::vector<double> u, v;
  int steps_u = 1, steps_v = 1;
};

/// The most samples a direction that are honoured (one a knot interval is always made).
inline constexpr int max_samples = 4096;

/// A grid with about `samples_u` x `samples_v` steps: at least one a knot interval, rounded up to whole steps, and at
/// least three round a closed direction.
SampleGrid sample_grid(const KnotVector& knots_u, const KnotVector& knots_v, int samples_u, int samples_v, Seam seam);

/// Where a grid direction goes on at its end: nowhere, or at its start, there with index k of the other direction
/// reflected to mirror - k (modulo that direction's size) where mirror >= 0.
struct GridWrap {
  bool wraps = false;
  int mirror = -1;
};

/// Triangle indices of a grid of `columns` x `rows` vertices (vertex a * rows + b), wrapping where told.
std::vector<std::uint32_t> grid_indices(int columns, int rows, bool wrap_u, bool wrap_v);
std::vector<std::uint32_t> grid_indices(int columns, int rows, GridWrap wrap_u, GridWrap wrap_v);

/// Positions, analytic normals and parameters of the surface on the grid.
MeshData sample(const BlendingSurface& surface, int samples_u, int samples_v, Seam seam);

}  // namespace knotwork
