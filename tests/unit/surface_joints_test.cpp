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

/// The largest of each difference.
struct Largest {
  double gap = 0, kink = 0, bend = 0;
};

Largest largest(const std::vector<SurfaceJoint>& joints) {
  REQUIRE_FALSE(joints.empty());
  return {worst_joint(joints, &SurfaceJoint::gap)->gap, worst_joint(joints, &SurfaceJoint::kink)->kink,
          worst_joint(joints, &SurfaceJoint::bend)->bend};
}

Largest joints_with(std::string_view function) {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"blending.function", std::string(function)}));
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  return largest(surface_joints(knotted_surface(surface), 8));
}

TEST_CASE("the order of the blending function is the order of contact across knot lines") {
  const Largest linear = joints_with("linear"), first = joints_with("polynomial1"), second = joints_with("polynomial2");
  for (const Largest& joints : {linear, first, second}) CHECK(joints.gap < 1e-12);
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
  const std::vector<SurfaceJoint> joints = surface_joints(knotted_surface(roof), 4);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].along_v);
  CHECK(joints[0].parameter == 1);
  CHECK(joints[0].kink == doctest::Approx(std::numbers::pi / 2));
  CHECK(joints[0].gap < 1e-15);
}

TEST_CASE("each knot line is told by itself, the seam of a closed direction last") {
  // A tube with four facets over u in [0, 4), and two lines v = const, of which the upper one has a bend.
  const KnotVector u = KnotVector::make(1, Topology::closed, {0, 1, 2, 3, 4, 5, 6}).value();
  const KnotVector v = KnotVector::make(1, Topology::open, {0, 0, 1, 2, 3, 3}).value();
  const std::vector<double> heights{0, 1, 2, 3}, widths{1, 1, 1, 2};
  std::vector<Eigen::Vector3d> net;
  for (int k = 0; k < 4; ++k)
    for (std::size_t row = 0; row < 4; ++row)
      net.emplace_back(widths[row] * std::cos(k * std::numbers::pi / 2),
                       widths[row] * std::sin(k * std::numbers::pi / 2), heights[row]);
  const BSplineSurface tube = BSplineSurface::make(u, v, net).value();
  const std::vector<SurfaceJoint> joints = surface_joints(knotted_surface(tube), 4);
  REQUIRE(joints.size() == 6);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(joints[k].along_v);
    CHECK(joints[k].parameter == tube.knots_u().start() + (k < 3 ? static_cast<double>(k) + 1 : 0));
    CHECK(joints[k].kink == doctest::Approx(std::numbers::pi / 2));
  }
  CHECK_FALSE(joints[4].along_v);
  CHECK(joints[4].kink < 1e-12);
  CHECK(joints[5].parameter == 2);
  // A facet is cos(45°) from the axis: there it widens by that much over a height of 1.
  CHECK(joints[5].kink == doctest::Approx(std::atan(std::sqrt(0.5))));
  CHECK(worst_joint(joints, &SurfaceJoint::kink)->along_v);
  CHECK(worst_joint({}, &SurfaceJoint::kink) == nullptr);
}

TEST_CASE("a fold is a kink of half a turn, though both sides have one tangent plane") {
  const KnotVector u = KnotVector::make(1, Topology::open, {0, 0, 1, 2, 2}).value();
  const KnotVector v = KnotVector::make(1, Topology::open, {0, 0, 1, 1}).value();
  const std::vector<Eigen::Vector3d> net{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {0, 1, 0}};
  const BSplineSurface fold = BSplineSurface::make(u, v, net).value();
  CHECK(largest(surface_joints(knotted_surface(fold), 4)).kink == doctest::Approx(std::numbers::pi));
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
  const Largest joints = largest(surface_joints(knotted_surface(surface), 4));
  CHECK(joints.kink < 1e-7);
  CHECK(joints.bend < 1e-12);
}

TEST_CASE("a twisted seam is left out: there points of the same parameters are no neighbours") {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"model", std::string("moebius")}));
  scene::blending_surface(document).edits.clear();
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  REQUIRE((surface.twist_u() || surface.twist_v()));
  CHECK(largest(surface_joints(knotted_surface(surface), 8)).gap > 0.1);
  const Largest joints = largest(surface_joints(knotted_surface(surface), 8, untwisted_seams(surface)));
  CHECK(joints.gap < 1e-12);
  CHECK(joints.kink < 1e-6);
}

}  // namespace
}  // namespace knotwork::surface_joints_test
