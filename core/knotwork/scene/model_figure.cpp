#include "knotwork/scene/model_figure.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knotwork::scene {

namespace {

constexpr int cells_wanted = 320, least_cells = 6, most_cells = 48;
constexpr std::size_t measured_steps = 24;

std::vector<double> even_steps(const Interval& range) {
  std::vector<double> t;
  for (std::size_t k = 0; k <= measured_steps; ++k)
    t.push_back(std::lerp(range.start, range.end, static_cast<double>(k) / measured_steps));
  return t;
}

/// How much longer the u-lines are than the v-lines, all together.
double aspect(const ModelSurface& model, const SurfaceDomain& where) {
  const std::vector<double> u = even_steps(where.u), v = even_steps(where.v);
  std::vector<SurfaceJet> jets(u.size() * v.size());
  evaluate_grid(model, u, v, jets);
  const auto at = [&](std::size_t a, std::size_t b) -> const Eigen::Vector3d& { return jets[a * v.size() + b].s; };
  double along_u = 0, along_v = 0;
  for (std::size_t a = 0; a < u.size(); ++a) {
    for (std::size_t b = 0; b < v.size(); ++b) {
      if (a > 0) along_u += (at(a, b) - at(a - 1, b)).norm();
      if (b > 0) along_v += (at(a, b) - at(a, b - 1)).norm();
    }
  }
  return along_v > 0 ? along_u / along_v : 1;
}

KnotVector lines(const Interval& range, Closure closure, double wanted) {
  const int pairs = static_cast<int>(std::lround(std::clamp(wanted, 1.0 * least_cells, 1.0 * most_cells) / 2));
  const bool closed = closure == Closure::closed;
  return KnotVector::uniform(1, closed ? 2 * pairs : 2 * pairs + 1, closed ? Topology::closed : Topology::open,
                             range.start, range.end)
      .value();
}

}  // namespace

ModelFigure::ModelFigure(const ModelSurface& model)
    : model_(model),
      knots_u_(lines(domain(model).u, domain(model).closure_u, std::sqrt(cells_wanted * aspect(model, domain(model))))),
      knots_v_(
          lines(domain(model).v, domain(model).closure_v, std::sqrt(cells_wanted / aspect(model, domain(model))))) {}

bool ModelFigure::one_sided() const {
  const SurfaceDomain where = domain(model_);
  return where.closure_u == Closure::twisted || where.closure_v == Closure::twisted;
}

}  // namespace knotwork::scene
