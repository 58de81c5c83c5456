#include "knotwork/surface/closest_surface_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/curve/point_check.h"

namespace knotwork {
namespace {

constexpr int most_newton_steps = 60;
constexpr double same_surface_point = 1e-14;

/// One parameter of the surface: its grid, and how it goes on at its ends.
struct GridDirection {
  Interval domain;
  bool closed;               ///< a twisted direction is searched as an open one: its domain holds every point
  std::vector<double> grid;  ///< closed: without the end, which is the start again

  GridDirection(const Interval& where, Closure closure, std::span<const double> breaks, int detail)
      : domain(where), closed(closure == Closure::closed) {
    const std::vector<double> ends = piece_ends(where.start, where.end, breaks);
    for (std::size_t piece = 1; piece < ends.size(); ++piece) {
      for (int k = 0; k < detail; ++k)
        grid.push_back(std::lerp(ends[piece - 1], ends[piece], static_cast<double>(k) / detail));
    }
    if (!closed) grid.push_back(where.end);
  }

  double length() const { return domain.end - domain.start; }
  int size() const { return static_cast<int>(grid.size()); }
  /// The index in the grid, -1 when there is none.
  int neighbour(int i, int step) const {
    const int there = i + step;
    if (closed) return (there + size()) % size();
    return there < size() ? there : -1;
  }
  /// x, at most a length outside, brought into the domain.
  double inside(double x) const {
    if (!closed) return std::clamp(x, domain.start, domain.end);
    const double round = x < domain.start ? x + length() : x < domain.end ? x : x - length();
    return round >= domain.start && round < domain.end ? round : domain.start;
  }
  /// Whether the domain ends here in the direction in which the function falls.
  bool blocked(double x, double slope) const {
    return !closed && ((x <= domain.start && slope > 0) || (x >= domain.end && slope < 0));
  }
};

/// Half the square of the distance to a point, with its gradient and second derivatives.
struct DistanceJet {
  double f;
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian, metric;  ///< the metric is the Hessian for a point on the surface
};

double determinant_of(const Eigen::Matrix2d& m) { return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0); }

struct Place {
  double u, v;
  DistanceJet jet;
};

class SurfaceSearch {
 public:
  SurfaceSearch(const SurfaceView& surface, Eigen::Vector3d point)
      : surface_(surface),
        point_(std::move(point)),
        u_(surface.domain.u, surface.domain.closure_u, surface.breaks_u, surface.detail),
        v_(surface.domain.v, surface.domain.closure_v, surface.breaks_v, surface.detail) {}

  ClosestSurfacePoint run() {
    look();
    std::vector<int> starts;
    for (int i = 0; i < u_.size(); ++i) {
      for (int j = 0; j < v_.size(); ++j) {
        if (nearer_than_neighbours(i, j)) starts.push_back(index(i, j));
      }
    }
    // From the nearest on, so that starts which are far away need not be tried.
    std::stable_sort(starts.begin(), starts.end(), [&](int a, int b) { return distance(a) < distance(b); });
    ClosestSurfacePoint best{0, 0, Eigen::Vector3d::Zero(), std::numeric_limits<double>::max()};
    for (const int start : starts) {
      const int i = start / v_.size(), j = start % v_.size();
      if (distance(start) - reach(i, j) > best.distance) continue;
      const ClosestSurfacePoint found = descend(u_.grid[at(i)], v_.grid[at(j)]);
      const double same = same_surface_point * size_;
      const bool before = found.u < best.u || (found.u == best.u && found.v < best.v);
      if (found.distance < best.distance - same || (before && found.distance <= best.distance + same)) best = found;
    }
    return best;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int index(int i, int j) const { return i * v_.size() + j; }
  double distance(int k) const { return distances_[at(k)]; }

  void look() {
    size_ = point_.cwiseAbs().maxCoeff();
    for (const double u : u_.grid) {
      for (const double v : v_.grid) {
        points_.push_back(surface_.evaluate(u, v).s);
        distances_.push_back((points_.back() - point_).norm());
        size_ = std::max(size_, points_.back().cwiseAbs().maxCoeff());
      }
    }
  }

  template <class Visit>
  void for_neighbours(int i, int j, const Visit& visit) const {
    for (int a = -1; a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) {
        const int k = u_.neighbour(i, a), l = v_.neighbour(j, b);
        if (k >= 0 && l >= 0) visit(index(k, l));
      }
    }
  }
  bool nearer_than_neighbours(int i, int j) const {
    bool nearest = true;
    for_neighbours(i, j, [&](int other) { nearest = nearest && distance(index(i, j)) <= distance(other); });
    return nearest;
  }
  /// How far the neighbours are: the surface between them is hardly nearer to the point by more.
  double reach(int i, int j) const {
    double far = 0;
    for_neighbours(i, j,
                   [&](int other) { far = std::max(far, (points_[at(index(i, j))] - points_[at(other)]).norm()); });
    return far;
  }

  DistanceJet jet(double u, double v) const {
    const SurfaceJet s = surface_.evaluate(u, v);
    const Eigen::Vector3d d = s.s - point_;
    DistanceJet out;
    out.f = d.squaredNorm() / 2;
    out.gradient = {d.dot(s.su), d.dot(s.sv)};
    const double f = s.su.dot(s.sv);
    out.metric << s.su.squaredNorm(), f, f, s.sv.squaredNorm();
    const double uv = d.dot(s.suv);
    out.hessian = out.metric;
    out.hessian(0, 0) += d.dot(s.suu), out.hessian(0, 1) += uv, out.hessian(1, 0) += uv;
    out.hessian(1, 1) += d.dot(s.svv);
    return out;
  }

  /// Newton's step where the Hessian is positive, else one along the metric's gradient; a direction that is blocked by
  /// the end of the domain rests. `newton` says which.
  Eigen::Vector2d step(const Place& place, bool& newton) const {
    const DistanceJet& here = place.jet;
    Eigen::Vector2d gradient = here.gradient;
    const bool rest[2] = {u_.blocked(place.u, gradient[0]), v_.blocked(place.v, gradient[1])};
    // In parts of the domain, so that both directions count alike.
    const Eigen::Vector2d unit(u_.length(), v_.length());
    Eigen::Matrix2d h = unit.asDiagonal() * here.hessian * unit.asDiagonal();
    const Eigen::Matrix2d metric = unit.asDiagonal() * here.metric * unit.asDiagonal();
    gradient = gradient.cwiseProduct(unit);
    const double scale = metric.trace();
    const auto rested = [&](Eigen::Matrix2d m) {
      for (int k = 0; k < 2; ++k) {
        if (rest[k]) m.row(k).setZero(), m.col(k).setZero(), m(k, k) = scale, gradient[k] = 0;
      }
      return m;
    };
    h = rested(h);
    newton = h(0, 0) > 0 && determinant_of(h) > 1e-12 * h(0, 0) * scale;
    if (!newton) h = rested(metric) + 1e-3 * scale * Eigen::Matrix2d::Identity();
    const double determinant = determinant_of(h);
    if (!(determinant > 0)) return Eigen::Vector2d::Zero();  // the surface is a point here
    return {-(h(1, 1) * gradient[0] - h(0, 1) * gradient[1]) / determinant * unit[0],
            -(h(0, 0) * gradient[1] - h(1, 0) * gradient[0]) / determinant * unit[1]};
  }

  /// Moves `place` by `by`, or by half of it, and so on, until it is nearer; false where it cannot come nearer. A step
  /// may lead away by `noise`.
  bool advance(Place& place, Eigen::Vector2d by, double noise) const {
    for (int halving = 0; halving < 40; ++halving, by /= 2) {
      const double u = u_.inside(place.u + by[0]), v = v_.inside(place.v + by[1]);
      if (u == place.u && v == place.v) return false;
      const DistanceJet next = jet(u, v);
      if (next.f < place.jet.f || (halving == 0 && next.f <= place.jet.f + noise)) {
        place = {u, v, next};
        return true;
      }
    }
    return false;
  }

  ClosestSurfacePoint descend(double u, double v) const {
    Place place{u, v, jet(u, v)};
    // No farther at once than about to the next grid points but one.
    const double most = 2.0 / std::min(u_.size(), v_.size());
    for (int round = 0; round < most_newton_steps; ++round) {
      bool newton = false;
      Eigen::Vector2d by = step(place, newton);
      const double longest = std::max(std::abs(by[0]) / u_.length(), std::abs(by[1]) / v_.length());
      if (longest > most) by *= most / longest;
      // Near the minimum rounding hides whether a step of Newton's leads down; there it is taken at its word.
      const double noise = newton ? same_surface_point * size_ * std::sqrt(place.jet.f) : 0;
      if (!advance(place, by, noise) || longest < 1e-15) break;
    }
    const Eigen::Vector3d there = surface_.evaluate(place.u, place.v).s;
    return {place.u, place.v, there, (there - point_).norm()};
  }

  SurfaceView surface_;
  Eigen::Vector3d point_;
  GridDirection u_, v_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<double> distances_;  ///< of the grid's points
  double size_ = 0;
};

}  // namespace

Result<ClosestSurfacePoint> closest_point(const SurfaceView& surface, const Eigen::Vector3d& point) {
  if (Status status = check_distant_point(point); !status) return status.error();
  return SurfaceSearch(surface, point).run();
}

}  // namespace knotwork
