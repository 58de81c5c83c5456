#include "knotwork/scene/fit_edits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "knotwork/scene/curve_edits.h"

namespace knotwork::scene {

CurveFitSettings fit_settings(const FittedCurveObject& object) {
  constexpr double exponents[] = {uniform_exponent, centripetal_exponent, chord_length_exponent};
  CurveFitSettings settings;
  settings.degree = object.degree;
  settings.count = object.count;
  settings.topology = object.topology;
  settings.exponent = exponents[static_cast<std::size_t>(object.parameters)];
  settings.knots = object.knots;
  settings.interpolate_ends = object.topology == Topology::open && object.ends == FitEnds::interpolated;
  settings.smoothing = object.smoothing;
  return settings;
}

Result<CurveFit> build_fit(const FittedCurveObject& object) {
  const int least = least_control_points(object.degree, object.topology);
  if (object.count < least) {
    return Error{"count", std::string(object.topology == Topology::closed ? "A closed" : "An open") +
                              " curve of degree " + std::to_string(object.degree) + " needs at least " +
                              std::to_string(least) + " control points."};
  }
  Result<CurveFit> fit = fit_curve(object.points, fit_settings(object));
  if (!fit && object.parameters != DataParameters::uniform && fit.error().message == "All points are in one place.")
    return Error{"points", "All points are in one place: move one away, or use uniform parameters."};
  return fit;
}

Status check_fit(const FittedCurveObject& object) {
  const Result<CurveFit> fit = build_fit(object);
  return fit ? success() : Status(fit.error());
}

Status set_points(FittedCurveObject& object, std::vector<Eigen::Vector3d> points) {
  if (Status status = check_point_list(points, limits::data_points); !status) return status;
  return refit(object, [&](FittedCurveObject& changed) { changed.points = std::move(points); });
}

Limits control_point_range(const FittedCurveObject& object) {
  const double least = least_control_points(object.degree, object.topology);
  // Smoothing determines more control points than there are data; averaged knots need data for each.
  const bool any = object.smoothing > 0 && object.knots == KnotPlacement::even;
  const double most =
      any ? limits::points.max : std::min(limits::points.max, static_cast<double>(object.points.size()));
  return {least, std::max(least, most)};
}

}  // namespace knotwork::scene
