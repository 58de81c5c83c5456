#pragma once

#include <vector>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/result.h"

namespace knotwork::scene {

// What becomes of knots when a hand changes a spline, be it a curve or a direction of a surface.

/// The fewest control points: p+1 open, max(2, p) closed.
int least_points(int degree, Topology topology);

/// What evenly spaced knots an open spline has.
enum class Ends : unsigned char { clamped, unclamped };
/// Clamped when closed, where it means nothing.
Ends ends_of(const KnotVector& knots);

/// Evenly spaced knots one apart: open ones over [0, n-p] when clamped, else from 0 on; closed, over [0, n]. Error path:
/// as KnotVector.
Result<KnotVector> even_knots(int degree, int points, Topology topology, Ends ends = Ends::clamped);
/// Whether the knots are evenly spaced, over any domain; open ones clamped or not.
bool evenly_spaced(const KnotVector& knots);

/// Where control point i has its say: (t_{i+1} + .. + t_{i+p}) / p.
double greville(const KnotVector& knots, int i);

/// Knots with a new one near where the new point i will have its say.
Result<KnotVector> with_knot_for(const KnotVector& knots, int i);
/// Knots without the inner one nearest to where point i has its say.
Result<KnotVector> without_knot_of(const KnotVector& knots, int i);

/// Knots with another t_index; of closed ones those a period away go with it. Error path: `index` or `value`, which must
/// leave the knots sorted and no knot with a multiplicity above the degree (p+1 at the ends of open ones).
Result<std::vector<double>> with_knot_moved(const KnotVector& knots, int index, double value);

}  // namespace knotwork::scene
