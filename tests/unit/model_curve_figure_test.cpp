#include "knotwork/scene/model_curve_figure.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "knotwork/scene/chapters.h"

namespace knotwork::scene::model_curve_figure_test {
namespace {

ModelCurveFigure figure_of(std::string_view id, double parameter = 0.3) {
  ModelCurveObject object;
  object.model = make_catalogue_curve(id).value();
  object.parameter = parameter;
  return ModelCurveFigure(object);
}

}  // namespace

TEST_CASE("model curve figure: every curve of the catalogue has a smooth picture of bounded size") {
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CAPTURE(row.id);
    const ModelCurveFigure figure = figure_of(row.id);
    const std::vector<CurveSample>& samples = figure.samples;
    REQUIRE(figure.curvatures.size() == samples.size());
    REQUIRE(figure.torsions.size() == samples.size());
    CHECK(samples.size() < 30000);
    CHECK(std::is_sorted(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.t < b.t; }));
    CHECK(samples.front().t == figure.start);
    CHECK(samples.back().t == figure.end);
    double worst = 0;
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      Eigen::Vector3d between;
      evaluate(figure.model, 0.5 * (samples[k].t + samples[k + 1].t), {&between, 1});
      const Eigen::Vector3d chord = samples[k + 1].point - samples[k].point;
      const Eigen::Vector3d off = between - samples[k].point;
      const double share = chord.norm() > 0 ? std::clamp(off.dot(chord) / chord.squaredNorm(), 0.0, 1.0) : 0;
      worst = std::max(worst, (off - share * chord).norm() / figure.size);
    }
    CHECK(worst < 5e-4);
  }
}

TEST_CASE("model curve figure: a circle's osculating circle is itself, a line has none") {
  const ModelCurveFigure circle = figure_of("circle");
  CHECK(circle.flat);
  REQUIRE(circle.circle);
  CHECK(circle.circle->radius == doctest::Approx(1));
  CHECK(circle.circle->centre.norm() < 1e-14);
  for (const double curvature : circle.curvatures) CHECK(curvature == doctest::Approx(1));
  const ModelCurveFigure line = figure_of("line");
  CHECK_FALSE(line.circle);
  CHECK(line.flat);
  const ModelCurveFigure helix = figure_of("helix");
  CHECK_FALSE(helix.flat);
  CHECK(helix.torsions[7] == doctest::Approx(0.1 / 1.01));
  CHECK(helix.topology == Topology::open);
  const ModelCurveFigure cusp = figure_of("astroid", 0.25);
  CHECK_FALSE(cusp.circle);
  CHECK(cusp.frame.tangent.norm() == doctest::Approx(1));
}

TEST_CASE("model curve figure: the parameter moves the frame and not the samples") {
  ModelCurveObject object;
  object.model = make_catalogue_curve("torus-knot").value();
  ModelCurveFigure figure(object);
  const CurveSample* before = figure.samples.data();
  object.parameter = 0.75;
  figure.update(object);
  CHECK(figure.samples.data() == before);
  CHECK(figure.t == doctest::Approx(0.75 * figure.end));
  Eigen::Vector3d point;
  evaluate(object.model, figure.t, {&point, 1});
  CHECK(figure.point == point);
  object.model.measures[3] = 0.1;
  figure.update(object);
  CHECK(figure.samples[9].point == ModelCurveFigure(object).samples[9].point);
}

}  // namespace knotwork::scene::model_curve_figure_test
