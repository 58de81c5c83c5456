#include "knotwork/scene/picking.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/surface_builder.h"

namespace knotwork::scene::picking_test {
namespace {

using std::numbers::pi;

BlendingSurface surface_of(const BlendingSurfaceObject& object) { return build_surface(object, Animation{}); }

BlendingSurface chapter_surface(Topology u = Topology::closed, Topology v = Topology::closed) {
  Document document = find_chapter("blending-surface")->start_document();
  blending_surface(document).topology_u = u;
  blending_surface(document).topology_v = v;
  return surface_of(blending_surface(document));
}

}  // namespace

TEST_CASE("picking: the exact point of an unmoved torus, from both sides") {
  BlendingSurfaceObject object;
  object.model = torus_surface(1, 0.4, 0.4);
  const BlendingSurface torus = surface_of(object);
  const PickNet net(knotted_surface(torus));

  const Ray along_x{{5, 0, 0}, {-2, 0, 0}};
  const auto front = net.pick(knotted_surface(torus), along_x);
  REQUIRE(front);
  CHECK(front->distance == doctest::Approx(3.6).epsilon(1e-12));
  CHECK(std::abs(std::remainder(front->u, 2 * pi)) < 1e-10);
  CHECK(std::abs(std::remainder(front->v, 2 * pi)) < 1e-10);
  CHECK((front->jet.s - Eigen::Vector3d(1.4, 0, 0)).norm() < 1e-12);

  const auto from_inside = net.pick(knotted_surface(torus), {{1, 0, 0}, {-1, 0, 0}});
  REQUIRE(from_inside);
  CHECK(from_inside->distance == doctest::Approx(0.4).epsilon(1e-12));
}

TEST_CASE("picking: rays at many points of an edited surface find points on the ray and on the surface") {
  for (Topology u : {Topology::open, Topology::closed}) {
    for (Topology v : {Topology::open, Topology::closed}) {
      const BlendingSurface surface = chapter_surface(u, v);
      const PickNet net(knotted_surface(surface));
      const double size = net.radius();
      int tried = 0, found = 0, nearer = 0, wrong = 0;
      for (int a = 0; a < 15; ++a) {
        for (int b = 0; b < 15; ++b) {
          const double s = (a + 0.37) / 15, t = (b + 0.61) / 15;
          const SurfaceJet target = surface.evaluate(-pi + 2 * pi * s, -pi + 2 * pi * t);
          const Ray ray{{6, -3, 5}, target.s - Eigen::Vector3d(6, -3, 5)};
          const auto hit = net.pick(knotted_surface(surface), ray);
          ++tried;
          if (!hit) continue;
          ++found;
          const Eigen::Vector3d on_ray = ray.origin + hit->distance * ray.direction.normalized();
          if ((on_ray - surface.evaluate(hit->u, hit->v).s).norm() > 1e-10 * size) ++wrong;
          // The point that was aimed at is met, or something stands before it.
          if (hit->distance <= ray.direction.norm() + 1e-6 * size) ++nearer;
        }
      }
      CHECK(found == tried);
      // A ray that only grazes the surface before its aim may miss the graze's side that is aimed at.
      CHECK(nearer >= found - 2);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("picking: the parameters lie in the domain, the seam included") {
  const BlendingSurface surface = chapter_surface();
  const PickNet net(knotted_surface(surface));
  // Straight at the seam u = -pi = pi from outside.
  const auto hit = net.pick(knotted_surface(surface), {{-5, 0, 0.01}, {1, 0, 0}});
  REQUIRE(hit);
  CHECK(hit->u >= surface.knots_u().start());
  CHECK(hit->u < surface.knots_u().end());
  CHECK(std::abs(std::abs(hit->u) - pi) < 1e-9);
  CHECK(hit->distance == doctest::Approx(5 - 1.45).epsilon(1e-3));
}

TEST_CASE("picking: works where the B-function has a kink") {
  Document document = find_chapter("blending-surface")->start_document();
  blending_surface(document).blending = BlendingKind::linear;
  const BlendingSurface surface = surface_of(blending_surface(document));
  const PickNet net(knotted_surface(surface));
  int found = 0;
  for (int k = 0; k < 100; ++k) {
    const SurfaceJet target = surface.evaluate(-1.9 + 0.017 * k, 0.002 * k);
    const Eigen::Vector3d outwards = 4 * Eigen::Vector3d(target.s.x(), target.s.y(), 0).normalized();
    if (const auto hit = net.pick(knotted_surface(surface), {target.s + outwards, -outwards})) {
      if ((hit->jet.s - target.s).norm() < 1e-6) ++found;
    }
  }
  CHECK(found >= 98);
}

TEST_CASE("picking: a miss, what lies behind and a ray without direction give nothing") {
  const BlendingSurface surface = chapter_surface();
  const PickNet net(knotted_surface(surface));
  CHECK_FALSE(net.pick(knotted_surface(surface), {{5, 0, 0}, {0, 0, 1}}));
  CHECK_FALSE(net.pick(knotted_surface(surface), {{5, 0, 0}, {1, 0, 0}}));
  CHECK_FALSE(net.pick(knotted_surface(surface), {{0, 0, 5}, {0, 0, -1}}));  // through the hole
  CHECK_FALSE(net.pick(knotted_surface(surface), {{5, 0, 0}, {0, 0, 0}}));
}

TEST_CASE("picking: the ball holds the surface and the net stays small for many patches") {
  Document document = find_chapter("blending-surface")->start_document();
  blending_surface(document).locals_u = blending_surface(document).locals_v = 64;
  const BlendingSurface surface = surface_of(blending_surface(document));
  const PickNet net(knotted_surface(surface));
  double outside = 0;
  for (int a = 0; a < 40; ++a) {
    for (int b = 0; b < 40; ++b) {
      const SurfaceJet jet = surface.evaluate(-pi + 0.157 * a, -pi + 0.157 * b);
      outside = std::max(outside, (jet.s - net.centre()).norm() - net.radius());
    }
  }
  CHECK(outside < 1e-2 * net.radius());
  const auto hit = net.pick(knotted_surface(surface), {{0, 5, 0.1}, {0, -1, 0}});
  REQUIRE(hit);
  CHECK(hit->jet.s.y() > 1.3);
}

}  // namespace knotwork::scene::picking_test
