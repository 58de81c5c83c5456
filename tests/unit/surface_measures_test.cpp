#include "knotwork/surface/surface_measures.h"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Geometry>

#include "knotwork/surface/model_surface.h"
#include "unit/analytic_curves.h"
#include "unit/curvature_bounds.h"
#include "unit/oracle.h"

namespace knotwork::surface_measures_test {
using namespace test;

namespace {

using std::numbers::pi;

SurfaceJet jet_of(const Eigen::Vector3d& su, const Eigen::Vector3d& sv, const Eigen::Vector3d& suu = {0, 0, 0},
                  const Eigen::Vector3d& suv = {0, 0, 0}, const Eigen::Vector3d& svv = {0, 0, 0}) {
  return {{0, 0, 0}, su, sv, suu, suv, svv};
}

}  // namespace

TEST_CASE("oracle 08: curvatures of the torus") {
  const nlohmann::json& torus = read_case(load_oracle("08_differential_geometry.json")["cases"]["torus_1_0.4_0.6"]);
  REQUIRE(torus["points"].size() == 7);
  for (const nlohmann::json& point : torus["points"]) {
    const SurfaceJet jet = evaluate(torus_surface(1, 0.4, 0.6), point["u"], point["v"]);
    const SurfaceCurvature c = curvature(jet);
    const CurvatureScale scale = curvature_scale(jet);
    CHECK(c.regular);
    CHECK(close(c.gaussian, point["K"].get<double>(), oracle_tolerance, scale.gaussian));
    CHECK(close(c.mean, point["H"].get<double>(), oracle_tolerance, scale.mean));
    CHECK(close(c.k_max, point["k_max"].get<double>(), oracle_tolerance, scale.mean));
    CHECK(close(c.k_min, point["k_min"].get<double>(), oracle_tolerance, scale.mean));
  }
}

TEST_CASE("oracle 08: closed forms on the circular torus, sphere-like sign of H") {
  const double r_wheel = 1, r = 0.4;
  for (int k = 0; k < 12; ++k) {
    const double v = 0.5 * k + 0.1, w = r_wheel + r * std::cos(v);
    const SurfaceJet jet = evaluate(torus_surface(r_wheel, r, r), 0.7 * k, v);
    const SurfaceCurvature c = curvature(jet);
    const CurvatureScale scale = curvature_scale(jet);
    CHECK(close(c.gaussian, std::cos(v) / (r * w), oracle_tolerance, scale.gaussian));
    CHECK(close(c.mean, -(r_wheel + 2 * r * std::cos(v)) / (2 * r * w), oracle_tolerance, scale.mean));
    CHECK(close(c.k_max * c.k_min, c.gaussian, oracle_tolerance, scale.gaussian));
    CHECK(c.k_max >= c.k_min);
  }
}

TEST_CASE("oracle 08: curvatures of the sphere and the cylinder") {
  const nlohmann::json& cases = load_oracle("08_differential_geometry.json")["cases"];
  REQUIRE(cases.contains("sphere_r2"));
  read_case(cases["sphere_r2"]);
  read_case(cases["cylinder_r2"]);
  for (int k = 0; k < 12; ++k) {
    const SurfaceCurvature ball = curvature(sphere(2, 0.5 * k, 0.2 * k - 1.2));
    CHECK(close(ball.gaussian, cases["sphere_r2"]["K"].get<double>(), oracle_tolerance));
    CHECK(close(std::abs(ball.mean), cases["sphere_r2"]["abs_H"].get<double>(), oracle_tolerance));
    const SurfaceCurvature tube = curvature(evaluate(cylinder_surface(2, 2, 5), 0.1, 0.5 * k));
    CHECK(close(tube.gaussian, cases["cylinder_r2"]["K"].get<double>(), oracle_tolerance, 0.25));
    CHECK(close(std::abs(tube.mean), cases["cylinder_r2"]["abs_H"].get<double>(), oracle_tolerance));
  }
}

TEST_CASE("oracle 09: unit normals, K and H of every surface of the catalogue, from its partials") {
  const nlohmann::json& surfaces = load_oracle("09_catalog.json")["surfaces"];
  REQUIRE(surfaces.size() == 29);
  int points = 0;
  for (const nlohmann::json& surface : surfaces) {
    const std::string name = surface["name"].get<std::string>();
    CAPTURE(name);
    for (const nlohmann::json& at : surface["points"]) {
      SurfaceJet jet;
      jet.s = vector3(at["S"]), jet.su = vector3(at["Su"]), jet.sv = vector3(at["Sv"]);
      jet.suu = vector3(at["Suu"]), jet.suv = vector3(at["Suv"]), jet.svv = vector3(at["Svv"]);
      const SurfaceCurvature c = curvature(jet);
      const CurvatureScale scale = curvature_scale(jet);
      const double parallel = jet.su.norm() * jet.sv.norm() / jet.su.cross(jet.sv).norm();
      CHECK(close(unit_normal(jet), vector3(at["unit_normal"]), oracle_tolerance, parallel));
      CHECK(close(c.gaussian, at["K"].get<double>(), oracle_tolerance, scale.gaussian));
      CHECK(close(c.mean, at["H"].get<double>(), oracle_tolerance, scale.mean));
      if (std::abs(c.mean) > 1e-6 * scale.mean)
        CHECK_FALSE(close(1.0001 * c.mean, at["H"].get<double>(), oracle_tolerance, scale.mean));
      const FundamentalForms form = fundamental_forms(jet);
      const double area2 = form.E * form.G - form.F * form.F;
      CHECK(close((form.e * form.g - form.f * form.f) / area2, c.gaussian, 1e-10, scale.gaussian * parallel));
      CHECK(close((form.e * form.G - 2 * form.f * form.F + form.g * form.E) / (2 * area2), c.mean, 1e-10,
                  scale.mean * parallel));
      ++points;
    }
  }
  CHECK(points == 116);
}

TEST_CASE("both fundamental forms of the torus, in closed form") {
  const double r_wheel = 1, r = 0.4;
  for (int k = 0; k < 12; ++k) {
    const double v = 0.5 * k + 0.1, w = r_wheel + r * std::cos(v);
    const FundamentalForms form = fundamental_forms(evaluate(torus_surface(r_wheel, r, r), 0.7 * k, v));
    CHECK(close(form.E, w * w, 1e-14));
    CHECK(close(form.F, 0, 1e-15, 1));
    CHECK(close(form.G, r * r, 1e-14));
    CHECK(close(form.e, -w * std::cos(v), 1e-14, 1));
    CHECK(close(form.f, 0, 1e-15, 1));
    CHECK(close(form.g, -r, 1e-14));
  }
}

TEST_CASE("along the principal directions, and only there, the surface bends by the principal curvatures") {
  std::mt19937 random(71);
  for (int k = 0; k < 200; ++k) {
    const auto about = [&] { return random_point(random, 1); };
    const SurfaceJet jet = jet_of(about(), about(), about(), about(), about());
    const SurfaceCurvature c = curvature(jet);
    const PrincipalDirections d = principal_directions(jet);
    const Eigen::Vector3d n = unit_normal(jet);
    const FundamentalForms form = fundamental_forms(jet);
    const CurvatureScale scale = curvature_scale(jet);
    // A tangent's curvature is the second form over the first, of its parts along S_u and S_v.
    const auto bend = [&](const Eigen::Vector3d& tangent) {
      Eigen::Matrix<double, 3, 2> partials;
      partials << jet.su, jet.sv;
      const Eigen::Vector2d by = partials.colPivHouseholderQr().solve(tangent);
      return form.e * by[0] * by[0] + 2 * form.f * by[0] * by[1] + form.g * by[1] * by[1];
    };
    CHECK(d.regular);
    CHECK(close(d.max.norm(), 1, 1e-14));
    CHECK(close(d.max.dot(n), 0, 1e-13, 1));
    CHECK(close(n.cross(d.max), d.min, 1e-14));
    CHECK(close(bend(d.max), c.k_max, 1e-10, scale.mean));
    CHECK(close(bend(d.min), c.k_min, 1e-10, scale.mean));
    CHECK(bend((d.max + 0.1 * d.min).normalized()) < c.k_max);
    CHECK(bend((d.min + 0.1 * d.max).normalized()) > c.k_min);
  }
  // The cylinder bends across its axis: inwards, hence that is `min`.
  const PrincipalDirections tube = principal_directions(evaluate(cylinder_surface(2, 2, 5), 0.1, 0.4));
  CHECK(close(std::abs(tube.max.z()), 1, 1e-14));
  CHECK(close(tube.min.z(), 0, 1e-14, 1));
}

TEST_CASE("umbilics and degenerate points have the directions that are stated") {
  const SurfaceJet ball = sphere(2, 0.4, 0.3);
  CHECK(close(principal_directions(ball).max, ball.su.normalized(), 1e-14));
  CHECK(principal_directions(ball).regular);
  const SurfaceJet flat = evaluate(plane_surface({3, 4, 5}, {1, 4, 3}, {1, 1, 2}), 0.1, 0.2);
  CHECK(close(principal_directions(flat).max, flat.su.normalized(), 1e-14));
  SurfaceJet pole = sphere(2, 0.4, -pi / 2);
  pole.su.setZero(), pole.suu.setZero();  // the cosine of the rounded pi/2 is not 0
  for (const SurfaceJet& jet : {pole, SurfaceJet{}, jet_of({1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 3})}) {
    const PrincipalDirections d = principal_directions(jet);
    CHECK_FALSE(d.regular);
    CHECK(close(d.max.norm(), 1, 1e-15));
    CHECK(close(d.min, unit_normal(jet).cross(d.max), 1e-15));
    CHECK(close(d.max.dot(unit_normal(jet)), 0, 1e-14, 1));
    const FundamentalForms form = fundamental_forms(jet);
    CHECK(std::isfinite(form.e + form.f + form.g));
  }
  // The pole's second form is that of its limit normal.
  CHECK(close(fundamental_forms(pole).g, -2, 1e-14));
}

TEST_CASE("curvatures do not see a motion or the parameters, turn round with the normal, and scale") {
  std::mt19937 random(72);
  const SurfaceJet jet = evaluate(torus_surface(1, 0.4, 0.6), 0.3, 1.0);
  const SurfaceCurvature c = curvature(jet);
  for (int k = 0; k < 50; ++k) {
    const RigidMotion motion = random_motion(random);
    const auto turned = [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(motion.turn * x); };
    const SurfaceJet there{motion.move,     turned(jet.su),  turned(jet.sv),
                           turned(jet.suu), turned(jet.suv), turned(jet.svv)};
    CHECK(close(curvature(there).gaussian, c.gaussian, 1e-13));
    CHECK(close(curvature(there).mean, c.mean, 1e-13));
    // u = x + a y + b x y, v = y at (0,0): S_x = S_u, S_y = a S_u + S_v, S_xy = a S_uu + S_uv + b S_u, ..
    const double a = motion.move.x() / 5, b = motion.move.y();
    const SurfaceJet sheared = jet_of(jet.su, a * jet.su + jet.sv, jet.suu, a * jet.suu + jet.suv + b * jet.su,
                                      a * a * jet.suu + 2 * a * jet.suv + jet.svv);
    CHECK(close(curvature(sheared).gaussian, c.gaussian, 1e-12));
    CHECK(close(curvature(sheared).k_max, c.k_max, 1e-12));
    CHECK(close(std::abs(principal_directions(sheared).max.dot(principal_directions(jet).max)), 1, 1e-12));
  }
  const SurfaceJet flipped = jet_of(jet.sv, jet.su, jet.svv, jet.suv, jet.suu);
  CHECK(close(curvature(flipped).mean, -c.mean, 1e-14));
  CHECK(close(curvature(flipped).gaussian, c.gaussian, 1e-14));
}

TEST_CASE("measures do not depend on the size of the surface or the speed of its parameters") {
  const SurfaceJet jet = evaluate(torus_surface(1, 0.4, 0.6), 0.3, 1.0);
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
