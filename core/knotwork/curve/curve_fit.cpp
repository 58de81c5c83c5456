#include "knotwork/curve/curve_fit.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace knotwork {
namespace {

/// Known before any parameter is: the sentence is then about points, which is what a reader gave.
Status check_number_of_points(std::size_t points, const CurveFitSettings& settings) {
  if (points < 2) return Error{"points", "There must be at least 2 points."};
  const bool averaged = settings.knots == KnotPlacement::averaged;
  if (averaged && points < static_cast<std::size_t>(settings.count)) {
    return Error{"points", "There are " + std::to_string(points) + " points for " + std::to_string(settings.count) +
                               " control points: averaged knots need at least as many points; use even knots, or fewer "
                               "control points."};
  }
  return success();
}

Result<KnotVector> knots_for(const CurveFitSettings& settings, std::span<const double> parameters, double end) {
  if (settings.knots == KnotPlacement::even)
    return KnotVector::uniform(settings.degree, settings.count, settings.topology, 0, end);
  Result<KnotVector> knots = averaged_knots(settings.degree, settings.count, settings.topology, parameters, end);
  if (!knots && knots.error().path.starts_with("knots")) {
    return Error{"knots",
                 "So many neighbouring points coincide that averaged knots do, too: use even knots, uniform "
                 "parameters or fewer control points."};
  }
  return knots;
}

}  // namespace

int least_control_points(int degree, Topology topology) {
  return topology == Topology::closed ? std::max(2, degree) : degree + 1;
}

Result<CurveFit> fit_curve(std::span<const Eigen::Vector3d> points, const CurveFitSettings& settings) {
  const bool closed = settings.topology == Topology::closed;
  const double end = static_cast<double>(settings.count) - (closed ? 0.0 : settings.degree);
  // Degree and count first: without them there is no domain to have parameters in.
  if (Result<KnotVector> even = KnotVector::uniform(settings.degree, settings.count, settings.topology, 0, end); !even)
    return even.error();
  if (Status status = check_number_of_points(points.size(), settings); !status) return status.error();
  Result<std::vector<double>> parameters = parameterize(points, settings.exponent, settings.topology, 0, end);
  if (!parameters) return parameters.error();
  const Result<KnotVector> knots = knots_for(settings, parameters.value(), end);
  if (!knots) return knots.error();
  Result<LeastSquaresFit> fit =
      fit_least_squares(knots.value(), points, parameters.value(),
                        {.interpolate_ends = settings.interpolate_ends, .smoothing = settings.smoothing});
  if (!fit) return fit.error();
  return CurveFit{std::move(fit).value(), std::move(parameters).value()};
}

std::vector<CurveFitError> fit_errors(std::span<const Eigen::Vector3d> points, CurveFitSettings settings, int most) {
  std::vector<CurveFitError> errors;
  for (int n = least_control_points(settings.degree, settings.topology); n <= most; ++n) {
    settings.count = n;
    if (const Result<CurveFit> fit = fit_curve(points, settings))
      errors.push_back({n, fit.value().fit.rms, fit.value().fit.maximum});
  }
  return errors;
}

}  // namespace knotwork
