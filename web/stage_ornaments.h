#pragma once

#include "knotwork/later.h"
#include "web/figure_picture.h"

namespace knotwork::web {

// What is drawn on and about the surface, as plain ribbons and discs added to a picture.

/// A handle: a white disc with a rim in its hue; the selected one in accent, the hovered one larger.
Disc handle_disc(const Handle& handle, const Colour& hue, float radius, const InteractionState& state,
                 const Theme& theme);
/// Those of local patches.
void add_handles(Picture& picture, std::span<const Handle> handles, const scene::BlendingSurfaceObject& object,
                 const InteractionState& state);

/// The gizmo round the selected handle, the part under the pointer or held drawn stronger.
void add_gizmo(Picture& picture, const BlendingSurface& surface, const scene::BlendingSurfaceObject& object,
               const InteractionState& state);

void add_gizmo_strokes(Picture& picture, const Gizmo& gizmo, const InteractionState& state);

/// Each local patch's own frame: its u, v and normal axes as short arrows.
KNOTWORK_LATER void add_patch_frames(Picture& picture, const BlendingSurface& surface,
                                     const scene::BlendingSurfaceObject& object);

/// Unit normals of the surface as thin hairs on a regular grid of each knot interval.
KNOTWORK_LATER void add_normals(Picture& picture, const KnottedSurface& surface);

inline constexpr float ring_radius = 12.5F;  ///< CSS pixels, with its band
/// The rings of an exercise, on a band of paper so that they stand out from every hue.
KNOTWORK_LATER void add_rings(Picture& picture);

/// The surface itself, its handles and what display asks for.
void add_to_picture(Picture& picture, const BlendingFigure& figure, const Look& look);
inline std::vector<StageLabel> labels_of(const BlendingFigure&, std::span<const Handle>, const View&, const Theme&,
                                         const Obstacles&) {
  return {};
}

/// What the probe shows at a point of the surface.
Probe probe_at(const BlendingSurface& surface, double u, double v);

}  // namespace knotwork::web
