#include "knotwork/surface/bspline_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "property/difference_check.h"
#include "unit/bspline_cases.h"

namespace knotwork::bspline_surface_test {
using namespace test;
namespace {

constexpr Ends all_ends[] = {Ends::clamped, Ends::unclamped, Ends::closed};

BSplineSurface random_surface(int p, int q, Ends u, Ends v, std::mt19937& random) {
  KnotVector knots_u = random_knots(p, p + 4, u, random), knots_v = random_knots(q, q + 3, v, random);
  std::vector<Eigen::Vector3d> points = random_points(static_cast<std::size_t>((p + 4) * (q + 3)), random);
  return BSplineSurface::make(std::move(knots_u), std::move(knots_v), std::move(points)).value();
}

/// A surface for every pair of ends, the degrees 1..9 mixed.
std::vector<BSplineSurface> random_surfaces(std::mt19937& random) {
  std::vector<BSplineSurface> surfaces;
  for (int degree = 1; degree <= 9; ++degree) {
    for (const Ends u : all_ends) {
      for (const Ends v : all_ends) {
        if ((degree + static_cast<int>(u) + static_cast<int>(v)) % 2 == 0)
          surfaces.push_back(random_surface(degree, 1 + (degree + 3) % 9, u, v, random));
      }
    }
  }
  return surfaces;
}

std::vector<double> parameters(const KnotVector& knots, int count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(knots.start(), knots.end());
  std::vector<double> t;
  t.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) t.push_back(place(random));
  return t;
}

double largest_point(const BSplineSurface& surface) {
  double size = 0;
  for (const Eigen::Vector3d& point : surface.points()) size = std::max(size, point.norm());
  return size;
}

/// The size of the terms of each vector of the jet.
std::array<double, 6> jet_sizes(const BSplineSurface& surface, double u, double v) {
  constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
  std::array<double, 6> sizes{};
  for (std::size_t k = 0; k < 6; ++k) {
    sizes[k] = largest_point(surface) * basis_size(surface.knots_u(), u, orders[k][0]) *
               basis_size(surface.knots_v(), v, orders[k][1]);
  }
  return sizes;
}

/// Whether two surfaces, or two ways to evaluate one, have the same jet at (u,v).
void check_same(const SurfaceJet& actual, const SurfaceJet& expected, const std::array<double, 6>& sizes,
                double tolerance) {
  for (int k = 0; k < 6; ++k) {
    CAPTURE(jet_names[k]);
    CHECK(close(jet_part(actual, k), jet_part(expected, k), tolerance, sizes[static_cast<std::size_t>(k)]));
  }
}

}  // namespace

TEST_CASE("tensor-product surfaces meet oracle 13") {
  const std::vector<SurfaceOracle> oracles = surface_oracles();
  REQUIRE(oracles.size() == 4);
  int compared = 0;
  for (const SurfaceOracle& oracle : oracles) {
    CAPTURE(oracle.name);
    for (const nlohmann::json& at : oracle.points) {
      const double u = at["u"].get<double>(), v = at["v"].get<double>();
      CAPTURE(u);
      CAPTURE(v);
      const SurfaceJet jet = oracle.surface.evaluate(u, v);
      const std::array<double, 6> sizes = jet_sizes(oracle.surface, u, v);
      for (int k = 0; k < 6; ++k, ++compared) {
        CAPTURE(jet_names[k]);
        CHECK(close(jet_part(jet, k), vector3(at[jet_names[k]]), oracle_tolerance, sizes[static_cast<std::size_t>(k)]));
      }
    }
  }
  CHECK(compared == 6 * 72);
}

TEST_CASE("a surface is its isoparametric curves, with their derivatives") {
  std::mt19937 random(51);
  for (const BSplineSurface& surface : random_surfaces(random)) {
    for (const double u : parameters(surface.knots_u(), 4, random)) {
      for (const double v : parameters(surface.knots_v(), 4, random)) {
        const SurfaceJet jet = surface.evaluate(u, v);
        Eigen::Vector3d along_u[3], along_v[3];
        surface.curve_u(v).evaluate(u, along_u);
        surface.curve_v(u).evaluate(v, along_v);
        SurfaceJet expected{along_u[0], along_u[1], along_v[1], along_u[2], jet.suv, along_v[2]};
        check_same(jet, expected, jet_sizes(surface, u, v), 1e-13);
        CHECK(close(along_v[0], jet.s, 1e-13, largest_point(surface)));
      }
    }
  }
}

TEST_CASE("a net of products is the product of curves, in all partials of any order") {
  std::mt19937 random(52);
  for (const Ends ends_u : all_ends) {
    for (const Ends ends_v : all_ends) {
      const int p = 4, q = 3;
      const BSplineCurve f = random_curve(p, 9, ends_u, random), g = random_curve(q, 8, ends_v, random);
      std::vector<Eigen::Vector3d> points;
      for (const Eigen::Vector3d& a : f.points()) {
        for (const Eigen::Vector3d& b : g.points()) points.emplace_back(a.cwiseProduct(b));
      }
      const BSplineSurface surface = BSplineSurface::make(f.knots(), g.knots(), std::move(points)).value();
      for (const double u : parameters(f.knots(), 5, random)) {
        for (const double v : parameters(g.knots(), 5, random)) {
          Eigen::Vector3d by_u[p + 2], by_v[q + 2], partials[(p + 2) * (q + 2)];
          f.evaluate(u, by_u);
          g.evaluate(v, by_v);
          surface.evaluate(u, v, p + 1, q + 1, partials);
          for (std::size_t a = 0; a < p + 2; ++a) {
            for (std::size_t b = 0; b < q + 2; ++b) {
              const double size =
                  derivative_size(f, u, static_cast<int>(a)) * derivative_size(g, v, static_cast<int>(b));
              CHECK(close(partials[a * (q + 2) + b], Eigen::Vector3d(by_u[a].cwiseProduct(by_v[b])), 1e-12, size));
            }
          }
          const SurfaceJet jet = surface.evaluate(u, v);
          const SurfaceJet expected{partials[0],           partials[q + 2], partials[1],
                                    partials[2 * (q + 2)], partials[q + 3], partials[2]};
          check_same(jet, expected, jet_sizes(surface, u, v), 1e-13);
        }
      }
    }
  }
}

TEST_CASE("a grid and a list are the single evaluations, sorted or not, inside and outside") {
  std::mt19937 random(53);
  const std::vector<BSplineSurface> surfaces = random_surfaces(random);
  for (std::size_t k = 0; k < surfaces.size(); k += 4) {
    const BSplineSurface& surface = surfaces[k];
    // More than a block of v.
    std::vector<double> u = parameters(surface.knots_u(), 3, random), v = parameters(surface.knots_v(), 40, random);
    u.push_back(surface.knots_u().end());
    u.push_back(surface.knots_u().end() + 1);
    v.push_back(surface.knots_v().start() - 2);
    v.push_back(surface.knots_v().end());
    for (const bool sorted : {false, true}) {
      if (sorted) std::sort(v.begin(), v.end());
      std::vector<SurfaceJet> grid(u.size() * v.size()), list(grid.size());
      std::vector<Eigen::Vector2d> uv;
      for (const double a : u) {
        for (const double b : v) uv.emplace_back(a, b);
      }
      surface.evaluate_grid(u, v, grid);
      surface.evaluate(uv, list);
      bool same = true;
      for (std::size_t at = 0; at < grid.size(); ++at) {
        const SurfaceJet one = surface.evaluate(uv[at].x(), uv[at].y());
        for (int part = 0; part < 6; ++part) {
          same = same && jet_part(grid[at], part) == jet_part(one, part) &&
                 jet_part(list[at], part) == jet_part(one, part);
        }
      }
      CHECK(same);
    }
  }
}

TEST_CASE("partials agree with differences, and a wrong partial is seen") {
  std::mt19937 random(54);
  for (const Ends ends_u : all_ends) {
    for (const Ends ends_v : all_ends) {
      const BSplineSurface surface = random_surface(4, 3, ends_u, ends_v, random);
      const auto widest_middle = [](const KnotVector& knots, double& h) {
        int widest = knots.degree();
        for (int i = widest; i <= knots.last_span(); ++i) {
          if (knots[i + 1] - knots[i] > knots[widest + 1] - knots[widest]) widest = i;
        }
        h = (knots[widest + 1] - knots[widest]) / 64;
        return (knots[widest] + knots[widest + 1]) / 2;
      };
      double h_u = 0, h_v = 0;
      const double u = widest_middle(surface.knots_u(), h_u), v = widest_middle(surface.knots_v(), h_v);
      DifferenceCheck check;
      check.tolerance = 1e-10;
      const std::array<double, 6> sizes = jet_sizes(surface, u, v);
      std::copy(sizes.begin(), sizes.end(), check.scale);
      const auto jet = [&](double a, double b) { return surface.evaluate(a, b); };
      CHECK(partials_agree(jet, u, v, h_u, h_v, check));
      for (int part = 1; part < 6; ++part) {
        const auto wrong = [&](double a, double b) {
          SurfaceJet result = surface.evaluate(a, b);
          Eigen::Vector3d* parts[] = {&result.s, &result.su, &result.sv, &result.suu, &result.suv, &result.svv};
          *parts[part] += 1e-6 * sizes[static_cast<std::size_t>(part)] * Eigen::Vector3d::Ones();
          return result;
        };
        CAPTURE(part);
        CHECK_FALSE(partials_agree(wrong, u, v, h_u, h_v, check));
      }
    }
  }
}

TEST_CASE("a knot in u or v keeps the surface") {
  std::mt19937 random(55);
  for (const BSplineSurface& surface : random_surfaces(random)) {
    const double knot_u = parameters(surface.knots_u(), 1, random)[0];
    const double knot_v = parameters(surface.knots_v(), 1, random)[0];
    const BSplineSurface finer = surface.with_knot_u(knot_u).value().with_knot_v(knot_v).value();
    CHECK(finer.knots_u().count() == surface.knots_u().count() + 1);
    CHECK(finer.knots_v().count() == surface.knots_v().count() + 1);
    for (const double u : parameters(surface.knots_u(), 3, random)) {
      for (const double v : parameters(surface.knots_v(), 3, random)) {
        check_same(finer.evaluate(u, v), surface.evaluate(u, v), jet_sizes(finer, u, v), 1e-12);
      }
    }
  }
}

TEST_CASE("closed directions repeat, open ones are clamped") {
  std::mt19937 random(56);
  const BSplineSurface surface = random_surface(3, 3, Ends::closed, Ends::clamped, random);
  CHECK(close(surface.evaluate(1.25 + 6, 2).s, surface.evaluate(1.25, 2).s, 1e-14, 5));
  CHECK(surface.evaluate(1, 7).s == surface.evaluate(1, 6).s);
  CHECK(surface.evaluate(1, -1).sv == surface.evaluate(1, 0).sv);
  // At the clamped end the surface is the curve of its last column.
  const int n_u = surface.knots_u().count(), n_v = surface.knots_v().count();
  std::vector<Eigen::Vector3d> column(static_cast<std::size_t>(n_u));
  for (int i = 0; i < n_u; ++i) column[static_cast<std::size_t>(i)] = surface.point(i, n_v - 1);
  CHECK(surface.evaluate(1, 6).s == BSplineCurve::make(surface.knots_u(), column).value()(1));
}

TEST_CASE("what is no B-spline surface is refused, with the place") {
  const KnotVector u = KnotVector::uniform(2, 4, Topology::open, 0, 1).value();
  const KnotVector v = KnotVector::uniform(1, 3, Topology::closed, 0, 1).value();
  std::vector<Eigen::Vector3d> points(12, Eigen::Vector3d::Ones());
  const Result<BSplineSurface> surface = BSplineSurface::make(u, v, points);
  REQUIRE(surface);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points[7].z() = nan;
  CHECK(BSplineSurface::make(u, v, points).error().path == "points[7]");
  points.pop_back();
  CHECK(BSplineSurface::make(u, v, points).error().path == "points");
  for (const double t : {-0.1, 0.0, 1.5, nan}) CHECK(surface.value().with_knot_u(t).error().path == "u");
  for (const double t : {0.0, nan}) CHECK(surface.value().with_knot_v(t).error().path == "v");
  CHECK(surface.value().with_knot_v(1.1).has_value());
}

}  // namespace knotwork::bspline_surface_test
