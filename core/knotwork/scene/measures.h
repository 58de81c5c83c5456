#pragma once

#include <optional>
#include <string_view>

#include "knotwork/scene/document.h"
#include "knotwork/scene/later.h"

namespace knotwork::scene {

/// A number about the shape on the stage, for the exercises of the page; nothing where the shape has no such measure, or
/// there is none of this name. Lengths are in model units. `start` is the document that the figure began with.
///
///   ring.distance       from the farthest of the document's rings to the point of the curve or surface nearest to it
///   fit.rms, fit.max    of the distances of the data from a fitted curve, at their parameters
///   points.count        control points, or data
///   points.moved        control points, or data, farther than 1e-6 from where the point of the same index was at the
///                       start; all of them when there are more or fewer now
///   knots.multiplicity  the largest of an inner knot of a B-spline curve; 0 without inner knots
///   knots.continuity    the least k such that the curve is C^k for sure at an inner knot: degree - multiplicity
///   knots.ratio         the longest span of the domain over the shortest that is not empty
///   locals.moved, locals.turned, locals.scaled   how many locals a hand has moved (1e-6), turned (1e-6) or scaled
///   locals.changed      how many locals have another edit than at the start, by more than 1e-6
///   model.distance      the largest |c(t) - m(t)| of a blending curve from its model, of 64 steps an interval
///   cells.count         of a blending or B-spline surface: its knot intervals in u times those in v, empty ones left out
///   seam.gap            the largest distance between the two ends of a direction of a surface that is open, of both
///                       the smaller; 0 when one is closed
///   joints.kink         of a surface: the largest angle between its normals across knot lines and seams, degrees
///   joints.bend         the same of normal curvatures across these lines, 1 / model units
///   curve.length        arc length
///   curve.inflections   how often a curve in a plane z = const begins to turn the other way
///   hodograph.gap       the largest |c'(t-) - c'(t+)| where pieces of a curve meet
///   subdivision.error   the largest distance of the polygon's vertices from their own places on the limit
KNOTWORK_LATER std::optional<double> measure(const Document& document, const Document& start, std::string_view name);

}  // namespace knotwork::scene
