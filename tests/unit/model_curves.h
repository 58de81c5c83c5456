#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "knotwork/curve/model_curve.h"

namespace knotwork::test {

/// The k-th derivative of amplitude sin(frequency t + phase).
inline double wave(double amplitude, double frequency, double phase, double t, std::size_t k) {
  const double order = static_cast<double>(k);
  return amplitude * std::pow(frequency, order) * std::sin(frequency * t + phase + order * std::numbers::pi / 2);
}

/// The report's model curve, as in oracle 06.
inline ModelCurve report_curve() {
  using std::numbers::pi;
  return {0, 2 * pi, Topology::closed, 16, [](double t, std::span<Eigen::Vector3d> out) {
            for (std::size_t k = 0; k < out.size(); ++k) {
              out[k] = Eigen::Vector3d(wave(1, 1, pi / 2, t, k) + wave(0.5, 3, pi / 2, t, k),
                                       wave(1, 1, 0, t, k) + wave(0.5, 3, -1, t, k),
                                       wave(0.3, 5, 0, t, k) + wave(1, 1, 0, t, k));
            }
          }};
}

/// The open helix (cos t, sin t, t/4) of oracle 06.
inline ModelCurve helix() {
  using std::numbers::pi;
  return {0, 4 * pi, Topology::open, 16, [](double t, std::span<Eigen::Vector3d> out) {
            for (std::size_t k = 0; k < out.size(); ++k) {
              const double rise = k == 0 ? t / 4 : (k == 1 ? 0.25 : 0);
              out[k] = Eigen::Vector3d(wave(1, 1, pi / 2, t, k), wave(1, 1, 0, t, k), rise);
            }
          }};
}

/// The circle of the given radius about the z-axis, run through `frequency` times a unit of t, over one turn.
inline ModelCurve circle(double radius, double frequency) {
  using std::numbers::pi;
  return {0, 2 * pi / frequency, Topology::closed, 16, [=](double t, std::span<Eigen::Vector3d> out) {
            for (std::size_t k = 0; k < out.size(); ++k) {
              out[k] = Eigen::Vector3d(wave(radius, frequency, pi / 2, t, k), wave(radius, frequency, 0, t, k), 0);
            }
          }};
}

/// The polynomial sum_j coefficients[j] t^j on [start, end].
inline ModelCurve polynomial(std::vector<Eigen::Vector3d> coefficients, double start, double end) {
  return {start, end, Topology::open, 16,
          [coefficients = std::move(coefficients)](double t, std::span<Eigen::Vector3d> out) {
            for (std::size_t k = 0; k < out.size(); ++k) {
              out[k].setZero();
              for (std::size_t j = k; j < coefficients.size(); ++j) {
                double factor = std::pow(t, static_cast<double>(j - k));
                for (std::size_t m = 0; m < k; ++m) factor *= static_cast<double>(j - m);
                out[k] += factor * coefficients[j];
              }
            }
          }};
}

}  // namespace knotwork::test
