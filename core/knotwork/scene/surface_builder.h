#pragma once

#include <span>
#include <vector>

#include "knotwork/scene/document.h"
#include "knotwork/scene/local_frame.h"
#include "knotwork/surface/blending_surface.h"

namespace knotwork::scene {

/// How far a direction is closed on the stage, from 0 (open) to 1 (closed): equal to the topology at rest, in between
/// while the sheet rolls.
struct Roll {
  double u, v;
};
Roll rest_roll(const BlendingSurfaceObject& object);

/// The blending surface that a document means, at its clock: knots, model, and M_ij from edits and motion.
/// Precondition: the document is valid (it came through parse or apply).
BlendingSurface build_surface(const BlendingSurfaceObject& object, const Animation& animation);

/// The same half way between two topologies. Where a roll component is strictly between 0 and 1, the surface is built
/// open with n+1 locals: the last one is local 0's ghost one period on, and the last interval's width shrinks with the
/// roll, so that roll 1 shows the closed surface and roll 0 the open one without a jump. Its edit is interpolated from
/// the last local's (0) to the first one's (1).
BlendingSurface build_surface(const BlendingSurfaceObject& object, const Animation& animation, Roll roll);

/// Only M_ij again, for a frame of the animation or of a drag: same knots and model. `axes` are patch_frames() of the
/// surface, which do not change meanwhile.
void update_locals(BlendingSurface& surface, const BlendingSurfaceObject& object, const Animation& animation, Roll roll,
                   std::span<const Eigen::Matrix3d> axes);

/// Patch (i,j) as the document has it: the surface gives knots and model only. The axes are those of patch_frame().
LocalFrame local_frame(const BlendingSurfaceObject& object, const Animation& animation, const BlendingSurface& surface,
                       PatchIndex patch);

/// F: columns S_u/|S_u|, N x S_u/|S_u|, N; the first is any tangent where S_u vanishes.
Eigen::Matrix3d tangent_frame(const SurfaceJet& jet);
/// The model's at the centre of local (i,j).
Eigen::Matrix3d patch_frame(const BlendingSurface& surface, PatchIndex patch);
/// Of all locals, (i,j) at i n_v + j.
std::vector<Eigen::Matrix3d> patch_frames(const BlendingSurface& surface);

/// The origin of local (i,j) on the stage: M_ij (0,0,0).
Eigen::Vector3d patch_origin(const BlendingSurface& surface, PatchIndex patch);

/// One direction of the report's table: what the topology makes of the counts.
struct DirectionSummary {
  Topology topology;
  double start, end;
  int first_knot, last_knot;  ///< the domain is [t_first, t_last] or [t_first, t_last)
  std::vector<double> knots;
  int patches, locals;
};
DirectionSummary summary_u(const BlendingSurface& surface);
DirectionSummary summary_v(const BlendingSurface& surface);

}  // namespace knotwork::scene
