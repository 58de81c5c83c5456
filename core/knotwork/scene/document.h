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
#include "knotwork/scene/limits.h"
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

struct Object {
  std::string id;  ///< unique, [a-z][a-z0-9-]*
  std::string label;
  std::variant<BlendingSurfaceObject> shape;

  bool operator==(const Object&) const = default;
};

/// Orbit camera: the eye is at target + distance * (direction of azimuth, elevation), z up.
struct Camera {
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  double distance = 5.2;    ///< model units, > 0
  double azimuth = -1.05;   ///< radians, from +x towards +y
  double elevation = 0.52;  ///< radians, in (-pi/2, pi/2)

  bool operator==(const Camera&) const = default;
};

/// What is shown on the stage.
struct Display {
  bool surface = true, patch_colours = true, knot_lines = true, wireframe = false;
  bool local_patches = false, frames = false, normals = false, handles = true;

  bool operator==(const Display&) const = default;
};

enum class MotionKind : unsigned char {
  breathe,  ///< along and about each patch's normal
  report,   ///< the report's, in its frame-rate independent form (THEORY 2.10)
};

struct Animation {
  bool playing = false;
  double time = 0;   ///< the clock, seconds at speed 1; playing keeps it in [0, clock_period)
  double speed = 1;  ///< seconds of clock a second
  MotionKind motion = MotionKind::breathe;
  double amplitude = 0.14;  ///< breathe: model units; report: the rate a, model units a second (the report's is 1.5)
  double translation = 1;   ///< share of the translation in [0,1]
  double rotation = 0;      ///< share of the rotation in [0,1]; 1 is the report's angle 2t

  bool operator==(const Animation&) const = default;
};

/// The whole of what a reader can change. A plain value.
struct Document {
  std::vector<Object> objects;
  Camera camera;
  Display display;
  Animation animation;

  bool operator==(const Document&) const = default;
};

/// The first blending surface: what the stage and the parameter table are about in this version.
/// Precondition: there is one, as in every document that check() lets pass.
const BlendingSurfaceObject& blending_surface(const Document& document);
BlendingSurfaceObject& blending_surface(Document& document);

/// Whether the document is valid: every number within limits.h, ids unique, no direction closed in which the model is
/// not. Errors name the member as in its JSON form, as `objects[0].locals.u`.
Status check(const Document& document);
Status check(const PatchEdit& edit);
Status check(const Camera& camera);

}  // namespace knotwork::scene
