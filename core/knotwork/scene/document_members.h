#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include "knotwork/scene/document.h"
#include "knotwork/scene/document_json.h"
#include "knotwork/scene/later.h"

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
///   later_toggle, later_choice, later_points   of a member that older documents do not have
///   points(name, vector of Vector3d, limits of the count)   numbers(name, vector of double, limits of the count)
///   net(name, Net, limits of the count of rows and of the points in each)
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
ChoiceIds ids_of(LocalSurfaceKind);
ChoiceIds ids_of(MotionKind);
ChoiceIds ids_of(Shading);
ChoiceIds ids_of(DataParameters);
ChoiceIds ids_of(KnotPlacement);
ChoiceIds ids_of(FitEnds);
ChoiceIds ids_of(LocalCurveKind);
/// A row of the catalogue of curves, as an enumerator.
enum class CurveRow : unsigned char {};
ChoiceIds ids_of(CurveRow);

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

/// The kind first: it decides which measures follow.
template <class Io>
void members(Io& io, Is<ModelSurface> auto& model) {
  ModelKind kind = model_kind(model);
  io.choice("kind", kind);
  if constexpr (Io::reads) {
    if (kind != model_kind(model)) model = make_model(kind);
  }
  const std::span<const CatalogueMeasure> measures = model_measures(kind);
  for (std::size_t k = 0; k < measures.size(); ++k) {
    decltype(auto) value = model_measure(model, k);
    io.number(measures[k].id, value, Limits{measures[k].least, measures[k].greatest});
  }
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
    io.choice("kind", object.patches.kind);
    io.integer("degreeU", object.patches.degree_u, limits::patch_degree);
    io.integer("degreeV", object.patches.degree_v, limits::patch_degree);
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

template <class Io>
void members(Io& io, Is<FittedCurveObject> auto& object) {
  io.points("points", object.points, limits::data_points);
  io.integer("degree", object.degree, limits::degree);
  io.choice("topology", object.topology);
  io.integer("count", object.count, limits::points);
  io.choice("parameters", object.parameters);
  io.choice("knots", object.knots);
  io.choice("ends", object.ends);
  io.number("smoothing", object.smoothing, limits::smoothing);
}

template <class Io>
void members(Io& io, Is<SubdivisionCurveObject> auto& object) {
  io.points("points", object.points, limits::points);
  io.integer("degree", object.degree, limits::degree);
  io.choice("topology", object.topology);
  io.integer("levels", object.levels, limits::levels);
  io.integer("step", object.step, limits::steps);
  io.number("fraction", object.fraction, limits::share);
  io.toggle("limit", object.limit);
}

/// The row first: it decides which measures follow.
template <class Io>
void members(Io& io, Is<CatalogueCurve> auto& curve) {
  auto row = static_cast<CurveRow>(curve.row);
  io.choice("kind", row);
  if constexpr (Io::reads) {
    if (static_cast<int>(row) != curve.row) curve = standard_curve(static_cast<int>(row));
  }
  std::size_t k = 0;
  for (const CatalogueMeasure& measure : curve_catalogue()[static_cast<std::size_t>(curve.row)].measures)
    io.number(measure.id, curve.measures[k++], Limits{measure.least, measure.greatest});
}

template <class Io>
void members(Io& io, Is<ModelCurveObject> auto& object) {
  io.group("model", [&] { members(io, object.model); });
  io.number("parameter", object.parameter, limits::share);
}

template <class Io>
void members(Io& io, Is<BlendingCurveObject> auto& object) {
  io.group("model", [&] { members(io, object.model); });
  io.choice("topology", object.topology);
  io.group("locals", [&] {
    io.integer("count", object.locals, limits::curve_locals);
    io.choice("kind", object.local_kind);
    io.integer("degree", object.local_degree, limits::local_degree);
  });
  io.group("blending", [&] {
    io.choice("function", object.blending);
    io.integer("parameter", object.blending_parameter, limits::blending_parameter);
  });
  io.numbers("knots", object.knots, limits::inner_knots);
  io.patches("edits", object.edits, limits::patches);
  io.number("parameter", object.parameter, limits::share);
}

template <class Io>
void members(Io& io, Is<BSplineSurfaceObject> auto& object) {
  io.group("degree", [&] {
    io.integer("u", object.u.degree, limits::degree);
    io.integer("v", object.v.degree, limits::degree);
  });
  io.group("topology", [&] {
    io.choice("u", object.u.topology);
    io.choice("v", object.v.topology);
  });
  io.group("knots", [&] {
    io.numbers("u", object.u.knots, limits::net_knots);
    io.numbers("v", object.v.knots, limits::net_knots);
  });
  io.net("net", object.net, limits::net);
  io.group("samples", [&] {
    io.integer("u", object.samples_u, limits::samples);
    io.integer("v", object.samples_v, limits::samples);
  });
  io.group("sheet", [&] {
    io.number("flatRadiusU", object.sheet.flat_radius_u, limits::length);
    io.number("closedRadiusU", object.sheet.closed_radius_u, limits::length);
    io.number("flatRadiusV", object.sheet.flat_radius_v, limits::length);
    io.number("closedRadiusV", object.sheet.closed_radius_v, limits::length);
  });
}

template <class Io>
void members(Io& io, Is<ModelSurfaceObject> auto& object) {
  io.group("model", [&] { members(io, object.model); });
  io.group("samples", [&] {
    io.integer("u", object.samples_u, limits::samples);
    io.integer("v", object.samples_v, limits::samples);
  });
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
  visit_first([&io](auto& shape) { members(io, shape); }, object.shape);
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
  io.later_toggle("comb", display.comb);
  io.later_toggle("osculating", display.osculating);
  io.later_toggle("hodograph", display.hodograph);
  io.later_toggle("continuity", display.continuity);
  io.later_choice("shading", display.shading);
  io.later_toggle("adaptive", display.adaptive);
  io.later_points("rings", display.rings, limits::rings);
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
