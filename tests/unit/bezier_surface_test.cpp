#include "knotwork/surface/bezier_surface.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "knotwork/basis/bernstein.h"
#include "unit/bspline_cases.h"

namespace knotwork::bezier_surface_test {
using namespace test;
namespace {

const Eigen::Vector2d from(-1, 2), to(3, 2.5);

BezierSurface random_surface(int p, int q, std::mt19937& random) {
  return BezierSurface::make(p, q, random_points(static_cast<std::size_t>((p + 1) * (q + 1)), random), from, to)
      .value();
}

/// Places in the domain, its corners among them.
std::vector<Eigen::Vector2d> places() {
  std::vector<Eigen::Vector2d> out;
  for (const double a : {0.0, 0.21, 0.5, 0.93, 1.0}) {
    for (const double b : {0.0, 0.4, 0.77, 1.0})
      out.emplace_back(std::lerp(from.x(), to.x(), a), std::lerp(from.y(), to.y(), b));
  }
  return out;
}

void check_same(const BezierSurface& actual, const BezierSurface& expected, const Eigen::Vector2d& at) {
  const SurfaceJet a = actual.evaluate(at.x(), at.y()), b = expected.evaluate(at.x(), at.y());
  const Eigen::Vector2d length = to - from;
  const double p = 2 * actual.degree_u() / length.x(), q = 2 * actual.degree_v() / length.y();
  const double scale[6] = {10, 10 * p, 10 * q, 10 * p * p, 10 * p * q, 10 * q * q};
  for (int k = 0; k < 6; ++k) {
    CAPTURE(jet_names[k]);
    CHECK(close(jet_part(a, k), jet_part(b, k), 1e-12, scale[k]));
  }
}

}  // namespace

TEST_CASE("the seed's bilinear patch meets oracle 13") {
  int compared = 0;
  for (const SurfaceOracle& oracle : surface_oracles()) {
    if (oracle.name != "seed_bezier_2x2") continue;
    const std::vector<Eigen::Vector3d> points(oracle.surface.points().begin(), oracle.surface.points().end());
    const BezierSurface surface = BezierSurface::make(1, 1, points).value();
    for (const nlohmann::json& at : oracle.points) {
      const SurfaceJet jet = surface.evaluate(at["u"].get<double>(), at["v"].get<double>());
      for (int k = 0; k < 6; ++k, ++compared) {
        CHECK(close(jet_part(jet, k), vector3(at[jet_names[k]]), oracle_tolerance, 2));
      }
    }
  }
  CHECK(compared == 120);
}

TEST_CASE("all partials are those of the Bernstein-Hermite matrices: B_p C B_q^T") {
  std::mt19937 random(61);
  for (int p = 1; p <= max_bezier_degree; p += 5) {
    for (int q = 2; q <= max_bezier_degree; q += 7) {
      const BezierSurface surface = random_surface(p, q, random);
      for (const Eigen::Vector2d& at : places()) {
        const Eigen::Vector2d delta = (to - from).cwiseInverse(), w = (at - from).cwiseProduct(delta);
        const Eigen::MatrixXd by_u = bernstein_hermite(p, w.x(), delta.x());
        const Eigen::MatrixXd by_v = bernstein_hermite(q, w.y(), delta.y());
        const std::size_t width = static_cast<std::size_t>(q) + 1;
        std::vector<Eigen::Vector3d> partials(width * (static_cast<std::size_t>(p) + 1));
        surface.spline().evaluate(at.x(), at.y(), p, q, partials);
        for (Eigen::Index a = 0; a <= p; ++a) {
          for (Eigen::Index b = 0; b <= q; ++b) {
            Eigen::Vector3d expected = Eigen::Vector3d::Zero();
            double size = 0;
            for (int i = 0; i <= p; ++i) {
              for (int j = 0; j <= q; ++j) {
                const double weight = by_u(a, i) * by_v(b, j);
                expected += weight * surface.point(i, j);
                size += std::abs(weight) * surface.point(i, j).norm();
              }
            }
            CHECK(close(partials[static_cast<std::size_t>(a) * width + static_cast<std::size_t>(b)], expected, 1e-12,
                        size));
          }
        }
      }
    }
  }
}

TEST_CASE("de Casteljau's nets shrink to the point of the surface") {
  std::mt19937 random(62);
  const int degrees[][2] = {{1, 1}, {3, 3}, {2, 5}, {16, 1}, {4, 16}};
  for (const auto& [p, q] : degrees) {
    const BezierSurface surface = random_surface(p, q, random);
    for (const Eigen::Vector2d& at : places()) {
      const std::vector<PointNet> nets = surface.de_casteljau(at.x(), at.y());
      REQUIRE(nets.size() == static_cast<std::size_t>(std::max(p, q)) + 1);
      for (std::size_t k = 0; k < nets.size(); ++k) {
        CHECK(nets[k].rows == std::max(p + 1 - static_cast<int>(k), 1));
        CHECK(nets[k].columns == std::max(q + 1 - static_cast<int>(k), 1));
        CHECK(nets[k].points.size() == static_cast<std::size_t>(nets[k].rows * nets[k].columns));
      }
      CHECK(close(nets.back().points.front(), surface.evaluate(at.x(), at.y()).s, 1e-13, 9));
      // The first round: the bilinear point of every cell.
      const Eigen::Vector2d w = (at - from).cwiseQuotient(to - from);
      const Eigen::Vector3d cell = (1 - w.x()) * ((1 - w.y()) * surface.point(0, 0) + w.y() * surface.point(0, 1)) +
                                   w.x() * ((1 - w.y()) * surface.point(1, 0) + w.y() * surface.point(1, 1));
      CHECK(close(nets[1].points.front(), cell, 1e-14, 9));
    }
  }
}

TEST_CASE("elevation and splitting keep the surface") {
  std::mt19937 random(63);
  for (int p = 1; p < max_bezier_degree; p += 2) {
    const int q = 1 + (p + 6) % 15;
    const BezierSurface surface = random_surface(p, q, random);
    const BezierSurface raised_u = surface.elevated_u(), raised_v = surface.elevated_v();
    CHECK(raised_u.degree_u() == p + 1);
    CHECK(raised_u.degree_v() == q);
    CHECK(raised_v.degree_u() == p);
    CHECK(raised_v.degree_v() == q + 1);
    const double u = std::lerp(from.x(), to.x(), 0.3), v = std::lerp(from.y(), to.y(), 0.6);
    const auto [left, right] = surface.split_u(u);
    const auto [below, above] = surface.split_v(v);
    CHECK(left.end() == Eigen::Vector2d(u, to.y()));
    CHECK(right.start() == Eigen::Vector2d(u, from.y()));
    CHECK(below.end() == Eigen::Vector2d(to.x(), v));
    CHECK(above.start() == Eigen::Vector2d(from.x(), v));
    for (const Eigen::Vector2d& at : places()) {
      CAPTURE(p);
      check_same(raised_u, surface, at);
      check_same(raised_v, surface, at);
      check_same(at.x() < u ? left : right, surface, at);
      check_same(at.y() < v ? below : above, surface, at);
    }
  }
}

TEST_CASE("a split next to the end is a split") {
  std::mt19937 random(64);
  const BezierSurface surface = random_surface(3, 2, random);
  const auto [most, least] = surface.split_u(std::nextafter(to.x(), 0));
  CHECK(most.end().x() < to.x());
  CHECK(least.end().x() == to.x());
}

TEST_CASE("outside, parameters are clamped") {
  std::mt19937 random(65);
  const BezierSurface surface = random_surface(3, 2, random);
  CHECK(surface.evaluate(-5, 9).s == surface.point(0, 2));
  CHECK(surface.evaluate(9, 2.1).su == surface.evaluate(3, 2.1).su);
}

TEST_CASE("what is no Bezier surface is refused, with the place") {
  const std::vector<Eigen::Vector3d> points(6, Eigen::Vector3d::Ones());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(BezierSurface::make(1, 2, points).has_value());
  CHECK(BezierSurface::make(2, 2, points).error().path == "points");
  CHECK(BezierSurface::make(0, 5, points).error().path == "degree_u");
  CHECK(BezierSurface::make(5, 0, points).error().path == "degree_v");
  CHECK(BezierSurface::make(17, 1, points).error().path == "degree_u");
  CHECK(BezierSurface::make(1, 17, points).error().path == "degree_v");
  CHECK(BezierSurface::make(1, 2, points, {nan, 0}).error().path == "start");
  CHECK(BezierSurface::make(1, 2, points, {0, 0}, {1, nan}).error().path == "end");
  CHECK(BezierSurface::make(1, 2, points, {0, 0}, {0, 1}).error().path == "end");
  std::vector<Eigen::Vector3d> broken = points;
  broken[4].x() = std::numeric_limits<double>::infinity();
  CHECK(BezierSurface::make(1, 2, broken).error().path == "points[4]");
}

}  // namespace knotwork::bezier_surface_test
