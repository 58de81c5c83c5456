#include "web/stage_grid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "knotwork/mesh/fitted_grid.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr double most_stray = 0.5;     // CSS pixels
constexpr double busy_pause_ms = 250;  // between two looks while something moves
constexpr double nearly_all = 0.9;     // of the most vertices

/// The sides of what the view sees: n . x + d >= 0 inside, n of unit length.
std::array<glm::dvec4, 4> sides_of(const View& view) {
  const glm::dmat4 rows = glm::transpose(view.projection * view.view);
  std::array<glm::dvec4, 4> sides{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
  for (glm::dvec4& side : sides) side /= glm::length(glm::dvec3(side));
  return sides;
}

struct OnScreen {
  const View& view;
  std::array<glm::dvec4, 4> sides;
};

/// Half a pixel at the nearest place of a ball.
double tolerance_on_screen(const void* about, const Eigen::Vector3d& centre, double radius) {
  const auto& [view, sides] = *static_cast<const OnScreen*>(about);
  const glm::dvec3 at = to_glm(centre);
  for (const glm::dvec4& side : sides)
    if (glm::dot(glm::dvec3(side), at) + side.w < -radius) return std::numeric_limits<double>::infinity();
  if (glm::dot(at - view.eye, view.forward) < -radius) return std::numeric_limits<double>::infinity();
  return most_stray * view.pixel_size(at - radius * view.forward);
}

bool same_view(const View& a, const View& b) {
  return a.view == b.view && a.projection == b.projection && a.viewport.width == b.viewport.width &&
         a.viewport.height == b.viewport.height;
}

double vertices(const GridSteps& steps) {
  return std::accumulate(steps.u.begin(), steps.u.end(), 1.0) * std::accumulate(steps.v.begin(), steps.v.end(), 1.0);
}

bool finer_somewhere(const std::vector<int>& a, const std::vector<int>& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] > b[k]) return true;
  return false;
}

GridSteps finest_of(GridSteps a, const GridSteps& b) {
  for (std::size_t k = 0; k < a.u.size(); ++k) a.u[k] = std::max(a.u[k], b.u[k]);
  for (std::size_t k = 0; k < a.v.size(); ++k) a.v[k] = std::max(a.v[k], b.v[k]);
  return a;
}

/// Whether steps that are wanted are worth new tables.
bool worth_changing(const GridSteps& from, const GridSteps& to) {
  if (from.u.size() != to.u.size() || from.v.size() != to.v.size()) return true;
  if (finer_somewhere(to.u, from.u) || finer_somewhere(to.v, from.v)) return true;
  return 2 * vertices(to) < vertices(from);
}

}  // namespace

GridSteps steps_on_screen(const Figure& figure, const View& view) {
  const OnScreen screen{view, sides_of(view)};
  GridSteps steps = fitted_steps(*surface_of(figure), {&screen, tolerance_on_screen}, StageGrid::most_vertices).steps;
  if (const auto* blending = std::get_if<BlendingFigure>(&figure)) {
    if (blending->surface.twist_u()) make_symmetric(steps.v, blending->surface.twist_u()->mirror);
    if (blending->surface.twist_v()) make_symmetric(steps.u, blending->surface.twist_v()->mirror);
  }
  return steps;
}

bool StageGrid::choose(const Look& look) {
  put_off_ = false;
  if (look.fitted && may_fit_) return fit(look);
  if (!look.other_grid && !fitted_) return false;
  fitted_ = false;
  const KnottedSurface surface = *surface_of(look.figure);
  steps_ = even_steps(*surface.knots_u, *surface.knots_v, look.samples_u, look.samples_v);
  return true;
}

bool StageGrid::fit(const Look& look) {
  const bool must = look.other_grid || !fitted_;
  const bool same = !look.changed && fitted_view_ && same_view(*fitted_view_, look.view);
  if (!must && same && (look.busy || !kept_)) return false;
  put_off_ = !must && look.busy && look.now - fitted_at_ < busy_pause_ms;
  if (put_off_) {
    if (look.changed) fitted_view_.reset();
    return false;
  }
  // What is as fine as may be cannot be refined while something moves.
  if (!must && look.busy && vertices(steps_) > nearly_all * most_vertices) {
    fitted_view_.reset();
    return false;
  }
  fitted_view_ = look.view;
  fitted_at_ = look.now;
  GridSteps wanted = steps_on_screen(look.figure, look.view);
  // What moves asks for now this, now that: it keeps what it has had, so that after a while nothing is made anew.
  kept_ = look.busy && !must;
  if (kept_) {
    GridSteps both = finest_of(wanted, steps_);
    if (vertices(both) <= most_vertices) wanted = std::move(both);
  }
  if (!must && !worth_changing(steps_, wanted)) return false;
  fitted_ = true;
  steps_ = std::move(wanted);
  return true;
}

SampleGrid StageGrid::grid(const Figure& figure, bool parted) const {
  const KnottedSurface surface = *surface_of(figure);
  SampleGrid grid = sample_grid(*surface.knots_u, *surface.knots_v, steps_, Seam::repeated);
  return parted ? parted_at_knots(std::move(grid), *surface.knots_u, *surface.knots_v) : grid;
}

}  // namespace knotwork::web
