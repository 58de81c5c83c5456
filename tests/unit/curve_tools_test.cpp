#include "web/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"

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

}  // namespace
}  // namespace knotwork::web::curve_tools_test
