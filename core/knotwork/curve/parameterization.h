#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/result.h"

namespace knotwork {

/// Exponents of the chord length that have names.
inline constexpr double uniform_exponent = 0;
inline constexpr double centripetal_exponent = 0.5;
inline constexpr double chord_length_exponent = 1;

/// Parameters for points p_0 .. p_{m-1} that a curve shall pass in this order: u_0 = 0,
/// u_j = u_{j-1} + |p_j - p_{j-1}|^mu, mapped to [start, end]. They do not decrease; the first is `start`, exactly.
///
/// Open: u_{m-1} becomes `end`, exactly. Closed: the chord from p_{m-1} back to p_0 counts too, and what becomes `end` is
/// u_m, which is p_0 again, so that the last parameter is below `end`.
/// Neighbours that coincide have the same parameter, unless mu = 0, where they are one step apart like all others;
/// closed, a last point that repeats p_0 therefore has the parameter `end` when mu > 0.
///
/// 0 <= mu <= 1. Error at most (m + 4) 2^-53 (end - start). Errors, with paths: `points` (fewer than 2, or mu > 0 and all
/// in one place), `points[i]`, `exponent`, `start`, `end`. Source: THEORY 2.4; Lee, Computer-Aided Design 21 (1989).
Result<std::vector<double>> parameterize(std::span<const Eigen::Vector3d> points, double exponent, Topology topology,
                                         double start, double end);

/// Knots for a curve of `count` control points through or near points at these parameters x_0 <= x_1 <= .. <= x_{m-1},
/// m >= count, such that Schoenberg and Whitney are content as a rule: every knot interval holds data.
///
/// Open: clamped on [x_0, x_{m-1}]. m > n: the inner knot t_{p+j} stands at place j m / (n-p) - 1 among the x, linearly
/// between neighbours (Piegl and Tiller, The NURBS Book, 9.68, 9.69). m = n: t_{p+j} = (x_j + .. + x_{j+p-1}) / p (9.8).
/// Closed: the parameters go on with the period, x_{j+m} = x_j + period. m > n, or p odd: t_{p+j} stands at place j m / n,
/// j = 0..n, so that the domain is [x_0, x_0 + period). m = n and p even: t_{p+j} = (x_{j-1} + x_j) / 2; the parameters
/// themselves as knots would leave the curve undetermined when n is even.
///
/// `period` is used when closed only: above 0, and x_{m-1} <= x_0 + period.
/// Errors, with paths: `degree`, `count`, `period`, `parameters` (fewer than `count`), `parameters[j]`, and `knots[i]`
/// where so many parameters are equal that the knots are refused. Source: THEORY 2.4.
Result<KnotVector> averaged_knots(int degree, int count, Topology topology, std::span<const double> parameters,
                                  double period = 0);

}  // namespace knotwork
