#include "web/still_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/parametric_curve.h"
#include "knotwork/mesh/curvature_field.h"
#include "knotwork/mesh/surface_sampling.h"
#include "knotwork/scene/palette.h"
#include "knotwork/surface/surface_measures.h"
#include "web/curvature_colours.h"
#include "web/model_ornaments.h"
#include "web/net_ornaments.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

/// A mixture of hues with its chroma kept up in part, as raised_hue() in shaders/blending.glsl.
class HueMixture {
 public:
  void add(double weight, const glm::vec3& hue) {
    lab_ += weight * glm::dvec3(hue);
    chroma_ += weight * std::hypot(hue.y, hue.z);
  }
  glm::dvec3 hue() const {
    const double kept = std::hypot(lab_.y, lab_.z);
    const double raised = std::lerp(kept, chroma_, 0.4 * glm::smoothstep(0.0, 0.06, kept));
    const double factor = kept > 1e-5 ? raised / kept : 1;
    return {lab_.x, lab_.y * factor, lab_.z * factor};
  }

 private:
  glm::dvec3 lab_{0};
  double chroma_ = 0;
};

glm::dvec3 hue_at(const BlendingFigure& figure, const scene::Document& document, const Theme& theme, double u,
                  double v) {
  const scene::BlendingSurfaceObject& object = scene::blending_surface(document);
  HueMixture mixture;
  for (const auto& [i, j, value] : figure.surface.weights(u, v)) {
    const scene::PatchIndex patch{i % object.locals_u, j % object.locals_v};
    mixture.add(value, oklab(scene::patch_hue(scene::patch_hue_index(object, patch), theme.dark)));
  }
  return mixture.hue();
}

glm::dvec3 hue_at(const NetSurfaceFigure& figure, const scene::Document& document, const Theme& theme, double u,
                  double v) {
  const BSplineSurface& surface = figure.shown.surface;
  const auto& object = *std::get_if<scene::BSplineSurfaceObject>(&scene::stage_shape(document));
  const std::vector<glm::vec3> hues = net_hues(figure.shown, object, theme.dark);
  const auto functions = [](const KnotVector& knots, double t) {
    std::vector<std::pair<int, double>> found;
    const double within = knots.reduced(t);
    const int span = knots.span(within), degree = knots.degree();
    std::vector<double> values(static_cast<std::size_t>(degree) + 1);
    bspline_basis(knots, span, within, 0, values);
    found.reserve(values.size());
    for (int k = 0; k <= degree; ++k)
      found.emplace_back((span - degree + k) % knots.count(), values[static_cast<std::size_t>(k)]);
    return found;
  };
  HueMixture mixture;
  const std::vector<std::pair<int, double>> along_v = functions(surface.knots_v(), v);
  for (const auto& [i, weight_u] : functions(surface.knots_u(), u)) {
    for (const auto& [j, weight_v] : along_v) {
      const auto k = static_cast<std::size_t>(i * surface.knots_v().count() + j);
      mixture.add(weight_u * weight_v, hues[k]);
    }
  }
  return mixture.hue();
}

glm::dvec3 hue_at(const ModelSurfaceFigure&, const scene::Document&, const Theme& theme, double, double) {
  return model_hue(theme);
}

template <class Curve>
glm::dvec3 hue_at(const Curve&, const scene::Document&, const Theme&, double, double) {
  return {};
}

double linear(float c) { return c <= 0.04045F ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
float encoded(double c) {
  c = std::max(c, 0.0);
  return static_cast<float>(c < 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

/// The fragment shader's light of the light scheme: a large key light, a fill, sky and floor, gloss.
Colour lit(glm::dvec3 hue, glm::dvec3 normal, glm::dvec3 to_eye, bool back, const View& view) {
  const glm::dvec3 key_light =
      glm::normalize(-0.44 * view.right + 0.34 * view.up - 0.58 * view.forward + glm::dvec3(0, 0, 0.46));
  const glm::dvec3 fill_light = glm::normalize(0.8 * view.right + 0.1 * view.up - 0.1 * view.forward);
  hue = {hue.x + 0.04, 1.04 * hue.y, 1.04 * hue.z};
  if (back) hue = {0.93 * hue.x, 0.72 * hue.y, 0.72 * hue.z};
  const Colour flat = srgb(glm::vec3(hue));
  const glm::dvec3 albedo(linear(flat[0]), linear(flat[1]), linear(flat[2]));
  const double key = glm::smoothstep(-0.45, 1.0, glm::dot(normal, key_light));
  const double fill = 0.5 + 0.5 * glm::dot(normal, fill_light);
  const double sky = 0.5 + 0.5 * normal.z;
  const double facing = std::max(glm::dot(normal, to_eye), 0.0);
  glm::dvec3 light = glm::dvec3(1.00, 0.98, 0.95) * (0.74 * key * key + 0.20 * key) +
                     glm::dvec3(0.90, 0.95, 1.0) * (0.16 * fill) +
                     0.56 * glm::mix(glm::dvec3(0.589, 0.558, 0.527), glm::dvec3(0.97, 0.985, 1.0), sky);
  light += 0.2 * facing * facing;
  const double glance = std::max(glm::dot(normal, glm::normalize(key_light + to_eye)), 0.0);
  const double fresnel = 0.04 + 0.6 * std::pow(1.0 - facing, 4.0);
  const double gloss = 0.30 * std::pow(glance, 90.0) + 0.10 * std::pow(glance, 18.0);
  const glm::dvec3 reflected = glm::mix(glm::dvec3(0.80, 0.76, 0.72), glm::dvec3(1.0), glm::smoothstep(0.25, 0.9, sky));
  glm::dvec3 sum = glm::mix(albedo * light, reflected, fresnel * 0.42 * (0.35 + 0.65 * sky)) + gloss;
  sum /= 1.0 + std::max(std::max({sum.x, sum.y, sum.z}) - 0.92, 0.0);
  return {encoded(sum.x), encoded(sum.y), encoded(sum.z)};
}

/// A place of the sampled surface on the screen.
struct Corner {
  glm::dvec3 point, normal;
  std::optional<glm::dvec3> screen;
};

bool goes_round(const KnottedSurface& surface) { return surface.knots_u->closed() && surface.knots_v->closed(); }

/// What a shading that is not the light alone makes of a place's hue (OKLab).
class QualityHue {
 public:
  QualityHue(const KnottedSurface& surface, const SampleGrid& grid, scene::Shading shading) : shading_(shading) {
    if (!curved()) return;
    const auto kind = shading == scene::Shading::mean ? CurvatureKind::mean : CurvatureKind::gaussian;
    scale_ = curvature_field(surface, grid, kind).scale;
  }

  bool striped() const { return shading_ == scene::Shading::zebra || shading_ == scene::Shading::isophotes; }

  /// Positive in one half of the stripes. Lamps as lamp() in shaders/surface.frag; bands of slope instead of its lines.
  double stripe(glm::dvec3 normal, glm::dvec3 to_eye) const {
    if (shading_ == scene::Shading::isophotes) return std::sin(18 * std::acos(std::clamp(normal.z, -1.0, 1.0)));
    const glm::dvec3 mirrored = glm::reflect(-to_eye, normal);
    return std::cos(14 * std::atan2(mirrored.y, mirrored.z));
  }

  glm::dvec3 in_stripe(glm::dvec3 hue, bool positive) const {
    if (shading_ == scene::Shading::isophotes) return positive ? hue : glm::dvec3(0.84 * hue.x, hue.y, hue.z);
    return positive ? glm::dvec3(0.97, 0.35 * hue.y, 0.35 * hue.z) : glm::dvec3(0.30, 0.2 * hue.y, 0.2 * hue.z);
  }

  glm::dvec3 of(const SurfaceJet& jet, glm::dvec3 hue) const {
    if (!curved()) return hue;
    const SurfaceCurvature bent = curvature(jet);
    const double value = shading_ == scene::Shading::mean ? bent.mean : bent.gaussian;
    return CurvatureColours().at(static_cast<float>(value / scale_));
  }

 private:
  bool curved() const { return shading_ == scene::Shading::gaussian || shading_ == scene::Shading::mean; }

  scene::Shading shading_;
  double scale_ = 1;
};

/// The part of a piece where values are not negative that are given at its corners and linear between them.
std::vector<glm::dvec2> positive_part(std::span<const glm::dvec2> corners, std::span<const double> values) {
  std::vector<glm::dvec2> part;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    if (values[k] >= 0) part.push_back(corners[k]);
    if (values[k] * values[next] < 0)
      part.push_back(glm::mix(corners[k], corners[next], values[k] / (values[k] - values[next])));
  }
  return part;
}

}  // namespace

SurfacePieces surface_pieces(const Figure& figure, const scene::Document& document, const View& view, int pieces_u,
                             int pieces_v) {
  const std::optional<KnottedSurface> surface = surface_of(figure);
  if (!surface) return {};
  SampleGrid grid = sample_grid(*surface->knots_u, *surface->knots_v, pieces_u, pieces_v, Seam::repeated);
  // What jumps at knot lines is what is to be seen.
  if (document.display.shading != scene::Shading::lit)
    grid = parted_at_knots(std::move(grid), *surface->knots_u, *surface->knots_v);
  std::vector<SurfaceJet> jets(grid.u.size() * grid.v.size());
  surface->evaluate_grid(grid.u, grid.v, jets);
  std::vector<Corner> corners;
  corners.reserve(jets.size());
  for (const SurfaceJet& jet : jets) {
    const glm::dvec3 point = to_glm(jet.s);
    corners.push_back({point, to_glm(unit_normal(jet)), view.project(point)});
  }
  const auto corner = [&](int a, int b) -> const Corner& {
    return corners[static_cast<std::size_t>(a * grid.rows() + b)];
  };

  const Theme theme = make_theme(false);
  const glm::dvec3 plain = oklab(Colour{0.80F, 0.79F, 0.76F});
  const QualityHue quality(*surface, grid, document.display.shading);
  SurfacePieces pieces;
  std::vector<bool> backs;
  for (int a = 0; a + 1 < grid.columns(); ++a) {
    for (int b = 0; b + 1 < grid.rows(); ++b) {
      const double from_u = grid.u[static_cast<std::size_t>(a)], to_u = grid.u[static_cast<std::size_t>(a) + 1];
      const double from_v = grid.v[static_cast<std::size_t>(b)], to_v = grid.v[static_cast<std::size_t>(b) + 1];
      if (from_u >= just_before(to_u) || from_v >= just_before(to_v)) continue;  // between the sides of a knot
      const std::array<const Corner*, 4> round{&corner(a, b), &corner(a + 1, b), &corner(a + 1, b + 1),
                                               &corner(a, b + 1)};
      if (!std::all_of(round.begin(), round.end(), [](const Corner* c) { return c->screen.has_value(); })) continue;
      glm::dvec3 middle(0), normal(0);
      for (const Corner* c : round) {
        middle += 0.25 * c->point;
        normal += c->normal;
      }
      if (glm::dot(normal, normal) < 1e-12)
        normal = glm::cross(round[2]->point - round[0]->point, round[3]->point - round[1]->point);
      if (glm::dot(normal, normal) < 1e-24) continue;  // of no extent
      normal = glm::normalize(normal);
      const glm::dvec3 to_eye = glm::normalize(view.eye - middle);
      const bool back = glm::dot(normal, to_eye) < 0;
      if (back) normal = -normal;
      const double u = 0.5 * (from_u + to_u), v = 0.5 * (from_v + to_v);
      const glm::dvec3 hue =
          document.display.patch_colours
              ? scene::visit_first([&](const auto& shown) { return hue_at(shown, document, theme, u, v); }, figure)
              : plain;
      std::vector<glm::dvec2> outline;
      std::array<double, 4> stripes{};
      for (std::size_t k = 0; k < 4; ++k) {
        outline.emplace_back(*round[k]->screen);
        if (quality.striped())
          stripes[k] = quality.stripe(round[k]->normal, glm::normalize(view.eye - round[k]->point));
      }
      const double depth = glm::dot(middle - view.eye, view.forward);
      const auto add = [&](std::vector<glm::dvec2> part, const glm::dvec3& own) {
        if (part.size() < 3) return;
        pieces.facets.push_back({std::move(part), depth, lit(own, normal, to_eye, back, view)});
        backs.push_back(back);
      };
      if (!quality.striped()) {
        add(std::move(outline), quality.of(surface->evaluate(u, v), hue));
        continue;
      }
      add(positive_part(outline, stripes), quality.in_stripe(hue, true));
      for (double& value : stripes) value = -value;
      add(positive_part(outline, stripes), quality.in_stripe(hue, false));
    }
  }
  if (goes_round(*surface) && !pieces.facets.empty()) {
    // What is nearest to the eye shows the outside.
    const auto nearest = std::min_element(pieces.facets.begin(), pieces.facets.end(),
                                          [](const Facet& f, const Facet& g) { return f.depth < g.depth; });
    const bool outside = backs[static_cast<std::size_t>(nearest - pieces.facets.begin())];
    std::vector<Facet> seen;
    seen.reserve(pieces.facets.size());
    for (std::size_t k = 0; k < backs.size(); ++k)
      if (backs[k] == outside) seen.push_back(pieces.facets[k]);
    pieces.facets = std::move(seen);
  }
  if (!document.display.knot_lines) return pieces;

  const auto add_edge = [&](const Corner& start, const Corner& end) {
    if (!start.screen || !end.screen) return;
    pieces.knot_lines.push_back({glm::dvec2(*start.screen), glm::dvec2(*end.screen), 0.5 * (start.point + end.point)});
  };
  for (const int a : grid.starts_u)
    for (int b = 0; b + 1 < grid.rows(); ++b) add_edge(corner(a, b), corner(a, b + 1));
  for (const int b : grid.starts_v)
    for (int a = 0; a + 1 < grid.columns(); ++a) add_edge(corner(a, b), corner(a + 1, b));
  return pieces;
}

}  // namespace knotwork::web
