#include "web/curvature_comb.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/curve/parametric_curve.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr int most_hairs = 900, hairs_of_piece = 36, least_hairs = 6;
constexpr double scale = 0.035;   ///< hair = scale * size^2 * curvature, of a curve of this size (its box's diagonal)
constexpr double longest = 0.45;  ///< of the size: what turns more sharply is cut off
constexpr float hair_ink = 1, tip_ink = 1.8F;

}  // namespace

std::vector<CombHair> curvature_comb(const CurveView& view) {
  const std::vector<double> ends = piece_ends(view.start, view.end, view.breaks);
  const int pieces = static_cast<int>(ends.size()) - 1;
  const int hairs =
      std::clamp(most_hairs / std::max(pieces, 1), least_hairs, pieces == 1 ? 4 * hairs_of_piece : hairs_of_piece);
  struct Bend {
    Eigen::Vector3d foot, bend;
  };
  std::vector<Bend> bends;
  bends.reserve(static_cast<std::size_t>(pieces) * static_cast<std::size_t>(hairs + 1));
  Eigen::AlignedBox3d box;
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = ends[static_cast<std::size_t>(piece)], to = ends[static_cast<std::size_t>(piece) + 1];
    for (int k = 0; k <= hairs; ++k) {
      const double t = k == hairs ? just_before(to) : std::lerp(from, to, static_cast<double>(k) / hairs);
      std::array<Eigen::Vector3d, 3> c;
      view.evaluate(t, c);
      bends.push_back({c[0], curvature_vector(c)});
      box.extend(c[0]);
    }
  }
  const double size = box.diagonal().norm();
  std::vector<CombHair> comb;
  comb.reserve(bends.size());
  for (const auto& [foot, bend] : bends) {
    const double length = scale * size * size * bend.norm();
    const double cut = length > longest * size ? longest * size / length : 1;
    const Eigen::Vector3d tip = foot - cut * scale * size * size * bend;
    const bool last = (comb.size() + 1) % static_cast<std::size_t>(hairs + 1) == 0;
    comb.push_back({glm::vec3(to_glm(foot)), glm::vec3(to_glm(tip)), last});
  }
  return comb;
}

void add_comb(Picture& picture, std::span<const CombHair> comb) {
  const glm::vec4 faint = to_glm(picture.theme.accent, 0.45F), strong = to_glm(picture.theme.accent, 0.9F);
  for (std::size_t k = 0; k < comb.size(); ++k) {
    picture.ribbons.push_back({comb[k].foot, comb[k].tip, faint, hair_ink});
    if (!comb[k].ends_piece && k + 1 < comb.size())
      picture.ribbons.push_back({comb[k].tip, comb[k + 1].tip, strong, tip_ink});
  }
}

}  // namespace knotwork::web
