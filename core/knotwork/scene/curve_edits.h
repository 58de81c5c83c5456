#pragma once

#include <span>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/scene/objects.h"

namespace knotwork::scene {

/// The points that a reader moves, adds and deletes; none for a surface.
std::span<const Eigen::Vector3d> curve_points(const Shape& shape);
/// Whether the last point is joined to the first one.
bool closes(const Shape& shape);

/// The curve that the object means. Errors as those of KnotVector and BSplineCurve.
Result<BSplineCurve> build_curve(const BSplineCurveObject& object);

/// Whether the knots are those that set_degree() would choose, up to their domain.
bool knots_are_even(const BSplineCurveObject& object);

// What a hand does to a curve. On an error nothing has changed. Error path: `index`, `value`, `degree`, `topology`.

Status set_point(Shape& shape, int index, const Eigen::Vector3d& position);

/// A new point before point `index` (0..n; n: after the last). A Bezier curve gets a higher degree. A B-spline gets a
/// knot more: evenly spaced knots stay so, over a domain one longer; among others the new one stands at the mean of the
/// neighbours' Greville abscissae.
Status insert_point(Shape& shape, int index, const Eigen::Vector3d& position);

/// The reverse: of unevenly spaced knots the inner one nearest to the point's Greville abscissa goes.
Status remove_point(Shape& shape, int index);

/// Knot t_index; of a closed curve the knots a period away go with it. `value` must leave the knots sorted and no knot
/// with a multiplicity above the degree (p+1 at the ends of an open curve).
Status set_knot(BSplineCurveObject& object, int index, double value);

/// The same points under evenly spaced knots of the new degree or topology: open ones clamped, domain [0, n-p]; closed,
/// [0, n]. Refused when there are too few points.
Status set_degree(BSplineCurveObject& object, int degree);
Status set_topology(BSplineCurveObject& object, Topology topology);

}  // namespace knotwork::scene
