#include "web/still.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "web/composition.h"
#include "web/still_surface.h"

namespace knotwork::web::still_test {
namespace {

scene::Document started(std::string_view chapter) { return scene::find_chapter(chapter)->start_document(); }

int count_of(std::string_view text, std::string_view part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The longest row of decimal figures in a text.
std::size_t longest_number(std::string_view text) {
  std::size_t longest = 0, length = 0;
  for (const char letter : text) {
    length = letter >= '0' && letter <= '9' ? length + 1 : 0;
    longest = std::max(longest, length);
  }
  return longest;
}

View view_of(const scene::Document& document, const Figure& figure) {
  const std::vector<glm::dvec3> points = outline(figure);
  const Composition composition = compose(document.camera, {points, {}}, {.width = 720, .height = 440}, {});
  return make_view(composition.camera, composition.viewport);
}

TEST_CASE("every start document has a still picture, with all its handles") {
  for (const scene::Chapter& chapter : scene::chapters()) {
    CAPTURE(chapter.id);
    const scene::Document document = chapter.start_document();
    const std::string svg = still(document);
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    // Written as a whole number, a coordinate that is not finite has 19 figures; a colour has six.
    CHECK(longest_number(svg) <= 6);
    CHECK(count_of(svg, "<path") > 3);
    CHECK(count_of(svg, "<g") == count_of(svg, "</g"));
    const HandleGrid handles = handle_grid(scene::stage_shape(document));
    if (document.display.handles) CHECK(count_of(svg, "<circle") >= handles.columns * handles.rows);
  }
}

TEST_CASE("the same document gives the same picture, another one another") {
  scene::Document document = started("bspline-curve");
  const std::string before = still(document);
  CHECK(still(document) == before);
  REQUIRE(scene::apply(document, scene::SetParameter{"curve.parameter", 2.25}));
  CHECK(still(document) != before);
}

TEST_CASE("a point of a plane curve lies where the camera sees it") {
  const scene::Document document = started("bezier-curve");
  const Figure figure = make_figure(scene::stage_shape(document), document.animation);
  const View view = view_of(document, figure);
  std::vector<Handle> handles;
  take_handles(figure, scene::stage_shape(document), handles);
  const std::string svg = still(document);
  for (const Handle& handle : handles) {
    const glm::dvec3 at = *view.project(handle.position);
    const auto half_pixels = [](double x) { return std::to_string(static_cast<long>(std::lround(2 * x))); };
    const std::string disc = "cx=\"" + half_pixels(at.x) + "\" cy=\"" + half_pixels(at.y) + "\"";
    CAPTURE(disc);
    CHECK(svg.find(disc) != std::string::npos);
  }
}

TEST_CASE("rings are those of the stage: an accent on a wider band of paper, within their radius") {
  scene::Document document = started("bezier-curve");
  document.display.handles = false;
  const int without = count_of(still(document), "<circle");
  document.display.rings = {{0, 1, 0}};
  const std::string svg = still(document);
  CHECK(count_of(svg, "<circle") == without + 2);
  const std::size_t band = svg.rfind("<circle", svg.rfind("<circle") - 1);
  CHECK(svg.find("r=\"20\"", band) != std::string::npos);               // half pixels, of the middle of the rim
  CHECK(svg.find("stroke-width=\"11\"", band) < svg.rfind("<circle"));  // drawn first
  CHECK(svg.find("stroke-width=\"5\"", svg.rfind("<circle")) != std::string::npos);
}

TEST_CASE("of a closed surface the pieces that face away are left out, of an open one none") {
  scene::Document document = started("blending-surface");
  const auto pieces = [&] {
    const Figure figure = make_figure(scene::stage_shape(document), document.animation);
    return surface_pieces(figure, document, view_of(document, figure), 48, 32).facets.size();
  };
  const std::size_t closed = pieces();
  CHECK(closed > 500);
  CHECK(closed < 1100);
  REQUIRE(scene::apply(document, scene::SetParameter{"topology.u", std::string("open")}));
  CHECK(pieces() > 1400);
}

TEST_CASE("hues are those of the patches: without patch colours the surface is grey") {
  scene::Document document = started("blending-surface");
  const auto chroma = [&] {
    const Figure figure = make_figure(scene::stage_shape(document), document.animation);
    float most = 0;
    for (const Facet& facet : surface_pieces(figure, document, view_of(document, figure), 24, 16).facets) {
      const auto [low, high] = std::minmax_element(facet.colour.begin(), facet.colour.end());
      most = std::max(most, *high - *low);
    }
    return most;
  };
  CHECK(chroma() > 0.5F);
  REQUIRE(scene::apply(document, scene::SetParameter{"display.colours", false}));
  CHECK(chroma() < 0.1F);
}

TEST_CASE("stripes cut the pieces along their edges, and nothing is lost of them") {
  scene::Document document = started("blending-surface");
  REQUIRE(scene::apply(document, scene::SetParameter{"display.colours", false}));
  const auto pieces = [&] {
    const Figure figure = make_figure(scene::stage_shape(document), document.animation);
    return surface_pieces(figure, document, view_of(document, figure), 144, 96).facets;
  };
  const auto area = [](const std::vector<Facet>& facets) {
    double sum = 0;
    for (const Facet& facet : facets) {
      double twice = 0;
      for (std::size_t k = 0; k < facet.corners.size(); ++k) {
        const glm::dvec2 &a = facet.corners[k], &b = facet.corners[(k + 1) % facet.corners.size()];
        twice += a.x * b.y - a.y * b.x;
      }
      sum += std::abs(twice) / 2;
    }
    return sum;
  };
  const std::vector<Facet> lit = pieces();
  for (const std::string_view shading : {"zebra", "isophotes"}) {
    REQUIRE(scene::apply(document, scene::SetParameter{"display.shading", std::string(shading)}));
    const std::vector<Facet> striped = pieces();
    CHECK(striped.size() > 1.2 * static_cast<double>(lit.size()));
    CHECK(area(striped) == doctest::Approx(area(lit)).epsilon(0.03));
  }
  REQUIRE(scene::apply(document, scene::SetParameter{"display.shading", std::string("zebra")}));
  int light = 0, dark = 0;
  for (const Facet& facet : pieces()) ++(facet.colour[1] > 0.6F ? light : dark);
  CHECK(light > 200);
  CHECK(dark > 200);
}

TEST_CASE("a coarse picture has fewer bytes") {
  const scene::Document document = started("blending-surface");
  CHECK(still(document, {.pieces_u = 24, .pieces_v = 16}).size() < 0.6 * static_cast<double>(still(document).size()));
}

}  // namespace
}  // namespace knotwork::web::still_test
