#include "knotwork/scene/commands.h"

#include <cmath>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/messages.h"
#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene {

namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

Error no_patches() { return {"patch", "What is on the stage has no local patches."}; }

Status perform(Document& document, const SetParameter& command) {
  const Parameter* parameter = find_parameter(command.id);
  if (parameter == nullptr) return Error{command.id, "There is no parameter of this name."};
  if (!applies(document, *parameter)) return Error{command.id, "What is on the stage has no such parameter."};
  const Status status = parameter->set(document, command.value);
  return status ? success() : Status(Error{command.id, status.error().message});
}

Status perform(Document& document, const SetPatchEdit& command) {
  auto* surface = std::get_if<BlendingSurfaceObject>(&stage_shape(document));
  if (surface == nullptr) return no_patches();
  BlendingSurfaceObject& object = *surface;
  const auto [i, j] = command.patch;
  if (i < 0 || i >= object.locals_u || j < 0 || j >= object.locals_v) {
    return Error{"patch", "There is no patch " + std::to_string(i) + ", " + std::to_string(j) + "."};
  }
  if (Status status = check(command.edit); !status) return status;
  if (command.edit.is_identity()) {
    object.edits.erase(command.patch);
  } else {
    object.edits[command.patch] = command.edit;
  }
  return success();
}

Status perform(Document& document, const ResetPatches&) {
  auto* surface = std::get_if<BlendingSurfaceObject>(&stage_shape(document));
  if (surface == nullptr) return no_patches();
  surface->edits.clear();
  return success();
}

Error no_locals() { return {"local", "What is on the stage has no local curves."}; }

KNOTWORK_LATER Status perform(Document& document, const SetLocalEdit& command) {
  auto* curve = std::get_if<BlendingCurveObject>(&stage_shape(document));
  return curve == nullptr ? Status(no_locals()) : set_local_edit(*curve, command.local, command.edit);
}

KNOTWORK_LATER Status perform(Document& document, const ResetLocals&) {
  auto* curve = std::get_if<BlendingCurveObject>(&stage_shape(document));
  if (curve == nullptr) return no_locals();
  curve->edits.clear();
  return success();
}

KNOTWORK_LATER Status perform(Document& document, const SetPoint& command) {
  return set_point(stage_shape(document), command.index, command.position);
}

KNOTWORK_LATER Status perform(Document& document, const SetPoints& command) {
  return set_points(stage_shape(document), command.points);
}

KNOTWORK_LATER Status perform(Document& document, const InsertPoint& command) {
  return insert_point(stage_shape(document), command.index, command.position);
}

KNOTWORK_LATER Status perform(Document& document, const RemovePoint& command) {
  return remove_point(stage_shape(document), command.index);
}

KNOTWORK_LATER Status perform(Document& document, const SetKnot& command) {
  if (auto* blending = std::get_if<BlendingCurveObject>(&stage_shape(document)))
    return set_knot(*blending, command.index, command.value);
  auto* curve = std::get_if<BSplineCurveObject>(&stage_shape(document));
  if (curve == nullptr) return Error{"index", "What is on the stage has no knots to be moved."};
  return set_knot(*curve, command.index, command.value);
}

/// What `edit` does to the net on the stage.
template <class Edit>
Status on_net(Document& document, const char* path, const Edit& edit) {
  auto* object = std::get_if<BSplineSurfaceObject>(&stage_shape(document));
  return object != nullptr ? edit(*object) : Status(Error{path, "What is on the stage has no net of control points."});
}

KNOTWORK_LATER Status perform(Document& document, const SetNetPoint& command) {
  return on_net(document, "point",
                [&](auto& object) { return set_net_point(object, command.point, command.position); });
}

KNOTWORK_LATER Status perform(Document& document, const InsertNetLine& command) {
  return on_net(document, "at", [&](auto& object) { return insert_net_line(object, command.direction, command.at); });
}

KNOTWORK_LATER Status perform(Document& document, const RemoveNetLine& command) {
  return on_net(document, "index",
                [&](auto& object) { return remove_net_line(object, command.direction, command.index); });
}

KNOTWORK_LATER Status perform(Document& document, const SetNetKnot& command) {
  return on_net(document, "index",
                [&](auto& object) { return set_net_knot(object, command.direction, command.index, command.value); });
}

Status perform(Document& document, const SetCamera& command) {
  if (const Status status = check(command.camera); !status) {
    return Error{"camera." + status.error().path, status.error().message};
  }
  document.camera = command.camera;
  return success();
}

Status perform(Document& document, const LoadDocument& command) {
  if (Status status = check(command.document); !status) return status;
  document = command.document;
  return success();
}

Status perform(Document& document, const AdvanceClock& command) {
  if (!limits::elapsed.contains(command.seconds)) return Error{"seconds", number_message(limits::elapsed)};
  Animation& animation = document.animation;
  if (auto* curve = std::get_if<SubdivisionCurveObject>(&stage_shape(document))) {
    if (animation.playing) animation.playing = walk(*curve, command.seconds * animation.speed);
    return success();
  }
  if (animation.playing) animation.time = std::fmod(animation.time + command.seconds * animation.speed, clock_period);
  return success();
}

std::string describe_value(const Parameter& parameter, const ParameterValue& value) {
  return std::visit(
      Overloaded{[](double x) { return number_text(x); }, [](bool on) { return std::string(on ? "on" : "off"); },
                 [&](const std::string& id) {
                   for (const Choice& choice : parameter.choices) {
                     if (choice.id == id) return choice.label;
                   }
                   return id;
                 }},
      value);
}

std::string describe(const SetParameter& command) {
  const Parameter* parameter = find_parameter(command.id);
  if (parameter == nullptr) return "Set " + command.id;
  const std::string label(parameter->label), value = describe_value(*parameter, command.value);
  if (parameter->group == "Topology") {
    if (parameter->id == "curve.topology") return value == "closed" ? "Close the curve" : "Open the curve";
    if (parameter->id == "model") return "Change the model to " + value;
    return (value == "closed" ? "Close " : "Open ") + label;
  }
  if (const bool* on = std::get_if<bool>(&command.value)) return (*on ? "Show " : "Hide ") + label;
  return "Set " + label + " to " + value;
}

std::string describe(const SetPatchEdit& command) {
  const std::string patch =
      "patch " + std::to_string(command.patch.first) + ", " + std::to_string(command.patch.second);
  return (command.edit.is_identity() ? "Reset " : "Move ") + patch;
}

std::string describe(const ResetPatches&) { return "Reset all patches"; }

KNOTWORK_LATER std::string describe(const SetLocalEdit& command) {
  return (command.edit.is_identity() ? "Reset local curve " : "Move local curve ") + std::to_string(command.local);
}

KNOTWORK_LATER std::string describe(const ResetLocals&) { return "Reset all local curves"; }
KNOTWORK_LATER std::string describe(const SetPoint& command) { return "Move point " + std::to_string(command.index); }
KNOTWORK_LATER std::string describe(const SetPoints&) { return "Replace the points"; }
KNOTWORK_LATER std::string describe(const InsertPoint& command) { return "Add point " + std::to_string(command.index); }
KNOTWORK_LATER std::string describe(const RemovePoint& command) {
  return "Delete point " + std::to_string(command.index);
}
KNOTWORK_LATER std::string describe(const SetKnot& command) { return "Move knot " + std::to_string(command.index); }
std::string line_name(NetDirection direction) { return direction == NetDirection::u ? "row" : "column"; }
KNOTWORK_LATER std::string describe(const SetNetPoint& command) {
  return "Move point " + std::to_string(command.point.first) + ", " + std::to_string(command.point.second);
}
KNOTWORK_LATER std::string describe(const InsertNetLine& command) { return "Add a " + line_name(command.direction); }
KNOTWORK_LATER std::string describe(const RemoveNetLine& command) {
  return "Delete " + line_name(command.direction) + " " + std::to_string(command.index);
}
KNOTWORK_LATER std::string describe(const SetNetKnot& command) {
  return "Move knot " + std::to_string(command.index) + " of " + (command.direction == NetDirection::u ? "u" : "v");
}
std::string describe(const SetCamera&) { return "Move the camera"; }
std::string describe(const LoadDocument&) { return "Load a document"; }
std::string describe(const AdvanceClock&) { return "Advance the clock"; }

}  // namespace

Status apply(Document& document, const Command& command) {
  return std::visit([&](const auto& alternative) { return perform(document, alternative); }, command);
}

bool in_history(const Command& command) {
  if (const SetParameter* set = std::get_if<SetParameter>(&command)) {
    const Parameter* parameter = find_parameter(set->id);
    return parameter != nullptr && parameter->in_history;
  }
  return !std::holds_alternative<SetCamera>(command) && !std::holds_alternative<AdvanceClock>(command);
}

std::string describe(const Command& command) {
  return std::visit([](const auto& alternative) { return describe(alternative); }, command);
}

std::string notice(const Document& document, const Command& command) {
  const SetParameter* set = std::get_if<SetParameter>(&command);
  const Parameter* parameter = set == nullptr ? nullptr : find_parameter(set->id);
  return parameter == nullptr ? std::string() : side_effect(document, *parameter, set->value);
}

}  // namespace knotwork::scene
