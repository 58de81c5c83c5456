#include "knotwork/scene/blending_curve_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/chapters.h"

namespace knotwork::scene::blending_curve_figure_test {
namespace {

struct Scene {
  BlendingCurveObject object;
  Animation animation;
};

Scene start() {
  const Document document = find_chapter("blending-curve")->start_document();
  return {*std::get_if<BlendingCurveObject>(&stage_shape(document)), document.animation};
}

Scene unmoved() {
  Scene scene = start();
  scene.object.edits.clear();
  return scene;
}

BlendingCurveFigure figure_of(const Scene& scene) { return {scene.object, scene.animation}; }

bool same_samples(const BlendingCurveFigure& a, const BlendingCurveFigure& b) {
  return std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                    [](const auto& x, const auto& y) { return x.point == y.point && x.t == y.t; });
}

}  // namespace

TEST_CASE("blending curve figure: samples lie on the curve, are a mixture of two locals, and weights sum to 1") {
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (const LocalCurveKind kind : {LocalCurveKind::sub_curve, LocalCurveKind::bezier_hermite, LocalCurveKind::arc}) {
      Scene scene = start();
      scene.object.topology = topology;
      scene.object.local_kind = kind;
      const BlendingCurveFigure figure = figure_of(scene);
      REQUIRE(figure.samples.size() > 300);
      for (std::size_t i = 0; i < figure.samples.size(); ++i) {
        const auto& sample = figure.samples[i];
        CHECK((figure.curve(sample.t) - sample.point).norm() < 1e-12);
        double sum = 0;
        for (int k = 0; k < scene.object.locals; ++k) sum += figure.weight(i, k);
        CHECK(std::abs(sum - 1) < 1e-14);
      }
      CHECK((figure.curve(figure.t) - figure.point).norm() == 0);
      const Eigen::Vector3d mixed =
          figure.weights[0].value * figure.local_points[0] + figure.weights[1].value * figure.local_points[1];
      CHECK((mixed - figure.point).norm() < 1e-13);
    }
  }
}

TEST_CASE("blending curve figure: strands begin and end with weight 0, and pass their handle with weight 1") {
  const BlendingCurveFigure figure = figure_of(start());
  REQUIRE(figure.strands.size() == 10);
  for (std::size_t k = 0; k < figure.strands.size(); ++k) {
    const BlendingCurveFigure::Strand& strand = figure.strands[k];
    REQUIRE(strand.points.size() == strand.weights.size());
    CHECK(strand.weights.front() == 0);
    CHECK(strand.weights.back() == 0);
    const auto top = std::max_element(strand.weights.begin(), strand.weights.end());
    CHECK(*top == 1);
    const Eigen::Vector3d& centre = strand.points[static_cast<std::size_t>(top - strand.weights.begin())];
    CHECK((centre - local_origin(figure.locals[k])).norm() < 1e-13);
  }
  // Open: the first and last one have one side only.
  Scene open = start();
  open.object.topology = Topology::open;
  const BlendingCurveFigure ends = figure_of(open);
  CHECK(ends.strands.front().weights.front() == 1);
  CHECK(ends.strands.back().weights.back() == 1);
}

TEST_CASE("blending curve figure: unmoved sub-curves are the model, an edit changes its support only") {
  const BlendingCurveFigure plain = figure_of(unmoved());
  for (std::size_t i = 0; i < plain.samples.size(); ++i)
    CHECK((plain.samples[i].point - plain.mixtures[i].model).norm() < 1e-13);
  Scene scene = unmoved();
  scene.object.edits[{4, 0}].translation = {0, 0, 0.3};
  const BlendingCurveFigure moved = figure_of(scene);
  const KnotVector& knots = moved.curve.knots();
  int inside = 0;
  for (std::size_t i = 0; i < moved.samples.size(); ++i) {
    const double t = moved.samples[i].t, way = (moved.samples[i].point - plain.samples[i].point).norm();
    if (t <= knots[4] || t >= knots[6]) {
      CHECK(way == 0);
    } else if (std::abs(t - knots[5]) < 0.5 * (knots[5] - knots[4])) {
      CHECK(way > 0.1);
      ++inside;
    }
  }
  CHECK(inside > 10);
  // The handle moves by the edit, in its own axes.
  CHECK((local_origin(moved.locals[4]) - local_origin(plain.locals[4]) - 0.3 * moved.locals[4].axes.col(2)).norm() <
        1e-14);
}

TEST_CASE("blending curve figure: update() comes to the same as another figure, whatever has changed") {
  const auto check = [](auto change) {
    Scene scene = start();
    BlendingCurveFigure figure = figure_of(scene);
    change(scene);
    figure.update(scene.object, scene.animation);
    const BlendingCurveFigure fresh = figure_of(scene);
    CHECK(same_samples(figure, fresh));
    CHECK(figure.point == fresh.point);
    CHECK(figure.strands.size() == fresh.strands.size());
  };
  check([](Scene& scene) { scene.object.edits[{1, 0}].translation.x() = 0.2; });
  check([](Scene& scene) { scene.object.parameter = 0.9; });
  check([](Scene& scene) { scene.animation.time = 1; });
  check([](Scene& scene) { scene.object.blending = BlendingKind::expo_rational; });
  check([](Scene& scene) { scene.object.local_kind = LocalCurveKind::arc; });
  check([](Scene& scene) { REQUIRE(set_local_count(scene.object, 4)); });
  check([](Scene& scene) { REQUIRE(set_knot(scene.object, 3, 1.5)); });
  check([](Scene& scene) { REQUIRE(set_topology(scene.object, Topology::open)); });
  check([](Scene& scene) { scene.object.model = make_catalogue_curve("trefoil-knot").value(); });
}

TEST_CASE("blending curve figure: all locals move by themselves, neighbours against each other") {
  Scene scene = unmoved();
  const BlendingCurveFigure rest = figure_of(scene);
  scene.animation.time = std::numbers::pi / 2;
  const BlendingCurveFigure later = figure_of(scene);
  const auto way = [&](std::size_t k) {
    return Eigen::Vector3d(local_origin(later.locals[k]) - local_origin(rest.locals[k]));
  };
  CHECK(way(0).norm() > 0.1);
  for (std::size_t k = 1; k < 10; ++k) CHECK((way(k) + way(k - 1)).norm() < 1e-14);
  // The report's turn, about the parent's x axis by 2t: half a turn.
  CHECK((later.curve.local(0).linear() - Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix()).norm() < 1e-14);
}

TEST_CASE("blending curve figure: own frames are right-handed, along the curve, and even where it is straight") {
  for (const CatalogueCurveRow& row : curve_catalogue()) {
    CAPTURE(row.id);
    BlendingCurveObject object;
    object.model = make_catalogue_curve(row.id).value();
    object.topology = row.topology;
    const KnotVector knots = knots_of(object);
    const std::vector<Eigen::Matrix3d> frames = local_frames(object.model, knots);
    REQUIRE(frames.size() == 10);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      CHECK((frames[k].transpose() * frames[k] - Eigen::Matrix3d::Identity()).norm() < 1e-12);
      CHECK(frames[k].determinant() == doctest::Approx(1));
      Eigen::Vector3d jet[2];
      evaluate(object.model, knots[static_cast<int>(k) + 1], jet);
      if (jet[1].norm() > 1e-6) CHECK(frames[k].col(0).dot(jet[1].normalized()) > 1 - 1e-9);
    }
  }
}

}  // namespace knotwork::scene::blending_curve_figure_test
