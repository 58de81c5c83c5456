#include "knotwork/scene/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace knotwork::scene {

namespace {

constexpr int steps_a_turn = 256, fewest_steps = 256, most_steps = 6144, halvings = 5;
constexpr int box_steps = 64;

/// The distance of p from the segment from a to b.
double off_chord(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const Eigen::Vector3d chord = b - a;
  const double length2 = chord.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - a).dot(chord) / length2, 0.0, 1.0) : 0.0;
  return (p - a - share * chord).norm();
}

struct Halving {
  const CurveView& curve;
  double tolerance;
  std::vector<double>& parameters;

  /// Adds what lies between, and `to`.
  void add(double from, const Eigen::Vector3d& a, double to, const Eigen::Vector3d& b, int depth) {
    const double middle = std::midpoint(from, to);
    const Eigen::Vector3d m = curve(middle);
    const auto strays = [&](double share) { return off_chord(a, b, curve(std::lerp(from, to, share))) > tolerance; };
    // The middle alone may lie on the chord by symmetry.
    if (depth > 0 && (off_chord(a, b, m) > tolerance || strays(0.28) || strays(0.72))) {
      add(from, a, middle, m, depth - 1);
      add(middle, m, to, b, depth - 1);
    } else {
      parameters.push_back(to);
    }
  }
};

}  // namespace

CurveView view_of(const CatalogueCurve& curve) {
  const Interval where = domain(curve);
  const auto function = [](const void* self, double t, std::span<Eigen::Vector3d> out) {
    evaluate(*static_cast<const CatalogueCurve*>(self), t, out);
  };
  return {&curve, function, where.start, where.end, curve_catalogue()[static_cast<std::size_t>(curve.row)].topology};
}

std::vector<double> drawing_parameters(const CurveView& curve, double from, double to, int least, double tolerance) {
  std::vector<double> parameters{from};
  Halving halving{curve, tolerance, parameters};
  double start = from;
  Eigen::Vector3d a = curve(from);
  for (int k = 1; k <= least; ++k) {
    const double end = k == least ? to : std::lerp(from, to, static_cast<double>(k) / least);
    const Eigen::Vector3d b = curve(end);
    halving.add(start, a, end, b, halvings);
    start = end;
    a = b;
  }
  return parameters;
}

double drawn_size(const CurveView& curve) {
  Eigen::Vector3d low = curve(curve.start), high = low;
  for (int k = 1; k <= box_steps; ++k) {
    const Eigen::Vector3d point = curve(std::lerp(curve.start, curve.end, static_cast<double>(k) / box_steps));
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return std::max((high - low).norm() / 2, 1e-12);
}

int least_steps(const CatalogueCurve& curve) {
  const CatalogueCurveRow& row = curve_catalogue()[static_cast<std::size_t>(curve.row)];
  const Interval where = domain(curve);
  // The catalogue's parameters are angles, except on the line and the arc, whose standard steps are enough at any speed.
  const bool by_angle = row.id != "arc" && row.id != "line";
  const double turns = by_angle ? (where.end - where.start) / (2 * std::numbers::pi) : 1;
  return static_cast<int>(
      std::clamp(std::ceil(steps_a_turn * turns), static_cast<double>(fewest_steps), static_cast<double>(most_steps)));
}

}  // namespace knotwork::scene
