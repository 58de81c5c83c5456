#include "knotwork/surface/closest_surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/surface_measures.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::closest_surface_point_test {
using namespace test;
namespace {

using std::numbers::pi;

struct Ball {
  double radius;
  SurfaceJet evaluate(double u, double v) const { return sphere(radius, u, v); }
};
constexpr SurfaceDomain ball_domain{{0, 2 * pi}, {-pi / 2, pi / 2}, Closure::closed, Closure::open};

ClosestSurfacePoint nearest(const SurfaceView& surface, const Eigen::Vector3d& point) {
  return closest_point(surface, point).value();
}

/// The least distance to n x n points, the best of them improved by a pattern search.
double brute_distance(const SurfaceView& surface, const Eigen::Vector3d& point, int n) {
  const SurfaceDomain& where = surface.domain;
  const auto inside = [](double x, const Interval& domain, Closure closure) {
    if (closure == Closure::open) return std::clamp(x, domain.start, domain.end);
    const double length = domain.end - domain.start;
    return x < domain.start ? x + length : x > domain.end ? x - length : x;
  };
  const auto distance = [&](double u, double v) {
    return (surface.evaluate(inside(u, where.u, where.closure_u), inside(v, where.v, where.closure_v)).s - point)
        .norm();
  };
  double best = 1e300, best_u = 0, best_v = 0;
  for (int a = 0; a <= n; ++a) {
    for (int b = 0; b <= n; ++b) {
      const double u = std::lerp(where.u.start, where.u.end, static_cast<double>(a) / n);
      const double v = std::lerp(where.v.start, where.v.end, static_cast<double>(b) / n);
      if (const double d = distance(u, v); d < best) best = d, best_u = u, best_v = v;
    }
  }
  double step_u = (where.u.end - where.u.start) / n, step_v = (where.v.end - where.v.start) / n;
  for (int round_trip = 0; round_trip < 400; ++round_trip) {
    bool moved = false;
    for (const auto& [a, b] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const double u = inside(best_u + a * step_u, where.u, where.closure_u);
      const double v = inside(best_v + b * step_v, where.v, where.closure_v);
      if (const double d = distance(u, v); d < best) best = d, best_u = u, best_v = v, moved = true;
    }
    if (!moved) step_u /= 2, step_v /= 2;
  }
  return best;
}

}  // namespace

TEST_CASE("the closest point of a torus is known") {
  const ModelSurface torus = torus_surface(1, 0.4, 0.4);
  for (int k = 0; k < 60; ++k) {
    const double u = 0.1 * k + 0.02, v = std::fmod(0.37 * k + 0.01, 2 * pi), r = 0.05 + 0.02 * k;
    // On the circle of radius r about the tube's middle: the nearest point stands before it, while r < the wheel.
    const double w = 1 + r * std::cos(v);
    if (w < 0.05) continue;
    const ClosestSurfacePoint found = nearest(surface_view(torus), {w * std::cos(u), w * std::sin(u), r * std::sin(v)});
    CHECK(close(found.distance, std::abs(r - 0.4), 1e-13, 1));
    CHECK(close(found.u, u, 1e-12, 1));
    CHECK(close(found.v, v, 1e-12, 1));
  }
}

TEST_CASE("poles, edges, ties, and the whole surface equally near") {
  const Ball ball{2};
  const SurfaceView view = surface_view(ball, ball_domain);
  CHECK(close(nearest(view, {0, 0, 5}).point, {0, 0, 2}, 1e-14));
  CHECK(close(nearest(view, {0, 0, 5}).distance, 3, 1e-14));
  CHECK(close(nearest(view, {1e-3, 2e-3, 5}).distance, Eigen::Vector3d(1e-3, 2e-3, 5).norm() - 2, 1e-14));
  CHECK(close(nearest(view, {0, 0, 0}).distance, 2, 1e-14));
  CHECK(nearest(view, {0, 0, 0}).u == 0);
  CHECK(nearest(view, {0, 0, 0}).v == -pi / 2);
  const ModelSurface plane = plane_surface({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  const ClosestSurfacePoint corner = nearest(surface_view(plane), {-1, 3, 1});
  CHECK(corner.u == 0);
  CHECK(corner.v == 1);
  CHECK(close(corner.distance, std::sqrt(3.0), 1e-15));
  const ClosestSurfacePoint edge = nearest(surface_view(plane), {0.61, 7, 0});
  CHECK(close(edge.u, 0.305, 1e-14));
  CHECK(edge.v == 1);
  // Two opposite points of a cylinder: the first in u, then in v.
  const ModelSurface tube = cylinder_surface(1, 2, 4);
  const ClosestSurfacePoint tie = nearest(surface_view(tube), {0, 0, 1});
  CHECK(close(tie.u, 0.25, 1e-14));
  CHECK(close(tie.v, -1.5 * pi, 1e-13));
}

TEST_CASE("no point of random surfaces is nearer than the closest point") {
  std::mt19937 random(81);
  const KnotVector closed = KnotVector::uniform(1, 4, Topology::closed, 0, 2 * pi).value();
  const ModelSurface model = torus_surface(1, 0.4, 0.6);
  const BlendingFunction blending = BlendingFunction::make(BlendingKind::polynomial2).value();
  int compared = 0;
  for (int k = 0; k < 12; ++k) {
    std::vector<Eigen::Affine3d> locals = BlendingSurface::unmoved_locals(model, closed, closed);
    for (Eigen::Affine3d& local : locals) {
      const RigidMotion motion = random_motion(random);
      local = local * Eigen::AngleAxisd(motion.move.x() / 10, motion.turn.col(0).eval());
      local.translation() += motion.move / 20;
    }
    const BlendingSurface surface = BlendingSurface::make(model, closed, closed, blending, locals).value();
    const SurfaceView view = surface_view(surface);
    for (int m = 0; m < 8; ++m) {
      const Eigen::Vector3d point = random_point(random, m % 2 == 0 ? 1 : 3);
      const ClosestSurfacePoint found = nearest(view, point);
      CHECK(found.distance <= brute_distance(view, point, 60) + 1e-12);
      CHECK(close(found.point, surface.evaluate(found.u, found.v).s, 0));
      CHECK(close((found.point - point).norm(), found.distance, 1e-15));
      // The way to the point stands across the surface.
      const SurfaceJet jet = surface.evaluate(found.u, found.v);
      CHECK(close((point - found.point).cross(unit_normal(jet)), {0, 0, 0}, 1e-7, found.distance + 1));
      ++compared;
    }
  }
  CHECK(compared == 96);
}

TEST_CASE("a point that is no point is refused") {
  const ModelSurface tube = cylinder_surface(1, 2, 4);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), -1e101})
    CHECK(closest_point(surface_view(tube), {0, bad, 0}).error().path == "point");
}

}  // namespace knotwork::closest_surface_point_test
