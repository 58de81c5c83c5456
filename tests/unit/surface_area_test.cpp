#include "knotwork/surface/surface_area.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/surface/blending_surface.h"
#include "knotwork/surface/closest_surface_point.h"
#include "knotwork/surface/surface_measures.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::surface_area_test {
using namespace test;
namespace {

using std::numbers::pi;

struct Ball {
  double radius;
  SurfaceJet evaluate(double u, double v) const { return sphere(radius, u, v); }
};

/// (uv, u, v^2): S_u x S_v vanishes at the origin.
struct Whitney {
  static SurfaceJet evaluate(double u, double v) {
    return {{u * v, u, v * v}, {v, 1, 0}, {u, 0, 2 * v}, {0, 0, 0}, {1, 0, 0}, {0, 0, 2}};
  }
};

/// The total Gaussian curvature of a closed torus, by the trapezoid rule, which converges geometrically for periodic
/// integrands.
double total_curvature(const ModelSurface& model, int n) {
  double sum = 0;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const SurfaceJet jet = evaluate(model, 2 * pi * a / n, 2 * pi * b / n);
      sum += jet.su.cross(jet.sv).norm() * (2 * pi / n) * (2 * pi / n) * curvature(jet).gaussian;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("oracle 08: areas of two tori and a sphere") {
  const nlohmann::json& cases = load_oracle("08_differential_geometry.json")["cases"];
  REQUIRE(cases.contains("sphere_r2"));
  const SurfaceArea elliptic = surface_area(surface_view(torus_surface(1, 0.4, 0.6)));
  const SurfaceArea circular = surface_area(surface_view(torus_surface(1, 0.4, 0.4)));
  CHECK(close(elliptic.value, cases["torus_1_0.4_0.6"]["area"].get<double>(), oracle_tolerance));
  CHECK(close(circular.value, read_case(cases["circular_torus_R1_r0.4"])["area"].get<double>(), oracle_tolerance));
  CHECK(elliptic.error <= 1e-13 * elliptic.value);
  const Ball ball{2};
  const SurfaceDomain domain{{0, 2 * pi}, {-pi / 2, pi / 2}, Closure::closed, Closure::open};
  CHECK(close(surface_area(surface_view(ball, domain)).value, cases["sphere_r2"]["area"].get<double>(),
              oracle_tolerance));
  // Half of it is half: the comparison sees what is missing.
  const SurfaceDomain half{{0, pi}, {-pi / 2, pi / 2}, Closure::open, Closure::open};
  CHECK(close(2 * surface_area(surface_view(ball, half)).value, cases["sphere_r2"]["area"].get<double>(),
              oracle_tolerance));
}

TEST_CASE("Gauss-Bonnet: the total curvature of a torus is 0") {
  CHECK(close(total_curvature(torus_surface(1, 0.4, 0.6), 96), 0, oracle_tolerance, 8 * pi));
  CHECK(close(total_curvature(torus_surface(1, 0.4, 0.4), 96), 0, oracle_tolerance, 8 * pi));
}

TEST_CASE("areas of planes and cylinders") {
  CHECK(close(surface_area(surface_view(plane_surface({3, 4, 5}, {2, 0, 0}, {0, 3, 0}))).value, 6, 1e-14));
  CHECK(close(surface_area(surface_view(cylinder_surface(2, 2, 5))).value, 20 * pi, 1e-14));
}

TEST_CASE("the area of a blending surface is that of its model while its locals are unmoved, and grows with a bump") {
  const ModelSurface model = torus_surface(1, 0.4, 0.4);
  const KnotVector knots = KnotVector::uniform(1, 4, Topology::closed, 0, 2 * pi).value();
  std::vector<Eigen::Affine3d> locals = BlendingSurface::unmoved_locals(model, knots, knots);
  const BlendingFunction blending = BlendingFunction::make(BlendingKind::polynomial1).value();
  BlendingSurface surface = BlendingSurface::make(model, knots, knots, blending, locals).value();
  const double whole = surface_area(surface_view(model)).value;
  CHECK(close(surface_area(surface_view(surface)).value, whole, 1e-12));
  surface.set_local(1, 1, Eigen::Translation3d(0, 0, 1) * locals[5]);
  const SurfaceArea bumped = surface_area(surface_view(surface));
  CHECK(bumped.value > 1.05 * whole);
  CHECK(bumped.error <= 1e-12 * bumped.value);
}

TEST_CASE("where the partials are parallel inside, the error says how near the area is") {
  const Whitney umbrella;
  const SurfaceDomain domain{{-1, 1.3}, {-1, 1.7}, Closure::open, Closure::open};
  const SurfaceArea area = surface_area(surface_view(umbrella, domain));
  // |S_u x S_v| = sqrt(4 v^2 + 4 v^4 + u^2), by the midpoint rule.
  double expected = 0;
  const int n = 2000;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const double u = -1 + 2.3 * (a + 0.5) / n, v = -1 + 2.7 * (b + 0.5) / n;
      expected += std::sqrt(4 * v * v + 4 * v * v * v * v + u * u) * (2.3 / n) * (2.7 / n);
    }
  }
  CHECK(close(area.value, expected, 1e-6));
  CHECK(area.error < 1e-9);
}

TEST_CASE("a surface without extent has no area") {
  const Ball point{0};
  const SurfaceDomain domain{{0, 1}, {0, 1}, Closure::open, Closure::open};
  const SurfaceArea area = surface_area(surface_view(point, domain));
  CHECK(area.value == 0);
  CHECK(area.error == 0);
}

TEST_CASE("surfaces of the catalogue have views, and blending surfaces with a twisted seam") {
  const CatalogueSurface sphere = make_catalogue_surface("sphere", std::array{1.2}).value();
  CHECK(close(surface_area(surface_view(sphere)).value, 4 * pi * 1.44, 1e-12));
  const CatalogueSurface torus = torus_surface(1, 0.4, 0.4);
  CHECK(close(surface_area(surface_view(torus)).value, 4 * pi * pi * 0.4, 1e-12));
  CHECK(surface_view(torus).domain.closure_u == Closure::closed);

  const ModelSurface strip = make_catalogue_surface("moebius").value();
  const SurfaceDomain where = domain(strip);
  const KnotVector u = KnotVector::uniform(1, 3, Topology::open, where.u.start, where.u.end).value();
  const KnotVector v = KnotVector::uniform(1, 4, Topology::closed, where.v.start, where.v.end).value();
  const BlendingSurface surface =
      BlendingSurface::make(strip, u, v, BlendingFunction::make(BlendingKind::polynomial3).value(),
                            BlendingSurface::unmoved_locals(strip, u, v))
          .value();
  CHECK(surface_view(surface).domain.closure_v == Closure::twisted);
  CHECK(close(surface_area(surface_view(surface)).value, surface_area(surface_view(strip)).value, 1e-12));
  // Beside the seam, on either side.
  for (const double t : {v.start() + 0.01, v.end() - 0.01}) {
    const SurfaceJet jet = surface.evaluate(0.3, t);
    const Eigen::Vector3d beside = jet.s + 0.05 * jet.su.cross(jet.sv).normalized();
    CHECK(close(closest_point(surface_view(surface), beside).value().distance, 0.05, 1e-9));
  }
}

}  // namespace knotwork::surface_area_test
