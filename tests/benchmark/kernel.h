#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/lane_riesenfeld.h"

namespace knotwork::benchmark {

/// One row of the table: what is timed, and how its results are held to a readable reference.
struct Kernel {
  std::string name;
  /// What one run computes so many of: the program prints the time for each.
  std::size_t items;
  std::function<void()> run;
  /// After a run: the largest difference from the reference, relative to the size of the numbers.
  std::function<double()> error;
  /// With its reason where it is not the 1e-13 of an evaluator.
  double tolerance = 1e-13;
};

/// The rows of the program: each program has its own.
std::vector<Kernel> all_kernels();

/// Each file's rows.
std::vector<Kernel> curve_kernels();
std::vector<Kernel> fitting_kernels();
std::vector<Kernel> surface_kernels();
std::vector<Kernel> measure_kernels();

/// Points on a wavy way round the origin, of size 2.
inline std::vector<Eigen::Vector3d> wavy_points(std::size_t count) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 0.7 * static_cast<double>(k);
    points.emplace_back(std::cos(x) + 0.3 * std::sin(3.1 * x), std::sin(x), std::cos(1.7 * x));
  }
  return points;
}

/// Sorted parameters over [start, end), not on knots.
inline std::vector<double> parameters(double start, double end, std::size_t count) {
  std::vector<double> t;
  for (std::size_t k = 0; k < count; ++k)
    t.push_back(start + (end - start) * ((static_cast<double>(k) + 0.37) / static_cast<double>(count)));
  return t;
}

/// The same in an order that jumps about: 1009 is prime and divides no count that is used here.
inline std::vector<double> shuffled(const std::vector<double>& sorted) {
  std::vector<double> t;
  for (std::size_t k = 0; k < sorted.size(); ++k) t.push_back(sorted[k * 1009 % sorted.size()]);
  return t;
}

/// max |a - b|, relative to max |b|, over lists of the same length; infinite when they are not, or with a NaN.
inline double difference(std::span<const Eigen::Vector3d> actual, std::span<const Eigen::Vector3d> expected) {
  if (actual.size() != expected.size() || actual.empty()) return HUGE_VAL;
  double error = 0, size = 0;
  for (std::size_t k = 0; k < actual.size(); ++k) {
    const double apart = (actual[k] - expected[k]).norm();
    if (!(apart <= error)) error = std::isnan(apart) ? HUGE_VAL : apart;
    size = std::max(size, expected[k].norm());
  }
  return error / size;
}

/// Subdivision as it is defined, a split and one average after the other: what subdivide() is held to, bit for bit.
inline std::vector<Eigen::Vector3d> subdivided_by_passes(const LaneRiesenfeld& scheme,
                                                         std::vector<Eigen::Vector3d> points, int levels) {
  for (int level = 0; level < levels; ++level) {
    points = split_points(points);
    for (int pass = 0; pass < scheme.degree; ++pass) points = averaged_points(points, scheme.topology);
  }
  return points;
}

}  // namespace knotwork::benchmark
