#pragma once

#include <vector>

#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

LaneRiesenfeld scheme_of(const SubdivisionCurveObject& object);

/// The split and the averaging passes of one level.
inline int steps_of_level(const SubdivisionCurveObject& object) { return object.degree + 1; }
/// Of the whole walk.
inline int step_count(const SubdivisionCurveObject& object) { return object.levels * steps_of_level(object); }

/// The most levels that keep so many points within max_vertices.
KNOTWORK_LATER int most_levels(const SubdivisionCurveObject& object);

/// Whether there are points enough for the degree, vertices few enough, and the step is one of the walk's. Error path:
/// `points`, `levels`, `step`, `fraction`.
KNOTWORK_LATER Status check_subdivision(const SubdivisionCurveObject& object);

// What a hand does to it. On an error nothing has changed. Error path: the member's name.

/// Other points of the polygon at the start.
KNOTWORK_LATER Status set_points(SubdivisionCurveObject& object, std::vector<Eigen::Vector3d> points);
/// The levels done stay what they are, a level half done begins again.
KNOTWORK_LATER Status set_degree(SubdivisionCurveObject& object, int degree);
KNOTWORK_LATER Status set_topology(SubdivisionCurveObject& object, Topology topology);
/// Goes to the end of the walk.
KNOTWORK_LATER Status set_levels(SubdivisionCurveObject& object, int levels);
/// Between two steps nothing is left half done.
KNOTWORK_LATER Status set_step(SubdivisionCurveObject& object, int step);
KNOTWORK_LATER Status set_fraction(SubdivisionCurveObject& object, double fraction);

/// The clock's walk, a step a second: on from where it stands, from its end back to its start first. False when it has
/// come to the end.
KNOTWORK_LATER bool walk(SubdivisionCurveObject& object, double seconds);

}  // namespace knotwork::scene
