#include "web/curve_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "knotwork/curve/curve_measures.h"
#include "knotwork/mesh/curvature_field.h"
#include "web/curve_ornaments.h"
#include "web/language.h"
#include "web/model_curve_ornaments.h"
#include "web/vectors.h"
#include "web/words.h"

namespace knotwork::web {
namespace {

constexpr float circle_ink = 1.3F, hodograph_ink = 2.2F, velocity_ink = 1.7F;  // widths, CSS pixels
constexpr int circle_steps = 96;
constexpr double largest_circle = 2;  // of the curve's size
constexpr int places_of_piece = 48;
constexpr double hodograph_share = 0.8;   // of the curve's size, that the hodograph may have
constexpr double hodograph_margin = 0.1;  // of the curve's size, between both
constexpr double stage_aspect = 1.5;      // of what is free of it
constexpr std::size_t most_joint_labels = 24;
// CSS pixels, in the order in which places are tried.
constexpr std::array<double, 4> joint_label_distances{17, 40, -17, -40};
constexpr std::array<double, 3> scale_label_distances{26, -26, 44};
constexpr glm::dvec2 label_room{44, 15};  // CSS pixels that "C⁰ G²" or "c′ ÷ 20" keeps to the middle of another name

/// The curve of a figure, which must outlive it; of data the fitted one, of a polygon its limit. Nothing of a surface.
std::optional<CurveView> curve_of(const Figure& figure) {
  if (const auto* curve = std::get_if<scene::CurveFigure>(&figure)) return curve_view(curve->curve);
  if (const auto* fit = std::get_if<scene::FitFigure>(&figure)) return curve_view(fit->curve.curve);
  if (const auto* polygon = std::get_if<scene::SubdivisionFigure>(&figure)) return curve_view(polygon->limit.curve);
  if (const auto* model = std::get_if<scene::ModelCurveFigure>(&figure)) return curve_view(model->model);
  if (const auto* blending = std::get_if<scene::BlendingCurveFigure>(&figure)) return curve_view(blending->curve);
  return std::nullopt;
}

/// Where the point stands that slides along the curve.
std::optional<double> parameter_of(const Figure& figure) {
  if (const auto* curve = std::get_if<scene::CurveFigure>(&figure)) return curve->t;
  if (const auto* model = std::get_if<scene::ModelCurveFigure>(&figure)) return model->t;
  if (const auto* blending = std::get_if<scene::BlendingCurveFigure>(&figure)) return blending->t;
  return std::nullopt;
}

struct Box {
  glm::dvec3 low{1e300}, high{-1e300};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  glm::dvec3 extent() const { return high - low; }
};

const Colour& velocity_hue(const Theme& theme) { return theme.local[1]; }

/// Beside the curve or below it, where both together fill a stage better; of a curve in space below it.
glm::dvec3 origin_beside(const Box& curve, const Box& drawn) {
  const glm::dvec3 extent = curve.extent();
  const double margin = hodograph_margin * glm::length(extent);
  const bool flat = extent.z + drawn.extent().z < 1e-9 * glm::length(extent);
  glm::dvec3 origin = 0.5 * (curve.low + curve.high) - 0.5 * (drawn.low + drawn.high);
  const glm::dvec2 beside(extent.x + margin + drawn.extent().x, std::max(extent.y, drawn.extent().y));
  const glm::dvec2 below(std::max(extent.x, drawn.extent().x), extent.y + margin + drawn.extent().y);
  const auto needed = [](const glm::dvec2& room) { return std::max(room.x / stage_aspect, room.y); };
  if (flat && needed(beside) < needed(below))
    origin.x = curve.high.x + margin - drawn.low.x;
  else if (flat)
    origin.y = curve.low.y - margin - drawn.high.y;
  else
    origin.z = curve.low.z - margin - drawn.high.z;
  return origin;
}

Hodograph hodograph_of(const CurveView& view, const std::vector<glm::dvec3>& outline) {
  Hodograph hodograph;
  Box velocities, room;
  for (const glm::dvec3& point : outline) room.add(point);
  velocities.add(glm::dvec3(0));
  const std::vector<double> ends = piece_ends(view.start, view.end, view.breaks);
  std::vector<glm::dvec3> found;
  // A piece that winds needs more places than one that bends.
  const int steps = std::max(places_of_piece, view.detail);
  for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
    for (int k = 0; k <= steps; ++k) {
      const double end = ends[piece + 1];
      const double t = k == steps ? just_before(end) : std::lerp(ends[piece], end, static_cast<double>(k) / steps);
      std::array<Eigen::Vector3d, 2> c;
      view.evaluate(t, c);
      found.push_back(to_glm(c[1]));
      velocities.add(found.back());
    }
  }
  const double size = glm::length(room.extent()), most = glm::length(velocities.extent());
  if (!(size > 0) || !(most > 0)) return hodograph;
  hodograph.scale = 1 / round_up_to_125(most / (hodograph_share * size));
  const Box drawn{hodograph.scale * velocities.low, hodograph.scale * velocities.high};
  hodograph.origin = origin_beside(room, drawn);
  hodograph.places.reserve(found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    hodograph.places.push_back(
        {glm::vec3(hodograph.origin + hodograph.scale * found[k]), (k + 1) % static_cast<std::size_t>(steps + 1) == 0});
  return hodograph;
}

void add_line(Picture& picture, const glm::dvec3& from, const glm::dvec3& to, const glm::vec4& ink, float width) {
  picture.ribbons.push_back({glm::vec3(from), glm::vec3(to), ink, width});
}

void add_hodograph(Picture& picture, const Figure& figure, const CurveTools& tools) {
  const Hodograph& hodograph = tools.hodograph;
  const std::optional<CurveView> view = curve_of(figure);
  if (hodograph.places.empty() || !view) return;
  const glm::vec4 ink = to_glm(velocity_hue(picture.theme), 1), soft = to_glm(picture.theme.ink_soft, 0.7F);
  for (std::size_t k = 0; k + 1 < hodograph.places.size(); ++k)
    if (!hodograph.places[k].ends_piece)
      picture.ribbons.push_back({hodograph.places[k].at, hodograph.places[k + 1].at, ink, hodograph_ink});

  // Where it is torn, both ends are marked.
  for (const Continuity& joint : tools.joints) {
    if (joint.parametric >= 1) continue;
    const double before = joint.t <= view->start ? view->end : joint.t;
    for (const double t : {just_before(before), joint.t}) {
      std::array<Eigen::Vector3d, 2> c;
      view->evaluate(t, c);
      const glm::dvec3 at = hodograph.origin + hodograph.scale * to_glm(c[1]);
      picture.discs.push_back({glm::vec3(at), 4.2F, to_glm(picture.theme.stage, 1), glm::vec3(ink), 1.8F});
    }
  }

  const double cross = 5 * picture.view.pixel_size(hodograph.origin);
  for (const glm::dvec3& axis : {picture.view.right, picture.view.up})
    add_line(picture, hodograph.origin - cross * axis, hodograph.origin + cross * axis, soft, 1.2F);
  const std::optional<double> t = parameter_of(figure);
  if (!t) return;
  // The same arrow twice: from the origin, and from the point that moves with this velocity.
  std::array<Eigen::Vector3d, 2> c;
  view->evaluate(*t, c);
  const glm::dvec3 step = hodograph.scale * to_glm(c[1]);
  for (const glm::dvec3& foot : {hodograph.origin, to_glm(c[0])}) {
    add_line(picture, foot, foot + step, ink, velocity_ink);
    picture.discs.push_back({glm::vec3(foot + step), 3.6F, ink, glm::vec3(ink), 1});
  }
}

void add_circle_at_parameter(Picture& picture, const Figure& figure, double size) {
  const std::optional<CurveView> curve = curve_of(figure);
  const std::optional<double> t = parameter_of(figure);
  if (!curve || !t) return;
  std::array<Eigen::Vector3d, 3> c;
  curve->evaluate(*t, c);
  const FrenetFrame frame = frenet_frame(c, size > 0 ? 1e-12 / size : 0);
  if (!frame.regular || frame.straight) return;
  const double radius = 1 / frame.curvature;
  add_osculating_circle(picture, to_glm(c[0]) + radius * to_glm(frame.normal), radius, to_glm(frame.tangent),
                        to_glm(frame.normal), size);
}

/// At the first of some distances along a way from where the label is that no other name is near; else at the last.
void add_where_free(std::vector<StageLabel>& labels, StageLabel label, const glm::dvec2& way,
                    std::span<const double> distances) {
  const glm::dvec2 from = label.place;
  for (const double distance : distances) {
    label.place = from + distance * way;
    const bool free = std::none_of(labels.begin(), labels.end(), [&](const StageLabel& other) {
      return std::abs(other.place.x - label.place.x) < label_room.x &&
             std::abs(other.place.y - label.place.y) < label_room.y;
    });
    if (free) break;
  }
  labels.push_back(std::move(label));
}

}  // namespace

bool wants_tools(const scene::Display& display) {
  return display.comb || display.osculating || display.hodograph || display.continuity;
}

CurveTools curve_tools(const Figure& figure, const scene::Display& display) {
  CurveTools tools;
  const std::optional<CurveView> curve = curve_of(figure);
  if (!curve) return tools;
  if (display.comb) tools.comb = curvature_comb(*curve);
  for (const CombHair& hair : tools.comb) tools.tips.emplace_back(hair.tip);
  if (display.hodograph || display.continuity) tools.joints = joints(*curve);
  if (display.osculating) {
    Box box;
    for (const glm::dvec3& point : outline(figure)) box.add(point);
    tools.size = glm::length(box.extent());
  }
  if (!display.hodograph) return tools;
  std::vector<glm::dvec3> room = outline(figure);
  room.insert(room.end(), tools.tips.begin(), tools.tips.end());
  tools.hodograph = hodograph_of(*curve, room);
  for (const Hodograph::Place& place : tools.hodograph.places) tools.tips.emplace_back(place.at);
  tools.tips.push_back(tools.hodograph.origin);
  return tools;
}

void add_tools(Picture& picture, const Figure& figure, const CurveTools& tools) {
  add_comb(picture, tools.comb);
  add_hodograph(picture, figure, tools);
  // A model curve has its own, with the frame.
  if (picture.display.osculating && !std::holds_alternative<scene::ModelCurveFigure>(figure))
    add_circle_at_parameter(picture, figure, tools.size);
}

void add_osculating_circle(Picture& picture, const glm::dvec3& centre, double radius, const glm::dvec3& tangent,
                           const glm::dvec3& normal, double size) {
  if (radius > largest_circle * size) return;
  const Colour ink = mixed(picture.theme.stage, bend_hue(picture.theme), 0.75F);
  const auto at = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / circle_steps;
    return centre - radius * std::cos(angle) * normal + radius * std::sin(angle) * tangent;
  };
  for (int k = 0; k < circle_steps; ++k) add_line(picture, at(k), at(k + 1), to_glm(ink, 1), circle_ink);
  picture.discs.push_back({glm::vec3(centre), 2.6F, to_glm(ink, 1), to_glm(ink), 1});
}

std::string continuity_text(const Continuity& joint) {
  if (joint.parametric < 0) return std::string(say("torn"));
  std::string text = "C" + superscript(joint.parametric);
  if (joint.geometric > joint.parametric) text += " G" + superscript(joint.geometric);
  return text;
}

void add_tool_labels(std::vector<StageLabel>& labels, const Figure& figure, const scene::Display& display,
                     const CurveTools& tools, const View& view, const Theme& theme) {
  const std::optional<CurveView> curve = curve_of(figure);
  if (!curve) return;
  if (!tools.hodograph.places.empty()) {
    const auto screen = view.project(tools.hodograph.origin);
    const std::string words = tools.hodograph.scale == 1 ? "c′" : "c′ ÷ " + text_of("%.3g", 1 / tools.hodograph.scale);
    if (screen)
      add_where_free(labels, {words, glm::dvec2(*screen), velocity_hue(theme)}, {0, 1}, scale_label_distances);
  }
  if (!display.continuity || tools.joints.size() > most_joint_labels) return;
  for (const Continuity& joint : tools.joints) {
    std::array<Eigen::Vector3d, 3> c;
    curve->evaluate(joint.t, c);
    const glm::dvec3 at = to_glm(c[0]);
    const std::optional<glm::dvec3> screen = view.project(at);
    const double pixel = view.pixel_size(at);
    const FrenetFrame frame = frenet_frame(c);
    // Inside the bend: outside is the comb.
    const std::optional<glm::dvec3> inside = view.project(at + 10 * pixel * to_glm(frame.normal));
    if (!screen || !inside) continue;
    const glm::dvec2 way = glm::dvec2(*inside) - glm::dvec2(*screen);
    const double length = glm::length(way);
    const glm::dvec2 side = length > 1 ? way / length : glm::dvec2(0, 1);
    add_where_free(labels, {continuity_text(joint), glm::dvec2(*screen), theme.accent}, side, joint_label_distances);
  }
}

}  // namespace knotwork::web
