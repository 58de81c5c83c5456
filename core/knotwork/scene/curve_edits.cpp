#include "knotwork/scene/curve_edits.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "knotwork/scene/limits.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// Relative to the period; what comes through JSON or a drag and back is still evenly spaced.
constexpr double even_tolerance = 1e-12;

/// nullptr for a surface. `S` is Shape or const Shape.
template <class S>
auto* points_in(S& shape) {
  using Points =
      std::conditional_t<std::is_const_v<S>, const std::vector<Eigen::Vector3d>, std::vector<Eigen::Vector3d>>;
  return std::visit(
      [](auto& object) -> Points* {
        if constexpr (requires { object.points; })
          return &object.points;
        else
          return nullptr;
      },
      shape);
}

std::vector<double> copied(std::span<const double> values) { return {values.begin(), values.end()}; }

Result<KnotVector> even_knots(int degree, std::size_t points, Topology topology) {
  const int count = static_cast<int>(points);
  const int intervals = topology == Topology::closed ? count : count - degree;
  if (intervals < 1 || (topology == Topology::closed && count < std::max(degree, 2))) {
    const int least = topology == Topology::closed ? std::max(degree, 2) : degree + 1;
    return Error{"points", std::string(topology == Topology::closed ? "A closed" : "An open") + " curve of degree " +
                               std::to_string(degree) + " needs at least " + std::to_string(least) + " points."};
  }
  return KnotVector::uniform(degree, count, topology, 0, intervals);
}

bool evenly_spaced(const KnotVector& knots) {
  const Result<KnotVector> even =
      KnotVector::uniform(knots.degree(), knots.count(), knots.topology(), knots.start(), knots.end());
  if (!even) return false;
  const std::span<const double> a = knots.knots(), b = even.value().knots();
  return std::equal(a.begin(), a.end(), b.begin(),
                    [&](double x, double y) { return std::abs(x - y) <= even_tolerance * knots.period(); });
}

/// All knots of a closed vector from those of one period, t_p .. t_{p+n-1}.
std::vector<double> repeated(const std::vector<double>& period, double length, int degree) {
  const int n = static_cast<int>(period.size());
  std::vector<double> knots;
  for (int i = -degree; i <= n + degree; ++i) {
    const int round = i >= 0 ? i / n : -((n - 1 - i) / n);
    knots.push_back(period[static_cast<std::size_t>(i - round * n)] + round * length);
  }
  return knots;
}

double greville(const KnotVector& knots, int i) {
  double sum = 0;
  for (int k = i + 1; k <= i + knots.degree(); ++k) sum += knots[k];
  return sum / knots.degree();
}

/// Knots with a new one near where the new point i will have its say.
Result<KnotVector> with_knot_for(const KnotVector& knots, int i) {
  const int n = knots.count(), p = knots.degree();
  if (knots.closed()) {
    const double before = i > 0 ? greville(knots, i - 1) : greville(knots, n - 1) - knots.period();
    const double after = i < n ? greville(knots, i) : greville(knots, 0) + knots.period();
    std::vector<double> period(knots.knots().begin() + p, knots.knots().begin() + p + n);
    period.push_back(knots.reduced((before + after) / 2));
    std::sort(period.begin(), period.end());
    return KnotVector::make(p, Topology::closed, repeated(period, knots.period(), p));
  }
  const int a = std::clamp(i, 1, n - 1);
  std::vector<double> inserted = copied(knots.knots());
  const double t = std::clamp((greville(knots, a - 1) + greville(knots, a)) / 2, knots.start(), knots.end());
  inserted.insert(std::upper_bound(inserted.begin(), inserted.end(), t), t);
  return KnotVector::make(p, Topology::open, std::move(inserted));
}

Result<KnotVector> without_knot_of(const KnotVector& knots, int i) {
  const int n = knots.count(), p = knots.degree();
  const int first = knots.closed() ? p : p + 1, last = knots.closed() ? p + n - 1 : n - 1;
  const double said = knots.closed() ? knots.reduced(greville(knots, i)) : greville(knots, i);
  int gone = first;
  for (int k = first; k <= last; ++k)
    if (std::abs(knots[k] - said) < std::abs(knots[gone] - said)) gone = k;
  if (knots.closed()) {
    std::vector<double> period(knots.knots().begin() + p, knots.knots().begin() + p + n);
    period.erase(period.begin() + (gone - p));
    return KnotVector::make(p, Topology::closed, repeated(period, knots.period(), p));
  }
  std::vector<double> rest = copied(knots.knots());
  rest.erase(rest.begin() + gone);
  return KnotVector::make(p, Topology::open, std::move(rest));
}

Error no_such_point(int index) { return {"index", "There is no point " + std::to_string(index) + "."}; }

/// Takes new knots and points together, when they belong together.
Status take(BSplineCurveObject& object, const Result<KnotVector>& knots, std::vector<Eigen::Vector3d> points) {
  if (!knots) return knots.error();
  object.degree = knots.value().degree();
  object.topology = knots.value().topology();
  object.knots = copied(knots.value().knots());
  object.points = std::move(points);
  return success();
}

Result<KnotVector> knots_of(const BSplineCurveObject& object) {
  return KnotVector::make(object.degree, object.topology, object.knots);
}

Status take_points(BezierCurveObject& object, std::vector<Eigen::Vector3d> points, int) {
  if (!limits::bezier_points.contains(static_cast<double>(points.size())))
    return Error{"index", "A Bézier curve has from 2 to 17 points here."};
  object.points = std::move(points);
  return success();
}

Status take_points(BlendingSurfaceObject&, const std::vector<Eigen::Vector3d>&, int) {
  return Error{"index", "A blending surface has no points of its own."};
}

Status take_points(BSplineCurveObject& object, std::vector<Eigen::Vector3d> points, int index) {
  if (!limits::points.contains(static_cast<double>(points.size())))
    return Error{"index", "A curve has from 2 to " + std::to_string(max_points) + " points here."};
  const Result<KnotVector> old = knots_of(object);
  if (!old) return old.error();
  const KnotVector& knots = old.value();
  const auto changed = [&]() -> Result<KnotVector> {
    Result<KnotVector> even = even_knots(knots.degree(), points.size(), knots.topology());
    if (!even || evenly_spaced(knots)) return even;
    return points.size() > object.points.size() ? with_knot_for(knots, index) : without_knot_of(knots, index);
  };
  const Result<KnotVector> fresh = changed();
  if (!fresh) {
    const std::string reason =
        fresh.error().path == "points" ? fresh.error().message : "The knots here leave no room for another one.";
    return Error{"index", reason};
  }
  return take(object, fresh, std::move(points));
}

}  // namespace

std::span<const Eigen::Vector3d> curve_points(const Shape& shape) {
  const auto* points = points_in(shape);
  return points == nullptr ? std::span<const Eigen::Vector3d>() : *points;
}

bool closes(const Shape& shape) {
  const auto* curve = std::get_if<BSplineCurveObject>(&shape);
  return curve != nullptr && curve->topology == Topology::closed;
}

Result<BSplineCurve> build_curve(const BSplineCurveObject& object) {
  Result<KnotVector> knots = knots_of(object);
  if (!knots) return knots.error();
  return BSplineCurve::make(std::move(knots).value(), object.points);
}

bool knots_are_even(const BSplineCurveObject& object) {
  const Result<KnotVector> knots = knots_of(object);
  return knots && evenly_spaced(knots.value());
}

Status set_point(Shape& shape, int index, const Eigen::Vector3d& position) {
  std::vector<Eigen::Vector3d>* points = points_in(shape);
  if (points == nullptr || index < 0 || index >= static_cast<int>(points->size())) return no_such_point(index);
  for (int k = 0; k < 3; ++k)
    if (!limits::coordinate.contains(position[k])) return Error{"position", number_message(limits::coordinate)};
  (*points)[static_cast<std::size_t>(index)] = position;
  return success();
}

Status insert_point(Shape& shape, int index, const Eigen::Vector3d& position) {
  std::vector<Eigen::Vector3d>* points = points_in(shape);
  if (points == nullptr || index < 0 || index > static_cast<int>(points->size())) return no_such_point(index);
  for (int k = 0; k < 3; ++k)
    if (!limits::coordinate.contains(position[k])) return Error{"position", number_message(limits::coordinate)};
  std::vector<Eigen::Vector3d> longer = *points;
  longer.insert(longer.begin() + index, position);
  return std::visit([&](auto& object) { return take_points(object, std::move(longer), index); }, shape);
}

Status remove_point(Shape& shape, int index) {
  std::vector<Eigen::Vector3d>* points = points_in(shape);
  if (points == nullptr || index < 0 || index >= static_cast<int>(points->size())) return no_such_point(index);
  std::vector<Eigen::Vector3d> shorter = *points;
  shorter.erase(shorter.begin() + index);
  return std::visit([&](auto& object) { return take_points(object, std::move(shorter), index); }, shape);
}

Status set_knot(BSplineCurveObject& object, int index, double value) {
  const int size = static_cast<int>(object.knots.size()), p = object.degree;
  const int n = static_cast<int>(object.points.size());
  const bool closed = object.topology == Topology::closed;
  if (index < 0 || index >= size || (closed && (index < p || index >= p + n)))
    return Error{"index", "There is no knot " + std::to_string(index) + " to be moved."};
  if (!limits::coordinate.contains(value)) return Error{"value", number_message(limits::coordinate)};
  std::vector<double> knots = object.knots;
  knots[static_cast<std::size_t>(index)] = value;
  if (closed) {
    const double period = object.knots[static_cast<std::size_t>(p + n)] - object.knots[static_cast<std::size_t>(p)];
    knots = repeated({knots.begin() + p, knots.begin() + p + n}, period, p);
  }
  const Result<KnotVector> moved = KnotVector::make(p, object.topology, knots);
  if (!moved) return Error{"value", moved.error().message};
  object.knots = std::move(knots);
  return success();
}

Status set_degree(BSplineCurveObject& object, int degree) {
  if (!limits::degree.contains(degree)) return Error{"degree", integer_message(limits::degree)};
  const Result<KnotVector> knots = even_knots(degree, object.points.size(), object.topology);
  if (!knots) return Error{"degree", knots.error().message};
  return take(object, knots, object.points);
}

Status set_topology(BSplineCurveObject& object, Topology topology) {
  const Result<KnotVector> knots = even_knots(object.degree, object.points.size(), topology);
  if (!knots) return Error{"topology", knots.error().message};
  return take(object, knots, object.points);
}

}  // namespace knotwork::scene
