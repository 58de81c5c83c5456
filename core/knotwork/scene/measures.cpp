#include "knotwork/scene/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotwork/curve/parametric_curve.h"
#include "knotwork/scene/blending_curve_figure.h"
#include "knotwork/scene/curve_figure.h"
#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/subdivision_figure.h"
#include "knotwork/scene/surface_builder.h"
#include "knotwork/surface/knotted_surface.h"

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

/// How many of the locals that are on the stage have an edit of a kind.
template <class Has>
Measure edited(const Document& document, Has has) {
  const auto count = [&](const auto& edits, int locals_u, int locals_v) -> Measure {
    return static_cast<double>(std::count_if(edits.begin(), edits.end(), [&](const auto& entry) {
      return entry.first.first < locals_u && entry.first.second < locals_v && has(entry.second);
    }));
  };
  const Shape& shape = stage_shape(document);
  if (const auto* surface = std::get_if<BlendingSurfaceObject>(&shape))
    return count(surface->edits, surface->locals_u, surface->locals_v);
  if (const auto* curve = std::get_if<BlendingCurveObject>(&shape)) return count(curve->edits, curve->locals, 1);
  return std::nullopt;
}

constexpr double least_edit = 1e-6;

Measure locals_moved(const Document& document) {
  return edited(document, [](const PatchEdit& edit) { return edit.translation.norm() > least_edit; });
}
Measure locals_turned(const Document& document) {
  return edited(document, [](const PatchEdit& edit) {
    return edit.rotation.angularDistance(Eigen::Quaterniond::Identity()) > least_edit;
  });
}
Measure locals_scaled(const Document& document) {
  return edited(document,
                [](const PatchEdit& edit) { return (edit.scale - Eigen::Vector3d::Ones()).norm() > least_edit; });
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

Measure subdivision_error(const Document& document) {
  const auto* object = std::get_if<SubdivisionCurveObject>(&stage_shape(document));
  if (object == nullptr) return std::nullopt;
  const SubdivisionFigure figure(*object);
  for (const SubdivisionFigure::LevelDistance& row : figure.distances)
    if (row.level == figure.level) return row.maximum;
  return std::nullopt;
}

}  // namespace

std::optional<double> measure(const Document& document, std::string_view name) {
  // Calls, not a table of functions: what stands in a table belongs to the module's first part.
  if (name == "ring.distance") return ring_distance(document);
  if (name == "fit.rms") return of_fit<&LeastSquaresFit::rms>(document);
  if (name == "fit.max") return of_fit<&LeastSquaresFit::maximum>(document);
  if (name == "points.count") return points_count(document);
  if (name == "knots.multiplicity") return knots_multiplicity(document);
  if (name == "knots.continuity") return knots_continuity(document);
  if (name == "knots.ratio") return knots_ratio(document);
  if (name == "locals.moved") return locals_moved(document);
  if (name == "locals.turned") return locals_turned(document);
  if (name == "locals.scaled") return locals_scaled(document);
  if (name == "seam.gap") return seam_gap(document);
  if (name == "curve.length") return curve_length(document);
  if (name == "subdivision.error") return subdivision_error(document);
  return std::nullopt;
}

}  // namespace knotwork::scene
