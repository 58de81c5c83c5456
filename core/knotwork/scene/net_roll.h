#pragma once

#include "knotwork/scene/objects.h"
#include "knotwork/scene/surface_builder.h"
#include "knotwork/surface/bspline_surface.h"

namespace knotwork::scene {

// A net is carried by a sheet that rolls up where the net's directions close, as the model of a blending surface does:
// plane, cylinder, torus. Line i of n belongs to the sheet's parameter
//
//   s_i = -pi + 2 pi (g_i - g_0) / L,  L = g_{n-1} - g_0 where open, the period where closed,
//
// g being the Greville abscissae. What a point keeps while the sheet bends is its offset from the sheet's point there,
// in the sheet's own frame (tangent_frame()).

/// How far the directions are closed: 0 or 1 each.
Roll rest_roll(const BSplineSurfaceObject& object);

/// Every point on the sheet itself.
Net net_on_sheet(const BSplineSurfaceObject& object);

/// The net of `from` as the sheet carries it to the topology and the knots of `to`, which has as many lines.
Net carried_net(const BSplineSurfaceObject& from, const BSplineSurfaceObject& to);

/// What the stage shows half way between two topologies; at either end, the surface itself. `other_u` and `other_v` are
/// the directions in the topology that the object does not have: where they are not of its degree and count, evenly
/// spaced knots take their place. A direction on its way is open with p lines more, ghosts of the first ones a turn on;
/// each knot is as far between those of the open vector, whose end counts p times more, and of the closed one.
BSplineSurface rolled_net(const BSplineSurfaceObject& object, const SplineDirection& other_u,
                          const SplineDirection& other_v, Roll roll);

}  // namespace knotwork::scene
