#include "knotwork/curve/parameterization.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "knotwork/curve/point_check.h"

namespace knotwork {
namespace {

/// Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
bool allowed_parameter(double t) { return std::isfinite(t) && std::abs(t) <= KnotVector::max_knot; }

/// A quarter of the step from `from` to `to`: a difference of any two points, and its norm, stay finite.
Eigen::Vector3d quarter_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return 0.25 * to - 0.25 * from; }

Status check_knot_input(int degree, int count, Topology topology, std::span<const double> parameters, double period) {
  const bool closed = topology == Topology::closed;
  if (degree < 1 || degree > KnotVector::max_degree)
    return Error{"degree", "The degree must lie between 1 and " + std::to_string(KnotVector::max_degree) + "."};
  const int least_count = closed ? std::max(2, degree) : degree + 1;
  if (count < least_count || count > KnotVector::max_count) {
    return Error{"count", "The count must lie between " + std::to_string(least_count) + " and " +
                              std::to_string(KnotVector::max_count) + "."};
  }
  if (parameters.size() < static_cast<std::size_t>(count)) {
    return Error{"parameters", "There are " + std::to_string(parameters.size()) + " parameters for " +
                                   std::to_string(count) + " control points: use no more control points than data."};
  }
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const std::string path = "parameters[" + std::to_string(j) + "]";
    if (!allowed_parameter(parameters[j]))
      return Error{path, "A parameter must be a finite number of reasonable size."};
    if (j > 0 && parameters[j] < parameters[j - 1]) return Error{path, "The parameters must not decrease."};
  }
  if (closed && (!allowed_parameter(period) || !(period > 0)))
    return Error{"period", "The period must be a number of reasonable size above 0."};
  if (closed && parameters.back() - parameters.front() > period) {
    return Error{"parameters[" + std::to_string(parameters.size() - 1) + "]",
                 "The parameters must lie within one period."};
  }
  return success();
}

}  // namespace

Result<std::vector<double>> parameterize(std::span<const Eigen::Vector3d> points, double exponent, Topology topology,
                                         double start, double end) {
  const std::size_t m = points.size();
  if (m < 2) return Error{"points", "There must be at least 2 points."};
  if (Status status = check_points(points); !status) return status.error();
  if (!std::isfinite(exponent) || exponent < 0 || exponent > 1)
    return Error{"exponent", "The exponent of the chord length must lie between 0 and 1."};
  if (!allowed_parameter(start)) return Error{"start", "The start must be a finite number of reasonable size."};
  if (!allowed_parameter(end)) return Error{"end", "The end must be a finite number of reasonable size."};
  if (!(start < end)) return Error{"end", "The end must be greater than the start."};

  const std::size_t chords = topology == Topology::closed ? m : m - 1;
  const auto quarter_chord = [&](std::size_t j) { return quarter_step(points[j], points[(j + 1) % m]); };
  // In units of the longest, chords of any size have squares that neither overflow nor vanish.
  double longest = 0;
  for (std::size_t j = 0; j < chords; ++j) longest = std::max(longest, quarter_chord(j).cwiseAbs().maxCoeff());
  if (longest == 0 && exponent > 0) return Error{"points", "All points are in one place."};

  std::vector<double> parameters(m);
  double sum = 0;
  for (std::size_t j = 0; j < chords; ++j) {
    sum += exponent > 0 ? std::pow((quarter_chord(j) / longest).norm(), exponent) : 1.0;
    if (j + 1 < m) parameters[j + 1] = sum;
  }
  for (double& parameter : parameters) parameter = std::lerp(start, end, parameter / sum);
  return parameters;
}

Result<KnotVector> averaged_knots(int degree, int count, Topology topology, std::span<const double> parameters,
                                  double period) {
  if (Status status = check_knot_input(degree, count, topology, parameters, period); !status) return status.error();
  const int m = static_cast<int>(parameters.size()), p = degree, n = count;
  const bool closed = topology == Topology::closed;
  // x_j; closed, for -m <= j <= 3m.
  const auto x = [&](int j) {
    const int rounds = (j + m) / m - 1;
    return parameters[static_cast<std::size_t>(j - rounds * m)] + rounds * period;
  };
  // x at place whole + numerator / denominator, linearly between x_whole and x_{whole+1}.
  const auto x_between = [&](int place, int numerator, int denominator) {
    if (numerator == 0) return x(place);
    return std::lerp(x(place), x(place + 1), static_cast<double>(numerator) / denominator);
  };
  std::vector<double> knots;
  if (!closed) {
    knots.assign(static_cast<std::size_t>(p) + 1, parameters.front());
    for (int j = 1; j < n - p; ++j) {
      if (m == n) {
        double sum = 0;
        for (int k = j; k < j + p; ++k) sum += x(k);
        knots.push_back(sum / p);
      } else {
        const long long place = static_cast<long long>(j) * m;
        knots.push_back(x_between(static_cast<int>(place / (n - p)) - 1, static_cast<int>(place % (n - p)), n - p));
      }
    }
    knots.insert(knots.end(), static_cast<std::size_t>(p) + 1, parameters.back());
    return KnotVector::make(p, topology, std::move(knots));
  }
  const auto knot = [&](int j) {
    if (m == n && p % 2 == 0) return x_between(j - 1, 1, 2);
    const long long place = static_cast<long long>(j) * m;
    return x_between(static_cast<int>(place / n), static_cast<int>(place % n), n);
  };
  for (int j = -p; j <= n + p; ++j) {
    const int rounds = (j + 2 * n) / n - 2;
    knots.push_back(knot(j - rounds * n) + rounds * period);
  }
  return KnotVector::make(p, topology, std::move(knots));
}

}  // namespace knotwork
