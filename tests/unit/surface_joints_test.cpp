#include "knotwork/surface/surface_joints.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/surface_builder.h"

namespace knotwork::surface_joints_test {
namespace {

SurfaceJoints joints_with(std::string_view function) {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"blending.function", std::string(function)}));
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  return surface_joints(knotted_surface(surface), 8);
}

TEST_CASE("the order of the blending function is the order of contact across knot lines") {
  const SurfaceJoints linear = joints_with("linear"), first = joints_with("polynomial1"),
                      second = joints_with("polynomial2");
  for (const SurfaceJoints& joints : {linear, first, second}) CHECK(joints.gap < 1e-12);
  CHECK(linear.kink > 0.05);
  CHECK(first.kink < 1e-6);
  CHECK(second.kink < 1e-6);
  CHECK(first.bend > 0.1);
  CHECK(second.bend < 1e-6);
}

TEST_CASE("a net of degree 1 has the kinks of its facets") {
  // A roof: three rows, the middle one raised; its two sides are inclined by 45 degrees.
  const KnotVector u = KnotVector::make(1, Topology::open, {0, 0, 1, 2, 2}).value();
  const KnotVector v = KnotVector::make(1, Topology::open, {0, 0, 1, 1}).value();
  std::vector<Eigen::Vector3d> net;
  for (const double x : {0.0, 1.0, 2.0})
    for (const double y : {0.0, 1.0}) net.emplace_back(x, y, 1 - std::abs(x - 1));
  const BSplineSurface roof = BSplineSurface::make(u, v, net).value();
  const SurfaceJoints joints = surface_joints(knotted_surface(roof), 4);
  CHECK(joints.kink == doctest::Approx(std::numbers::pi / 2));
  CHECK(joints.gap < 1e-15);
}

TEST_CASE("a fold is a kink of half a turn, though both sides have one tangent plane") {
  const KnotVector u = KnotVector::make(1, Topology::open, {0, 0, 1, 2, 2}).value();
  const KnotVector v = KnotVector::make(1, Topology::open, {0, 0, 1, 1}).value();
  const std::vector<Eigen::Vector3d> net{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {0, 1, 0}};
  const BSplineSurface fold = BSplineSurface::make(u, v, net).value();
  CHECK(surface_joints(knotted_surface(fold), 4).kink == doctest::Approx(std::numbers::pi));
}

/// A cylinder of radius 1, over [-1, 1] x [0, 1], whose lines v = const have a corner at u = 0.
struct BrokenLines {
  KnotVector u = KnotVector::make(1, Topology::open, {-1, -1, 0, 1, 1}).value();
  KnotVector v = KnotVector::make(1, Topology::open, {0, 0, 1, 1}).value();

  const KnotVector& knots_u() const { return u; }
  const KnotVector& knots_v() const { return v; }
  static SurfaceJet evaluate(double s, double t) {
    const double turn = s < 0 ? 0 : 1;
    return {{std::sin(s), t + turn * s, std::cos(s)},
            {std::cos(s), turn, -std::sin(s)},
            {0, 1, 0},
            {-std::sin(s), 0, -std::cos(s)},
            {0, 0, 0},
            {0, 0, 0}};
  }
  static void evaluate_grid(std::span<const double> s, std::span<const double> t, std::span<SurfaceJet> out) {
    for (std::size_t a = 0; a < s.size(); ++a)
      for (std::size_t b = 0; b < t.size(); ++b) out[a * t.size() + b] = evaluate(s[a], t[b]);
  }
};

TEST_CASE("a corner of the parameter lines is no corner of the surface") {
  const BrokenLines surface;
  const SurfaceJoints joints = surface_joints(knotted_surface(surface), 4);
  CHECK(joints.kink < 1e-7);
  CHECK(joints.bend < 1e-12);
}

TEST_CASE("a twisted seam is left out: there points of the same parameters are no neighbours") {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"model", std::string("moebius")}));
  scene::blending_surface(document).edits.clear();
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  REQUIRE((surface.twist_u() || surface.twist_v()));
  CHECK(surface_joints(knotted_surface(surface), 8).gap > 0.1);
  const SurfaceJoints joints = surface_joints(knotted_surface(surface), 8, untwisted_seams(surface));
  CHECK(joints.gap < 1e-12);
  CHECK(joints.kink < 1e-6);
}

}  // namespace
}  // namespace knotwork::surface_joints_test
