#include "knotwork/mesh/fitted_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "knotwork/scene/model_figure.h"
#include "unit/even_grid.h"
#include "unit/grid_stray.h"

namespace knotwork::fitted_grid_test {
namespace {

double same_everywhere(const void* about, const Eigen::Vector3d& /*centre*/, double /*radius*/) {
  return *static_cast<const double*>(about);
}

template <class Surface>
FittedSteps fitted(const Surface& surface, double tolerance, int most = 4000000) {
  return fitted_steps(knotted_surface(surface), {&tolerance, same_everywhere}, most);
}

template <class Surface>
SampleGrid grid_with(const Surface& surface, const GridSteps& steps) {
  return sample_grid(surface.knots_u(), surface.knots_v(), steps, Seam::repeated);
}

BlendingSurface pulled_torus() {
  const ModelSurface model = torus_surface(1, 0.4, 0.4);
  const SurfaceDomain over = domain(model);
  const KnotVector u = KnotVector::uniform(1, 6, Topology::closed, over.u.start, over.u.end).value();
  const KnotVector v = KnotVector::uniform(1, 4, Topology::closed, over.v.start, over.v.end).value();
  BlendingSurface surface =
      BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(model, u, v))
          .value();
  surface.set_local(
      2, 1, Eigen::Translation3d(0, 0.4, 0.6) * surface.local(2, 1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  return surface;
}

int vertices(const SampleGrid& grid) { return grid.columns() * grid.rows(); }

}  // namespace

TEST_CASE("fitted grid: triangles stay within the tolerance, whatever it is") {
  const BlendingSurface surface = pulled_torus();
  for (const double tolerance : {0.05, 0.01, 2e-3}) {
    CAPTURE(tolerance);
    const FittedSteps found = fitted(surface, tolerance);
    CHECK(found.within_tolerance);
    const double stray = test::grid_stray(surface, grid_with(surface, found.steps));
    CHECK(stray < tolerance);
    CHECK(stray > tolerance / 12);  // nor are there many more than needed
  }
}

TEST_CASE("fitted grid: a fourth of the tolerance takes twice as many steps a direction") {
  const BlendingSurface surface = pulled_torus();
  const auto sum = [](const std::vector<int>& steps) { return std::accumulate(steps.begin(), steps.end(), 0.0); };
  // So fine that smoothness asks for no more than shape does.
  const GridSteps coarse = fitted(surface, 4e-4).steps, fine = fitted(surface, 1e-4).steps;
  CHECK(std::abs(sum(fine.u) / sum(coarse.u) - 2) < 0.3);
  CHECK(std::abs(sum(fine.v) / sum(coarse.v) - 2) < 0.3);
}

TEST_CASE("fitted grid: it takes fewer vertices than an even grid that is as good") {
  const BlendingSurface surface = pulled_torus();
  const SampleGrid found = grid_with(surface, fitted(surface, 4e-3).steps);
  const double reached = test::grid_stray(surface, found);
  int samples = 12;
  while (test::grid_stray(surface, test::grid_of(surface, samples, samples * 2 / 3)) > reached) samples += samples / 4;
  const int even = vertices(test::grid_of(surface, samples, samples * 2 / 3));
  MESSAGE("vertices: " << vertices(found) << " fitted, " << even << " even");
  CHECK(vertices(found) < 0.75 * even);
}

TEST_CASE("fitted grid: every surface of the catalogue, and what is wrong is seen") {
  for (const scene::ModelRow& row : scene::model_kinds()) {
    CAPTURE(row.id);
    const scene::ModelFigure figure(scene::make_model(row.kind));
    const SampleGrid coarse = test::grid_of(figure, 8, 8);
    const double size = test::grid_size(figure, coarse), tolerance = 2e-3 * size;
    const FittedSteps found = fitted(figure, tolerance);
    CHECK(found.within_tolerance);
    CHECK(test::grid_stray(figure, grid_with(figure, found.steps)) < tolerance);
    // The check itself would notice a grid that is too coarse.
    if (row.id == "torus" || row.id == "sphere") CHECK(test::grid_stray(figure, coarse) > tolerance);
  }
}

TEST_CASE("fitted grid: nothing is spent where nobody looks, little where it is flat") {
  const BlendingSurface surface = pulled_torus();
  const double nowhere = std::numeric_limits<double>::infinity();
  const GridSteps unseen = fitted(surface, nowhere).steps;
  CHECK(unseen.u == std::vector<int>(6, 1));
  CHECK(unseen.v == std::vector<int>(4, 1));

  // Only the part with x > 0 is looked at.
  const auto half = [](const void* about, const Eigen::Vector3d& centre, double radius) {
    return centre.x() + radius > 0 ? *static_cast<const double*>(about) : std::numeric_limits<double>::infinity();
  };
  const double tolerance = 1e-3;
  const GridSteps steps = fitted_steps(knotted_surface(surface), {&tolerance, half}, 4000000).steps;
  CHECK(*std::min_element(steps.u.begin(), steps.u.end()) == 1);
  CHECK(*std::max_element(steps.u.begin(), steps.u.end()) > 8);

  const ModelSurface plane = make_catalogue_surface("plane").value();
  for (const int steps_u : fitted(scene::ModelFigure(plane), 1.0).steps.u) CHECK(steps_u == 1);
}

TEST_CASE("fitted grid: no more vertices than allowed, and it says so") {
  const BlendingSurface surface = pulled_torus();
  for (const int most : {100, 5000, 100000}) {
    const FittedSteps found = fitted(surface, 1e-7, most);
    CHECK_FALSE(found.within_tolerance);
    CHECK(vertices(grid_with(surface, found.steps)) <= most);
    CHECK(vertices(grid_with(surface, found.steps)) > most / 4);
  }
  // Round a closed direction three at least, even where nobody looks.
  const Interval round = domain(torus_surface(1, 0.4, 0.4)).u;
  const KnotVector one = KnotVector::uniform(1, 2, Topology::closed, round.start, round.end).value();
  const BlendingSurface two =
      BlendingSurface::make(torus_surface(1, 0.4, 0.4), one, one,
                            BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(torus_surface(1, 0.4, 0.4), one, one))
          .value();
  CHECK(fitted(two, std::numeric_limits<double>::infinity()).steps == GridSteps{{2, 1}, {2, 1}});
}

TEST_CASE("fitted grid: a twisted seam meets as many steps on both of its sides") {
  std::vector<int> closed{1, 2, 3, 4, 5}, open{6, 1, 2, 8};
  make_symmetric(closed, 3);  // 0-2, 1, 3-4
  CHECK(closed == std::vector<int>{3, 2, 3, 5, 5});
  make_symmetric(open, 4);
  CHECK(open == std::vector<int>{8, 2, 2, 8});
}

}  // namespace knotwork::fitted_grid_test
