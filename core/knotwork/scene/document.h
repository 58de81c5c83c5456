#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/model_surface.h"

namespace knotwork::scene {

/// Limits of what a document may ask for; stated in the JSON Schema too.
inline constexpr int min_locals = 2, max_locals = 128;
inline constexpr int min_samples = 8, max_samples = 1024;
inline constexpr double max_coordinate = 1e6;  ///< model units, any coordinate or radius

/// A reader's edit of one local patch, in the patch's own frame: x along S_u of the model at the patch's centre,
/// z along the normal. M_ij = Translation(centre + F translation) F rotation scale F^-1, so that an edit keeps its
/// meaning ("outwards", "about the normal") while the model bends.
struct PatchEdit {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();             ///< model units
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();      ///< unit
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();                   ///< each in [0.01, 100]

  bool is_identity() const;
  bool operator==(const PatchEdit& other) const;
};

/// Which local patch: (i, j) with 0 <= i < n_u, 0 <= j < n_v.
using PatchIndex = std::pair<int, int>;

/// What carries a blending surface: `sheet` is the default that follows the topology (plane, cylinder, torus); the
/// others are fixed shapes.
enum class ModelKind : unsigned char { sheet, plane, cylinder, torus };

struct BlendingSurfaceObject {
  ModelKind model = ModelKind::sheet;
  Sheet sheet;  ///< its bends are ignored: they follow the topology
  Plane plane;
  Cylinder cylinder;
  Torus torus;
  Topology topology_u = Topology::closed, topology_v = Topology::closed;
  int locals_u = 6, locals_v = 4;
  BlendingKind blending = BlendingKind::polynomial2;
  int blending_parameter = 2;
  int samples_u = 144, samples_v = 96;
  /// Only edited patches are listed. Edits beyond the present counts are kept and sleep.
  std::map<PatchIndex, PatchEdit> edits;
};

struct Object {
  std::string id;  ///< unique, [a-z][a-z0-9-]*
  std::string label;
  std::variant<BlendingSurfaceObject> shape;
};

/// Orbit camera: the eye is at target + distance * (direction of azimuth, elevation), z up.
struct Camera {
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  double distance = 5.2;          ///< model units, > 0
  double azimuth = -1.05;         ///< radians, from +x towards +y
  double elevation = 0.52;        ///< radians, in (-pi/2, pi/2)
};

/// What is shown on the stage.
struct Display {
  bool surface = true, patch_colours = true, knot_lines = true, wireframe = false;
  bool local_patches = false, frames = false, normals = false, handles = true;
};

enum class MotionKind : unsigned char {
  breathe,  ///< along and about each patch's normal
  report,   ///< the report's, in its frame-rate independent form (THEORY 2.10)
};

struct Animation {
  bool playing = false;
  double time = 0;  ///< the clock in [0, clock_period), seconds at speed 1
  double speed = 1; ///< seconds of clock a second
  MotionKind motion = MotionKind::breathe;
  double amplitude = 0.14;  ///< breathe: model units; report: the rate a, model units a second (the report's is 1.5)
  double translation = 1;   ///< share of the translation in [0,1]
  double rotation = 0;      ///< share of the rotation in [0,1]; 1 is the report's angle 2t
};
inline constexpr double clock_period = 6.283185307179586;  ///< every motion repeats after 2pi

/// The whole of what a reader can change. A plain value.
struct Document {
  std::vector<Object> objects;
  Camera camera;
  Display display;
  Animation animation;
};

/// The first blending surface: what the stage and the parameter table are about in this version.
const BlendingSurfaceObject& blending_surface(const Document& document);
BlendingSurfaceObject& blending_surface(Document& document);

}  // namespace knotwork::scene
