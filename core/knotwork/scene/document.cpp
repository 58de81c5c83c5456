#include "knotwork/scene/document.h"

#include <array>

#include "knotwork/scene/document_members.h"

namespace knotwork::scene {

namespace {

constexpr std::array<ModelRow, 4> model_table{{
    {ModelKind::sheet, "sheet", "Rolling sheet"},
    {ModelKind::plane, "plane", "Plane"},
    {ModelKind::cylinder, "cylinder", "Cylinder"},
    {ModelKind::torus, "torus", "Torus"},
}};

constexpr std::array<ShapeRow, std::variant_size_v<Shape>> shape_table{{
    {"blendingSurface", "Blending surface"},
    {"bezierCurve", "Bézier curve"},
    {"bsplineCurve", "B-spline curve"},
}};

}  // namespace

bool PatchEdit::is_identity() const { return *this == PatchEdit{}; }

bool PatchEdit::operator==(const PatchEdit& other) const {
  return translation == other.translation && rotation.coeffs() == other.rotation.coeffs() && scale == other.scale;
}

std::span<const ModelRow> model_kinds() { return model_table; }

const ModelRow& model_row(ModelKind kind) { return model_table[static_cast<std::size_t>(kind)]; }

ModelKind model_kind(const ModelSurface& model) {
  if (std::holds_alternative<Plane>(model)) return ModelKind::plane;
  if (std::holds_alternative<Cylinder>(model)) return ModelKind::cylinder;
  if (std::holds_alternative<Torus>(model)) return ModelKind::torus;
  return ModelKind::sheet;
}

ModelSurface make_model(ModelKind kind) {
  switch (kind) {
    case ModelKind::plane:
      return Plane{};
    case ModelKind::cylinder:
      return Cylinder{};
    case ModelKind::torus:
      return Torus{};
    case ModelKind::sheet:
      break;
  }
  return Sheet{};
}

bool closes_u(const ModelSurface& model) {
  return model_kind(model) == ModelKind::sheet || domain(model).closure_u == Topology::closed;
}

bool closes_v(const ModelSurface& model) {
  return model_kind(model) == ModelKind::sheet || domain(model).closure_v == Topology::closed;
}

std::span<const ShapeRow> shape_kinds() { return shape_table; }

Shape make_shape(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::bezier_curve:
      return BezierCurveObject{};
    case ShapeKind::bspline_curve:
      return BSplineCurveObject{};
    case ShapeKind::blending_surface:
      break;
  }
  return BlendingSurfaceObject{};
}

ChoiceIds ids_of(Topology) {
  return {2, [](int i) { return i == 0 ? std::string_view("open") : std::string_view("closed"); }};
}

ChoiceIds ids_of(MotionKind) {
  return {2, [](int i) { return i == 0 ? std::string_view("breathe") : std::string_view("report"); }};
}

ChoiceIds ids_of(ModelKind) {
  return {static_cast<int>(model_table.size()), [](int i) { return model_table[static_cast<std::size_t>(i)].id; }};
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
