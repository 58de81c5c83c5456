#include "knotwork/scene/subdivision_figure.h"

#include <algorithm>
#include <utility>

#include "knotwork/scene/subdivision_edits.h"

namespace knotwork::scene {

namespace {

/// Levels beyond are measured only when the walk goes there: a drag measures at each move.
constexpr std::size_t readily_measured = std::size_t{1} << 13;
/// Below, rounding is all that is left to be seen.
constexpr int most_measured = 12;

double distance_from(const BSplineCurve& limit, const LaneRiesenfeld& scheme, std::size_t count, int level,
                     const std::vector<Eigen::Vector3d>& polygon) {
  std::vector<double> parameters;
  std::vector<std::size_t> vertices;
  for (std::size_t j = 0; j < polygon.size(); ++j) {
    const double t = vertex_parameter(scheme, count, level, j);
    if (t < limit.knots().start() || t > limit.knots().end()) continue;
    parameters.push_back(t);
    vertices.push_back(j);
  }
  std::vector<Eigen::Vector3d> points(parameters.size());
  limit.evaluate(parameters, 0, points);
  double maximum = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    maximum = std::max(maximum, (points[k] - polygon[vertices[k]]).norm());
  return maximum;
}

std::vector<SubdivisionFigure::LevelDistance> distances_of(const SubdivisionCurveObject& object,
                                                           const BSplineCurve& limit) {
  const LaneRiesenfeld scheme = scheme_of(object);
  std::vector<SubdivisionFigure::LevelDistance> distances;
  std::vector<Eigen::Vector3d> polygon = object.points;
  const int most = most_levels(object);
  for (int level = 0;; ++level) {
    distances.push_back({level, distance_from(limit, scheme, object.points.size(), level, polygon)});
    const bool readily =
        level < most_measured && subdivided_count(scheme, object.points.size(), level + 1) <= readily_measured;
    if (level == most || (level >= object.levels && !readily)) return distances;
    polygon = subdivide(scheme, polygon, 1).value();
  }
}

}  // namespace

SubdivisionFigure::SubdivisionFigure(const SubdivisionCurveObject& object)
    : level(object.step / steps_of_level(object)),
      pass(object.step % steps_of_level(object)),
      closed(object.topology == Topology::closed),
      limit_shown(object.limit),
      points(object.points),
      polygon(subdivide(scheme_of(object), object.points, level).value()),
      doubled(pass == 1 && object.fraction == 0),
      limit(limit_curve(scheme_of(object), object.points).value(), 0),
      distances(distances_of(object, limit.curve)) {
  if (pass >= 1) polygon = split_points(polygon);
  for (int k = 1; k < pass; ++k) polygon = averaged_points(polygon, object.topology);
  // The split moves nothing: only averages are on a way.
  if (object.fraction == 0 || pass == 0) return;
  std::vector<Eigen::Vector3d> averages = averaged_points(polygon, object.topology);
  for (std::size_t i = 0; i < averages.size(); ++i)
    averages[i] = (1 - object.fraction) * polygon[i] + object.fraction * averages[i];
  polygon = std::move(averages);
}

}  // namespace knotwork::scene
