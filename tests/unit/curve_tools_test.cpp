#include "web/curve_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "web/vectors.h"

namespace knotwork::web::curve_tools_test {
namespace {

scene::Document started(std::string_view chapter) { return scene::find_chapter(chapter)->start_document(); }

CurveTools tools_of(scene::Document document) {
  document.display.comb = true;
  return curve_tools(make_figure(scene::stage_shape(document), document.animation), document.display);
}
std::vector<CombHair> comb_of(const scene::Document& document) { return tools_of(document).comb; }

TEST_CASE("the comb of a circle stands outwards, everywhere as long as 0.035 size^2 / radius") {
  scene::Document document = started("model-curve");
  REQUIRE(scene::apply(document, scene::SetParameter{"curve.model", std::string("circle")}));
  const std::vector<CombHair> comb = comb_of(document);
  REQUIRE(comb.size() > 100);
  const double radius = glm::length(comb[0].foot);
  const double size = std::sqrt(8.0) * radius;  // the diagonal of its box
  for (const CombHair& hair : comb) {
    CHECK(glm::length(hair.foot) == doctest::Approx(radius));
    CHECK(glm::distance(hair.foot, hair.tip) == doctest::Approx(0.035 * size * size / radius).epsilon(1e-3));
    CHECK(glm::length(hair.tip) > radius);
  }
}

TEST_CASE("where pieces meet there are two hairs in one place; at a double knot of different lengths") {
  scene::Document document = started("bspline-curve");
  const auto jumps = [&] {
    const std::vector<CombHair> comb = comb_of(document);
    int count = 0;
    for (std::size_t k = 0; k + 1 < comb.size(); ++k) {
      if (!comb[k].ends_piece) continue;
      CHECK(glm::distance(comb[k].foot, comb[k + 1].foot) < 1e-4);
      if (glm::distance(comb[k].tip, comb[k + 1].tip) > 0.05) ++count;
    }
    return count;
  };
  CHECK(jumps() == 0);  // C^2
  REQUIRE(scene::apply(document, scene::SetKnot{.index = 5, .value = 1}));
  CHECK(jumps() == 1);
}

TEST_CASE("surfaces have no comb; a comb needs room in the picture") {
  CHECK(comb_of(started("blending-surface")).empty());
  const CurveTools tools = tools_of(started("bezier-curve"));
  CHECK(tools.tips.size() == tools.comb.size());
}

TEST_CASE("hairs and the line along their tips are drawn, the line not from piece to piece") {
  scene::Document document = started("bspline-curve");
  const std::vector<CombHair> comb = comb_of(document);
  Picture picture;
  add_comb(picture, comb);
  const auto pieces = static_cast<std::size_t>(
      std::count_if(comb.begin(), comb.end(), [](const CombHair& hair) { return hair.ends_piece; }));
  CHECK(pieces == 4);
  CHECK(picture.ribbons.size() == 2 * comb.size() - pieces);
}

/// Two cubic pieces that meet with the speeds 3 and 4.5.
scene::Document two_speeds() {
  scene::Document document = started("bspline-curve");
  auto& curve = *std::get_if<scene::BSplineCurveObject>(&scene::stage_shape(document));
  curve.knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
  curve.points = {{-3, -2.6, 0}, {-2, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {3, -2.25, 0}, {3.4, -4, 0}};
  return document;
}

TEST_CASE("the hodograph is the derivative, scaled by a round number and laid beside the curve") {
  scene::Document document = two_speeds();
  document.display.hodograph = true;
  const Figure figure = make_figure(scene::stage_shape(document), document.animation);
  const CurveTools tools = curve_tools(figure, document.display);
  const Hodograph& hodograph = tools.hodograph;
  CHECK(1 / hodograph.scale == doctest::Approx(2));
  std::vector<glm::dvec3> torn;
  for (std::size_t k = 0; k + 1 < hodograph.places.size(); ++k)
    if (hodograph.places[k].ends_piece)
      for (const std::size_t end : {k, k + 1})
        torn.push_back((glm::dvec3(hodograph.places[end].at) - hodograph.origin) / hodograph.scale);
  REQUIRE(torn.size() == 2);
  CHECK(glm::distance(torn[0], glm::dvec3(3, 0, 0)) < 1e-5);
  CHECK(glm::distance(torn[1], glm::dvec3(4.5, 0, 0)) < 1e-5);
  // Below the curve both would be taller than they are wide.
  double rightmost = -1e9;
  for (const glm::dvec3& point : outline(figure)) rightmost = std::max(rightmost, point.x);
  for (const Hodograph::Place& place : hodograph.places) CHECK(place.at.x > rightmost);
  CHECK(tools.tips.size() == hodograph.places.size() + 1);

  Picture picture;
  picture.view = make_view({}, {.width = 800, .height = 600});
  add_tools(picture, figure, tools);
  CHECK(picture.discs.size() == 4);  // both torn ends, and the tips of the velocity at the origin and at the point
}

TEST_CASE("joints are named by what is continuous there, and only where that is asked for") {
  CHECK(continuity_text({.parametric = 2, .geometric = 2}) == "C²");
  CHECK(continuity_text({.parametric = 0, .geometric = 2}) == "C⁰ G²");
  CHECK(continuity_text({.parametric = -1, .geometric = -1}) == "torn");
  scene::Document document = two_speeds();
  document.display.continuity = true;
  const Figure figure = make_figure(scene::stage_shape(document), document.animation);
  const View view = make_view(document.camera, {.width = 800, .height = 600});
  std::vector<StageLabel> labels;
  add_tool_labels(labels, figure, document.display, curve_tools(figure, document.display), view, make_theme(false));
  REQUIRE(labels.size() == 1);
  CHECK(labels[0].words == "C⁰ G²");
  document.display.continuity = false;
  labels.clear();
  add_tool_labels(labels, figure, document.display, curve_tools(figure, document.display), view, make_theme(false));
  CHECK(labels.empty());
}

TEST_CASE("the osculating circle has the curve's curvature; one as large as a line is not drawn") {
  scene::Document document = started("bspline-curve");
  document.display.osculating = true;
  const Figure figure = make_figure(scene::stage_shape(document), document.animation);
  const auto& curve = std::get<scene::CurveFigure>(figure);
  std::array<Eigen::Vector3d, 3> c;
  curve_view(curve.curve).evaluate(curve.t, c);
  Picture picture;
  picture.display = document.display;
  add_tools(picture, figure, curve_tools(figure, document.display));
  REQUIRE(picture.ribbons.size() > 50);
  REQUIRE(picture.discs.size() == 1);
  const double radius = 1 / curvature(c);
  for (const Ribbon& ribbon : picture.ribbons)
    CHECK(glm::distance(ribbon.start, picture.discs[0].centre) == doctest::Approx(radius).epsilon(1e-5));
  CHECK(glm::distance(glm::dvec3(picture.ribbons[0].start), to_glm(c[0])) < 1e-5);

  scene::Document blending = started("blending-curve");
  blending.display.osculating = true;
  const Figure blended = make_figure(scene::stage_shape(blending), blending.animation);
  const auto& locals = std::get<scene::BlendingCurveFigure>(blended);
  curve_view(locals.curve).evaluate(locals.t, c);
  Picture circle;
  circle.display = blending.display;
  add_tools(circle, blended, curve_tools(blended, blending.display));
  REQUIRE(circle.discs.size() == 1);
  CHECK(glm::distance(glm::dvec3(circle.discs[0].centre), to_glm(c[0])) ==
        doctest::Approx(1 / curvature(c)).epsilon(1e-5));

  Picture straight;
  add_osculating_circle(straight, {0, 0, 0}, 21, {1, 0, 0}, {0, 1, 0}, 10);
  CHECK(straight.ribbons.empty());
}

}  // namespace
}  // namespace knotwork::web::curve_tools_test
