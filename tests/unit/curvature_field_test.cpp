#include "knotwork/mesh/curvature_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/model_figure.h"
#include "knotwork/scene/surface_builder.h"
#include "knotwork/surface/bspline_surface.h"
#include "knotwork/surface/surface_measures.h"

namespace knotwork::curvature_field_test {
namespace {

scene::ModelFigure model(std::string_view id) {
  scene::Document document = scene::find_chapter("model-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"model", std::string(id)}));
  return scene::ModelFigure(std::get_if<scene::ModelSurfaceObject>(&scene::stage_shape(document))->model);
}

CurvatureField field_of(const scene::ModelFigure& figure, CurvatureKind kind) {
  const KnottedSurface surface = knotted_surface(figure);
  return curvature_field(surface, sample_grid(*surface.knots_u, *surface.knots_v, 40, 40, Seam::repeated), kind);
}

TEST_CASE("round_up_to_125 takes the next of 1, 2, 5, 10") {
  CHECK(round_up_to_125(1) == doctest::Approx(1));
  CHECK(round_up_to_125(1.2) == doctest::Approx(2));
  CHECK(round_up_to_125(4.17) == doctest::Approx(5));
  CHECK(round_up_to_125(5.1) == doctest::Approx(10));
  CHECK(round_up_to_125(0.003) == doctest::Approx(0.005));
  CHECK(round_up_to_125(2e7) == doctest::Approx(2e7));
}

TEST_CASE("a torus has K = cos v / (r (R + r cos v)): all values lie between those of its equators") {
  const scene::ModelFigure torus = model("torus");
  const CurvatureField field = field_of(torus, CurvatureKind::gaussian);
  const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
  // Minor radius 0.4, major radius 1: 1 / (0.4 * 1.4), -1 / (0.4 * 0.6).
  CHECK(*most == doctest::Approx(1 / (0.4 * 1.4)).epsilon(1e-9));
  CHECK(*least == doctest::Approx(-1 / (0.4 * 0.6)).epsilon(1e-9));
  CHECK(field.scale == doctest::Approx(5));
}

TEST_CASE("the scale is that of the area: a thin stem with many vertices does not fade the rest") {
  // An apple's stem bends twenty times as much as its body, and one line in seven runs round it.
  const CurvatureField field = field_of(model("apple"), CurvatureKind::mean);
  CHECK(field.scale == doctest::Approx(2));
}

TEST_CASE("a minimal surface has H = 0, and a scale that does not blow rounding up") {
  const CurvatureField field = field_of(model("enneper"), CurvatureKind::mean);
  for (const double value : field.values) CHECK(std::abs(value) < 1e-6 * field.scale);
  CHECK(field.scale > 0.005);
}

TEST_CASE("a grid parted at its knots has the values of both sides there, and the same places otherwise") {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"blending.function", std::string("linear")}));
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  const KnottedSurface view = knotted_surface(surface);
  const SampleGrid plain = sample_grid(*view.knots_u, *view.knots_v, 24, 24, Seam::repeated);
  const SampleGrid parted = parted_at_knots(plain, *view.knots_u, *view.knots_v);
  const std::size_t inner_u = plain.starts_u.size() - 2, inner_v = plain.starts_v.size() - 2;
  REQUIRE(parted.u.size() == plain.u.size() + inner_u);
  REQUIRE(parted.v.size() == plain.v.size() + inner_v);
  CHECK(std::is_sorted(parted.u.begin(), parted.u.end()));
  double sharpest = 0;
  for (std::size_t k = 1; k + 1 < parted.starts_u.size(); ++k) {
    const auto at = static_cast<std::size_t>(parted.starts_u[k]);
    CHECK(parted.u[at] == plain.u[static_cast<std::size_t>(plain.starts_u[k])]);
    CHECK(parted.u[at - 1] == just_before(parted.u[at]));
    for (const double v : {0.3, 1.7, 4.0}) {
      const SurfaceJet left = view.evaluate(parted.u[at - 1], v), right = view.evaluate(parted.u[at], v);
      CHECK((left.s - right.s).norm() < 1e-12);
      sharpest = std::max(sharpest, (unit_normal(left) - unit_normal(right)).norm());
    }
  }
  CHECK(sharpest > 0.05);  // linear blending of a pulled patch has creases
}

TEST_CASE("the values on a parted grid are those of both sides, at seams too") {
  scene::Document document = scene::find_chapter("blending-surface")->start_document();
  REQUIRE(scene::apply(document, scene::SetParameter{"blending.function", std::string("polynomial1")}));
  const BlendingSurface surface = scene::build_surface(scene::blending_surface(document), document.animation);
  const KnottedSurface view = knotted_surface(surface);
  const SampleGrid grid =
      parted_at_knots(sample_grid(*view.knots_u, *view.knots_v, 24, 24, Seam::repeated), *view.knots_u, *view.knots_v);
  CHECK(grid.u.back() == just_before(view.knots_u->end()));
  const CurvatureField field = curvature_field(view, grid, CurvatureKind::gaussian);
  double jump = 0;
  for (std::size_t k = 1; k + 1 < grid.starts_u.size(); ++k) {
    const auto at = static_cast<std::size_t>(grid.starts_u[k]);
    for (std::size_t b = 0; b < grid.v.size(); ++b)
      jump =
          std::max(jump, std::abs(field.values[at * grid.v.size() + b] - field.values[(at - 1) * grid.v.size() + b]));
  }
  CHECK(jump > 0.1);  // order 1 leaves the curvature to jump
}

TEST_CASE("a surface that is a point, or nearly one, has finite values and a finite scale") {
  for (const double size : {0.0, 1e-99, 1e-20}) {
    const KnotVector knots = KnotVector::make(1, Topology::open, {0, 0, 1, 1}).value();
    const BSplineSurface tiny =
        BSplineSurface::make(knots, knots, {{0, 0, 0}, {0, size, 0}, {size, 0, 0}, {size, size, size}}).value();
    const KnottedSurface view = knotted_surface(tiny);
    for (const CurvatureKind kind : {CurvatureKind::gaussian, CurvatureKind::mean}) {
      const CurvatureField field = curvature_field(view, sample_grid(knots, knots, 6, 6, Seam::repeated), kind);
      for (const double value : field.values) CHECK(std::isfinite(static_cast<float>(value)));
      CHECK(std::isfinite(static_cast<float>(field.scale)));
    }
  }
}

}  // namespace
}  // namespace knotwork::curvature_field_test
