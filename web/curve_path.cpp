#include "web/curve_path.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr double most_bend =
    0.25;  // CSS pixels that a piece may bend by; half of what is promised, as the most may be missed
constexpr double worth_a_look = most_bend / 4;  // where neighbours tell of so much, the curve itself is asked
constexpr int halvings = 7;
constexpr double line_margin = 20;  // CSS pixels beyond the picture: lines are wide

/// The distance of b from the segment from a to c.
template <class Point>
double off_chord(Point a, Point b, Point c) {
  const Point chord = c - a;
  const double square = glm::dot(chord, chord);
  const double share = square > 0 ? std::clamp(glm::dot(b - a, chord) / square, 0.0, 1.0) : 0.0;
  return glm::distance(b, a + share * chord);
}

}  // namespace

CurvePath::CurvePath(const View& view, const CurveView& curve, std::span<const scene::CurveSample> samples)
    : view_(view), curve_(curve), samples_(samples), places_(samples.size()) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::optional<glm::dvec3> screen = view.project(to_glm(samples[k].point));
    if (screen) places_[k] = {glm::dvec2(*screen), true};
  }
}

/// Of the stretch from samples[k] on, in pixels at its nearer end, as its neighbours tell wherever they lie: a quarter of
/// what twice its length bends by.
double CurvePath::hinted_bend(std::size_t k) const {
  const auto here = [this](std::size_t i) {
    const bool together = samples_[i].t < samples_[i + 1].t && samples_[i + 1].t < samples_[i + 2].t;
    return together
               ? off_chord(to_glm(samples_[i].point), to_glm(samples_[i + 1].point), to_glm(samples_[i + 2].point)) / 4
               : 0.0;
  };
  const double before = k > 0 ? here(k - 1) : 0, after = k + 2 < samples_.size() ? here(k) : 0;
  return std::max(before, after) /
         std::min(view_.pixel_size(to_glm(samples_[k].point)), view_.pixel_size(to_glm(samples_[k + 1].point)));
}

/// Adds what lies between two places of the curve, without them: halves until each piece is straight enough.
void CurvePath::cut(const End& from, const End& to, int depth) {
  const auto look = [&](double share) -> End {
    const double t = std::lerp(from.t, to.t, share);
    const glm::dvec3 point = to_glm(curve_(t));
    const std::optional<glm::dvec3> screen = view_.project(point);
    return {t, point, screen ? glm::dvec2(*screen) : from.screen};
  };
  const auto strays = [&](const End& end) { return off_chord(from.screen, end.screen, to.screen) > most_bend; };
  const End middle = look(0.5);
  // The middle alone may lie on the chord by symmetry.
  if (depth == 0 || !(strays(middle) || strays(look(0.28)) || strays(look(0.72)))) return;
  cut(from, middle, depth - 1);
  stretch_.emplace_back(middle.point);
  cut(middle, to, depth - 1);
}

/// Whether the stretch and what it may bend by lie beside the picture.
bool CurvePath::outside(std::size_t k, double bend) const {
  const double margin = line_margin + 4 * bend;
  const glm::dvec2 a = places_[k].screen, b = places_[k + 1].screen;
  const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
  return high.x < -margin || high.y < -margin || low.x > view_.viewport.width + margin ||
         low.y > view_.viewport.height + margin;
}

std::span<const glm::vec3> CurvePath::stretch(std::size_t k) {
  const auto &from = samples_[k], &to = samples_[k + 1];
  stretch_.assign(1, glm::vec3(to_glm(from.point)));
  const double bend = hinted_bend(k);
  if (bend > worth_a_look && places_[k].seen && places_[k + 1].seen && !outside(k, bend)) {
    cut({from.t, to_glm(from.point), places_[k].screen}, {to.t, to_glm(to.point), places_[k + 1].screen}, halvings);
  }
  stretch_.emplace_back(to_glm(to.point));
  return stretch_;
}

}  // namespace knotwork::web
