#include "web/curve_path.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "knotwork/curve/curve_catalogue.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/curve_sampling.h"
#include "web/vectors.h"

namespace knotwork::web::curve_path_test {
namespace {

constexpr Viewport viewport{1200, 800};

/// The largest distance on the screen between a curve and the pieces that it is drawn as, of what is in the picture; and
/// how many pieces there are.
struct Drawn {
  double error = 0;
  std::size_t pieces = 0;
};
Drawn drawn(const View& view, const CurveView& curve, std::span<const scene::CurveSample> samples) {
  CurvePath path(view, curve, samples);
  Drawn result;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    if (samples[k].t >= samples[k + 1].t) continue;
    const std::span<const glm::vec3> stretch = path.stretch(k);
    REQUIRE(glm::vec3(to_glm(samples[k].point)) == stretch.front());
    REQUIRE(glm::vec3(to_glm(samples[k + 1].point)) == stretch.back());
    result.pieces += stretch.size() - 1;
    constexpr int looks = 40;
    for (int look = 1; look < looks; ++look) {
      const double t = std::lerp(samples[k].t, samples[k + 1].t, static_cast<double>(look) / looks);
      const auto at = view.project(to_glm(curve(t)));
      if (!at || at->x < 0 || at->y < 0 || at->x > viewport.width || at->y > viewport.height) continue;
      double nearest = 1e9;
      for (std::size_t i = 0; i + 1 < stretch.size(); ++i) {
        const auto a = view.project(glm::dvec3(stretch[i])), b = view.project(glm::dvec3(stretch[i + 1]));
        if (!a || !b) continue;
        const glm::dvec2 chord = glm::dvec2(*b) - glm::dvec2(*a), way = glm::dvec2(*at) - glm::dvec2(*a);
        const double square = glm::dot(chord, chord);
        const double share = square > 0 ? std::clamp(glm::dot(way, chord) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, glm::length(way - share * chord));
      }
      if (nearest < 1e9) result.error = std::max(result.error, nearest);
    }
  }
  return result;
}

View looking_at(const Eigen::Vector3d& target, double distance) {
  return make_view(scene::Camera{target, distance, 0.6, 0.8}, viewport);
}

scene::CurveFigure report_curve() {
  return scene::CurveFigure(scene::stage_shape(scene::find_chapter("bspline-curve")->start_document()));
}

}  // namespace

TEST_CASE("a drawn curve stays within half a pixel of the curve, however near one looks") {
  const scene::CurveFigure figure = report_curve();
  const CurveView curve = curve_view(figure.curve);
  for (const double distance : {8.0, 1.0, 0.3, 0.06, 0.01, 1e-3}) {
    for (const double t : {0.1, 0.37, 0.62, 0.9}) {
      CAPTURE(distance);
      CAPTURE(t);
      const double at = std::lerp(curve.start, curve.end, t);
      CHECK(drawn(looking_at(curve(at), distance), curve, figure.samples).error < 0.5);
      // Beside the curve, so that it passes the edge of the picture.
      const Eigen::Vector3d beside = curve(at) + 0.2 * distance * Eigen::Vector3d(0.6, -0.8, 0.1);
      CHECK(drawn(looking_at(beside, distance), curve, figure.samples).error < 0.5);
    }
  }
}

TEST_CASE("a stretch that bows into the picture from beside it, or whose neighbours lie behind the eye, is cut too") {
  const CatalogueCurve circle = make_catalogue_curve("circle").value();
  const CurveView curve = curve_view(circle);
  std::vector<scene::CurveSample> samples;
  constexpr int steps = 64;
  for (int k = 0; k <= steps; ++k) {
    const double t = std::lerp(curve.start, curve.end, static_cast<double>(k) / steps);
    samples.push_back({t, curve(t)});
  }
  constexpr double share = 10.5 / steps, along = 2 * std::numbers::pi * share;
  const Eigen::Vector3d middle = curve(std::lerp(curve.start, curve.end, share));
  for (const double distance : {0.3, 0.05, 0.02}) {
    // From above, where the stretch lies level in the picture, and along the curve.
    for (const std::pair<double, double>& angles :
         {std::pair(along, 1.5533), std::pair(along + std::numbers::pi / 2, 0.05)}) {
      const double azimuth = angles.first, elevation = angles.second;
      for (const glm::dvec2 way : {glm::dvec2(0, 394), glm::dvec2(0, -394), glm::dvec2(594, 0), glm::dvec2(-594, 0)}) {
        CAPTURE(distance);
        CAPTURE(elevation);
        CAPTURE(way.x);
        CAPTURE(way.y);
        // The middle of the stretch is 6 pixels inside an edge of the picture.
        const View centred = make_view({middle, distance, azimuth, elevation}, viewport);
        const glm::dvec3 shift = centred.pixel_size(to_glm(middle)) * (way.x * centred.right + way.y * centred.up);
        const Eigen::Vector3d target = middle + Eigen::Vector3d(shift.x, shift.y, shift.z);
        CHECK(drawn(make_view({target, distance, azimuth, elevation}, viewport), curve, samples).error < 0.5);
      }
    }
  }
}

TEST_CASE("only what is looked at closely is cut, and that in fewer pieces than even steps take") {
  const scene::CurveFigure figure = report_curve();
  const CurveView curve = curve_view(figure.curve);
  const std::size_t stretches = figure.samples.size() - 1;
  CHECK(drawn(looking_at({0, 0, 0}, 8), curve, figure.samples).pieces <= stretches);

  const View near = looking_at(curve(std::lerp(curve.start, curve.end, 0.37)), 0.06);
  const Drawn adaptive = drawn(near, curve, figure.samples);
  CHECK(adaptive.pieces > stretches);
  // Even steps, as many as the same error asks for.
  std::size_t even = figure.samples.size();
  for (double error = 1e9; error > adaptive.error; even *= 2) {
    std::vector<scene::CurveSample> samples;
    for (std::size_t k = 0; k <= 2 * even; ++k) {
      const double t = std::lerp(curve.start, curve.end, static_cast<double>(k) / static_cast<double>(2 * even));
      samples.push_back({t, curve(t)});
    }
    // A polygon: its own points are all that is drawn.
    const CurveView polygon = curve;
    error = 0;
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      const auto a = near.project(to_glm(samples[k].point)), b = near.project(to_glm(samples[k + 1].point));
      const auto m = near.project(to_glm(polygon(0.5 * (samples[k].t + samples[k + 1].t))));
      if (!a || !b || !m || m->x < 0 || m->y < 0 || m->x > viewport.width || m->y > viewport.height) continue;
      const glm::dvec2 chord = glm::dvec2(*b) - glm::dvec2(*a), way = glm::dvec2(*m) - glm::dvec2(*a);
      const double square = glm::dot(chord, chord);
      error = std::max(error, glm::length(way - (square > 0 ? glm::dot(way, chord) / square : 0) * chord));
    }
  }
  MESSAGE("pieces: " << adaptive.pieces << ", even steps of the same error: " << even);
  CHECK(adaptive.pieces * 4 < even);
}

TEST_CASE("every curve of the catalogue is drawn within half a pixel from near by") {
  for (std::size_t row = 0; row < curve_catalogue().size(); ++row) {
    CAPTURE(curve_catalogue()[row].id);
    const CatalogueCurve model = make_catalogue_curve(curve_catalogue()[row].id).value();
    const CurveView curve = curve_view(model);
    const double size = scene::drawn_size(curve);
    std::vector<scene::CurveSample> samples;
    for (const double t :
         scene::drawing_parameters(curve, curve.start, curve.end, scene::least_steps(model), 1e-3 * size))
      samples.push_back({t, curve(t)});
    const double at = std::lerp(curve.start, curve.end, 0.41);
    CHECK(drawn(looking_at(curve(at), 0.2 * size), curve, samples).error < 0.5);
  }
}

}  // namespace knotwork::web::curve_path_test
