#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include "knotwork/scene/document.h"
#include "knotwork/scene/document_json.h"

/// What a document's JSON form consists of, said once. Each `members` function names the members of one JSON object
/// with their limits; an Io visits them: one reads JSON, one writes it, one checks limits, and a test's compares them
/// with the JSON Schema. An Io has
///
///   reads                             a constant: whether it assigns
///   constant(name, text or integer)   a member with one possible value
///   text(name, string, limits, slug)  limits of the length; slug: [a-z][a-z0-9-]*
///   number, integer(name, x, limits)  toggle(name, x)   choice(name, enumerator)
///   vector(name, v, limits)           quaternion(name, q, limits)
///   group(name, f)                    an object whose members f visits
///   list(name, vector, limits)        limits of the count
///   patches(name, map, limits)
///   points(name, vector of Vector3d, limits of the count)   numbers(name, vector of double, limits of the count)
namespace knotwork::scene {

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

/// An enumeration's ids in documents, by its enumerators' values.
struct ChoiceIds {
  int count;
  std::string_view (*id)(int);
};
ChoiceIds ids_of(Topology);
ChoiceIds ids_of(ShapeKind);
ChoiceIds ids_of(ModelKind);
ChoiceIds ids_of(BlendingKind);
ChoiceIds ids_of(MotionKind);

/// The index of an id, -1 when there is no such one.
int find_choice(const ChoiceIds& ids, std::string_view id);
/// "Must be open or closed."
std::string choice_message(const ChoiceIds& ids);

template <class E>
std::string_view id_of(E enumerator) {
  return ids_of(enumerator).id(static_cast<int>(enumerator));
}

/// A patch in the list `patches`: the map's key and value side by side.
template <class Io>
void members(Io& io, Is<int> auto& i, Is<int> auto& j, Is<PatchEdit> auto& edit) {
  io.integer("i", i, limits::local_index);
  io.integer("j", j, limits::local_index);
  members(io, edit);
}

template <class Io>
void members(Io& io, Is<PatchEdit> auto& edit) {
  io.vector("translation", edit.translation, limits::coordinate);
  io.quaternion("rotation", edit.rotation, limits::quaternion);
  io.vector("scale", edit.scale, limits::scale);
}

template <class Io>
void members(Io& io, Is<Sheet> auto& sheet) {
  io.number("flatRadiusU", sheet.flat_radius_u, limits::length);
  io.number("closedRadiusU", sheet.closed_radius_u, limits::length);
  io.number("flatRadiusV", sheet.flat_radius_v, limits::length);
  io.number("closedRadiusV", sheet.closed_radius_v, limits::length);
}

template <class Io>
void members(Io& io, Is<Plane> auto& plane) {
  io.vector("origin", plane.origin, limits::coordinate);
  io.vector("uAxis", plane.u_axis, limits::coordinate);
  io.vector("vAxis", plane.v_axis, limits::coordinate);
}

template <class Io>
void members(Io& io, Is<Cylinder> auto& cylinder) {
  io.number("radiusX", cylinder.radius_x, limits::length);
  io.number("radiusY", cylinder.radius_y, limits::length);
  io.number("height", cylinder.height, limits::length);
}

template <class Io>
void members(Io& io, Is<Torus> auto& torus) {
  io.number("wheelRadius", torus.wheel_radius, limits::length);
  io.number("tubeRadius", torus.tube_radius, limits::length);
  io.number("tubeHeight", torus.tube_height, limits::length);
}

/// The kind first: it decides which members follow.
template <class Io>
void members(Io& io, Is<ModelSurface> auto& model) {
  ModelKind kind = model_kind(model);
  io.choice("kind", kind);
  if constexpr (Io::reads) {
    if (kind != model_kind(model)) model = make_model(kind);
  }
  std::visit([&io](auto& shape) { members(io, shape); }, model);
}

template <class Io>
void members(Io& io, Is<BlendingSurfaceObject> auto& object) {
  io.group("model", [&] { members(io, object.model); });
  io.group("topology", [&] {
    io.choice("u", object.topology_u);
    io.choice("v", object.topology_v);
  });
  io.group("locals", [&] {
    io.integer("u", object.locals_u, limits::locals);
    io.integer("v", object.locals_v, limits::locals);
  });
  io.group("blending", [&] {
    io.choice("function", object.blending);
    io.integer("parameter", object.blending_parameter, limits::blending_parameter);
  });
  io.group("samples", [&] {
    io.integer("u", object.samples_u, limits::samples);
    io.integer("v", object.samples_v, limits::samples);
  });
  io.patches("patches", object.edits, limits::patches);
}

template <class Io>
void members(Io& io, Is<BezierCurveObject> auto& object) {
  io.points("points", object.points, limits::bezier_points);
  io.number("parameter", object.parameter, limits::share);
}

template <class Io>
void members(Io& io, Is<BSplineCurveObject> auto& object) {
  io.integer("degree", object.degree, limits::degree);
  io.choice("topology", object.topology);
  io.numbers("knots", object.knots, limits::knots);
  io.points("points", object.points, limits::points);
  io.number("parameter", object.parameter, limits::share);
}

/// The kind before the shape, as with models.
template <class Io>
void members(Io& io, Is<Object> auto& object) {
  io.text("id", object.id, limits::id_length, true);
  io.text("label", object.label, limits::label_length, false);
  ShapeKind kind = object.kind();
  io.choice("kind", kind);
  if constexpr (Io::reads) {
    if (kind != object.kind()) object.shape = make_shape(kind);
  }
  std::visit([&io](auto& shape) { members(io, shape); }, object.shape);
}

template <class Io>
void members(Io& io, Is<Camera> auto& camera) {
  io.vector("target", camera.target, limits::coordinate);
  io.number("distance", camera.distance, limits::length);
  io.number("azimuth", camera.azimuth, limits::azimuth);
  io.number("elevation", camera.elevation, limits::elevation);
}

template <class Io>
void members(Io& io, Is<Display> auto& display) {
  io.toggle("surface", display.surface);
  io.toggle("colours", display.patch_colours);
  io.toggle("knots", display.knot_lines);
  io.toggle("wireframe", display.wireframe);
  io.toggle("locals", display.local_patches);
  io.toggle("frames", display.frames);
  io.toggle("normals", display.normals);
  io.toggle("handles", display.handles);
  io.toggle("polygon", display.polygon);
  io.toggle("construction", display.construction);
}

template <class Io>
void members(Io& io, Is<Animation> auto& animation) {
  io.toggle("playing", animation.playing);
  io.number("time", animation.time, limits::time);
  io.number("speed", animation.speed, limits::speed);
  io.choice("motion", animation.motion);
  io.number("amplitude", animation.amplitude, limits::amplitude);
  io.number("translation", animation.translation, limits::share);
  io.number("rotation", animation.rotation, limits::share);
}

template <class Io>
void members(Io& io, Is<Document> auto& document) {
  io.constant("format", "knotwork");
  io.constant("version", document_version);
  io.list("objects", document.objects, limits::objects);
  io.group("camera", [&] { members(io, document.camera); });
  io.group("display", [&] { members(io, document.display); });
  io.group("animation", [&] { members(io, document.animation); });
}

}  // namespace knotwork::scene
