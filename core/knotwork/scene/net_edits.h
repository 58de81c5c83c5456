#pragma once

#include "knotwork/scene/later.h"
#include "knotwork/scene/objects.h"
#include "knotwork/surface/bspline_surface.h"

namespace knotwork::scene {

/// The two directions of a net: u counts its rows, v its columns.
enum class NetDirection : unsigned char { u, v };

const SplineDirection& direction_of(const BSplineSurfaceObject& object, NetDirection direction);
/// Rows (u) or columns (v).
int line_count(const BSplineSurfaceObject& object, NetDirection direction);

/// The surface that the object means. Error path: `knots.u`, `knots.u[i]`, `net` and so on. Precondition: every member
/// within its limits, rows of one length.
KNOTWORK_LATER Result<BSplineSurface> build_net(const BSplineSurfaceObject& object);

/// The knots of a direction. Precondition: the object is valid.
KNOTWORK_LATER KnotVector net_knots(const BSplineSurfaceObject& object, NetDirection direction);

// What a hand does to a net; a line is a row (u) or a column (v). On an error nothing has changed. Error path: `point`,
// `position`, `index`, `value`, `at`, `count`, `degree`, `topology`. Precondition: the object is valid.

KNOTWORK_LATER Status set_net_point(BSplineSurfaceObject& object, PatchIndex point, const Eigen::Vector3d& position);

/// One knot and one line more; the surface stays as it is. `at` in the domain, where the knots have room.
KNOTWORK_LATER Status insert_net_line(BSplineSurfaceObject& object, NetDirection direction, double at);
/// Where insert_net_line() puts a new line between line `index` and the next one: half way between their Greville
/// abscissae. After the last line of an open direction the place before it; a closed one goes round.
KNOTWORK_LATER double place_after(const BSplineSurfaceObject& object, NetDirection direction, int index);

/// The line goes, the other points stay where they are: the surface changes there. Evenly spaced knots stay so; among
/// others the inner one nearest to the line's Greville abscissa goes.
KNOTWORK_LATER Status remove_net_line(BSplineSurfaceObject& object, NetDirection direction, int index);

/// More lines: knots in the middle of the widest intervals, the surface stays. Fewer: one after the other the knot goes
/// whose removal changes the surface least (Tiller's), so that lines added are taken back exactly.
KNOTWORK_LATER Status set_line_count(BSplineSurfaceObject& object, NetDirection direction, int count);

/// Knot t_index; of a closed direction the knots a period away go with it.
KNOTWORK_LATER Status set_net_knot(BSplineSurfaceObject& object, NetDirection direction, int index, double value);

/// The same points under evenly spaced knots of the new degree. An open direction that has too few of them becomes a
/// Bezier surface's and is elevated: the degree rises, and the lines with it, the surface stays. Refused for a closed
/// one.
KNOTWORK_LATER Status set_net_degree(BSplineSurfaceObject& object, NetDirection direction, int degree);

/// Evenly spaced knots of the other topology. The net goes with the sheet that carries it, as net_roll.h says. Refused
/// when there are too few lines.
KNOTWORK_LATER Status set_net_topology(BSplineSurfaceObject& object, NetDirection direction, Topology topology);

}  // namespace knotwork::scene
