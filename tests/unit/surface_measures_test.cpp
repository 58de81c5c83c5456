#include "knotwork/surface/surface_measures.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "knotwork/surface/model_surface.h"
#include "unit/curvature_bounds.h"
#include "unit/oracle.h"

namespace knotwork::surface_measures_test {
using namespace test;

namespace {

using std::numbers::pi;

/// Area and total Gaussian curvature of a closed-closed surface on [0,2pi]^2 by the trapezoid rule, which converges
/// geometrically for periodic integrands.
struct Totals {
  double area = 0, gauss = 0;
};
Totals totals(const ModelSurface& model, int n) {
  Totals sum;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const SurfaceJet jet = evaluate(model, 2 * pi * a / n, 2 * pi * b / n);
      const double area = jet.su.cross(jet.sv).norm() * (2 * pi / n) * (2 * pi / n);
      sum.area += area;
      sum.gauss += area * curvature(jet).gaussian;
    }
  }
  return sum;
}

SurfaceJet jet_of(const Eigen::Vector3d& su, const Eigen::Vector3d& sv, const Eigen::Vector3d& suu = {0, 0, 0},
                  const Eigen::Vector3d& suv = {0, 0, 0}, const Eigen::Vector3d& svv = {0, 0, 0}) {
  return {{0, 0, 0}, su, sv, suu, suv, svv};
}

}  // namespace

TEST_CASE("oracle 08: curvatures of the torus") {
  const nlohmann::json torus = load_oracle("08_differential_geometry.json")["cases"]["torus_1_0.4_0.6"];
  REQUIRE(torus["points"].size() == 7);
  for (const nlohmann::json& point : torus["points"]) {
    const SurfaceJet jet = evaluate(Torus{1, 0.4, 0.6}, point["u"], point["v"]);
    const SurfaceCurvature c = curvature(jet);
    const CurvatureScale scale = curvature_scale(jet);
    CHECK(c.regular);
    CHECK(close(c.gaussian, point["K"].get<double>(), oracle_tolerance, scale.gaussian));
    CHECK(close(c.mean, point["H"].get<double>(), oracle_tolerance, scale.mean));
    CHECK(close(c.k_max, point["k_max"].get<double>(), oracle_tolerance, scale.mean));
    CHECK(close(c.k_min, point["k_min"].get<double>(), oracle_tolerance, scale.mean));
  }
}

TEST_CASE("oracle 08: area and total curvature of tori") {
  const nlohmann::json cases = load_oracle("08_differential_geometry.json")["cases"];
  const Totals elliptic = totals(Torus{1, 0.4, 0.6}, 96), circular = totals(Torus{1, 0.4, 0.4}, 96);
  CHECK(close(elliptic.area, cases["torus_1_0.4_0.6"]["area"].get<double>(), oracle_tolerance));
  CHECK(close(circular.area, cases["circular_torus_R1_r0.4"]["area"].get<double>(), oracle_tolerance));
  // Gauss-Bonnet: the total curvature of a torus is 0; its positive half is 4 pi.
  CHECK(close(elliptic.gauss, 0, oracle_tolerance, 8 * pi));
  CHECK(close(circular.gauss, 0, oracle_tolerance, 8 * pi));
}

TEST_CASE("oracle 08: closed forms on the circular torus, sphere-like sign of H") {
  const double r_wheel = 1, r = 0.4;
  for (int k = 0; k < 12; ++k) {
    const double v = 0.5 * k + 0.1, w = r_wheel + r * std::cos(v);
    const SurfaceJet jet = evaluate(Torus{r_wheel, r, r}, 0.7 * k, v);
    const SurfaceCurvature c = curvature(jet);
    const CurvatureScale scale = curvature_scale(jet);
    CHECK(close(c.gaussian, std::cos(v) / (r * w), oracle_tolerance, scale.gaussian));
    CHECK(close(c.mean, -(r_wheel + 2 * r * std::cos(v)) / (2 * r * w), oracle_tolerance, scale.mean));
    CHECK(close(c.k_max * c.k_min, c.gaussian, oracle_tolerance, scale.gaussian));
    CHECK(c.k_max >= c.k_min);
  }
}

TEST_CASE("oracle 09: unit normals, K and H of plane, cylinder and torus") {
  const nlohmann::json surfaces = load_oracle("09_catalog.json")["surfaces"];
  const std::pair<const char*, ModelSurface> models[] = {
      {"plane((3,4,5),(1,4,3),(1,1,2))", Plane{{3, 4, 5}, {1, 4, 3}, {1, 1, 2}}},
      {"cylinder(2,3.5,5)", Cylinder{2, 3.5, 5}},
      {"torus(1,0.4,0.6)", Torus{1, 0.4, 0.6}},
  };
  int points = 0;
  for (const auto& [name, model] : models) {
    for (const nlohmann::json& surface : surfaces) {
      if (surface["name"] != name) continue;
      for (const nlohmann::json& point : surface["points"]) {
        const SurfaceJet jet = evaluate(model, point["u"], point["v"]);
        const SurfaceCurvature c = curvature(jet);
        const CurvatureScale scale = curvature_scale(jet);
        CHECK(close(unit_normal(jet), vector3(point["unit_normal"]), oracle_tolerance));
        CHECK(close(c.gaussian, point["K"].get<double>(), oracle_tolerance, scale.gaussian));
        CHECK(close(c.mean, point["H"].get<double>(), oracle_tolerance, scale.mean));
        ++points;
      }
    }
  }
  CHECK(points >= 12);
}

TEST_CASE("measures do not depend on the size of the surface or the speed of its parameters") {
  const SurfaceJet jet = evaluate(Torus{1, 0.4, 0.6}, 0.3, 1.0);
  const SurfaceCurvature c = curvature(jet);
  for (const double size : {1e-40, 1e-3, 1e5, 1e40}) {
    for (const double speed : {1e-30, 1.0, 1e20}) {
      const double p = size * speed;
      const SurfaceJet scaled =
          jet_of(p * jet.su, p * jet.sv, p * speed * jet.suu, p * speed * jet.suv, p * speed * jet.svv);
      CHECK(close(unit_normal(scaled), unit_normal(jet), 1e-14));
      CHECK(close(curvature(scaled).mean * size, c.mean, 1e-13));
    }
  }
}

TEST_CASE("where a partial vanishes the normal is the limit along the surface") {
  // The pole of a sphere (cos u cos v, sin u cos v, sin v) at v = -pi/2, where S_u = 0 and the surface has v growing.
  const double u = 0.4;
  const SurfaceJet pole =
      jet_of({0, 0, 0}, {std::cos(u), std::sin(u), 0}, {0, 0, 0}, {-std::sin(u), std::cos(u), 0}, {0, 0, 1});
  CHECK(close(unit_normal(pole), {0, 0, -1}, 1e-15));
  CHECK_FALSE(curvature(pole).regular);
  CHECK(curvature(pole).gaussian == 0);
}

TEST_CASE("where the partials are parallel the normal is the limit") {
  // (u, u + v^2, 0) folds at v = 0; its image is the xy-plane.
  const SurfaceJet fold = jet_of({1, 1, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 2, 0});
  CHECK(close(unit_normal(fold), {0, 0, 1}, 1e-15));
  // Parallel, but not zero, first partials.
  const SurfaceJet parallel = jet_of({1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 3});
  CHECK(close(unit_normal(parallel), {0, -1, 0}, 1e-15));
  CHECK_FALSE(curvature(parallel).regular);
}

TEST_CASE("where all first partials vanish second partials decide, and z stands in at last") {
  CHECK(close(unit_normal(jet_of({0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 0, 3}, {0, 0, 0})), {0, -1, 0}, 1e-15));
  CHECK(close(unit_normal(jet_of({0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 5})), {0, -1, 0}, 1e-15));
  CHECK(unit_normal(SurfaceJet{}) == Eigen::Vector3d(0, 0, 1));
  CHECK(unit_normal(jet_of({1, 2, 3}, {0, 0, 0})) == Eigen::Vector3d(0, 0, 1));
  CHECK_FALSE(curvature(SurfaceJet{}).regular);
}

TEST_CASE("the normal has length 1 and is a number for extreme jets") {
  for (const double a : {0.0, 1e-300, 1e-150, 1e-12, 1.0, 1e12, 1e90}) {
    for (const double b : {0.0, 1e-300, 1e-150, 1e-12, 1.0, 1e12, 1e90}) {
      const SurfaceJet jet = jet_of({a, b, 0}, {b, 0, a}, {0, a, b}, {b, b, 0}, {a, -a, b});
      CHECK(close(unit_normal(jet).norm(), 1, 1e-14));
    }
  }
}

}  // namespace knotwork::surface_measures_test
