#include "knotwork/mesh/fitted_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace knotwork {
namespace {

constexpr double safety = 1.2;
constexpr int most_steps = 512;       // in an interval
constexpr int most_looks = 4;         // a direction in an interval
constexpr int looks_altogether = 96;  // a direction; one an interval at least
constexpr double smooth_edge = 64;    // tolerances
constexpr double most_for_smoothness = 12;

int looks_in(const std::vector<Interval>& intervals) {
  return std::clamp(looks_altogether / static_cast<int>(intervals.size()), 1, most_looks);
}

/// In the middle of equal parts of each interval.
std::vector<double> places(const std::vector<Interval>& intervals, int looks) {
  std::vector<double> t;
  t.reserve(intervals.size() * static_cast<std::size_t>(looks));
  for (const Interval& interval : intervals)
    for (int k = 0; k < looks; ++k) t.push_back(std::lerp(interval.start, interval.end, (k + 0.5) / looks));
  return t;
}

/// The length of x off the direction of `along`.
double off(const Eigen::Vector3d& x, const Eigen::Vector3d& along) {
  const double square = along.squaredNorm();
  return square > 0 ? (x - x.dot(along) / square * along).norm() : x.norm();
}

/// What counts of a cell, at its worst: how it bends over one whole interval each way, and how long its lines are.
struct Cell {
  double bend_u = 0, bend_v = 0, twist = 0, length_u = 0, length_v = 0;

  void look(const SurfaceJet& jet, double width_u, double width_v) {
    bend_u = std::max(bend_u, off(jet.suu, jet.su) * width_u * width_u);
    bend_v = std::max(bend_v, off(jet.svv, jet.sv) * width_v * width_v);
    const Eigen::Vector3d normal = jet.su.cross(jet.sv);
    const double size = normal.norm();
    twist = std::max(twist, (size > 0 ? std::abs(jet.suv.dot(normal)) / size : jet.suv.norm()) * width_u * width_v);
    length_u = std::max(length_u, jet.su.norm() * width_u);
    length_v = std::max(length_v, jet.sv.norm() * width_v);
  }
};

/// (L h^2 + M h k) / 8 <= tolerance / 2, and long edges divided for smoothness.
double needed(double bend, double twist, double length, double tolerance) {
  const double for_shape = std::sqrt(safety * (bend + twist) / (4 * tolerance));
  const double for_smoothness = std::min(length / (smooth_edge * tolerance), most_for_smoothness);
  return std::max(for_shape, for_smoothness);
}

/// The least of 1, 2, 3, 4, 6, 8, 12, ... that is no less.
int rounded_up(double steps) {
  int power = 1;
  while (power < most_steps && power < steps) {
    if (power >= 2 && 1.5 * power >= steps) return power + power / 2;
    power *= 2;
  }
  return power;
}

std::vector<int> rounded_up(const std::vector<double>& needs, double share, bool closed) {
  std::vector<int> steps;
  steps.reserve(needs.size());
  for (const double need : needs) steps.push_back(rounded_up(need * share));
  // Round a closed direction three at least.
  for (std::size_t k = 0; closed && std::accumulate(steps.begin(), steps.end(), 0) < 3; k = (k + 1) % steps.size())
    ++steps[k];
  return steps;
}

double vertices(const GridSteps& steps) {
  const auto sum = [](const std::vector<int>& counts) {
    return 1.0 + std::accumulate(counts.begin(), counts.end(), 0);
  };
  return sum(steps.u) * sum(steps.v);
}

}  // namespace

FittedSteps fitted_steps(const KnottedSurface& surface, GridTolerance tolerance, int most_vertices) {
  const std::vector<Interval> over_u = knot_intervals(*surface.knots_u), over_v = knot_intervals(*surface.knots_v);
  const int looks_u = looks_in(over_u), looks_v = looks_in(over_v);
  const std::vector<double> v = places(over_v, looks_v);
  std::vector<double> needs_u(over_u.size(), 1), needs_v(over_v.size(), 1);
  std::vector<SurfaceJet> jets(static_cast<std::size_t>(looks_u) * v.size());
  for (std::size_t a = 0; a < over_u.size(); ++a) {
    const std::vector<double> u = places({over_u[a]}, looks_u);
    surface.evaluate_grid(u, v, jets);
    for (std::size_t b = 0; b < over_v.size(); ++b) {
      Cell cell;
      Eigen::Vector3d low = jets[b * static_cast<std::size_t>(looks_v)].s, high = low;
      for (int k = 0; k < looks_u * looks_v; ++k) {
        const auto row = static_cast<std::size_t>(k / looks_v), column = static_cast<std::size_t>(k % looks_v);
        const SurfaceJet& jet = jets[row * v.size() + b * static_cast<std::size_t>(looks_v) + column];
        cell.look(jet, over_u[a].end - over_u[a].start, over_v[b].end - over_v[b].start);
        low = low.cwiseMin(jet.s);
        high = high.cwiseMax(jet.s);
      }
      // From the outermost places to the cell's edges it is half as far as between two of them.
      const double edge = 0.5 * std::hypot(cell.length_u / looks_u, cell.length_v / looks_v);
      const double allowed = tolerance((low + high) / 2, (high - low).norm() / 2 + edge);
      if (!std::isfinite(allowed)) continue;
      needs_u[a] = std::max(needs_u[a], needed(cell.bend_u, cell.twist, cell.length_u, allowed));
      needs_v[b] = std::max(needs_v[b], needed(cell.bend_v, cell.twist, cell.length_v, allowed));
    }
  }
  const auto shared = [&](double share) {
    return GridSteps{rounded_up(needs_u, share, surface.knots_u->closed()),
                     rounded_up(needs_v, share, surface.knots_v->closed())};
  };
  FittedSteps fitted{shared(1), true};
  for (double share = 0.8; vertices(fitted.steps) > most_vertices && share > 1e-9; share *= 0.8)
    fitted = {shared(share), false};
  const auto capped = [](double need) { return need > most_steps; };
  fitted.within_tolerance &=
      std::none_of(needs_u.begin(), needs_u.end(), capped) && std::none_of(needs_v.begin(), needs_v.end(), capped);
  return fitted;
}

void make_symmetric(std::vector<int>& steps, int mirror) {
  const int count = static_cast<int>(steps.size());
  for (int k = 0; k < count; ++k) {
    const int other = ((mirror - 1 - k) % count + count) % count;
    int &a = steps[static_cast<std::size_t>(k)], &b = steps[static_cast<std::size_t>(other)];
    a = b = std::max(a, b);
  }
}

}  // namespace knotwork
