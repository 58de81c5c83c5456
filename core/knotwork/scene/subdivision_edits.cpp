#include "knotwork/scene/subdivision_edits.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "knotwork/scene/curve_edits.h"
#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// Takes a changed object, if it is a good one.
Status take_walk(SubdivisionCurveObject& object, SubdivisionCurveObject changed, const char* path) {
  if (const Status status = check_subdivision(changed); !status) return Error{path, status.error().message};
  object = std::move(changed);
  return success();
}

int least_points(const SubdivisionCurveObject& object) {
  return object.topology == Topology::closed ? 2 : std::max(2, object.degree + 1);
}

/// A level half done begins again, with `before` steps to a level till now.
void begin_level_again(SubdivisionCurveObject& object, int before) {
  object.step = object.step / before * steps_of_level(object);
  object.fraction = 0;
}

}  // namespace

LaneRiesenfeld scheme_of(const SubdivisionCurveObject& object) { return {object.degree, object.topology}; }

int most_levels(const SubdivisionCurveObject& object) {
  const LaneRiesenfeld scheme = scheme_of(object);
  int levels = 0;
  while (levels < static_cast<int>(limits::levels.max) &&
         subdivided_count(scheme, object.points.size(), levels + 1) <= max_vertices) {
    ++levels;
  }
  return levels;
}

Status check_subdivision(const SubdivisionCurveObject& object) {
  const int least = least_points(object);
  if (static_cast<int>(object.points.size()) < least) {
    return Error{"points", std::string(object.topology == Topology::closed ? "A closed" : "An open") +
                               " polygon needs at least " + std::to_string(least) + " points for degree " +
                               std::to_string(object.degree) + "."};
  }
  if (const int most = most_levels(object); object.levels > most) {
    return Error{"levels", "At most " + std::to_string(most) + " levels of " + std::to_string(object.points.size()) +
                               " points keep within " + std::to_string(max_vertices) + " vertices."};
  }
  if (object.step > step_count(object))
    return Error{"step", integer_message({0, static_cast<double>(step_count(object))})};
  if (object.step == step_count(object) && object.fraction != 0)
    return Error{"fraction", "Must be 0 after the last step."};
  return success();
}

Status set_points(SubdivisionCurveObject& object, std::vector<Eigen::Vector3d> points) {
  if (Status status = check_point_list(points, limits::points); !status) return status;
  SubdivisionCurveObject changed = object;
  changed.points = std::move(points);
  return take_walk(object, std::move(changed), "points");
}

Status set_degree(SubdivisionCurveObject& object, int degree) {
  if (!limits::degree.contains(degree)) return Error{"degree", integer_message(limits::degree)};
  SubdivisionCurveObject changed = object;
  changed.degree = degree;
  begin_level_again(changed, steps_of_level(object));
  return take_walk(object, std::move(changed), "degree");
}

Status set_topology(SubdivisionCurveObject& object, Topology topology) {
  SubdivisionCurveObject changed = object;
  changed.topology = topology;
  return take_walk(object, std::move(changed), "topology");
}

Status set_levels(SubdivisionCurveObject& object, int levels) {
  if (!limits::levels.contains(levels)) return Error{"levels", integer_message(limits::levels)};
  SubdivisionCurveObject changed = object;
  changed.levels = levels;
  changed.step = step_count(changed);
  changed.fraction = 0;
  return take_walk(object, std::move(changed), "levels");
}

Status set_step(SubdivisionCurveObject& object, int step) {
  const Limits range{0, static_cast<double>(step_count(object))};
  if (!range.contains(step)) return Error{"step", integer_message(range)};
  object.step = step;
  object.fraction = 0;
  return success();
}

Status set_fraction(SubdivisionCurveObject& object, double fraction) {
  if (!limits::share.contains(fraction)) return Error{"fraction", number_message(limits::share)};
  if (object.step == step_count(object) && fraction != 0)
    return Error{"fraction", "The last step is done: go back to see one on its way."};
  object.fraction = fraction;
  return success();
}

bool walk(SubdivisionCurveObject& object, double seconds) {
  const double end = step_count(object);
  const double start = object.step == step_count(object) ? 0 : object.step + object.fraction;
  const double place = std::min(start + seconds, end);
  object.step = static_cast<int>(place);
  object.fraction = place - object.step;
  return place < end;
}

}  // namespace knotwork::scene
