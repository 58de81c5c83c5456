#include "web/stage_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "knotwork/scene/chapters.h"
#include "unit/grid_stray.h"
#include "web/vectors.h"

namespace knotwork::web::stage_grid_test {
namespace {

constexpr Viewport viewport{1200, 800};

struct Start {
  scene::Document document;
  Figure figure;
};
Start start_of(std::string_view chapter) {
  scene::Document document = scene::find_chapter(chapter)->start_document();
  Figure figure = make_figure(scene::stage_shape(document), document.animation);
  return {std::move(document), std::move(figure)};
}

/// How far the surface strays from its triangles on the screen, of what is in the picture.
double stray_on_screen(const Figure& figure, const SampleGrid& grid, const View& view) {
  double most = 0;
  const KnottedSurface surface = *surface_of(figure);
  test::each_stray(surface, grid, [&](double distance, const Eigen::Vector3d& place) {
    const auto at = view.project(to_glm(place));
    if (!at || at->x < 0 || at->y < 0 || at->x > viewport.width || at->y > viewport.height) return;
    most = std::max(most, distance / view.pixel_size(to_glm(place)));
  });
  return most;
}

SampleGrid fitted_grid(const Figure& figure, const View& view) {
  const KnottedSurface surface = *surface_of(figure);
  return sample_grid(*surface.knots_u, *surface.knots_v, steps_on_screen(figure, view), Seam::repeated);
}

}  // namespace

TEST_CASE("stage grid: surfaces stay within half a pixel, from afar and close by") {
  for (const std::string_view chapter : {"blending-surface", "tensor-surface", "model-surface"}) {
    const Start start = start_of(chapter);
    for (const double nearer : {0.25, 1.0, 2.0}) {
      CAPTURE(chapter);
      CAPTURE(nearer);
      scene::Camera camera = start.document.camera;
      camera.distance /= nearer;
      const View view = make_view(camera, viewport);
      const SampleGrid grid = fitted_grid(start.figure, view);
      const double stray = stray_on_screen(start.figure, grid, view);
      MESSAGE(grid.columns() << " x " << grid.rows() << ", " << stray << " pixels");
      CHECK(stray < 0.5);
      CHECK(stray > 0);
      CHECK(grid.columns() * grid.rows() <= StageGrid::most_vertices);
    }
  }
}

TEST_CASE("stage grid: far away takes fewer vertices than close by, and nothing is spent on what is not seen") {
  const Start start = start_of("blending-surface");
  const auto vertices = [&](double distance, const Eigen::Vector3d& target) {
    const SampleGrid grid = fitted_grid(start.figure, make_view({target, distance, -1.0, 0.5}, viewport));
    return grid.columns() * grid.rows();
  };
  const Eigen::Vector3d middle = start.document.camera.target;
  CHECK(vertices(40, middle) < vertices(5, middle) / 3);
  CHECK(vertices(5, Eigen::Vector3d(200, 200, 0)) <= 7 * 5);
}

TEST_CASE("stage grid: a surface with a twisted seam has as many steps on both of its sides") {
  Start start = start_of("blending-surface");
  scene::BlendingSurfaceObject& object = scene::blending_surface(start.document);
  object.model = make_catalogue_surface("moebius").value();
  object.topology_u = Topology::open;
  object.topology_v = Topology::closed;
  REQUIRE(check(start.document));
  const Figure figure = make_figure(scene::stage_shape(start.document), start.document.animation);
  const BlendingSurface& surface = std::get_if<BlendingFigure>(&figure)->surface;
  REQUIRE(surface.twist_v());
  const GridSteps steps = steps_on_screen(figure, make_view({{1, 0.5, 0}, 3, -1.0, 0.5}, viewport));
  const int count = static_cast<int>(steps.u.size());
  for (int k = 0; k < count; ++k)
    CHECK(steps.u[static_cast<std::size_t>(k)] ==
          steps.u[static_cast<std::size_t>((surface.twist_v()->mirror - 1 - k + count) % count)]);
}

TEST_CASE("stage grid: tables are made anew when they must be, when it pays, and not while a hand is busy") {
  const Start start = start_of("blending-surface");
  const View near_view = make_view(start.document.camera, viewport);
  scene::Camera away = start.document.camera;
  away.distance *= 6;
  const View far_view = make_view(away, viewport);
  scene::Camera beside = start.document.camera;
  beside.azimuth += 1e-3;
  const View beside_view = make_view(beside, viewport);
  StageGrid grid;
  const auto look = [&](const View& view, bool fitted, double now, bool busy = false, bool other = false) {
    return grid.choose({.figure = start.figure,
                        .samples_u = 60,
                        .samples_v = 40,
                        .fitted = fitted,
                        .view = view,
                        .other_grid = other,
                        .changed = false,
                        .busy = busy,
                        .now = now});
  };
  // Before the second part is here there are the document's samples.
  CHECK(look(near_view, true, 0, false, true));
  CHECK(grid.grid(start.figure).columns() == 61);
  CHECK_FALSE(look(near_view, true, 10));
  grid.allow_fitting();
  CHECK(look(near_view, true, 20));
  const int fitted = grid.grid(start.figure).columns();
  CHECK(fitted != 61);
  CHECK_FALSE(look(near_view, true, 30));
  CHECK_FALSE(look(beside_view, true, 40));  // hardly another view
  CHECK_FALSE(grid.wants_another_look());

  // A hand is busy: not at once, but soon.
  CHECK_FALSE(look(far_view, true, 60, true));
  CHECK(grid.wants_another_look());
  CHECK_FALSE(look(far_view, true, 400, true));  // coarser will do, but what moves keeps what it has
  CHECK_FALSE(grid.wants_another_look());
  CHECK(grid.grid(start.figure).columns() == fitted);
  // Let go, it is looked at without delay.
  CHECK(look(far_view, true, 410));
  CHECK(grid.grid(start.figure).columns() < fitted);
  CHECK_FALSE(look(near_view, true, 420, true));
  CHECK(look(near_view, true, 800, true));  // finer is taken over while a hand is busy too
  CHECK(grid.grid(start.figure).columns() == fitted);

  // Back to the document's own.
  CHECK(look(near_view, false, 500));
  CHECK(grid.grid(start.figure).columns() == 61);
  CHECK_FALSE(look(near_view, false, 510));
}

}  // namespace knotwork::web::stage_grid_test
