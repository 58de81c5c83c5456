#include "knotwork/curve/lane_riesenfeld.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include "knotwork/basis/lanes.h"
#include "knotwork/curve/point_check.h"

namespace knotwork {
namespace {

bool is_closed(const LaneRiesenfeld& scheme) { return scheme.topology == Topology::closed; }

/// Halves first: the sum of two large numbers could overflow, and halving rounds nothing.
Eigen::Vector3d midpoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return 0.5 * a + 0.5 * b; }

/// So many points of degree 3 are computed at a time; polygons that are hardly longer are not worth it.
constexpr std::size_t cubic_block = 32, least_for_blocks = 8 * cubic_block;

Status check_polygon(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points) {
  if (scheme.degree < 1 || scheme.degree > LaneRiesenfeld::max_degree) {
    return Error{"degree", "The degree must lie between 1 and " + std::to_string(LaneRiesenfeld::max_degree) + "."};
  }
  const std::size_t least = is_closed(scheme) ? 1 : static_cast<std::size_t>(scheme.degree) + 1;
  if (points.size() < least || points.size() > LaneRiesenfeld::max_points) {
    return Error{"points", "This polygon needs " + std::to_string(least) + " to " +
                               std::to_string(LaneRiesenfeld::max_points) + " points, but there are " +
                               std::to_string(points.size()) + "."};
  }
  return check_points(points);
}

/// The new points first .. last - 1 of one level; `polygon` holds the n old points and then room for the new ones.
///
/// The split points stream through a chain of d averagers, each of which remembers half of the point before. They come
/// last point first, so that a new point is written only where the old ones have been read: q_m leaves the chain as
/// p_{m/2} enters. Closed, the chain is filled with the first points, which follow upon the last.
void refine_by_chain(const LaneRiesenfeld& scheme, std::size_t n, std::size_t first, std::size_t last,
                     std::span<Eigen::Vector3d> polygon) {
  const std::size_t d = static_cast<std::size_t>(scheme.degree);
  std::array<Eigen::Vector3d, LaneRiesenfeld::max_degree> halves;
  halves.fill(Eigen::Vector3d::Zero());
  for (std::size_t m = last + d; m-- > first;) {
    const std::size_t i = m / 2;
    Eigen::Vector3d point = polygon[i < n ? i : i % n];
    for (std::size_t pass = 0; pass < d; ++pass) {
      const Eigen::Vector3d half = 0.5 * point;
      point = half + halves[pass];
      halves[pass] = half;
    }
    if (m < last) polygon[m] = point;
  }
}

/// The same for the new points 2 first .. 2 last - 1 of degree 3, from the numbers p of the old points: what three
/// passes make of p_i, p_{i+1}, p_{i+2}, written out,
///
///   q_{2i} = ((p_i + h_i)/2 + (h_i + p_{i+1})/2)/2,   q_{2i+1} = ((h_i + p_{i+1})/2 + (p_{i+1} + h_{i+1})/2)/2
///
/// with h_i = (p_i + p_{i+1})/2: every average the same one, so that no bit differs. Fast because no point waits for its
/// neighbour: a lane for each coordinate, whichever point it is of. Precondition: the old points up to `last` + 1 are
/// before the new ones.
void refine_cubic(std::size_t first, std::size_t last, double* p) {
  constexpr std::size_t numbers = 3 * cubic_block;
  alignas(64) std::array<double, numbers + 1> even{}, odd{};
  const auto average = [](const Lanes& a, const Lanes& b) { return 0.5 * a + 0.5 * b; };
  for (std::size_t end = last; end > first; end -= cubic_block) {
    const double* from = p + 3 * (end - cubic_block);
    for (std::size_t k = 0; k < numbers; k += lane_count) {
      Lanes a, b, c;
      load(a, from + k);
      load(b, from + k + 3);
      load(c, from + k + 6);
      const Lanes h = average(a, b), right = average(h, b);
      store(average(average(a, h), right), &even[k]);
      store(average(right, average(b, average(b, c))), &odd[k]);
    }
    double* to = p + 6 * (end - cubic_block);
    // Four numbers at a time where the next three overwrite the fourth.
    for (std::size_t k = 0; k < numbers; k += 3, to += 6) {
      std::copy_n(&even[k], 4, to);
      std::copy_n(&odd[k], k + 3 < numbers ? 4 : 3, to + 3);
    }
  }
}

/// One level in place: `polygon` holds the n old points and then room for the new ones.
void refine_in_place(const LaneRiesenfeld& scheme, std::size_t n, std::span<Eigen::Vector3d> polygon) {
  const std::size_t count = subdivided_count(scheme, n, 1);
  if (scheme.degree != 3 || n < least_for_blocks) return refine_by_chain(scheme, n, 0, count, polygon);
  // The ends by the chain: the last points, which may go round, and the first, which lie among the old ones.
  const std::size_t last = (n - 2) / cubic_block * cubic_block;
  refine_by_chain(scheme, n, 2 * last, count, polygon);
  refine_cubic(cubic_block, last, polygon.front().data());
  refine_by_chain(scheme, n, 0, 2 * cubic_block, polygon);
}

}  // namespace

std::vector<Eigen::Vector3d> split_points(std::span<const Eigen::Vector3d> points) {
  std::vector<Eigen::Vector3d> twice;
  twice.reserve(2 * points.size());
  for (const Eigen::Vector3d& point : points) twice.insert(twice.end(), 2, point);
  return twice;
}

std::vector<Eigen::Vector3d> averaged_points(std::span<const Eigen::Vector3d> points, Topology topology) {
  std::vector<Eigen::Vector3d> averages;
  averages.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) averages.push_back(midpoint(points[i], points[i + 1]));
  if (topology == Topology::closed && !points.empty()) averages.push_back(midpoint(points.back(), points.front()));
  return averages;
}

std::size_t subdivided_count(const LaneRiesenfeld& scheme, std::size_t count, int levels) {
  const std::size_t kept = is_closed(scheme) ? 0 : static_cast<std::size_t>(scheme.degree);
  return ((count - kept) << levels) + kept;
}

int max_levels(const LaneRiesenfeld& scheme, std::size_t count) {
  assert(count > (is_closed(scheme) ? 0 : static_cast<std::size_t>(scheme.degree)));
  int levels = -1;
  while (subdivided_count(scheme, count, levels + 1) <= LaneRiesenfeld::max_points) ++levels;
  return levels;
}

Result<std::vector<Eigen::Vector3d>> subdivide(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points,
                                               int levels) {
  if (const Status ok = check_polygon(scheme, points); !ok) return ok.error();
  if (levels < 0) return Error{"levels", "The number of levels must not be negative."};
  if (const int most = max_levels(scheme, points.size()); levels > most) {
    return Error{"levels", "At most " + std::to_string(most) + " levels fit within " +
                               std::to_string(LaneRiesenfeld::max_points) + " vertices; there are " +
                               std::to_string(points.size()) + " to begin with."};
  }
  std::vector<Eigen::Vector3d> polygon(subdivided_count(scheme, points.size(), levels));
  subdivide(scheme, points, levels, polygon);
  return polygon;
}

void subdivide(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points, int levels,
               std::span<Eigen::Vector3d> out) {
  assert(out.size() == subdivided_count(scheme, points.size(), levels));
  std::copy(points.begin(), points.end(), out.begin());
  for (int level = 0; level < levels; ++level) {
    const std::size_t count = subdivided_count(scheme, points.size(), level);
    refine_in_place(scheme, count, out.first(subdivided_count(scheme, count, 1)));
  }
}

double vertex_parameter(const LaneRiesenfeld& scheme, std::size_t count, int level, std::size_t j) {
  assert(j < subdivided_count(scheme, count, level));
  const double d = scheme.degree, offset = std::ldexp(static_cast<double>(j) - (d - 1) / 2, -level);
  if (!is_closed(scheme)) return d + offset;
  // offset >= -(d-1)/2, with few points several periods before the domain.
  const double period = static_cast<double>(count);
  double inside = std::fmod(offset, period);
  if (inside < 0) inside += period;
  return d + inside;
}

Result<BSplineCurve> limit_curve(const LaneRiesenfeld& scheme, std::span<const Eigen::Vector3d> points) {
  if (const Status ok = check_polygon(scheme, points); !ok) return ok.error();
  const int d = scheme.degree;
  if (points.size() > static_cast<std::size_t>(KnotVector::max_count)) {
    return Error{"points", "A limit curve has at most " + std::to_string(KnotVector::max_count) + " points."};
  }
  const int n = static_cast<int>(points.size());
  if (!is_closed(scheme)) {
    std::vector<double> knots;
    for (int i = 0; i <= n + d; ++i) knots.push_back(i);
    return BSplineCurve::make(KnotVector::make(d, Topology::open, std::move(knots)).value(),
                              {points.begin(), points.end()});
  }
  int levels = 0;
  while (n << levels < std::max(2, d)) ++levels;
  return BSplineCurve::make(KnotVector::uniform(d, n << levels, Topology::closed, d, d + n).value(),
                            subdivide(scheme, points, levels).value());
}

}  // namespace knotwork
