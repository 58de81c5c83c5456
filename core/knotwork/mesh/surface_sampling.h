#pragma once

#include <cstdint>
#include <vector>

#include "knotwork/later.h"
#include "knotwork/mesh/mesh_data.h"
#include "knotwork/surface/blending_surface.h"

namespace knotwork {

/// What happens where a closed direction meets itself: one shared column of vertices (watertight, for files and for
/// topology), or a repeated one (the same positions bit for bit, but both parameter values, as drawing needs; at a
/// twisted seam, which reflects the vertices along it, the same to rounding).
enum class Seam : unsigned char { joined, repeated };

/// The parameters of a sampling grid: every knot is sampled, and each knot interval is cut into equal steps. As it is one
/// grid in both directions, however fine each of its intervals, its triangles meet without cracks.
struct SampleGrid {
  /// Sorted; a closed direction ends with its end parameter when repeated, one before when joined.
  std::vector<double> u, v;
  /// Which sample each knot interval begins with; one more: how many steps there are. Empty intervals do not count.
  std::vector<int> starts_u, starts_v;
  /// Where two intervals meet, each has a sample of its own: parted_at_knots() has made it.
  bool parted = false;

  int columns() const { return static_cast<int>(u.size()); }
  int rows() const { return static_cast<int>(v.size()); }
};

/// How many steps each knot interval is cut into, at least 1. Empty intervals do not count.
struct GridSteps {
  std::vector<int> u, v;

  bool operator==(const GridSteps&) const = default;
};

/// The most samples a direction that are honoured (one a knot interval is always made).
inline constexpr int max_samples = 4096;

/// The grid with so many steps. Precondition: as many as each direction has intervals that are not empty, and three round
/// a closed direction: of two the edges would join the same two vertices.
SampleGrid sample_grid(const KnotVector& knots_u, const KnotVector& knots_v, const GridSteps& steps, Seam seam);
/// About `samples_u` x `samples_v` steps, as many in each interval of a direction: at least one, rounded up, and at least
/// three round a closed direction.
GridSteps even_steps(const KnotVector& knots_u, const KnotVector& knots_v, int samples_u, int samples_v);
SampleGrid sample_grid(const KnotVector& knots_u, const KnotVector& knots_v, int samples_u, int samples_v, Seam seam);

/// The grid with two samples at each inner knot, the first of them just before it (just_before(), curve/
/// parametric_curve.h), and the last sample of a closed direction just before the end: what jumps there, as normals do at
/// a crease, has its values from both sides. Cells between the two samples have no width.
/// Precondition: the grid is of these knots and not parted, its seams repeated.
KNOTWORK_LAST SampleGrid parted_at_knots(SampleGrid grid, const KnotVector& knots_u, const KnotVector& knots_v);

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
