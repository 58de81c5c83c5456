#include "web/figure.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "knotwork/scene/later.h"
#include "knotwork/scene/net_roll.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

// --- The blending surface ------------------------------------------------------------------------------------------

Figure figure_of(const scene::BlendingSurfaceObject& object, const scene::Animation& animation) {
  return BlendingFigure(scene::build_surface(object, animation));
}

HandleGrid grid_of(const scene::BlendingSurfaceObject& object) {
  return {"patch", "Patch", object.locals_u, object.locals_v, true, false};
}

glm::dvec3 handle_position(const BlendingFigure& figure, HandleIndex index) {
  return to_glm(scene::patch_origin(figure.surface, index));
}

std::vector<glm::dvec3> outline_of(const BlendingFigure& figure) { return outline(knotted_surface(figure.surface)); }

std::span<const scene::CurveSample> path(const BlendingFigure&) { return {}; }

std::optional<KnottedSurface> surface_in(const BlendingFigure& figure) { return knotted_surface(figure.surface); }
std::optional<scene::PickNet>* net_in(BlendingFigure& figure) { return &figure.net; }

// --- Bezier and B-spline curves ------------------------------------------------------------------------------------

Figure figure_of(const scene::Shape& shape) { return scene::CurveFigure(shape); }
Figure figure_of(const scene::BezierCurveObject& curve, const scene::Animation&) { return figure_of(curve); }
Figure figure_of(const scene::BSplineCurveObject& curve, const scene::Animation&) { return figure_of(curve); }

HandleGrid points_grid(std::size_t count) { return {"point", "Point", static_cast<int>(count), 1, false, true}; }
HandleGrid grid_of(const scene::BezierCurveObject& curve) { return points_grid(curve.points.size()); }
HandleGrid grid_of(const scene::BSplineCurveObject& curve) { return points_grid(curve.points.size()); }

glm::dvec3 handle_position(const scene::CurveFigure& figure, HandleIndex index) {
  return to_glm(index == parameter_handle ? figure.construction.back().front() : figure.curve.point(index.first));
}

/// Its control points and the curve itself, which without clamped ends may be elsewhere.
std::vector<glm::dvec3> outline_of(const scene::CurveFigure& figure) {
  std::vector<glm::dvec3> points;
  for (const Eigen::Vector3d& point : figure.curve.points()) points.push_back(to_glm(point));
  for (std::size_t k = 0; k < figure.samples.size(); k += 8) points.push_back(to_glm(figure.samples[k].point));
  return points;
}

std::span<const scene::CurveSample> path(const scene::CurveFigure& figure) { return figure.samples; }

std::optional<KnottedSurface> surface_in(const scene::CurveFigure&) { return std::nullopt; }
std::optional<scene::PickNet>* net_in(scene::CurveFigure&) { return nullptr; }

// --- Fitted curves and subdivisions --------------------------------------------------------------------------------

/// So many data are handles; more are dots that no hand takes.
constexpr std::size_t most_data_handles = 300;
/// Of many points some say where they are.
constexpr std::size_t outline_points = 512;

Figure figure_of(const scene::FittedCurveObject& object, const scene::Animation&) { return scene::FitFigure(object); }
Figure figure_of(const scene::SubdivisionCurveObject& object, const scene::Animation&) {
  return scene::SubdivisionFigure(object);
}

HandleGrid grid_of(const scene::FittedCurveObject& object) {
  const std::size_t count = object.points.size() > most_data_handles ? 0 : object.points.size();
  return {"point", "Point", static_cast<int>(count), 1, false, false};
}
HandleGrid grid_of(const scene::SubdivisionCurveObject& object) {
  return {"point", "Point", static_cast<int>(object.points.size()), 1, false, false};
}

glm::dvec3 handle_position(const scene::FitFigure& figure, HandleIndex index) {
  return to_glm(figure.points[static_cast<std::size_t>(index.first)]);
}
glm::dvec3 handle_position(const scene::SubdivisionFigure& figure, HandleIndex index) {
  return to_glm(figure.points[static_cast<std::size_t>(index.first)]);
}

/// The points, and the curve that comes of them.
std::vector<glm::dvec3> outline_of(std::span<const Eigen::Vector3d> points, const scene::CurveFigure& curve) {
  std::vector<glm::dvec3> outline;
  const std::size_t step = 1 + points.size() / outline_points;
  for (std::size_t k = 0; k < points.size(); k += step) outline.push_back(to_glm(points[k]));
  for (std::size_t k = 0; k < curve.samples.size(); k += 8) outline.push_back(to_glm(curve.samples[k].point));
  return outline;
}
std::vector<glm::dvec3> outline_of(const scene::FitFigure& figure) {
  std::vector<glm::dvec3> points = outline_of(figure.points, figure.curve);
  for (const Eigen::Vector3d& point : figure.curve.curve.points()) points.push_back(to_glm(point));
  return points;
}
std::vector<glm::dvec3> outline_of(const scene::SubdivisionFigure& figure) {
  return outline_of(figure.points, figure.limit);
}

// No parameter slides along them.
std::span<const scene::CurveSample> path(const scene::FitFigure&) { return {}; }
std::span<const scene::CurveSample> path(const scene::SubdivisionFigure&) { return {}; }

std::optional<KnottedSurface> surface_in(const scene::FitFigure&) { return std::nullopt; }
std::optional<scene::PickNet>* net_in(scene::FitFigure&) { return nullptr; }
std::optional<KnottedSurface> surface_in(const scene::SubdivisionFigure&) { return std::nullopt; }
std::optional<scene::PickNet>* net_in(scene::SubdivisionFigure&) { return nullptr; }

// --- Model curves and blending curves ------------------------------------------------------------------------------

Figure figure_of(const scene::ModelCurveObject& curve, const scene::Animation&) {
  return scene::ModelCurveFigure(curve);
}
Figure figure_of(const scene::BlendingCurveObject& curve, const scene::Animation& animation) {
  return scene::BlendingCurveFigure(curve, animation);
}

HandleGrid grid_of(const scene::ModelCurveObject&) { return {"point", "Point", 0, 1, false, true}; }
HandleGrid grid_of(const scene::BlendingCurveObject& curve) {
  return {"local", "Local curve", curve.locals, 1, false, true};
}

glm::dvec3 handle_position(const scene::ModelCurveFigure& figure, HandleIndex) { return to_glm(figure.point); }
glm::dvec3 handle_position(const scene::BlendingCurveFigure& figure, HandleIndex index) {
  if (index == parameter_handle) return to_glm(figure.point);
  return to_glm(scene::local_origin(figure.locals[static_cast<std::size_t>(index.first)]));
}

std::vector<glm::dvec3> every(std::span<const scene::CurveSample> samples, std::size_t step) {
  std::vector<glm::dvec3> points;
  for (std::size_t k = 0; k < samples.size(); k += step) points.push_back(to_glm(samples[k].point));
  return points;
}

std::vector<glm::dvec3> outline_of(const scene::ModelCurveFigure& figure) { return every(figure.samples, 8); }

/// The curve, its handles, and its locals where they weigh enough to be seen.
std::vector<glm::dvec3> outline_of(const scene::BlendingCurveFigure& figure) {
  constexpr double seen = 0.1;
  std::vector<glm::dvec3> points = every(figure.samples, 8);
  for (const scene::BlendingCurveFigure::Strand& strand : figure.strands)
    for (std::size_t k = 0; k < strand.points.size(); k += 8)
      if (strand.weights[k] > seen) points.push_back(to_glm(strand.points[k]));
  for (const scene::LocalFrame& local : figure.locals) points.push_back(to_glm(scene::local_origin(local)));
  return points;
}

std::span<const scene::CurveSample> path(const scene::ModelCurveFigure& figure) { return figure.samples; }
std::span<const scene::CurveSample> path(const scene::BlendingCurveFigure& figure) { return figure.samples; }

std::optional<KnottedSurface> surface_in(const scene::ModelCurveFigure&) { return std::nullopt; }
std::optional<scene::PickNet>* net_in(scene::ModelCurveFigure&) { return nullptr; }
std::optional<KnottedSurface> surface_in(const scene::BlendingCurveFigure&) { return std::nullopt; }
std::optional<scene::PickNet>* net_in(scene::BlendingCurveFigure&) { return nullptr; }

// --- B-spline surfaces ---------------------------------------------------------------------------------------------

Figure figure_of(const scene::BSplineSurfaceObject& object, const scene::Animation&) {
  return NetSurfaceFigure{scene::NetFigure(object), {}};
}

HandleGrid grid_of(const scene::BSplineSurfaceObject& object) {
  return {"point", "Point", object.rows(), object.columns(), true, false};
}

glm::dvec3 handle_position(const NetSurfaceFigure& figure, HandleIndex index) {
  return to_glm(figure.shown.surface.point(index.first, index.second));
}

/// The net too: its points are what a hand takes hold of.
std::vector<glm::dvec3> outline_of(const NetSurfaceFigure& figure) {
  std::vector<glm::dvec3> points = outline(knotted_surface(figure.shown.surface));
  for (const Eigen::Vector3d& point : figure.shown.surface.points()) points.push_back(to_glm(point));
  return points;
}

std::span<const scene::CurveSample> path(const NetSurfaceFigure&) { return {}; }

std::optional<KnottedSurface> surface_in(const NetSurfaceFigure& figure) {
  return knotted_surface(figure.shown.surface);
}
std::optional<scene::PickNet>* net_in(NetSurfaceFigure& figure) { return &figure.net; }

// --- Model surfaces ------------------------------------------------------------------------------------------------

Figure figure_of(const scene::ModelSurfaceObject& object, const scene::Animation&) {
  return ModelSurfaceFigure{scene::ModelFigure(object.model), {}};
}

/// Nothing of it can be held.
HandleGrid grid_of(const scene::ModelSurfaceObject&) { return {"point", "Point", 0, 0, true, false}; }
glm::dvec3 handle_position(const ModelSurfaceFigure&, HandleIndex) { return glm::dvec3(0); }

std::vector<glm::dvec3> outline_of(const ModelSurfaceFigure& figure) { return outline(knotted_surface(figure.shown)); }

std::span<const scene::CurveSample> path(const ModelSurfaceFigure&) { return {}; }

std::optional<KnottedSurface> surface_in(const ModelSurfaceFigure& figure) { return knotted_surface(figure.shown); }
std::optional<scene::PickNet>* net_in(ModelSurfaceFigure& figure) { return &figure.net; }

// --- Names of handles ----------------------------------------------------------------------------------------------

std::optional<int> index_from(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  // One spelling for each handle: no sign, no leading zeros.
  if (!whole || value < 0 || std::to_string(value) != text) return std::nullopt;
  return value;
}

}  // namespace

Figure make_figure(const scene::Shape& shape, const scene::Animation& animation) {
  return scene::visit_first([&](const auto& object) { return figure_of(object, animation); }, shape);
}

void update_figure(std::optional<Figure>& figure, const scene::Shape& shape, const scene::Animation& animation) {
  auto* model = figure ? std::get_if<scene::ModelCurveFigure>(&*figure) : nullptr;
  auto* blending = figure ? std::get_if<scene::BlendingCurveFigure>(&*figure) : nullptr;
  const auto* model_object = std::get_if<scene::ModelCurveObject>(&shape);
  const auto* blending_object = std::get_if<scene::BlendingCurveObject>(&shape);
  if (model && model_object) {
    model->update(*model_object);
  } else if (blending && blending_object) {
    blending->update(*blending_object, animation);
  } else if (const auto* fitted = std::get_if<scene::FittedCurveObject>(&shape)) {
    figure = scene::FitFigure(*fitted, figure ? std::get_if<scene::FitFigure>(&*figure) : nullptr);
  } else {
    figure = make_figure(shape, animation);
  }
}

bool moves(const scene::Shape& shape) {
  return std::holds_alternative<scene::BlendingSurfaceObject>(shape) ||
         std::holds_alternative<scene::BlendingCurveObject>(shape);
}

bool is_other_model(const scene::Shape& shape, const scene::Shape& last) {
  const auto* surface = std::get_if<scene::ModelSurfaceObject>(&shape);
  const auto* curve = std::get_if<scene::ModelCurveObject>(&shape);
  const auto* blending = std::get_if<scene::BlendingCurveObject>(&shape);
  if (shape.index() != last.index()) return false;
  if (surface)
    return scene::model_kind(surface->model) != scene::model_kind(std::get<scene::ModelSurfaceObject>(last).model);
  if (curve) return curve->model.row != std::get<scene::ModelCurveObject>(last).model.row;
  return blending && blending->model.row != std::get<scene::BlendingCurveObject>(last).model.row;
}

HandleGrid handle_grid(const scene::Shape& shape) {
  return scene::visit_first([](const auto& object) { return grid_of(object); }, shape);
}

std::string handle_id(const scene::Shape& shape, HandleIndex index) {
  if (index == parameter_handle) return "parameter";
  const HandleGrid grid = handle_grid(shape);
  std::string id = std::string(grid.id) + '-' + std::to_string(index.first);
  return grid.two_indices ? id + '-' + std::to_string(index.second) : id;
}

std::optional<HandleIndex> find_handle(const scene::Shape& shape, std::string_view id) {
  const HandleGrid grid = handle_grid(shape);
  if (id == "parameter" && grid.has_parameter) return parameter_handle;
  const std::string prefix = std::string(grid.id) + '-';
  if (!id.starts_with(prefix)) return std::nullopt;
  id.remove_prefix(prefix.size());
  const std::size_t dash = grid.two_indices ? std::min(id.find('-'), id.size()) : id.size();
  const std::optional<int> i = index_from(id.substr(0, dash));
  const std::optional<int> j = grid.two_indices ? index_from(id.substr(std::min(dash + 1, id.size()))) : 0;
  if (!i || !j || !has_handle(shape, {*i, *j})) return std::nullopt;
  return HandleIndex(*i, *j);
}

std::string handle_name(const scene::Shape& shape, HandleIndex index) {
  if (index == parameter_handle) return "Parameter";
  const HandleGrid grid = handle_grid(shape);
  std::string name = std::string(grid.name) + ' ' + std::to_string(index.first);
  return grid.two_indices ? name + ", " + std::to_string(index.second) : name;
}

bool has_handle(const scene::Shape& shape, HandleIndex index) {
  const HandleGrid grid = handle_grid(shape);
  if (index == parameter_handle) return grid.has_parameter;
  return index.first >= 0 && index.first < grid.columns && index.second >= 0 && index.second < grid.rows;
}

void take_handles(const Figure& figure, const scene::Shape& shape, std::vector<Handle>& handles) {
  const HandleGrid grid = handle_grid(shape);
  handles.clear();
  handles.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1);
  const auto add = [&](HandleIndex index) {
    const auto position = [&](const auto& shown) { return handle_position(shown, index); };
    handles.push_back({index, scene::visit_first(position, figure), {}, false});
  };
  for (int i = 0; i < grid.columns; ++i)
    for (int j = 0; j < grid.rows; ++j) add({i, j});
  // Drawn and found after the points: where both are, a point is meant.
  if (grid.has_parameter) add(parameter_handle);
}

std::vector<glm::dvec3> outline(const Figure& figure) {
  return scene::visit_first([](const auto& shown) { return outline_of(shown); }, figure);
}

std::vector<glm::dvec3> outline(const KnottedSurface& surface) {
  constexpr std::size_t steps = 20;
  std::array<double, steps + 1> u{}, v{};
  for (std::size_t k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    u[k] = std::lerp(surface.knots_u->start(), surface.knots_u->end(), share);
    v[k] = std::lerp(surface.knots_v->start(), surface.knots_v->end(), share);
  }
  std::vector<SurfaceJet> jets(u.size() * v.size());
  surface.evaluate_grid(u, v, jets);
  std::vector<glm::dvec3> points;
  points.reserve(jets.size());
  for (const SurfaceJet& jet : jets) points.push_back(to_glm(jet.s));
  return points;
}

std::optional<KnottedSurface> surface_of(const Figure& figure) {
  return scene::visit_first([](const auto& shown) { return surface_in(shown); }, figure);
}

std::optional<scene::SurfaceHit> pick(Figure& figure, const scene::Ray& ray) {
  const std::optional<KnottedSurface> surface = surface_of(figure);
  std::optional<scene::PickNet>* net = scene::visit_first([](auto& shown) { return net_in(shown); }, figure);
  if (!surface || net == nullptr) return std::nullopt;
  if (!*net) net->emplace(*surface);
  return (*net)->pick(*surface, ray);
}

bool rolls(const scene::Shape& shape) {
  return moves(shape) || std::holds_alternative<scene::BSplineSurfaceObject>(shape);
}

scene::Roll roll_at_rest(const scene::Shape& shape) {
  if (const auto* net = std::get_if<scene::BSplineSurfaceObject>(&shape)) return scene::rest_roll(*net);
  const auto* blending = std::get_if<scene::BlendingSurfaceObject>(&shape);
  return blending != nullptr ? scene::rest_roll(*blending) : scene::Roll{0, 0};
}

std::span<const scene::CurveSample> path_of(const Figure& figure) {
  return scene::visit_first([](const auto& shown) { return path(shown); }, figure);
}

}  // namespace knotwork::web
