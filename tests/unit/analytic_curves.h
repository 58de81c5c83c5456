#pragma once

// Curves and surfaces with known measures, and random splines.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/curve/parametric_curve.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork::test {

/// c(t) = origin + t drift + sum of amplitude cos(frequency t + phase): circles, helices, ellipses, the report's curve.
struct WaveCurve {
  struct Wave {
    Eigen::Vector3d amplitude;
    double frequency, phase;
  };
  std::vector<Wave> waves;
  double start, end;
  Topology topology = Topology::closed;
  Eigen::Vector3d drift = Eigen::Vector3d::Zero(), origin = Eigen::Vector3d::Zero();

  void evaluate(double t, std::span<Eigen::Vector3d> out) const {
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = k == 0 ? Eigen::Vector3d(origin + t * drift) : k == 1 ? drift : Eigen::Vector3d::Zero();
      for (const Wave& wave : waves) {
        const double x = wave.frequency * t + wave.phase;
        // cos x and its derivatives without their factor.
        const double turned[4] = {std::cos(x), -std::sin(x), -std::cos(x), std::sin(x)};
        out[k] += turned[k % 4] * std::pow(wave.frequency, static_cast<double>(k)) * wave.amplitude;
      }
    }
  }
  CurveView view() const { return curve_view(*this, start, end, topology); }
};

inline constexpr double sine = -std::numbers::pi / 2;  ///< the phase that makes a cosine a sine
inline constexpr double round = 2 * std::numbers::pi;

/// (cos t + cos 3t / 2, sin t + sin(3t-1)/2, sin t + 3 sin 5t / 10).
inline WaveCurve report_model() {
  return {{{{1, 0, 0}, 1, 0},
           {{0.5, 0, 0}, 3, 0},
           {{0, 1, 1}, 1, sine},
           {{0, 0.5, 0}, 3, -1 + sine},
           {{0, 0, 0.3}, 5, sine}},
          0,
          round};
}
/// (a cos t, b sin t, c t).
inline WaveCurve helix(double a, double b, double c, double turns) {
  return {{{{a, 0, 0}, 1, 0}, {{0, b, 0}, 1, sine}},
          0,
          turns * round,
          c == 0 ? Topology::closed : Topology::open,
          {0, 0, c}};
}
inline WaveCurve circle(double radius) { return helix(radius, radius, 0, 1); }

/// (radius cos u cos v, radius sin u cos v, radius sin v).
inline SurfaceJet sphere(double radius, double u, double v) {
  const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v);
  const auto point = [&](double x, double y, double z) { return Eigen::Vector3d(radius * x, radius * y, radius * z); };
  return {point(cu * cv, su * cv, sv),  point(-su * cv, cu * cv, 0), point(-cu * sv, -su * sv, cv),
          point(-cu * cv, -su * cv, 0), point(su * sv, -cu * sv, 0), point(-cu * cv, -su * cv, -sv)};
}

inline Eigen::Vector3d random_point(std::mt19937& random, double size = 5) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(random), y = coordinate(random);
  return {x, y, coordinate(random)};
}

/// A B-spline curve with random points and random knots, some of them repeated.
inline BSplineCurve random_spline(int degree, int count, Topology topology, std::mt19937& random) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(random_point(random));
  if (topology == Topology::closed)
    return BSplineCurve::make(KnotVector::uniform(degree, count, topology, 0, count).value(), std::move(points))
        .value();
  std::uniform_real_distribution<double> place(0, 6);
  for (;;) {
    std::vector<double> inner;
    inner.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count - degree - 1; ++i)
      inner.push_back(degree > 1 && i % 3 == 2 ? inner.back() : place(random));
    std::sort(inner.begin(), inner.end());
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    knots.insert(knots.end(), inner.begin(), inner.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 6.0);
    const Result<KnotVector> vector = KnotVector::make(degree, topology, std::move(knots));
    if (vector) return BSplineCurve::make(vector.value(), std::move(points)).value();
  }
}

/// A turn and a move.
struct RigidMotion {
  Eigen::Matrix3d turn;
  Eigen::Vector3d move;
};
inline RigidMotion random_motion(std::mt19937& random) {
  const Eigen::Vector3d axis = random_point(random).normalized();
  return {Eigen::AngleAxisd(random_point(random).x(), axis).toRotationMatrix(), random_point(random)};
}

}  // namespace knotwork::test
