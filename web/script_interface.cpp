#include "web/script_interface.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/chapters.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/measures.h"
#include "knotwork/scene/surface_builder.h"
#include "web/words.h"

namespace knotwork::web {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string answer(Json value) {
  Json json = Json::object();
  json["value"] = std::move(value);
  return text(json);
}

std::string refusal(const Error& error) {
  Json inner = Json::object();
  inner["message"] = error.message;
  inner["path"] = error.path;
  Json json = Json::object();
  json["error"] = std::move(inner);
  return text(json);
}

std::string answer(const Status& status) { return status ? answer(Json()) : refusal(status.error()); }

Json array(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }
Json array(glm::dvec3 v) { return Json::array({v.x, v.y, v.z}); }

Json value_json(const scene::ParameterValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

const char* kind_name(scene::ParameterKind kind) {
  switch (kind) {
    case scene::ParameterKind::number:
      return "number";
    case scene::ParameterKind::integer:
      return "integer";
    case scene::ParameterKind::choice:
      return "choice";
    case scene::ParameterKind::toggle:
      return "toggle";
  }
  return "";
}

Json direction(const scene::DirectionSummary& summary, const char* letter) {
  const bool closed = summary.topology == Topology::closed;
  Json json = Json::object();
  json["topology"] = closed ? "closed" : "open";
  json["domain"] = "[" + (letter + subscript(summary.first_knot)) + ", " + (letter + subscript(summary.last_knot)) +
                   (closed ? ")" : "]");
  json["start"] = summary.start;
  json["end"] = summary.end;
  json["knots"] = summary.knots;
  json["patches"] = summary.patches;
  json["locals"] = summary.locals;
  return json;
}

std::string_view shape_name(const scene::BlendingSurfaceObject& object) {
  const bool u = object.topology_u == Topology::closed, v = object.topology_v == Topology::closed;
  if (const scene::ModelKind kind = scene::model_kind(object.model); kind != scene::ModelKind::sheet)
    return scene::model_row(kind).id;
  return u && v ? "torus" : u || v ? "cylinder" : "plane";
}

/// The highest derivative that a curve gives.
int highest_order(const scene::Shape& shape) {
  const bool of_catalogue = std::holds_alternative<scene::ModelCurveObject>(shape) ||
                            std::holds_alternative<scene::BlendingCurveObject>(shape);
  return of_catalogue ? BlendingCurve::max_order : max_bezier_degree;
}

void evaluate_curve(const scene::Shape& shape, const scene::Animation& animation, double t,
                    std::span<Eigen::Vector3d> out) {
  if (const auto* model = std::get_if<scene::ModelCurveObject>(&shape)) return evaluate(model->model, t, out);
  if (const auto* blending = std::get_if<scene::BlendingCurveObject>(&shape))
    return scene::build_curve(*blending, animation).evaluate(t, out);
  scene::spline_of(shape).evaluate(t, out);
}

KNOTWORK_LATER std::string curve_at(const scene::Shape& shape, const scene::Animation& animation,
                                    std::span<const double> at, int order) {
  const int most = highest_order(shape);
  if (order < 0 || order > most)
    return refusal({"order", "The order of derivatives is from 0 to " + std::to_string(most) + "."});
  if (at.size() != 1 || !std::isfinite(at[0]))
    return refusal({"parameter", "A curve is evaluated at t, a finite number."});
  std::vector<Eigen::Vector3d> derivatives(static_cast<std::size_t>(order) + 1);
  evaluate_curve(shape, animation, at[0], derivatives);
  Json list = Json::array();
  for (const Eigen::Vector3d& derivative : derivatives) list.push_back(array(derivative));
  return answer(std::move(list));
}

}  // namespace

std::string answer_document(const App& app) { return R"({"value":)" + scene::write_document(app.document()) + "}"; }

std::string answer_load(App& app, std::string_view json) {
  Result<scene::Document> document = scene::parse_document(json);
  if (!document) return refusal(document.error());
  return answer(app.load(std::move(document).value()));
}

std::string answer_parameters(const App& app) {
  Json rows = Json::array();
  for (const scene::Parameter& parameter : scene::parameters()) {
    if (!scene::applies(app.document(), parameter)) continue;
    Json row = Json::object();
    row["id"] = parameter.id;
    row["label"] = parameter.label;
    row["group"] = parameter.group;
    row["kind"] = kind_name(parameter.kind);
    const bool numeric =
        parameter.kind == scene::ParameterKind::number || parameter.kind == scene::ParameterKind::integer;
    const scene::Limits range = scene::range_of(app.document(), parameter);
    row["min"] = numeric ? Json(range.min) : Json();
    row["max"] = numeric ? Json(range.max) : Json();
    const scene::Limits soft = scene::soft_range_of(app.document(), parameter);
    row["softMin"] = numeric ? Json(soft.min) : Json();
    row["softMax"] = numeric ? Json(soft.max) : Json();
    row["step"] = numeric ? Json(parameter.step) : Json();
    row["unit"] = parameter.unit;
    Json choices = Json::array();
    for (const scene::Choice& choice : parameter.choices) {
      Json entry = Json::object();
      entry["id"] = choice.id;
      entry["label"] = choice.label;
      entry["refused"] = scene::refused_choice(app.document(), parameter, choice.id);
      choices.push_back(std::move(entry));
    }
    row["choices"] = std::move(choices);
    row["value"] = value_json(parameter.get(app.document()));
    row["disabled"] = parameter.disabled ? parameter.disabled(app.document()) : std::string_view();
    rows.push_back(std::move(row));
  }
  return answer(std::move(rows));
}

std::string answer_set(App& app, std::string_view id, const scene::ParameterValue& value) {
  return answer(app.perform(scene::SetParameter{std::string(id), value}));
}

std::string answer_handles(App& app) {
  const scene::Shape& shape = scene::stage_shape(app.document());
  Json handles = Json::array();
  for (const Handle& handle : app.handles()) {
    Json json = Json::object();
    json["id"] = handle_id(shape, handle.index);
    json["object"] = app.document().objects.front().id;
    json["label"] = handle_name(shape, handle.index);
    json["position"] = array(handle.position);
    json["screen"] = handle.screen ? Json::array({handle.screen->x, handle.screen->y}) : Json();
    json["selected"] = app.selected() == handle.index;
    handles.push_back(std::move(json));
  }
  return answer(std::move(handles));
}

std::string answer_widgets(const App& app) {
  Json widgets = Json::array();
  for (const Widget& widget : app.widgets()) {
    Json json = Json::object();
    json["label"] = widget.label;
    json["rect"] = widget.rect;
    widgets.push_back(std::move(json));
  }
  return answer(std::move(widgets));
}

std::string answer_evaluate(const App& app, std::string_view object, std::span<const double> at, int order) {
  const std::vector<scene::Object>& objects = app.document().objects;
  const auto found =
      std::find_if(objects.begin(), objects.end(), [&](const scene::Object& o) { return o.id == object; });
  if (found == objects.end())
    return refusal({"object", "There is no object \"" + std::string(object) + "\" in the document."});
  const bool curve = !std::holds_alternative<scene::BlendingSurfaceObject>(found->shape) &&
                     !std::holds_alternative<scene::BSplineSurfaceObject>(found->shape) &&
                     !std::holds_alternative<scene::ModelSurfaceObject>(found->shape);
  if (curve) return curve_at(found->shape, app.document().animation, at, order);
  if (order < 0 || order > 2) return refusal({"order", "The order of derivatives is 0, 1 or 2."});
  if (at.size() != 2 || !std::isfinite(at[0]) || !std::isfinite(at[1]))
    return refusal({"parameter", "A surface is evaluated at [u, v], two finite numbers."});
  const Figure figure = make_figure(found->shape, app.document().animation);
  const SurfaceJet jet = surface_of(figure)->evaluate(at[0], at[1]);
  Json json = Json::object();
  json["S"] = array(jet.s);
  if (order >= 1) {
    json["Su"] = array(jet.su);
    json["Sv"] = array(jet.sv);
  }
  if (order >= 2) {
    json["Suu"] = array(jet.suu);
    json["Suv"] = array(jet.suv);
    json["Svv"] = array(jet.svv);
  }
  return answer(std::move(json));
}

std::string answer_play(App& app, bool playing) {
  return answer(app.perform(scene::SetParameter{"animation.playing", playing}));
}

std::string answer_seek(App& app, double seconds) {
  if (!std::isfinite(seconds)) return refusal({"seconds", "The clock is set to a finite number of seconds."});
  // fmod is exact: a product with the number of periods would leave the period for large clocks.
  const double rest = std::fmod(seconds, scene::clock_period);
  const double positive = rest < 0 ? rest + scene::clock_period : rest;
  // A tiny negative time rounds up to the whole period, which is its start.
  const double wrapped = positive < scene::clock_period ? positive : 0;
  return answer(app.perform(scene::SetParameter{"animation.time", wrapped}));
}

std::string answer_undo(App& app) { return answer(Json(app.undo())); }
std::string answer_redo(App& app) { return answer(Json(app.redo())); }

std::string answer_stats(const App& app) {
  Json json = Json::object();
  json["frames"] = app.stats().frames;
  const RendererStats drawn = app.renderer_stats();
  json["drawCalls"] = drawn.draw_calls + app.stats().interface_draw_calls;
  json["stateChanges"] = drawn.state_changes;
  json["vertices"] = drawn.vertices;
  json["uploadBytes"] = drawn.upload_bytes;
  json["evaluateMs"] = app.stats().evaluate_ms;
  json["frameMs"] = app.stats().frame_ms;
  json["allocations"] = app.stats().allocations;
  return answer(std::move(json));
}

std::string answer_chapters() {
  Json chapters = Json::array();
  for (const scene::Chapter& chapter : scene::chapters()) {
    Json json = Json::object();
    json["id"] = chapter.id;
    json["title"] = chapter.title;
    Json parameters = Json::array();
    for (const std::string_view id : chapter.parameters) parameters.push_back(id);
    json["parameters"] = std::move(parameters);
    chapters.push_back(std::move(json));
  }
  return answer(std::move(chapters));
}

std::string answer_open(App& app, std::string_view chapter) { return answer(app.open_chapter(chapter)); }

std::string answer_measure(const App& app, std::string_view name) {
  const std::optional<double> value = scene::measure(app.document(), app.start(), name);
  return answer(value ? Json(*value) : Json());
}

std::string answer_points(App& app, std::string_view text) { return answer(app.take_points(text)); }

std::string answer_select(App& app, std::string_view handle) {
  if (handle.empty()) {
    app.select(std::nullopt);
    return answer(Json());
  }
  const std::optional<HandleIndex> found = find_handle(scene::stage_shape(app.document()), handle);
  if (!found) return refusal({"handle", "There is no handle \"" + std::string(handle) + "\"."});
  app.select(found);
  return answer(Json());
}

std::string answer_state(const App& app) {
  const scene::Shape& shape = scene::stage_shape(app.document());
  Json json = Json::object();
  json["canUndo"] = app.history().can_undo();
  json["canRedo"] = app.history().can_redo();
  json["undoLabel"] = app.history().undo_label();
  json["redoLabel"] = app.history().redo_label();
  json["notice"] = app.notice();
  json["selected"] = app.selected() ? handle_id(shape, *app.selected()) : std::string();
  json["selectedName"] = app.selected() ? handle_name(shape, *app.selected()) : std::string();
  json["points"] = scene::is_made_from_list(shape) ? Json(scene::curve_points(shape).size()) : Json();
  json["surface"] = Json();
  if (app.shows_surface()) {
    const BlendingSurface surface = app.surface_at_rest();
    json["surface"] = {{"shape", shape_name(scene::blending_surface(app.document()))},
                       {"u", direction(scene::summary_u(surface), "u")},
                       {"v", direction(scene::summary_v(surface), "v")}};
  }
  return answer(std::move(json));
}

}  // namespace knotwork::web
