#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "knotwork/scene/commands.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/picking.h"
#include "web/camera.h"
#include "web/patch_drag.h"

namespace knotwork::web {

/// Which handle of what is on the stage: (i, j) of a local patch, (i, 0) of a curve's point, or the curve's parameter.
using HandleIndex = scene::PatchIndex;
inline constexpr HandleIndex parameter_handle{-1, 0};

/// A handle as it stands on the stage.
struct Handle {
  HandleIndex index;
  glm::dvec3 position;
  std::optional<glm::dvec3> screen;  ///< nothing when behind the camera
  bool hidden = false;               ///< something lies in front of it
};

/// What an interaction looks at. Nothing in here is changed by it but the net, which is made when first needed: it costs
/// as much as a mesh. The document is up to date (the commands of the last outcome are applied before the next event);
/// surface or curve (the document's kind has one of them), net, view and handles are those of the last frame.
struct Stage {
  const scene::Document& document;
  const BlendingSurface* surface;
  const scene::CurveFigure* curve;
  std::optional<scene::PickNet>& net;
  const View& view;
  std::span<const Handle> handles;

  std::optional<scene::SurfaceHit> pick(const scene::Ray& ray) const {
    if (surface == nullptr) return std::nullopt;
    if (!net) net.emplace(*surface);
    return net->pick(*surface, ray);
  }
};

/// The id of handles() in the script interface: "patch-2-1", "point-3", "parameter".
std::string handle_id(const scene::Shape& shape, HandleIndex index);
/// The handle with this id, if the shape has it.
std::optional<HandleIndex> find_handle(const scene::Shape& shape, std::string_view id);
/// For readers: "Patch 2, 1", "Point 3", "Parameter".
std::string handle_name(const scene::Shape& shape, HandleIndex index);
/// Whether the shape has such a handle.
bool has_handle(const scene::Shape& shape, HandleIndex index);
/// In the document and, should that be a frame ahead, on the stage.
bool exists(const Stage& stage, HandleIndex index);
/// The next handle in a fixed order, going round; from nothing, forwards comes to the first and backwards to the last.
HandleIndex neighbour(const Stage& stage, std::optional<HandleIndex> from, int step);

/// A curve's point in the hand.
struct PointDrag {
  HandleIndex index{0, 0};
  glm::dvec3 start{0};        ///< where the point was taken
  glm::dvec2 grab_offset{0};  ///< from the handle's screen position to the pointer, so that nothing jumps
  glm::dvec2 pointer{0};
};

/// None where the document stays as it is, else one.
using Commands = std::vector<scene::Command>;

/// What a hand has hold of: a patch by handle or gizmo, or a point.
using Held = std::variant<PatchDrag, PointDrag>;
HandleIndex handle_of(const Held& held);
/// Whether what is held still exists: a whole document may have come under the hand.
bool exists(const Stage& stage, const Held& held);

/// A hold that has not moved yet.
Held take_hold(const Stage& stage, HandleIndex index, std::optional<GizmoPart> part, glm::dvec2 pointer);
/// What the pointer there makes of the document. A point moves in the plane through
/// it parallel to the screen, with Shift along z; the parameter goes to the nearest place of the curve as it is seen.
Commands drag_to(Held& held, const Stage& stage, glm::dvec2 pointer, bool shift);
/// What is held stays under a pointer that rests while the stage moves.
Commands hold_still(const Held& held, const Stage& stage);
/// A handle moved by so many CSS pixels to the right, up, and along the patch's normal or z.
Commands nudged(const Stage& stage, HandleIndex index, glm::dvec3 pixels);
/// A patch put back, a point deleted.
Commands removed(const Stage& stage, HandleIndex index);

/// The parameter of the curve's place within `reach` CSS pixels of a screen position.
std::optional<double> curve_parameter_at(const Stage& stage, glm::dvec2 screen, double reach);

/// A place on the control polygon where a press adds a point.
struct Insertion {
  int index;  ///< of the new point
  glm::dvec3 position;
};
/// Within `reach` CSS pixels of the polygon as it is seen, and away from its corners.
std::optional<Insertion> insertion_at(const Stage& stage, glm::dvec2 screen, double reach);
/// In the middle of the leg after a point; after the last point of an open curve, as far on as the last leg goes.
std::optional<Insertion> insertion_after(const Stage& stage, HandleIndex index);

}  // namespace knotwork::web
