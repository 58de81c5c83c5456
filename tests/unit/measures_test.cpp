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

double measured(const Document& document, std::string_view name) {
  const std::optional<double> value = measure(document, name);
  REQUIRE_MESSAGE(value.has_value(), name);
  return *value;
}

}  // namespace

TEST_CASE("a measure that a figure does not have, or that nobody has, is nothing") {
  CHECK_FALSE(measure(start_of("bezier-curve"), "fit.rms"));
  CHECK_FALSE(measure(start_of("bezier-curve"), "ring.distance"));
  CHECK_FALSE(measure(start_of("blending-surface"), "curve.length"));
  CHECK_FALSE(measure(start_of("bezier-curve"), "nonsense"));
}

TEST_CASE("the ring's distance is that of the nearest point; of several rings the farthest counts") {
  Document document = start_of("bezier-curve");
  const auto& points = std::get_if<BezierCurveObject>(&stage_shape(document))->points;
  document.display.rings = {points.front()};
  CHECK(measured(document, "ring.distance") < 1e-14);
  document.display.rings.push_back(points.back() + Eigen::Vector3d(0, 0, 2));
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
