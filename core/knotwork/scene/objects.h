#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/model_surface.h"

namespace knotwork::scene {

/// A reader's edit of one local patch, in the patch's own frame: x along S_u of the model at the patch's centre,
/// z along the normal. M_ij = Translation(centre + F translation) F rotation scale F^-1, so that an edit keeps its
/// meaning ("outwards", "about the normal") while the model bends.
struct PatchEdit {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< model units
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< unit to 1e-6
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();               ///< each in [0.01, 100]

  bool is_identity() const;
  bool operator==(const PatchEdit& other) const;
};

/// Which local patch: (i, j) with 0 <= i < n_u, 0 <= j < n_v.
using PatchIndex = std::pair<int, int>;

/// What carries a blending surface: `sheet` is the default that follows the topology (plane, cylinder, torus); the
/// others are fixed shapes.
enum class ModelKind : unsigned char { sheet, plane, cylinder, torus };

/// One row of the table of models that parameters and documents iterate.
struct ModelRow {
  ModelKind kind;
  std::string_view id;     ///< in documents, as `sheet`
  std::string_view label;  ///< for readers
};
std::span<const ModelRow> model_kinds();
const ModelRow& model_row(ModelKind kind);
ModelKind model_kind(const ModelSurface& model);
/// The model of this kind with its standard measures.
ModelSurface make_model(ModelKind kind);
/// Whether the model can be closed in the direction: a sheet always, as it rolls; the others where they are periodic.
bool closes_u(const ModelSurface& model);
bool closes_v(const ModelSurface& model);

struct BlendingSurfaceObject {
  ModelSurface model = Sheet{};  ///< the bends of a Sheet are ignored: they follow the topology
  Topology topology_u = Topology::closed, topology_v = Topology::closed;
  int locals_u = 6, locals_v = 4;
  BlendingKind blending = BlendingKind::polynomial2;
  int blending_parameter = 2;  ///< m or p; without meaning where the family has none
  int samples_u = 144, samples_v = 96;
  /// Only edited patches are listed. Edits beyond the present counts are kept and sleep.
  std::map<PatchIndex, PatchEdit> edits;

  bool operator==(const BlendingSurfaceObject&) const = default;
};

/// A Bezier curve by its control points, model units; its degree is their number less one.
struct BezierCurveObject {
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};
  double parameter = 0.5;  ///< where de Casteljau's construction is shown: share of the domain

  bool operator==(const BezierCurveObject&) const = default;
};

/// A B-spline curve by knots and control points, as KnotVector and BSplineCurve take them.
struct BSplineCurveObject {
  int degree = 1;
  Topology topology = Topology::open;
  std::vector<double> knots{0, 0, 1, 1};
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}};
  double parameter = 0.5;  ///< where de Boor's construction is shown: share of the domain

  bool operator==(const BSplineCurveObject&) const = default;
};

/// In the order of ShapeKind.
using Shape = std::variant<BlendingSurfaceObject, BezierCurveObject, BSplineCurveObject>;
enum class ShapeKind : unsigned char { blending_surface, bezier_curve, bspline_curve };

/// One row of the table of what an object can be.
struct ShapeRow {
  std::string_view id;     ///< in documents, as `blendingSurface`
  std::string_view label;  ///< for readers, as `Blending surface`
};
std::span<const ShapeRow> shape_kinds();
Shape make_shape(ShapeKind kind);

struct Object {
  std::string id;  ///< unique, [a-z][a-z0-9-]*
  std::string label;
  Shape shape;

  ShapeKind kind() const { return static_cast<ShapeKind>(shape.index()); }
  bool operator==(const Object&) const = default;
};

}  // namespace knotwork::scene
