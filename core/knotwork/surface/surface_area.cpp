#include "knotwork/surface/surface_area.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/gauss_legendre.h"
#include "knotwork/curve/parametric_curve.h"
#include "knotwork/curve/vector_length.h"

namespace knotwork {
namespace {

constexpr double area_tolerance = 1e-13;
constexpr std::size_t most_quarters = 4096;

struct AreaCell {
  Interval u, v;
  double area, error;
};

double cell_area(const SurfaceView& surface, const Interval& u, const Interval& v) {
  const double middle_u = (u.start + u.end) / 2, half_u = (u.end - u.start) / 2;
  const double middle_v = (v.start + v.end) / 2, half_v = (v.end - v.start) / 2;
  double sum = 0;
  for (const GaussNode& a : gauss_legendre_16) {
    for (const GaussNode& b : gauss_legendre_16) {
      for (const double x : {-a.x, a.x}) {
        for (const double y : {-b.x, b.x}) {
          const SurfaceJet jet = surface.evaluate(middle_u + half_u * x, middle_v + half_v * y);
          sum += a.weight * b.weight * vector_length(jet.su.cross(jet.sv));
        }
      }
    }
  }
  return half_u * half_v * sum;
}

bool less_wrong(const AreaCell& a, const AreaCell& b) { return a.error < b.error; }

}  // namespace

SurfaceArea surface_area(const SurfaceView& surface) {
  const std::vector<double> u = piece_ends(surface.domain.u.start, surface.domain.u.end, surface.breaks_u);
  const std::vector<double> v = piece_ends(surface.domain.v.start, surface.domain.v.end, surface.breaks_v);
  // A heap: the cell with the largest error is in front. A cell not yet cut may be all wrong.
  std::vector<AreaCell> cells;
  for (std::size_t i = 1; i < u.size(); ++i) {
    for (std::size_t j = 1; j < v.size(); ++j) {
      const Interval side_u{u[i - 1], u[i]}, side_v{v[j - 1], v[j]};
      const double area = cell_area(surface, side_u, side_v);
      cells.push_back({side_u, side_v, area, area});
    }
  }
  std::make_heap(cells.begin(), cells.end(), less_wrong);
  const std::size_t most_cells = 4 * cells.size() + most_quarters;
  for (;;) {
    // Summed afresh: differences of sums would collect rounding.
    double area = 0, error = 0;
    for (const AreaCell& cell : cells) area += cell.area, error += cell.error;
    if (error <= area_tolerance * area || cells.size() > most_cells) return {area, error};

    // As many at a time as are worth it, so that the sums do not cost more than the surface.
    for (std::size_t count = 1 + cells.size() / 8; count > 0 && cells.front().error > 0; --count) {
      std::pop_heap(cells.begin(), cells.end(), less_wrong);
      const AreaCell whole = cells.back();
      cells.pop_back();
      const double mid_u = (whole.u.start + whole.u.end) / 2, mid_v = (whole.v.start + whole.v.end) / 2;
      double sum = 0;
      for (const Interval& side_u : {Interval{whole.u.start, mid_u}, Interval{mid_u, whole.u.end}}) {
        for (const Interval& side_v : {Interval{whole.v.start, mid_v}, Interval{mid_v, whole.v.end}}) {
          cells.push_back({side_u, side_v, cell_area(surface, side_u, side_v), 0});
          sum += cells.back().area;
        }
      }
      for (std::size_t k = cells.size() - 4; k < cells.size(); ++k) {
        cells[k].error = std::abs(whole.area - sum) / 4;
        std::push_heap(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(k) + 1, less_wrong);
      }
    }
  }
}

}  // namespace knotwork
