#pragma once

#include <variant>
#include <vector>

#include <Eigen/Core>

#include "knotwork/result.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// Orbit camera: the eye is at target + distance * (direction of azimuth, elevation), z up.
struct Camera {
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  double distance = 5.2;    ///< model units, > 0
  double azimuth = -1.05;   ///< radians, from +x towards +y
  double elevation = 0.52;  ///< radians, in (-pi/2, pi/2)

  bool operator==(const Camera&) const = default;
};

/// How a surface is coloured.
enum class Shading : unsigned char {
  lit,        ///< as a body in the light
  zebra,      ///< as a mirror under parallel lamps
  isophotes,  ///< with lines along which the normal has one angle to the vertical
  gaussian,   ///< by its Gaussian curvature
  mean        ///< by its mean curvature
};

/// What is shown on the stage.
struct Display {
  bool surface = true, patch_colours = true, knot_lines = true, wireframe = false;
  bool local_patches = false, frames = false, normals = false, handles = true;
  bool polygon = true, construction = true;  ///< of a curve: its control polygon, its construction at the parameter
  bool comb = false;                         ///< of a curve: its curvature as hairs
  bool osculating = false;                   ///< of a curve: the circle that fits best at its parameter
  bool hodograph = false;                    ///< of a curve: its derivative as a curve of its own
  bool continuity = false;                   ///< of a curve: how smoothly pieces meet, in words
  Shading shading = Shading::lit;            ///< of a surface
  bool adaptive = true;                      ///< a surface's grid is fitted to the screen, else it has its own samples
  std::vector<Eigen::Vector3d> rings;        ///< places marked by a ring, for exercises; model units

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

/// The shape on the stage, which handles, panel and parameters are about: the first object's.
/// Precondition: there is one, as in every document that check() lets pass.
inline const Shape& stage_shape(const Document& document) { return document.objects.front().shape; }
inline Shape& stage_shape(Document& document) { return document.objects.front().shape; }

/// The blending surface on the stage. Precondition: it is one.
inline const BlendingSurfaceObject& blending_surface(const Document& document) {
  return *std::get_if<BlendingSurfaceObject>(&stage_shape(document));
}
inline BlendingSurfaceObject& blending_surface(Document& document) {
  return *std::get_if<BlendingSurfaceObject>(&stage_shape(document));
}

/// The model on the stage, alone or as a blending surface's; nullptr when something else stands there.
const ModelSurface* stage_model(const Document& document);
ModelSurface* stage_model(Document& document);

/// Whether the document is valid: every number within limits.h, ids unique, no direction closed in which the model is
/// not. Errors name the member as in its JSON form, as `objects[0].locals.u`.
Status check(const Document& document);
Status check(const PatchEdit& edit);
Status check(const Camera& camera);

}  // namespace knotwork::scene
