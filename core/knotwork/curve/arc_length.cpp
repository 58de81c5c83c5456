#include "knotwork/curve/arc_length.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "knotwork/basis/gauss_legendre.h"
#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

/// Of a sum of lengths.
constexpr double length_rounding = 4 * std::numeric_limits<double>::epsilon();
/// Of the length: far below the accuracy promised, since the halves are far better than the whole they are held to.
constexpr double halving_tolerance = 1e-14;
/// A cusp needs 24 halvings; deeper ones are after rounding.
constexpr int most_halvings = 44;
/// Intervals of the table beyond which the rest is taken as it is. Only noise gets there.
constexpr std::size_t most_intervals = 1 << 17;

}  // namespace

double ArcLength::length_between(double from, double to) const {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 0;
  for (const GaussNode& node : gauss_legendre_16) {
    for (const double x : {-node.x, node.x}) {
      std::array<Eigen::Vector3d, 2> c;
      curve_.evaluate(middle + half * x, c);
      sum += node.weight * vector_length(c[1]);
    }
  }
  return half * sum;
}

ArcLength::ArcLength(const CurveView& curve) : ArcLength(curve, curve.start, curve.end) {}

ArcLength::ArcLength(const CurveView& curve, double from, double to) : curve_(curve), parameters_{from}, lengths_{0} {
  // A rule of 16 points sees as much as two cubics.
  const int panels = std::max(1, curve.detail / 8);
  const std::vector<double> ends = piece_ends(from, to, curve.breaks);
  std::vector<double> nodes{from}, wholes;
  double total = 0, size = 0;
  for (std::size_t piece = 1; piece < ends.size(); ++piece) {
    for (int k = 1; k <= panels; ++k) {
      const double next =
          k == panels ? ends[piece] : std::lerp(ends[piece - 1], ends[piece], static_cast<double>(k) / panels);
      wholes.push_back(length_between(nodes.back(), next));
      nodes.push_back(next);
      total += wholes.back();
      size = std::max(size, vector_length(curve(next)));
    }
  }
  const double tolerance = halving_tolerance * total + 4 * length_rounding * size;
  for (std::size_t k = 0; k < wholes.size(); ++k) add(nodes[k], nodes[k + 1], wholes[k], tolerance, 0);
}

void ArcLength::add(double from, double to, double whole, double tolerance, int depth) {
  const double middle = (from + to) / 2;
  const bool divisible = from < middle && middle < to;
  const double left = divisible ? length_between(from, middle) : whole;
  const double right = divisible ? length_between(middle, to) : 0;
  if (!divisible || depth == most_halvings || parameters_.size() > most_intervals ||
      std::abs(left + right - whole) <= tolerance) {
    if (divisible) {
      parameters_.push_back(middle);
      lengths_.push_back(lengths_.back() + left);
    }
    parameters_.push_back(to);
    lengths_.push_back(lengths_.back() + (divisible ? right : whole));
    return;
  }
  add(from, middle, left, tolerance, depth + 1);
  add(middle, to, right, tolerance, depth + 1);
}

double ArcLength::at(double t) const {
  assert(!std::isnan(t));
  if (t <= parameters_.front()) return 0;
  if (t >= parameters_.back()) return length();
  const auto next = std::upper_bound(parameters_.begin(), parameters_.end(), t);
  const std::size_t k = static_cast<std::size_t>(next - parameters_.begin()) - 1;
  return std::min(lengths_[k] + length_between(parameters_[k], t), lengths_[k + 1]);
}

double ArcLength::parameter_at(double s) const {
  assert(!std::isnan(s));
  if (s <= 0) return parameters_.front();
  if (s >= length()) return length() > 0 ? parameters_.back() : parameters_.front();
  const auto next = std::lower_bound(lengths_.begin(), lengths_.end(), s);
  const std::size_t k = static_cast<std::size_t>(next - lengths_.begin()) - 1;
  double low = parameters_[k], high = parameters_[k + 1];
  double t = std::lerp(low, high, (s - lengths_[k]) / (lengths_[k + 1] - lengths_[k]));
  for (double before = length(); low < t && t < high;) {
    const double error = lengths_[k] + length_between(parameters_[k], t) - s;
    if (std::abs(error) <= length_rounding * length()) break;
    (error < 0 ? low : high) = t;
    std::array<Eigen::Vector3d, 2> c;
    curve_.evaluate(t, c);
    // Newton's step while it stays inside and each is half as wrong as the one before; else the middle.
    const double speed = vector_length(c[1]);
    const bool newton = std::abs(error) < before / 2 && std::abs(error) < speed * (high - low);
    const double guess = newton ? t - error / speed : low;
    t = guess > low && guess < high ? guess : (low + high) / 2;
    before = std::abs(error);
  }
  return t;
}

std::vector<double> ArcLength::equidistant(int count) const {
  assert(count >= 1);
  const int arcs = curve_.closed() ? count : count - 1;
  std::vector<double> parameters;
  parameters.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    parameters.push_back(parameter_at(arcs > 0 ? length() * (static_cast<double>(k) / arcs) : 0));
  return parameters;
}

double arc_length(const CurveView& curve, double from, double to) {
  if (from == to) return 0;
  return from < to ? ArcLength(curve, from, to).length() : -ArcLength(curve, to, from).length();
}

double arc_length(const CurveView& curve) { return arc_length(curve, curve.start, curve.end); }

}  // namespace knotwork
