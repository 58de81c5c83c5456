#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "knotwork/scene/commands.h"
#include "knotwork/scene/later.h"
#include "web/figure.h"
#include "web/patch_drag.h"

namespace knotwork::web {

/// What an interaction looks at. Nothing in here is changed by it but a figure's net for picking, which is made when
/// first needed. The document is up to date (the commands of the last outcome are applied before the next event); figure,
/// the shape that it shows, view and handles are those of the last frame.
struct Stage {
  const scene::Document& document;
  Figure& figure;
  const scene::Shape& shown;
  const View& view;
  std::span<const Handle> handles;

  const scene::Shape& shape() const { return scene::stage_shape(document); }
  /// nullptr where something else stands on the stage.
  const BlendingSurface* surface() const {
    const auto* blending = std::get_if<BlendingFigure>(&figure);
    return blending ? &blending->surface : nullptr;
  }
  std::optional<scene::SurfaceHit> pick(const scene::Ray& ray) const;
};

/// The local patch or local curve of a handle, as the document has it; nothing where the handle is another thing.
std::optional<scene::LocalFrame> local_of(const Stage& stage, HandleIndex index);
/// Its gizmo, where it stands on the stage.
std::optional<Gizmo> gizmo_of(const Stage& stage, HandleIndex index);

/// In the document and, should that be a frame ahead, on the stage.
bool exists(const Stage& stage, HandleIndex index);
/// The next handle in a fixed order, going round; from nothing, forwards comes to the first and backwards to the last.
HandleIndex neighbour(const Stage& stage, std::optional<HandleIndex> from, int step);

/// A control point in the hand.
struct PointDrag {
  HandleIndex index{0, 0};
  glm::dvec3 start{0};        ///< where the point was taken
  glm::dvec2 grab_offset{0};  ///< from the handle's screen position to the pointer, so that nothing jumps
  glm::dvec2 pointer{0};
  glm::dvec3 axis{0, 0, 1};  ///< unit; along it Shift moves the point
};

/// None where the document stays as it is, else one.
using Commands = std::vector<scene::Command>;

/// What a hand has hold of: a local patch or local curve by handle or gizmo, or a point.
using Held = std::variant<PatchDrag, PointDrag>;
HandleIndex handle_of(const Held& held);
/// Whether what is held still exists: a whole document may have come under the hand.
bool exists(const Stage& stage, const Held& held);

/// A hold that has not moved yet.
Held take_hold(const Stage& stage, HandleIndex index, std::optional<GizmoPart> part, glm::dvec2 pointer);
/// What the pointer there makes of the document. A point moves in the plane through
/// it parallel to the screen, with Shift along z or the surface's normal; the parameter goes to the nearest place of the curve as it is seen.
Commands drag_to(Held& held, const Stage& stage, glm::dvec2 pointer, bool shift);
/// What is held stays under a pointer that rests while the stage moves.
Commands hold_still(const Held& held, const Stage& stage);
/// A handle moved by so many CSS pixels to the right, up, and along the local's normal or z.
Commands nudged(const Stage& stage, HandleIndex index, glm::dvec3 pixels);
/// A local put back, a point deleted.
Commands removed(const Stage& stage, HandleIndex index);

/// Whether it has control points in a polygon, that a hand adds to.
bool has_polygon(const Stage& stage);
/// Whether a press on the polygon adds a point: not between data, which no polygon joins.
bool adds_on_polygon(const Stage& stage);
/// Whether it is made from a list of points, which a hand may draw.
bool takes_list(const Stage& stage);

/// The parameter of the curve's place within `reach` CSS pixels of a screen position.
std::optional<double> curve_parameter_at(const Stage& stage, glm::dvec2 screen, double reach);

/// A place on the control polygon or net where a press adds a point, or a whole line of points.
struct Insertion {
  int index;  ///< of the new point or line
  glm::dvec3 position;
  scene::Command command;
  HandleIndex handle;  ///< the new one; of a new line, the one where the press is
};
/// The handle that such a press takes hold of, and where it will stand.
struct Landing {
  HandleIndex handle;
  glm::dvec3 position;
};
/// A new line of a net lies beside the press: the surface stays. Nothing where the command will be refused.
std::optional<Landing> landing(const Stage& stage, const Insertion& insertion);
/// Within `reach` CSS pixels of the polygon as it is seen, and away from its corners.
KNOTWORK_LATER std::optional<Insertion> insertion_at(const Stage& stage, glm::dvec2 screen, double reach);
/// In the middle of the leg after a point; after the last point of an open curve, as far on as the last leg goes.
KNOTWORK_LATER std::optional<Insertion> insertion_after(const Stage& stage, HandleIndex index);

}  // namespace knotwork::web
