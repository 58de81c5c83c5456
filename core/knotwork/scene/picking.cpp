#include "knotwork/scene/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

namespace knotwork::scene {

namespace {

constexpr int steps_per_interval = 12, largest_net = 200, block_size = 12;
constexpr double tolerance = 1e-10;  ///< of the net's radius

/// Every knot and equal steps between, the end of the domain included.
std::vector<double> net_parameters(const KnotVector& knots) {
  const int intervals = knots.interval_count();
  const int steps = std::clamp(largest_net / intervals, 1, steps_per_interval);
  std::vector<double> t;
  for (int i = 0; i < intervals; ++i) {
    const double start = knots[knots.degree() + i], end = knots[knots.degree() + i + 1];
    if (!(start < end)) continue;  // at a multiple knot
    for (int k = 0; k < steps; ++k) t.push_back(start + (end - start) * k / steps);
  }
  t.push_back(knots.end());
  return t;
}

struct Ball {
  Eigen::Vector3d centre;
  double radius;
};

Ball ball_round(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  const Eigen::Vector3d centre = box.center();
  double squared = 0;
  for (const Eigen::Vector3d& p : points) squared = std::max(squared, (p - centre).squaredNorm());
  return {centre, std::sqrt(squared)};
}

struct TriangleHit {
  double distance, b, c;  ///< barycentric weights of the second and third corner
};

/// Möller's and Trumbore's equations: origin + distance direction = (1-b-c) p + b q + c r, in the triangle or just beside.
std::optional<TriangleHit> meet(const Ray& ray, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                                const Eigen::Vector3d& r) {
  const Eigen::Vector3d e1 = q - p, e2 = r - p, h = ray.direction.cross(e2);
  const double determinant = e1.dot(h);
  // Seen edge on, or no triangle at all.
  if (std::abs(determinant) <= 1e-14 * e1.norm() * e2.norm()) return std::nullopt;
  // Room at the edges: at a rim or a silhouette the surface reaches a little beyond its net. Newton's method decides.
  constexpr double slack = 0.15;
  const Eigen::Vector3d s = ray.origin - p;
  const double b = s.dot(h) / determinant;
  if (!(b >= -slack && b <= 1 + slack)) return std::nullopt;
  const Eigen::Vector3d k = s.cross(e1);
  const double c = ray.direction.dot(k) / determinant;
  if (!(c >= -slack && b + c <= 1 + slack)) return std::nullopt;
  const double distance = e2.dot(k) / determinant;
  if (!(distance > 0)) return std::nullopt;
  return TriangleHit{distance, b, c};
}

/// Where Newton's method starts and how far one step may go.
struct Start {
  double u, v, distance;
  double step_u, step_v;
};

double kept_in(const KnotVector& knots, double t) {
  return knots.closed() ? t : std::clamp(t, knots.start(), knots.end());
}

/// Solves S(u,v) = origin + distance direction by Newton's method with the analytic partials.
std::optional<SurfaceHit> polish(const KnottedSurface& surface, const Ray& ray, const Start& start, double size) {
  double u = start.u, v = start.v, distance = start.distance;
  double last_error = 0;
  for (int iteration = 0; iteration < 24; ++iteration) {
    const SurfaceJet jet = surface.evaluate(u, v);
    const Eigen::Vector3d residual = ray.origin + distance * ray.direction - jet.s;
    const double error = residual.norm();
    const bool settled = error <= tolerance * size;
    // One more step after the tolerance is met costs little and gives the last digits.
    if (settled && (iteration > 0 && (error == 0 || error >= last_error / 4))) {
      if (!(distance > 0)) return std::nullopt;
      return SurfaceHit{surface.knots_u->reduced(u), surface.knots_v->reduced(v), distance, jet};
    }
    last_error = error;

    Eigen::Matrix3d equations;
    equations << jet.su, jet.sv, -ray.direction;
    const double scale = jet.su.norm() * jet.sv.norm();
    if (!(std::abs(equations.determinant()) > 1e-12 * scale)) return std::nullopt;
    const Eigen::Vector3d step = equations.inverse() * residual;
    if (!step.allFinite()) return std::nullopt;
    const double shorter = std::min(
        {1.0, start.step_u / std::max(std::abs(step[0]), 1e-300), start.step_v / std::max(std::abs(step[1]), 1e-300)});
    u = kept_in(*surface.knots_u, u + shorter * step[0]);
    v = kept_in(*surface.knots_v, v + shorter * step[1]);
    distance += shorter * step[2];
  }
  return std::nullopt;
}

}  // namespace

PickNet::PickNet(const KnottedSurface& surface)
    : u_(net_parameters(*surface.knots_u)), v_(net_parameters(*surface.knots_v)) {
  points_.reserve(u_.size() * v_.size());
  std::vector<SurfaceJet> column(v_.size());
  for (const double& u : u_) {
    surface.evaluate_grid({&u, 1}, v_, column);
    for (const SurfaceJet& jet : column) points_.push_back(jet.s);
  }
  const Ball all = ball_round(points_);
  centre_ = all.centre;
  radius_ = all.radius;

  const int columns = static_cast<int>(u_.size()), rows = static_cast<int>(v_.size());
  std::vector<Eigen::Vector3d> members;
  for (int a = 0; a + 1 < columns; a += block_size) {
    for (int b = 0; b + 1 < rows; b += block_size) {
      const int last_a = std::min(a + block_size, columns - 1), last_b = std::min(b + block_size, rows - 1);
      members.clear();
      for (int i = a; i <= last_a; ++i) {
        for (int j = b; j <= last_b; ++j) members.push_back(point(i, j));
      }
      const Ball ball = ball_round(members);
      blocks_.push_back({a, last_a, b, last_b, ball.centre, ball.radius});
    }
  }
}

std::optional<SurfaceHit> PickNet::pick(const KnottedSurface& surface, const Ray& given) const {
  const double length = given.direction.norm();
  if (!std::isfinite(length) || length == 0) return std::nullopt;
  const Ray ray{given.origin, given.direction / length};

  std::vector<Start> starts;
  const auto try_triangle = [&](std::array<int, 2> p, std::array<int, 2> q, std::array<int, 2> r) {
    const auto hit = meet(ray, point(p[0], p[1]), point(q[0], q[1]), point(r[0], r[1]));
    if (!hit) return;
    const auto at = [&](const std::vector<double>& t, int k) { return t[static_cast<std::size_t>(k)]; };
    const auto weighted = [&](double x, double y, double z) {
      return (1 - hit->b - hit->c) * x + hit->b * y + hit->c * z;
    };
    const double u = weighted(at(u_, p[0]), at(u_, q[0]), at(u_, r[0]));
    const double v = weighted(at(v_, p[1]), at(v_, q[1]), at(v_, r[1]));
    const int a = std::min({p[0], q[0], r[0]}), b = std::min({p[1], q[1], r[1]});
    starts.push_back({u, v, hit->distance, 2 * (at(u_, a + 1) - at(u_, a)), 2 * (at(v_, b + 1) - at(v_, b))});
  };
  for (const Block& block : blocks_) {
    const Eigen::Vector3d to_centre = block.centre - ray.origin;
    if (to_centre.cross(ray.direction).norm() > block.radius * 1.05) continue;
    for (int a = block.first_column; a < block.last_column; ++a) {
      for (int b = block.first_row; b < block.last_row; ++b) {
        try_triangle({a, b}, {a + 1, b}, {a + 1, b + 1});
        try_triangle({a, b}, {a + 1, b + 1}, {a, b + 1});
      }
    }
  }

  // The nearest triangle need not lead to the nearest point where the net cuts a curve short: all of them are polished,
  // but for those that are further away than a hit by more than the net can be wrong.
  std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.distance < b.distance; });
  std::optional<SurfaceHit> nearest;
  for (const Start& start : starts) {
    if (nearest && start.distance > nearest->distance + 0.05 * radius_) break;
    const std::optional<SurfaceHit> hit = polish(surface, ray, start, radius_);
    if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
  }
  return nearest;
}

}  // namespace knotwork::scene
