#pragma once

#include <span>
#include <vector>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// The points that a reader moves, adds and deletes: a fitted curve's are its data; none for a surface.
std::span<const Eigen::Vector3d> curve_points(const Shape& shape);
/// Whether the last point is joined to the first one.
bool closes(const Shape& shape);

/// The curve that the object means. Errors as those of KnotVector and BSplineCurve.
KNOTWORK_LATER Result<BSplineCurve> build_curve(const BSplineCurveObject& object);

/// Whether an open curve has p+1 equal knots at both ends, so that it begins in its first point and ends in its last.
KNOTWORK_LATER bool is_clamped(const BSplineCurveObject& object);

/// Whether the knots are those that set_degree() would choose, up to their domain.
KNOTWORK_LATER bool knots_are_even(const BSplineCurveObject& object);

// What a hand does to a curve. On an error nothing has changed. Error path: `index`, `value`, `degree`, `topology`.

/// Whether set_points() is for it.
bool is_made_from_list(const Shape& shape);
/// All points at once, of a shape that is made from a list: the data of a fitted curve, the polygon of a subdivision.
KNOTWORK_LATER Status set_points(Shape& shape, std::vector<Eigen::Vector3d> points);
/// So many points with coordinates within their limits. Error path: `points`, `points[i]`.
Status check_point_list(std::span<const Eigen::Vector3d> points, const Limits& count);

KNOTWORK_LATER Status set_point(Shape& shape, int index, const Eigen::Vector3d& position);

/// A new point before point `index` (0..n; n: after the last). A Bezier curve gets a higher degree. A B-spline gets a
/// knot more: evenly spaced knots stay so, over a domain one longer; among others the new one stands at the mean of the
/// neighbours' Greville abscissae.
KNOTWORK_LATER Status insert_point(Shape& shape, int index, const Eigen::Vector3d& position);

/// The reverse: of unevenly spaced knots the inner one nearest to the point's Greville abscissa goes.
KNOTWORK_LATER Status remove_point(Shape& shape, int index);

/// Knot t_index; of a closed curve the knots a period away go with it. `value` must leave the knots sorted and no knot
/// with a multiplicity above the degree (p+1 at the ends of an open curve).
KNOTWORK_LATER Status set_knot(BSplineCurveObject& object, int index, double value);

/// The same points under evenly spaced knots of the new degree, topology or ends: open and clamped, the domain is
/// [0, n-p]; open and unclamped, [p, n]; closed, [0, n]. An open curve's ends stay as they are, a closed curve opens
/// clamped. Refused when there are too few points. Precondition of set_clamped(): an open curve.
KNOTWORK_LATER Status set_degree(BSplineCurveObject& object, int degree);
KNOTWORK_LATER Status set_topology(BSplineCurveObject& object, Topology topology);
KNOTWORK_LATER Status set_clamped(BSplineCurveObject& object, bool clamped);

// The same of any curve that has a degree and a topology of its own. Precondition: it has.

int degree_of(const Shape& shape);
Topology topology_of(const Shape& shape);
/// The degrees that its points allow now.
Limits degree_range(const Shape& shape);
Status set_degree(Shape& shape, int degree);
Status set_topology(Shape& shape, Topology topology);

}  // namespace knotwork::scene
