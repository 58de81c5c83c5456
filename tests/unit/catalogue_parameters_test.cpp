#include "knotwork/scene/catalogue_parameters.h"

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"

namespace knotwork::scene::catalogue_parameters_test {
namespace {

Document with(std::string_view chapter, std::initializer_list<SetParameter> settings) {
  Document document = find_chapter(chapter)->start_document();
  for (const SetParameter& setting : settings) REQUIRE(apply(document, setting));
  return document;
}

const Parameter& row(std::string_view id) { return *find_parameter(id); }

}  // namespace

TEST_CASE("catalogue parameters: the chosen curve's measures have rows, others have not") {
  for (const char* chapter : {"model-curve", "blending-curve"}) {
    for (const CatalogueCurveRow& curve : curve_catalogue()) {
      CAPTURE(curve.id);
      const Document document = with(chapter, {{"curve.model", std::string(curve.id)}});
      std::size_t found = 0;
      for (const Parameter& parameter : parameters()) {
        if (!parameter.soft_range || !parameter.id.starts_with("curve.") || !applies(document, parameter)) continue;
        ++found;
        const Limits range = range_of(document, parameter), soft = soft_range_of(document, parameter);
        CHECK(range.min <= soft.min);
        CHECK(soft.max <= range.max);
        const double value = std::get<double>(parameter.get(document));
        CHECK(soft.contains(value));  // the standard picture
      }
      CHECK(found == curve.measures.size());
    }
  }
  CHECK_FALSE(applies(find_chapter("blending-surface")->start_document(), row("curve.radius")));
  CHECK_FALSE(applies(find_chapter("bspline-curve")->start_document(), row("curve.model")));
}

TEST_CASE("catalogue parameters: labels are words, counts are whole numbers") {
  CHECK(row("curve.tubeRadius").label == "tube radius");
  CHECK(row("curve.turnsAround").kind == ParameterKind::integer);
  CHECK(row("curve.radius").kind == ParameterKind::number);
  Document document = with("model-curve", {});
  const Document before = document;
  CHECK(apply(document, SetParameter{"curve.turnsAround", 2.5}).error().message ==
        "Must be a whole number from 1 to 24.");
  CHECK(apply(document, SetParameter{"curve.tubeRadius", 0.0}).error().path == "curve.tubeRadius");
  CHECK(apply(document, SetParameter{"curve.turns", 2.0}).error().message ==
        "What is on the stage has no such parameter.");
  CHECK(document == before);
}

TEST_CASE("catalogue parameters: an open model opens the curve, says so, and refuses to be closed") {
  const Document closed = with("blending-curve", {});
  CHECK(side_effect(closed, row("curve.model"), "helix") == "Helix is not closed, so the blending curve opens.");
  CHECK(side_effect(closed, row("curve.model"), "circle").empty());
  CHECK(refused_choice(closed, row("curve.topology"), "closed").empty());
  const Document open = with("blending-curve", {{"curve.model", "helix"}});
  const std::string sentence = "Helix is not closed, so a blending curve over it can only be open.";
  CHECK(refused_choice(open, row("curve.topology"), "closed") == sentence);
  Document refused = open;
  CHECK(apply(refused, SetParameter{"curve.topology", "closed"}).error().message == sentence);
  CHECK(refused == open);

  Document uneven = closed;
  REQUIRE(apply(uneven, SetKnot{3, 1.4}));
  CHECK(side_effect(uneven, row("locals.count"), 5.0) == "The knots are evenly spaced again.");
  CHECK(side_effect(uneven, row("curve.topology"), "open") == "The knots are evenly spaced again.");
  CHECK(side_effect(uneven, row("locals.kind"), "arc").empty());
}

TEST_CASE("catalogue parameters: the parameter runs over the model's domain, degrees are of Bezier locals only") {
  const Document helix = with("model-curve", {{"curve.model", "helix"}, {"curve.turns", 2.0}});
  CHECK(range_of(helix, row("curve.parameter")).max == doctest::Approx(4 * 3.14159265358979));
  const Document curve = with("blending-curve", {});
  CHECK_FALSE(row("locals.degree").disabled(curve).empty());
  const Document bezier = with("blending-curve", {{"locals.kind", "bezier-hermite"}, {"locals.degree", 2.0}});
  CHECK(row("locals.degree").disabled(bezier).empty());
  CHECK(std::get<BlendingCurveObject>(stage_shape(bezier)).local_degree == 2);
}

}  // namespace knotwork::scene::catalogue_parameters_test
