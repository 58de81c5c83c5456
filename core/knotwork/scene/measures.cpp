#include "knotwork/scene/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "knotwork/curve/continuity.h"
#include "knotwork/curve/parametric_curve.h"
#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/subdivision_figure.h"
#include "knotwork/scene/surface_builder.h"
#include "knotwork/surface/knotted_surface.h"
#include "knotwork/surface/surface_joints.h"

namespace knotwork::scene {

namespace {

using Measure = std::optional<double>;

/// f(view) for a shape that is a curve, nothing for others.
template <class F>
Measure of_curve(const Document& document, F f) {
  const Shape& shape = stage_shape(document);
  if (const auto* model = std::get_if<ModelCurveObject>(&shape)) return f(curve_view(model->model));
  if (const auto* blending = std::get_if<BlendingCurveObject>(&shape)) {
    const BlendingCurve curve = build_curve(*blending, document.animation);
    return f(curve_view(curve));
  }
  if (std::holds_alternative<BezierCurveObject>(shape) || std::holds_alternative<BSplineCurveObject>(shape) ||
      std::holds_alternative<FittedCurveObject>(shape) || std::holds_alternative<SubdivisionCurveObject>(shape)) {
    const BSplineCurve curve = spline_of(shape);
    return f(curve_view(curve));
  }
  return std::nullopt;
}

/// f(surface) for a blending or a B-spline surface, nothing for others.
template <class F>
Measure of_surface(const Document& document, F f) {
  const Shape& shape = stage_shape(document);
  if (const auto* blending = std::get_if<BlendingSurfaceObject>(&shape))
    return f(knotted_surface(build_surface(*blending, document.animation)));
  if (const auto* net = std::get_if<BSplineSurfaceObject>(&shape)) {
    const Result<BSplineSurface> surface = build_net(*net);
    return surface ? f(knotted_surface(surface.value())) : Measure();
  }
  return std::nullopt;
}

/// The least distance found from a point: the nearest of a grid of places in the unit square, moved on by ever smaller
/// steps. (closest_point() proves its minimum; the page's module has no room for the proof.) at(x, y): the point there.
template <class At>
double least_distance(const Eigen::Vector3d& point, int places_x, int places_y, At at) {
  double best = std::numeric_limits<double>::infinity(), x = 0, y = 0;
  const auto look = [&](double new_x, double new_y) {
    const double nearer = (at(new_x, new_y) - point).norm();
    if (nearer >= best) return false;
    best = nearer;
    x = new_x;
    y = new_y;
    return true;
  };
  for (int i = 0; i <= places_x; ++i)
    for (int j = 0; j <= places_y; ++j)
      look(static_cast<double>(i) / places_x, places_y > 0 ? static_cast<double>(j) / places_y : 0);
  for (double step = 1.0 / places_x; step > 1e-9;) {
    const double left = std::max(x - step, 0.0), right = std::min(x + step, 1.0);
    const double below = std::max(y - step, 0.0), above = places_y > 0 ? std::min(y + step, 1.0) : 0;
    if (!look(left, y) && !look(right, y) && !look(x, below) && !look(x, above)) step /= 2;
  }
  return best;
}

constexpr int curve_places = 1024, surface_places = 96;

Measure ring_distance(const Document& document) {
  Measure farthest;
  for (const Eigen::Vector3d& ring : document.display.rings) {
    Measure distance = of_curve(document, [&](const CurveView& view) -> Measure {
      return least_distance(ring, curve_places, 0,
                            [&](double x, double) { return view(std::lerp(view.start, view.end, x)); });
    });
    if (!distance) {
      distance = of_surface(document, [&](const KnottedSurface& surface) -> Measure {
        const KnotVector &u = *surface.knots_u, &v = *surface.knots_v;
        return least_distance(ring, surface_places, surface_places, [&](double x, double y) {
          return surface.evaluate(std::lerp(u.start(), u.end(), x), std::lerp(v.start(), v.end(), y)).s;
        });
      });
    }
    if (!distance) return std::nullopt;
    farthest = std::max(farthest.value_or(0), *distance);
  }
  return farthest;
}

template <double LeastSquaresFit::*Member>
Measure of_fit(const Document& document) {
  const auto* object = std::get_if<FittedCurveObject>(&stage_shape(document));
  if (object == nullptr) return std::nullopt;
  const Result<CurveFit> fit = build_fit(*object);
  return fit ? Measure(fit.value().fit.*Member) : Measure();
}

Measure points_count(const Document& document) {
  return visit_first(
      [](const auto& object) -> Measure {
        if constexpr (requires { object.points.size(); })
          return static_cast<double>(object.points.size());
        else
          return std::nullopt;
      },
      stage_shape(document));
}

/// f(knots) for a B-spline curve.
template <class F>
Measure of_knots(const Document& document, F f) {
  if (!std::holds_alternative<BSplineCurveObject>(stage_shape(document))) return std::nullopt;
  return f(spline_of(stage_shape(document)).knots());
}

int most_multiple(const KnotVector& knots) {
  int most = 0;
  for (const double t : knots.knots()) {
    const bool inner = knots.closed() ? t >= knots.start() && t < knots.end() : t > knots.start() && t < knots.end();
    if (inner) most = std::max(most, knots.multiplicity(t));
  }
  return most;
}

Measure knots_multiplicity(const Document& document) {
  return of_knots(document, [](const KnotVector& knots) -> Measure { return most_multiple(knots); });
}

Measure knots_continuity(const Document& document) {
  return of_knots(document, [](const KnotVector& knots) -> Measure {
    const int most = most_multiple(knots);
    return most > 0 ? Measure(knots.degree() - most) : Measure();
  });
}

Measure knots_ratio(const Document& document) {
  return of_knots(document, [](const KnotVector& knots) -> Measure {
    double longest = 0, shortest = knots.period();
    for (int i = knots.degree(); i <= knots.last_span(); ++i) {
      const double span = knots[i + 1] - knots[i];
      longest = std::max(longest, span);
      if (span > 0) shortest = std::min(shortest, span);
    }
    return longest / shortest;
  });
}

constexpr double least_edit = 1e-6;

/// The control points or data of a shape, row by row.
struct ShapePoints {
  std::vector<Eigen::Vector3d> points;
  std::size_t rows = 1;
};
ShapePoints points_of(const Shape& shape) {
  return visit_first(
      [](const auto& object) {
        ShapePoints all;
        if constexpr (requires { object.points.size(); }) {
          all.points = object.points;
        } else if constexpr (requires { object.net.size(); }) {
          all.rows = object.net.size();
          for (const auto& row : object.net) all.points.insert(all.points.end(), row.begin(), row.end());
        }
        return all;
      },
      shape);
}

Measure points_moved(const Document& document, const Document& start) {
  const ShapePoints now = points_of(stage_shape(document)), then = points_of(stage_shape(start));
  if (now.points.empty()) return std::nullopt;
  if (now.rows != then.rows || now.points.size() != then.points.size()) return static_cast<double>(now.points.size());
  int moved = 0;
  for (std::size_t i = 0; i < now.points.size(); ++i)
    if ((now.points[i] - then.points[i]).norm() > least_edit) ++moved;
  return moved;
}

using Edits = std::map<PatchIndex, PatchEdit>;

PatchEdit edit_in(const Edits& edits, PatchIndex local) {
  const auto found = edits.find(local);
  return found == edits.end() ? PatchEdit{} : found->second;
}

/// In what two edits differ.
enum Difference : unsigned { moved = 1, turned = 2, scaled = 4, any_difference = moved | turned | scaled };

unsigned differences(const PatchEdit& a, const PatchEdit& b) {
  return ((a.translation - b.translation).norm() > least_edit ? moved : 0U) |
         (a.rotation.angularDistance(b.rotation) > least_edit ? turned : 0U) |
         ((a.scale - b.scale).norm() > least_edit ? scaled : 0U);
}

/// How many of the locals that are on the stage differ in one of these ways from what the other edits make of them.
Measure locals_differing(const Document& document, const Edits& others, unsigned ways) {
  const Shape& shape = stage_shape(document);
  const auto* surface = std::get_if<BlendingSurfaceObject>(&shape);
  const auto* curve = std::get_if<BlendingCurveObject>(&shape);
  if (surface == nullptr && curve == nullptr) return std::nullopt;
  const Edits& edits = *local_edits(shape);
  const int locals_u = surface ? surface->locals_u : curve->locals, locals_v = surface ? surface->locals_v : 1;
  int count = 0;
  for (int i = 0; i < locals_u; ++i)
    for (int j = 0; j < locals_v; ++j)
      if ((differences(edit_in(edits, {i, j}), edit_in(others, {i, j})) & ways) != 0) ++count;
  return count;
}

Measure locals_changed(const Document& document, const Document& start) {
  const Edits* edits = local_edits(stage_shape(start));
  return locals_differing(document, edits ? *edits : Edits{}, any_difference);
}

Measure model_distance(const Document& document) {
  const auto* object = std::get_if<BlendingCurveObject>(&stage_shape(document));
  if (object == nullptr) return std::nullopt;
  const BlendingCurve curve = build_curve(*object, document.animation);
  const KnotVector& knots = curve.knots();
  constexpr int steps = 64;
  double farthest = 0;
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    for (int k = 0; k <= steps; ++k) {
      const double t = std::lerp(knots[i], knots[i + 1], static_cast<double>(k) / steps);
      farthest = std::max(farthest, (curve(t) - curve.model()(t)).norm());
    }
  }
  return farthest;
}

int cells_along(const KnotVector& knots) {
  int cells = 0;
  for (int i = knots.degree(); i <= knots.last_span(); ++i)
    if (knots[i + 1] > knots[i]) ++cells;
  return cells;
}

Measure cells_count(const Document& document) {
  return of_surface(document, [](const KnottedSurface& surface) -> Measure {
    return cells_along(*surface.knots_u) * cells_along(*surface.knots_v);
  });
}

/// Between the ends of one direction, at places along the other one.
template <class At>
double gap(const KnotVector& across, const KnotVector& along, At at) {
  if (across.closed()) return 0;
  constexpr int places = 64;
  double widest = 0;
  for (int k = 0; k <= places; ++k) {
    const double share = static_cast<double>(k) / places, t = along.start() + share * along.period();
    widest = std::max(widest, (at(across.start(), t) - at(across.end(), t)).norm());
  }
  return widest;
}

Measure seam_gap(const Document& document) {
  return of_surface(document, [](const KnottedSurface& surface) -> Measure {
    const KnotVector &u = *surface.knots_u, &v = *surface.knots_v;
    return std::min(gap(u, v, [&](double s, double t) { return surface.evaluate(s, t).s; }),
                    gap(v, u, [&](double s, double t) { return surface.evaluate(t, s).s; }));
  });
}

Measure of_joints(const Document& document, double SurfaceJoint::*difference, double unit = 1) {
  JointSeams seams;
  if (const auto* blending = std::get_if<BlendingSurfaceObject>(&stage_shape(document)))
    seams = untwisted_seams(build_surface(*blending, document.animation));
  return of_surface(document, [&](const KnottedSurface& surface) -> Measure {
    const std::vector<SurfaceJoint> joints = surface_joints(surface, 4, seams);
    const SurfaceJoint* worst = worst_joint(joints, difference);
    return worst ? unit * worst->*difference : 0;
  });
}

/// Of a polygon in the curve, and of one twice as fine: their errors are as 4 to 1.
Measure curve_length(const Document& document) {
  return of_curve(document, [](const CurveView& view) -> Measure {
    const auto polygon = [&](int sides) {
      double length = 0;
      Eigen::Vector3d last = view(view.start);
      for (int k = 1; k <= sides; ++k) {
        const Eigen::Vector3d next = view(std::lerp(view.start, view.end, static_cast<double>(k) / sides));
        length += (next - last).norm();
        last = next;
      }
      return length;
    };
    return (4 * polygon(2 * curve_places) - polygon(curve_places)) / 3;
  });
}

/// By the sign of the z-coordinate of c' x c'', on a few hundred places of each piece.
Measure curve_inflections(const Document& document) {
  return of_curve(document, [](const CurveView& view) -> Measure {
    const std::vector<double> ends = piece_ends(view.start, view.end, view.breaks);
    constexpr int places = 400;
    constexpr double least_turn = 1e-9;  // sine between c' and c'': what is less is straight
    int count = 0;
    double last = 0, first = 0;
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
      for (int k = 0; k <= places; ++k) {
        const double t = std::lerp(ends[piece], just_before(ends[piece + 1]), static_cast<double>(k) / places);
        std::array<Eigen::Vector3d, 3> c;
        view.evaluate(t, c);
        const double turn = c[1].x() * c[2].y() - c[1].y() * c[2].x();
        if (std::abs(turn) <= least_turn * c[1].norm() * c[2].norm()) continue;
        if (turn * last < 0) ++count;
        last = turn;
        if (first == 0) first = turn;
      }
    }
    if (view.closed() && last * first < 0) ++count;
    return count;
  });
}

Measure hodograph_gap(const Document& document) {
  return of_curve(document, [](const CurveView& view) -> Measure {
    double widest = 0;
    for (const Continuity& joint : joints(view)) widest = std::max(widest, joint.velocity_gap);
    return widest;
  });
}

Measure subdivision_error(const Document& document) {
  const auto* object = std::get_if<SubdivisionCurveObject>(&stage_shape(document));
  if (object == nullptr) return std::nullopt;
  const SubdivisionFigure figure(*object);
  for (const SubdivisionFigure::LevelDistance& row : figure.distances)
    if (row.level == figure.level) return row.maximum;
  return std::nullopt;
}

}  // namespace

std::optional<double> measure(const Document& document, const Document& start, std::string_view name) {
  // Calls, not a table of functions: what stands in a table belongs to the module's first part.
  if (name == "ring.distance") return ring_distance(document);
  if (name == "fit.rms") return of_fit<&LeastSquaresFit::rms>(document);
  if (name == "fit.max") return of_fit<&LeastSquaresFit::maximum>(document);
  if (name == "points.count") return points_count(document);
  if (name == "points.moved") return points_moved(document, start);
  if (name == "knots.multiplicity") return knots_multiplicity(document);
  if (name == "knots.continuity") return knots_continuity(document);
  if (name == "knots.ratio") return knots_ratio(document);
  if (name == "locals.moved") return locals_differing(document, {}, moved);
  if (name == "locals.turned") return locals_differing(document, {}, turned);
  if (name == "locals.scaled") return locals_differing(document, {}, scaled);
  if (name == "locals.changed") return locals_changed(document, start);
  if (name == "model.distance") return model_distance(document);
  if (name == "cells.count") return cells_count(document);
  if (name == "seam.gap") return seam_gap(document);
  if (name == "joints.kink") return of_joints(document, &SurfaceJoint::kink, 180 / std::numbers::pi);
  if (name == "joints.bend") return of_joints(document, &SurfaceJoint::bend);
  if (name == "curve.length") return curve_length(document);
  if (name == "curve.inflections") return curve_inflections(document);
  if (name == "hodograph.gap") return hodograph_gap(document);
  if (name == "subdivision.error") return subdivision_error(document);
  return std::nullopt;
}

}  // namespace knotwork::scene
