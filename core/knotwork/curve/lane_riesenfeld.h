#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// Lane-Riesenfeld subdivision of degree d: a level takes every point twice (the split) and then d times the
/// midpoints of all legs (the averaging passes). It cuts corners: for d >= 2 the polygon approximates its limit, a
/// uniform B-spline curve of degree d, which is C^(d-1); for d = 1 it interpolates. One level as a mask, C(d+1, .)
/// the binomials:
///
///   q_j = 2^-d sum_i C(d+1, 2i+1-j) p_i.
///
/// Closed: n -> 2n points, n >= 1, the polygon's last leg goes back to its first point and the first point is not
/// repeated. Open: n -> 2n-d points, n >= d+1; the limit has the domain [d, n] and does not reach the ends of the
/// polygon. Source: Lane & Riesenfeld, IEEE PAMI 2(1) 1980; THEORY 2.5.
struct LaneRiesenfeld {
  static constexpr int max_degree = 9;
  /// No polygon has more vertices than this: 96 MiB of points.
  static constexpr std::size_t max_points = std::size_t{1} << 22;

  int degree = 3;  ///< d, 1 to max_degree
  Topology topology = Topology::closed;
};

/// Every point twice: p_0, p_0, p_1, p_1, ...; the first step of a level.
std::vector<Eigen::Vector3d> split_points(std::span<const Eigen::Vector3d> points);

/// One averaging pass, q_i = p_i/2 + p_{i+1}/2: as many points when closed (p_n = p_0), one fewer when open. Of no
/// points, none. Nothing is rounded as long as the result fits into 53 bits, and points that agree stay what they
/// are.
std::vector<Eigen::Vector3d> averaged_points(std::span<const Eigen::Vector3d> points, Topology topology);

/// The number of points after `levels` levels: n 2^k closed, (n-d) 2^k + d open. Precondition: levels <= max_levels().
std::size_t subdivided_count(const LaneRiesenfeld& scheme, std::size_t count, int levels);
/// The most levels that keep within max_points vertices; -1 when the polygon itself has more. Precondition: a degree in
/// range and as many points as it needs.
int max_levels(const LaneRiesenfeld& scheme, std::size_t count);

/// The polygon after `levels` levels (0: the points themselves). Each level is one sweep, O(d) a point, in place:
/// nothing is allocated but the result. Bit for bit what split_points and d times averaged_points give. Error path:
/// `degree`; `points` (too few or too many), `points[i]` (not finite); `levels` (negative, or more than max_levels(),
/// which the message names).
Result<std::vector<Eigen::Vector3d>> subdivide(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points,
                                               int levels);

/// The same into `out`, which has room for subdivided_count() points and does not overlap `points`. Allocates nothing.
/// Precondition: what the above checks.
void subdivide(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points, int levels,
               std::span<Eigen::Vector3d> out);

/// The parameter of the limit curve c that vertex j belongs to after `level` levels of `count` points:
///
///   t = d + (j - (d-1)/2) / 2^level,   closed: taken by the period n into [d, d+n).
///
/// For d >= 2, vertex - c(t) = -(d+1)/24 times the polygon's second difference there + O(16^-level), a quarter a
/// level; for d = 1 it is 0. Open: the t of the first and of the last floor(d/2) vertices lie outside the domain [d,
/// n]. Precondition: degree, count, level and j in range. Exact.
double vertex_parameter(const LaneRiesenfeld& scheme, std::size_t count, int level, std::size_t j);

/// The limit: the uniform B-spline curve of degree d. Open: the same points on the knots t_i = i, domain [d, n].
/// Closed: period n, domain [d, d+n); a closed curve with fewer points than max(2, d) is subdivided until it has as
/// many, which changes neither the curve nor its parameter. Error path: `degree`, `points` (too few, or more than
/// KnotVector::max_count), `points[i]`.
Result<BSplineCurve> limit_curve(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points);

}  // namespace knotwork
