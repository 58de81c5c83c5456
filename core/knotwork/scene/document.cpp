#include "knotwork/scene/document.h"

#include <array>
#include <cmath>

#include "knotwork/scene/document_members.h"

namespace knotwork::scene {

namespace {

constexpr std::array<ShapeRow, std::variant_size_v<Shape>> shape_table{{
    {"blendingSurface", "Blending surface"},
    {"bezierCurve", "Bézier curve"},
    {"bsplineCurve", "B-spline curve"},
    {"fittedCurve", "Fitted curve"},
    {"subdivisionCurve", "Subdivision curve"},
    {"modelCurve", "Model curve"},
    {"blendingCurve", "Blending curve"},
    {"bsplineSurface", "B-spline surface"},
    {"modelSurface", "Model surface"},
}};

constexpr std::array<std::string_view, 3> data_parameter_ids{"uniform", "centripetal", "chordLength"};

}  // namespace

namespace {

template <class M, class D>
M* model_in(D& document) {
  auto& shape = stage_shape(document);
  if (auto* blending = std::get_if<BlendingSurfaceObject>(&shape)) return &blending->model;
  auto* alone = std::get_if<ModelSurfaceObject>(&shape);
  return alone != nullptr ? &alone->model : nullptr;
}

}  // namespace

const ModelSurface* stage_model(const Document& document) { return model_in<const ModelSurface>(document); }
ModelSurface* stage_model(Document& document) { return model_in<ModelSurface>(document); }

bool PatchEdit::is_identity() const { return *this == PatchEdit{}; }

bool PatchEdit::operator==(const PatchEdit& other) const {
  return translation == other.translation && rotation.coeffs() == other.rotation.coeffs() && scale == other.scale;
}

bool twists(const ModelSurface& model) {
  const SurfaceDomain where = domain(model);
  return where.closure_u == Closure::twisted || where.closure_v == Closure::twisted;
}

SeamProblem seam_problem(const BlendingSurfaceObject& object) {
  return twists(object.model) ? twisted_seam_problem(object) : SeamProblem();
}

SeamProblem twisted_seam_problem(const BlendingSurfaceObject& object) {
  const SurfaceDomain where = domain(object.model);
  // Whether evenly spaced patches fall onto each other when the direction is reflected.
  const auto falls_onto_itself = [](const Interval& range, Closure closure, double reflection, Topology topology,
                                    int locals) {
    const double period = range.end - range.start;
    const double step = topology == Topology::closed ? period / locals : period;
    double gap = reflection - range.start - (topology == Topology::closed ? range.start : range.end);
    if (closure == Closure::closed) gap = std::remainder(gap, step);
    return std::abs(gap) <= 1e-9 * period;
  };
  const auto problem = [&](const char* turn, const char* other, Topology topology) -> SeamProblem {
    const bool closed = topology == Topology::closed;
    return {std::string(closed ? "locals." : "topology.") + other,
            "Going round the " + std::string(model_name(object.model)) + " in " + turn + " reflects the patches in " +
                other + ": " + (closed ? "their number must be even." : "that direction must be closed too.")};
  };
  if (object.topology_u == Topology::closed && where.closure_u == Closure::twisted &&
      !falls_onto_itself(where.v, where.closure_v, where.reflection_u, object.topology_v, object.locals_v)) {
    return problem("u", "v", object.topology_v);
  }
  if (object.topology_v == Topology::closed && where.closure_v == Closure::twisted &&
      !falls_onto_itself(where.u, where.closure_u, where.reflection_v, object.topology_u, object.locals_u)) {
    return problem("v", "u", object.topology_u);
  }
  return {};
}

ChoiceIds ids_of(LocalSurfaceKind) {
  return {2, [](int i) { return i == 0 ? std::string_view("sub-surface") : std::string_view("bezier-hermite"); }};
}

std::span<const ShapeRow> shape_kinds() { return shape_table; }

Shape make_shape(ShapeKind kind) {
  Shape shape;
  switch (kind) {
    case ShapeKind::bezier_curve:
      shape.emplace<BezierCurveObject>();
      break;
    case ShapeKind::bspline_curve:
      shape.emplace<BSplineCurveObject>();
      break;
    case ShapeKind::fitted_curve:
      shape.emplace<FittedCurveObject>();
      break;
    case ShapeKind::subdivision_curve:
      shape.emplace<SubdivisionCurveObject>();
      break;
    case ShapeKind::model_curve:
      shape.emplace<ModelCurveObject>();
      break;
    case ShapeKind::blending_curve:
      shape.emplace<BlendingCurveObject>();
      break;
    case ShapeKind::bspline_surface:
      shape.emplace<BSplineSurfaceObject>();
      break;
    case ShapeKind::model_surface:
      shape.emplace<ModelSurfaceObject>();
      break;
    case ShapeKind::blending_surface:
      break;
  }
  return shape;
}

ChoiceIds ids_of(Topology) {
  return {2, [](int i) { return i == 0 ? std::string_view("open") : std::string_view("closed"); }};
}

ChoiceIds ids_of(MotionKind) {
  return {2, [](int i) { return i == 0 ? std::string_view("breathe") : std::string_view("report"); }};
}

ChoiceIds ids_of(Shading) {
  return {5, [](int i) {
            constexpr std::array<std::string_view, 5> ids{"lit", "zebra", "isophotes", "gaussian", "mean"};
            return ids[static_cast<std::size_t>(i)];
          }};
}

ChoiceIds ids_of(DataParameters) {
  return {static_cast<int>(data_parameter_ids.size()),
          [](int i) { return data_parameter_ids[static_cast<std::size_t>(i)]; }};
}

ChoiceIds ids_of(KnotPlacement) {
  return {2, [](int i) { return i == 0 ? std::string_view("even") : std::string_view("averaged"); }};
}

ChoiceIds ids_of(FitEnds) {
  return {2, [](int i) { return i == 0 ? std::string_view("free") : std::string_view("interpolated"); }};
}

ChoiceIds ids_of(ModelKind) {
  return {static_cast<int>(model_kinds().size()), [](int i) { return model_kinds()[static_cast<std::size_t>(i)].id; }};
}

ChoiceIds ids_of(ShapeKind) {
  return {static_cast<int>(shape_table.size()), [](int i) { return shape_table[static_cast<std::size_t>(i)].id; }};
}

ChoiceIds ids_of(BlendingKind) {
  return {static_cast<int>(blending_families().size()),
          [](int i) { return blending_families()[static_cast<std::size_t>(i)].id; }};
}

int find_choice(const ChoiceIds& ids, std::string_view id) {
  for (int i = 0; i < ids.count; ++i) {
    if (ids.id(i) == id) return i;
  }
  return -1;
}

std::string choice_message(const ChoiceIds& ids) {
  std::string message = "Must be ";
  for (int i = 0; i < ids.count; ++i) {
    if (i > 0) message += i + 1 == ids.count ? " or " : ", ";
    message += ids.id(i);
  }
  return message + '.';
}

}  // namespace knotwork::scene
