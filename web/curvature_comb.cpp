#include "web/curvature_comb.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/curve/parametric_curve.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr int most_hairs = 900, hairs_of_piece = 36, least_hairs = 6;
constexpr double scale = 0.035;  ///< hair = scale * size^2 * curvature, of a curve of this size (its box's diagonal)
constexpr double longest = 0.6;  ///< of the size: what turns more sharply is cut off
constexpr float hair_ink = 1, tip_ink = 1.8F;

/// c'' across c', over |c'|^2: towards the centre of curvature, as long as the curvature; nothing without speed.
Eigen::Vector3d curvature_vector(const std::array<Eigen::Vector3d, 3>& c) {
  const double speed2 = c[1].squaredNorm();
  if (speed2 < 1e-20) return Eigen::Vector3d::Zero();
  return (c[2] - c[2].dot(c[1]) / speed2 * c[1]) / speed2;
}

void add_comb(Picture& picture, const CurveView& view) {
  const std::vector<double> ends = piece_ends(view.start, view.end, view.breaks);
  const int pieces = static_cast<int>(ends.size()) - 1;
  const int hairs =
      std::clamp(most_hairs / std::max(pieces, 1), least_hairs, pieces == 1 ? 4 * hairs_of_piece : hairs_of_piece);
  struct Hair {
    Eigen::Vector3d foot, bend;
  };
  std::vector<Hair> comb;
  comb.reserve(static_cast<std::size_t>(pieces) * static_cast<std::size_t>(hairs + 1));
  Eigen::AlignedBox3d box;
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = ends[static_cast<std::size_t>(piece)], to = ends[static_cast<std::size_t>(piece) + 1];
    for (int k = 0; k <= hairs; ++k) {
      const double t = k == hairs ? just_before(to) : std::lerp(from, to, static_cast<double>(k) / hairs);
      std::array<Eigen::Vector3d, 3> c;
      view.evaluate(t, c);
      const Hair hair{c[0], curvature_vector(c)};
      comb.push_back(hair);
      box.extend(c[0]);
    }
  }
  const double size = box.diagonal().norm();
  const auto tip = [&](const Hair& hair) {
    const double length = scale * size * size * hair.bend.norm();
    const double cut = length > longest * size ? longest * size / length : 1;
    return glm::vec3(to_glm(Eigen::Vector3d(hair.foot - cut * scale * size * size * hair.bend)));
  };
  const glm::vec4 faint = to_glm(picture.theme.accent, 0.45F), strong = to_glm(picture.theme.accent, 0.9F);
  for (std::size_t k = 0; k < comb.size(); ++k) {
    picture.ribbons.push_back({glm::vec3(to_glm(comb[k].foot)), tip(comb[k]), faint, hair_ink});
    const bool last_of_piece = (k + 1) % static_cast<std::size_t>(hairs + 1) == 0;
    if (!last_of_piece) picture.ribbons.push_back({tip(comb[k]), tip(comb[k + 1]), strong, tip_ink});
  }
}

}  // namespace

void add_curvature_comb(Picture& picture, const Figure& figure) {
  if (const auto* curve = std::get_if<scene::CurveFigure>(&figure)) add_comb(picture, curve_view(curve->curve));
  if (const auto* fit = std::get_if<scene::FitFigure>(&figure)) add_comb(picture, curve_view(fit->curve.curve));
  if (const auto* polygon = std::get_if<scene::SubdivisionFigure>(&figure))
    add_comb(picture, curve_view(polygon->limit.curve));
  if (const auto* model = std::get_if<scene::ModelCurveFigure>(&figure)) add_comb(picture, curve_view(model->model));
  if (const auto* blending = std::get_if<scene::BlendingCurveFigure>(&figure))
    add_comb(picture, curve_view(blending->curve));
}

}  // namespace knotwork::web
