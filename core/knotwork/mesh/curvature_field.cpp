#include "knotwork/mesh/curvature_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "knotwork/surface/surface_measures.h"

namespace knotwork {
namespace {

constexpr double usual_share = 0.95;  // of the area, whose values the scale has to hold
constexpr double least_bend = 0.1;    // times the size of the surface
constexpr double largest = 1e30;      // so that scale and values are floats

/// A vertex: the size of its value, and the area that it stands for.
struct Sized {
  double value, area;
};

/// What the values stay within on that share of the area; 0 where there is no area.
double usual(std::span<Sized> vertices) {
  double left = 0;
  for (const Sized& vertex : vertices) left += usual_share * vertex.area;
  if (!(left > 0)) return 0;
  // The half in which the share ends, again and again.
  while (vertices.size() > 1) {
    const std::size_t half = vertices.size() / 2;
    std::nth_element(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(half), vertices.end(),
                     [](const Sized& a, const Sized& b) { return a.value < b.value; });
    double below = 0;
    for (const Sized& vertex : vertices.first(half)) below += vertex.area;
    if (below >= left) {
      vertices = vertices.first(half);
    } else {
      left -= below;
      vertices = vertices.subspan(half);
    }
  }
  return vertices.front().value;
}

/// Half the way from the vertex before to the one behind.
double width(std::span<const double> t, std::size_t k) {
  return 0.5 * (t[std::min(k + 1, t.size() - 1)] - t[k > 0 ? k - 1 : 0]);
}

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
  std::vector<Sized> vertices;
  vertices.reserve(grid.u.size() * rows);
  for (std::size_t first = 0; first < grid.u.size(); first += strip) {
    const std::span<const double> u = std::span(grid.u).subspan(first, std::min(strip, grid.u.size() - first));
    const std::span<SurfaceJet> made = std::span(jets).first(u.size() * rows);
    surface.evaluate_grid(u, grid.v, made);
    for (const SurfaceJet& jet : made) {
      box.extend(jet.s);
      const SurfaceCurvature curved = curvature(jet);
      const double value = kind == CurvatureKind::gaussian ? curved.gaussian : curved.mean;
      const std::size_t place = field.values.size();
      field.values.push_back(std::isfinite(value) ? std::clamp(value, -largest, largest) : 0);
      const double area = jet.su.cross(jet.sv).norm() * width(grid.u, place / rows) * width(grid.v, place % rows);
      vertices.push_back({std::abs(field.values.back()), std::isfinite(area) ? area : 0});
    }
  }

  const double size = std::max(box.diagonal().norm(), 1e-12);
  field.scale =
      round_up_to_125(std::max(usual(vertices), least_bend / (kind == CurvatureKind::gaussian ? size * size : size)));
  return field;
}

}  // namespace knotwork
