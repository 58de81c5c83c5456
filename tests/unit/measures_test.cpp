#include "knotwork/scene/measures.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"

namespace {

using namespace knotwork;
using namespace knotwork::scene;

Document start_of(std::string_view chapter) { return find_chapter(chapter)->start_document(); }

double measured(const Document& document, const Document& start, std::string_view name) {
  const std::optional<double> value = measure(document, start, name);
  REQUIRE_MESSAGE(value.has_value(), name);
  return *value;
}
double measured(const Document& document, std::string_view name) { return measured(document, document, name); }

bool has_measure(const Document& document, std::string_view name) {
  return measure(document, document, name).has_value();
}

}  // namespace

TEST_CASE("a measure that a figure does not have, or that nobody has, is nothing") {
  CHECK_FALSE(has_measure(start_of("bezier-curve"), "fit.rms"));
  CHECK_FALSE(has_measure(start_of("bezier-curve"), "ring.distance"));
  CHECK_FALSE(has_measure(start_of("blending-surface"), "curve.length"));
  CHECK_FALSE(has_measure(start_of("bezier-curve"), "nonsense"));
}

TEST_CASE("the ring's distance is that of the nearest point; of several rings the farthest counts") {
  Document document = start_of("bezier-curve");
  const auto& points = std::get_if<BezierCurveObject>(&stage_shape(document))->points;
  document.display.rings = {points.front()};
  CHECK(measured(document, "ring.distance") < 1e-14);
  document.display.rings.emplace_back(points.back() + Eigen::Vector3d(0, 0, 2));
  CHECK(measured(document, "ring.distance") == doctest::Approx(2).epsilon(1e-12));

  // A torus of radii 1 and 0.4, its axis along z.
  Document torus = start_of("blending-surface");
  blending_surface(torus).edits.clear();
  torus.display.rings = {{0, 0, 0}};
  const Sheet& sheet = std::get<Sheet>(blending_surface(torus).model);
  CHECK(measured(torus, "ring.distance") ==
        doctest::Approx(sheet.closed_radius_u - sheet.closed_radius_v).epsilon(1e-9));
}

TEST_CASE("the fit's errors are those of the report's experiment") {
  // oracles/03, open and closed, n = 8.
  CHECK(measured(start_of("least-squares"), "fit.rms") == doctest::Approx(0.0170).epsilon(0.01));
  CHECK(measured(start_of("least-squares-closed"), "fit.rms") == doctest::Approx(0.0022).epsilon(0.03));
  CHECK(measured(start_of("least-squares"), "fit.max") >= measured(start_of("least-squares"), "fit.rms"));
  CHECK(measured(start_of("least-squares"), "points.count") == 20);
}

TEST_CASE("knots: the largest multiplicity, the continuity that is left, how uneven they are") {
  Document document = start_of("bspline-curve");
  auto& curve = *std::get_if<BSplineCurveObject>(&stage_shape(document));
  CHECK(measured(document, "knots.multiplicity") == 1);
  CHECK(measured(document, "knots.continuity") == 2);
  CHECK(measured(document, "knots.ratio") == doctest::Approx(1));
  curve.knots[5] = curve.knots[4];
  CHECK(measured(document, "knots.multiplicity") == 2);
  CHECK(measured(document, "knots.continuity") == 1);
  CHECK(measured(document, "knots.ratio") == doctest::Approx(2));
}

TEST_CASE("edits are counted by their kind, sleeping ones are not") {
  Document document = start_of("blending-surface");
  CHECK(measured(document, "locals.moved") == 1);
  CHECK(measured(document, "locals.turned") == 1);
  CHECK(measured(document, "locals.scaled") == 0);
  blending_surface(document).locals_u = 2;
  CHECK(measured(document, "locals.moved") == 0);
}

TEST_CASE("points that are elsewhere than at the start; all of them when there are more or fewer") {
  const Document start = start_of("bezier-curve");
  Document document = start;
  auto& points = std::get_if<BezierCurveObject>(&stage_shape(document))->points;
  CHECK(measured(document, start, "points.moved") == 0);
  points[1].x() += 1e-7;
  points[2].y() -= 0.5;
  CHECK(measured(document, start, "points.moved") == 1);
  points.emplace_back(7, 0, 0);
  CHECK(measured(document, start, "points.moved") == 5);

  const Document net_start = start_of("tensor-surface");
  Document net = net_start;
  auto& surface = *std::get_if<BSplineSurfaceObject>(&stage_shape(net));
  surface.net[5][4].z() += 1;
  surface.net[0][1].z() += 1;
  CHECK(measured(net, net_start, "points.moved") == 2);
  REQUIRE(apply(net, SetParameter{"net.u", 7.0}).has_value());
  CHECK(measured(net, net_start, "points.moved") == 35);
  CHECK_FALSE(has_measure(start_of("blending-curve"), "points.moved"));
}

TEST_CASE("locals whose edit is another than at the start, of a curve and of a surface") {
  const Document start = start_of("blending-curve");
  Document document = start;
  auto& edits = std::get_if<BlendingCurveObject>(&stage_shape(document))->edits;
  CHECK(measured(document, start, "locals.changed") == 0);
  edits[{3, 0}].scale.x() = 1.5;
  edits[{7, 0}].rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  edits[{8, 0}].translation.x() = 1e-7;
  CHECK(measured(document, start, "locals.changed") == 2);
  edits.clear();  // the one that the start has is missing now
  CHECK(measured(document, start, "locals.changed") == 1);
  CHECK(measured(document, start, "locals.moved") == 0);

  const Document surface_start = start_of("blending-surface");
  Document surface = surface_start;
  blending_surface(surface).edits[{5, 3}].translation.z() = 0.2;
  CHECK(measured(surface, surface_start, "locals.changed") == 1);
  CHECK_FALSE(has_measure(start_of("tensor-surface"), "locals.changed"));
}

TEST_CASE("a blending curve's distance from its model: none unmoved, a translation's length at a knot") {
  Document document = start_of("blending-curve");
  auto& curve = *std::get_if<BlendingCurveObject>(&stage_shape(document));
  curve.edits.clear();
  CHECK(measured(document, "model.distance") < 1e-14);
  curve.edits[{4, 0}].translation = {0.3, 0, 0.4};
  CHECK(measured(document, "model.distance") == doctest::Approx(0.5).epsilon(1e-12));
  CHECK_FALSE(has_measure(start_of("model-curve"), "model.distance"));
}

TEST_CASE("cells are counted between the knots, none for an empty interval") {
  Document blending = start_of("blending-surface");
  CHECK(measured(blending, "cells.count") == 24);
  blending_surface(blending).topology_v = Topology::open;
  CHECK(measured(blending, "cells.count") == 18);

  Document net = start_of("tensor-surface");
  CHECK(measured(net, "cells.count") == 6);
  std::get_if<BSplineSurfaceObject>(&stage_shape(net))->u.knots[5] = 1;  // 1 twice, and 3: an interval is empty
  CHECK(measured(net, "cells.count") == 4);
  CHECK_FALSE(has_measure(start_of("model-surface"), "cells.count"));
}

TEST_CASE("a seam gapes by as much as its ends are apart") {
  Document document = start_of("tensor-surface");
  CHECK(measured(document, "seam.gap") > 1);
  REQUIRE(apply(document, SetParameter{"topology.u", std::string("closed")}).has_value());
  CHECK(measured(document, "seam.gap") == 0);
}

TEST_CASE("length and the distance from the limit") {
  Document circle = start_of("least-squares-closed");
  CHECK(measured(circle, "curve.length") == doctest::Approx(10 * std::numbers::pi).epsilon(1e-3));
  Document polygon = start_of("subdivision");
  auto& object = *std::get_if<SubdivisionCurveObject>(&stage_shape(polygon));
  object.step = 4;
  const double first = measured(polygon, "subdivision.error");
  object.step = 8;
  CHECK(first / measured(polygon, "subdivision.error") == doctest::Approx(4).epsilon(0.2));
}

TEST_CASE("inflections are counted once each, along jumps of the curvature too") {
  Document arch = start_of("bspline-curve");
  auto& curve = *std::get_if<BSplineCurveObject>(&stage_shape(arch));
  curve.knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  curve.points = {{-3, 0, 0}, {-2.6, 2, 0}, {-1.3, 3, 0}, {0, 3.2, 0}, {1.3, 3, 0}, {2.6, 2, 0}, {3, 0, 0}};
  CHECK(measured(arch, "curve.inflections") == 0);
  curve.points[3] = {0, 1.6, 0};
  CHECK(measured(arch, "curve.inflections") == 2);
  // An S of straight legs.
  curve.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  curve.points = {{0, 0, 0}, {1, 2, 0}, {3, -2, 0}, {4, 0, 0}};
  CHECK(measured(arch, "curve.inflections") == 1);
}

TEST_CASE("the hodograph's gap is that of the speeds at a triple knot, and nothing at a simple one") {
  Document document = start_of("bspline-curve");
  CHECK(measured(document, "hodograph.gap") < 1e-9);
  auto& curve = *std::get_if<BSplineCurveObject>(&stage_shape(document));
  curve.knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
  curve.points = {{-3, -2.6, 0}, {-2, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {3, -2.25, 0}, {3.4, -4, 0}};
  CHECK(measured(document, "hodograph.gap") == doctest::Approx(1.5));
}
