#pragma once

#include <Eigen/Core>

#include "knotwork/later.h"
#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/surface/knotted_surface.h"

namespace knotwork {

/// How far triangles may stray from a surface within a ball, > 0, infinity where nobody looks: a reference to whatever
/// answers, which must outlive it.
struct GridTolerance {
  const void* about;
  double (*within)(const void* about, const Eigen::Vector3d& centre, double radius);

  double operator()(const Eigen::Vector3d& centre, double radius) const { return within(about, centre, radius); }
};

/// Steps for a grid of at most about `most_vertices`.
struct FittedSteps {
  GridSteps steps;
  bool within_tolerance;  ///< false where that many vertices are too few
};

/// So many steps in each knot interval that the grid's triangles stay within the tolerance. Triangles over a rectangle of
/// h x k stray by at most
///
///   1/8 max(L h^2 + 2 M h k + N k^2),
///
/// L = |S_uu| off the direction of S_u and N = |S_vv| off that of S_v, as a step along the surface's own line strays by
/// nothing; M = |S_uv| along the normal. They are looked at in a few places of each cell, and a fifth more is taken
/// for safety. With 2 M h k <= M (h^2 w_v / w_u + k^2 w_u / w_v) for intervals of width w each direction is told by itself
/// what it needs of a cell, and an interval takes the most of all its cells.
///
/// Steps are 1, 2, 3, 4, 6, 8, 12, ..., so that they seldom change. Where the tolerance alone would take fewer, an
/// interval gets as many as have edges of 64 tolerances, up to 12: what else varies along an edge, as a hue, stays smooth.
///
/// Source: Filip, Magedson, Markot, "Surface algorithms using bounds on derivatives", CAGD 3 (1986) 295-311.
KNOTWORK_LATER FittedSteps fitted_steps(const KnottedSurface& surface, GridTolerance tolerance, int most_vertices);

/// The same steps on both sides of what a twisted seam reflects: interval k and interval mirror - 1 - k (modulo the
/// number of intervals of a closed direction), each as many as the finer has.
KNOTWORK_LATER void make_symmetric(std::vector<int>& steps, int mirror);

}  // namespace knotwork
