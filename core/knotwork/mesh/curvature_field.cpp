#include "knotwork/mesh/curvature_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

constexpr double usual_share = 0.95;  // of the values, which the scale has to hold
constexpr double least_bend = 0.1;    // times the size of the surface
constexpr double largest = 1e30;      // so that scale and values are floats

}  // namespace

double round_up_to_125(double x) {
  assert(x > 0);
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0})
    if (x <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

CurvatureField curvature_field(const KnottedSurface& surface, const SampleGrid& grid, CurvatureKind kind) {
  CurvatureField field;
  field.values.reserve(grid.u.size() * grid.v.size());
  Eigen::AlignedBox3d box;
  // A strip of columns at a time bounds the memory of the jets.
  constexpr std::size_t jets_at_once = 16384;
  const std::size_t rows = grid.v.size(), strip = std::clamp<std::size_t>(jets_at_once / rows, 1, grid.u.size());
  std::vector<SurfaceJet> jets(strip * rows);
  for (std::size_t first = 0; first < grid.u.size(); first += strip) {
    const std::span<const double> u = std::span(grid.u).subspan(first, std::min(strip, grid.u.size() - first));
    const std::span<SurfaceJet> made = std::span(jets).first(u.size() * rows);
    surface.evaluate_grid(u, grid.v, made);
    for (const SurfaceJet& jet : made) {
      box.extend(jet.s);
      const SurfaceCurvature curved = curvature(jet);
      const double value = kind == CurvatureKind::gaussian ? curved.gaussian : curved.mean;
      field.values.push_back(std::isfinite(value) ? std::clamp(value, -largest, largest) : 0);
    }
  }

  std::vector<double> sizes;
  sizes.reserve(field.values.size());
  for (const double value : field.values) sizes.push_back(std::abs(value));
  const auto usual = sizes.begin() + static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), usual, sizes.end());
  const double size = std::max(box.diagonal().norm(), 1e-12);
  field.scale = round_up_to_125(std::max(*usual, least_bend / (kind == CurvatureKind::gaussian ? size * size : size)));
  return field;
}

}  // namespace knotwork
