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

}  // namespace
}  // namespace knotwork::surface_joints_test
