#include "knotwork/scene/curve_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>

#include "knotwork/scene/fit_edits.h"
#include "knotwork/scene/knot_edits.h"
#include "knotwork/scene/limits.h"
#include "knotwork/scene/messages.h"
#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene {

namespace {

template <class O>
concept CurveWithDegree = requires(O& object) {
  object.points;
  object.degree;
  object.topology;
};

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

/// Of a curve, with the reason in its words.
Result<KnotVector> even_curve_knots(int degree, std::size_t points, Topology topology, Ends ends) {
  Result<KnotVector> knots = even_knots(degree, static_cast<int>(points), topology, ends);
  if (knots) return knots;
  return Error{"points", std::string(topology == Topology::closed ? "A closed" : "An open") + " curve of degree " +
                             std::to_string(degree) + " needs at least " +
                             std::to_string(least_points(degree, topology)) + " points."};
}

Error no_such_point(int index) { return {"index", "There is no point " + std::to_string(index) + "."}; }

/// Takes new knots and points together, when they belong together.
Status take(BSplineCurveObject& object, const Result<KnotVector>& knots, std::vector<Eigen::Vector3d> points) {
  if (!knots) return knots.error();
  object.degree = knots.value().degree();
  object.topology = knots.value().topology();
  object.knots = {knots.value().knots().begin(), knots.value().knots().end()};
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

template <class Object>
Status take_points(Object&, const std::vector<Eigen::Vector3d>&, int) {
  return Error{"index", "What is on the stage has no points of its own."};
}

/// An edit of one point of a list: the list is what is said to be wrong.
template <class ListObject>
Status take_list(ListObject& object, std::vector<Eigen::Vector3d> points) {
  const Status status = set_points(object, std::move(points));
  return status ? success() : Status(Error{"index", status.error().message});
}

Status take_points(FittedCurveObject& object, std::vector<Eigen::Vector3d> points, int) {
  return take_list(object, std::move(points));
}

Status take_points(SubdivisionCurveObject& object, std::vector<Eigen::Vector3d> points, int) {
  return take_list(object, std::move(points));
}

Status take_points(ModelSurfaceObject&, const std::vector<Eigen::Vector3d>&, int) {
  return Error{"index", "A model surface has no points of its own."};
}

Status take_points(BSplineSurfaceObject&, const std::vector<Eigen::Vector3d>&, int) {
  return Error{"index", "A net takes whole rows and columns."};
}

Status take_points(BSplineCurveObject& object, std::vector<Eigen::Vector3d> points, int index) {
  if (!limits::points.contains(static_cast<double>(points.size())))
    return Error{"index", "A curve has from 2 to " + std::to_string(max_points) + " points here."};
  const Result<KnotVector> old = knots_of(object);
  if (!old) return old.error();
  const KnotVector& knots = old.value();
  const auto changed = [&]() -> Result<KnotVector> {
    Result<KnotVector> even = even_curve_knots(knots.degree(), points.size(), knots.topology(), ends_of(knots));
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
  return std::visit(
      [](const auto& object) {
        if constexpr (CurveWithDegree<decltype(object)>)
          return object.topology == Topology::closed;
        else
          return false;
      },
      shape);
}

Result<BSplineCurve> build_curve(const BSplineCurveObject& object) {
  Result<KnotVector> knots = knots_of(object);
  if (!knots) return knots.error();
  return BSplineCurve::make(std::move(knots).value(), object.points);
}

bool is_clamped(const BSplineCurveObject& object) {
  const Result<KnotVector> knots = knots_of(object);
  return knots && !knots.value().closed() && ends_of(knots.value()) == Ends::clamped;
}

bool knots_are_even(const BSplineCurveObject& object) {
  const Result<KnotVector> knots = knots_of(object);
  return knots && evenly_spaced(knots.value());
}

Status check_point_list(std::span<const Eigen::Vector3d> points, const Limits& count) {
  if (!count.contains(static_cast<double>(points.size()))) {
    return Error{"points", "There must be from " + number_text(count.min) + " to " + number_text(count.max) +
                               " points; there are " + std::to_string(points.size()) + "."};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double coordinate : points[i]) {
      if (!limits::coordinate.contains(coordinate))
        return Error{"points[" + std::to_string(i) + "]", number_message(limits::coordinate)};
    }
  }
  return success();
}

bool is_made_from_list(const Shape& shape) {
  return std::holds_alternative<FittedCurveObject>(shape) || std::holds_alternative<SubdivisionCurveObject>(shape);
}

Status set_points(Shape& shape, std::vector<Eigen::Vector3d> points) {
  if (auto* fitted = std::get_if<FittedCurveObject>(&shape)) return set_points(*fitted, std::move(points));
  if (auto* polygon = std::get_if<SubdivisionCurveObject>(&shape)) return set_points(*polygon, std::move(points));
  return Error{
      "points",
      "What is on the stage is not made from a list of points. A fitted curve or a subdivision is: open one first."};
}

Status set_point(Shape& shape, int index, const Eigen::Vector3d& position) {
  std::vector<Eigen::Vector3d>* points = points_in(shape);
  if (points == nullptr || index < 0 || index >= static_cast<int>(points->size())) return no_such_point(index);
  for (int k = 0; k < 3; ++k)
    if (!limits::coordinate.contains(position[k])) return Error{"position", number_message(limits::coordinate)};
  if (auto* fitted = std::get_if<FittedCurveObject>(&shape)) {
    // The only curve that a point can spoil: where data coincide, they may leave it undetermined.
    const auto move = [&](FittedCurveObject& moved) { moved.points[static_cast<std::size_t>(index)] = position; };
    const Status status = refit(*fitted, move);
    return status ? success() : Status(Error{"position", status.error().message});
  }
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
  const Result<KnotVector> knots = knots_of(object);
  if (!knots) return knots.error();
  Result<std::vector<double>> moved = with_knot_moved(knots.value(), index, value);
  if (!moved) return moved.error();
  object.knots = std::move(moved).value();
  return success();
}

Status set_degree(BSplineCurveObject& object, int degree) {
  if (!limits::degree.contains(degree)) return Error{"degree", integer_message(limits::degree)};
  const Result<KnotVector> old = knots_of(object);
  if (!old) return old.error();
  const Result<KnotVector> knots =
      even_curve_knots(degree, object.points.size(), object.topology, ends_of(old.value()));
  if (!knots) return Error{"degree", knots.error().message};
  return take(object, knots, object.points);
}

Status set_topology(BSplineCurveObject& object, Topology topology) {
  const Result<KnotVector> knots = even_curve_knots(object.degree, object.points.size(), topology, Ends::clamped);
  if (!knots) return Error{"topology", knots.error().message};
  return take(object, knots, object.points);
}

Status set_clamped(BSplineCurveObject& object, bool clamped) {
  const Ends ends = clamped ? Ends::clamped : Ends::unclamped;
  return take(object, even_curve_knots(object.degree, object.points.size(), object.topology, ends), object.points);
}

namespace {

/// f of the curve's object, where it has points, degree and topology.
template <class S, class F>
auto with_degree(S& shape, F f) {
  using Answer = decltype(f(*std::get_if<BSplineCurveObject>(&shape)));
  return std::visit(
      [&](auto& object) -> Answer {
        if constexpr (CurveWithDegree<decltype(object)>) {
          return f(object);
        } else {
          // Excluded by the precondition: any answer will do.
          assert(false);
          return f(*std::get_if<BSplineCurveObject>(&shape));
        }
      },
      shape);
}

Status set_degree(FittedCurveObject& object, int degree) {
  if (!limits::degree.contains(degree)) return Error{"degree", integer_message(limits::degree)};
  const Status status = refit(object, [&](FittedCurveObject& changed) { changed.degree = degree; });
  return status ? success() : Status(Error{"degree", status.error().message});
}

Status set_topology(FittedCurveObject& object, Topology topology) {
  const Status status = refit(object, [&](FittedCurveObject& changed) { changed.topology = topology; });
  return status ? success() : Status(Error{"topology", status.error().message});
}

double most_degree(const BSplineCurveObject& object) {
  const auto points = static_cast<double>(object.points.size());
  return object.topology == Topology::closed ? points : points - 1;
}
double most_degree(const FittedCurveObject& object) {
  return object.topology == Topology::closed ? object.count : object.count - 1;
}
/// A closed polygon goes round as often as a degree needs.
double most_degree(const SubdivisionCurveObject& object) {
  return object.topology == Topology::closed ? limits::degree.max : static_cast<double>(object.points.size()) - 1;
}

}  // namespace

int degree_of(const Shape& shape) {
  return with_degree(shape, [](const auto& object) { return object.degree; });
}

Topology topology_of(const Shape& shape) {
  return with_degree(shape, [](const auto& object) { return object.topology; });
}

Limits degree_range(const Shape& shape) {
  const double most = with_degree(shape, [](const auto& object) { return most_degree(object); });
  return {limits::degree.min, std::min(limits::degree.max, most)};
}

Status set_degree(Shape& shape, int degree) {
  return with_degree(shape, [&](auto& object) { return set_degree(object, degree); });
}

Status set_topology(Shape& shape, Topology topology) {
  return with_degree(shape, [&](auto& object) { return set_topology(object, topology); });
}

}  // namespace knotwork::scene
