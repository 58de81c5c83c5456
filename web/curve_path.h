#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/later.h"
#include "knotwork/scene/curve_sample.h"
#include "web/camera.h"

namespace knotwork::web {

/// A sampled curve as straight pieces that stay within half a CSS pixel of it on this very screen, however near the
/// reader looks: where a stretch between two samples bends by more, it is halved until it does not. Which may do so is
/// told from the samples beside them, so that only these are evaluated. A stretch that lies outside the picture or
/// reaches behind the eye stays whole. The view and the samples must outlive it.
class CurvePath {
 public:
  /// Ascending samples; where two have the same parameter one piece of the curve ends and another begins.
  KNOTWORK_LATER CurvePath(const View& view, const CurveView& curve, std::span<const scene::CurveSample> samples);

  /// The stretch from samples[k] to samples[k+1], ends included. Valid until the next call.
  KNOTWORK_LATER std::span<const glm::vec3> stretch(std::size_t k);

 private:
  struct Place {
    glm::dvec2 screen{0};
    bool seen = false;  ///< in front of the eye
  };
  struct End {
    double t;
    glm::dvec3 point;
    glm::dvec2 screen;
  };
  double hinted_bend(std::size_t k) const;
  bool outside(std::size_t k, double bend) const;
  void cut(const End& from, const End& to, int depth);

  const View& view_;
  CurveView curve_;
  std::span<const scene::CurveSample> samples_;
  std::vector<Place> places_;
  std::vector<glm::vec3> stretch_;
};

}  // namespace knotwork::web
