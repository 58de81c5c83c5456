#include "knotwork/mesh/blending_tables.h"

#include <array>

namespace knotwork {
namespace {

void append_four(std::vector<float>& out, const std::array<double, 4>& x) {
  for (const double value : x) out.push_back(static_cast<float>(value));
}

void append_point(std::vector<float>& out, const Eigen::Vector3d& x) { append_four(out, {x[0], x[1], x[2], 0.0}); }

/// Parameters of a direction as the tables see them. The repeated seam falls on the start; a twisted one stays at the
/// end, where the vertices of the other direction are not reflected.
std::vector<double> table_parameters(const KnotVector& knots, std::span<const double> t, bool twisted) {
  std::vector<double> result;
  result.reserve(t.size());
  for (const double x : t) result.push_back(twisted ? x : knots.reduced(x));
  return result;
}

std::vector<float> blend_table(const KnotVector& knots, const BlendingFunction& blending, std::span<const double> t,
                               bool twisted) {
  std::vector<float> table;
  table.reserve(4 * t.size());
  int i = knots.degree();
  for (const double x : t) {
    i = knots.span(x, i);
    const double delta = 1 / (knots[i + 1] - knots[i]);
    const BlendingValue b = blending(translation_and_scaling(knots, 1, i, x));
    append_four(table,
                {b[0], b[1] * delta, static_cast<double>(i - 1), static_cast<double>(twisted ? i : i % knots.count())});
  }
  return table;
}

}  // namespace

bool tables_follow_maps(const BlendingSurface& surface) {
  return surface.shape().kind == LocalSurfaceKind::bezier_hermite;
}

BlendingTables blending_tables(const BlendingSurface& surface, int samples_u, int samples_v) {
  SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), samples_u, samples_v, Seam::repeated);
  BlendingTables tables;
  tables.columns = static_cast<int>(grid.u.size());
  tables.rows = static_cast<int>(grid.v.size());
  tables.steps_u = grid.steps_u;
  tables.steps_v = grid.steps_v;
  for (std::vector<float>* table : {&tables.points, &tables.partials_u, &tables.partials_v}) {
    table->reserve(4 * grid.u.size() * grid.v.size());
  }
  const std::vector<double> u = table_parameters(surface.knots_u(), grid.u, surface.twist_u().has_value());
  const std::vector<double> v = table_parameters(surface.knots_v(), grid.v, surface.twist_v().has_value());
  const bool whole = tables_follow_maps(surface);
  std::vector<SurfaceJet> jets(grid.v.size());
  for (std::size_t a = 0; a < grid.u.size(); ++a) {
    for (std::size_t b = 0; b < grid.v.size(); ++b) {
      jets[b] = whole ? surface.evaluate(grid.u[a], grid.v[b]) : evaluate(surface.model(), u[a], v[b]);
    }
    for (const SurfaceJet& jet : jets) {
      append_point(tables.points, jet.s);
      append_point(tables.partials_u, jet.su);
      append_point(tables.partials_v, jet.sv);
    }
  }
  tables.blend_u = blend_table(surface.knots_u(), surface.blending(), u, surface.twist_u().has_value());
  tables.blend_v = blend_table(surface.knots_v(), surface.blending(), v, surface.twist_v().has_value());
  tables.u = std::move(grid.u);
  tables.v = std::move(grid.v);
  return tables;
}

MapCounts map_counts(const BlendingSurface& surface) {
  return {surface.knots_u().count() + (surface.twist_u() ? 1 : 0),
          surface.knots_v().count() + (surface.twist_v() ? 1 : 0)};
}

std::vector<float> map_table(const BlendingSurface& surface) {
  const MapCounts counts = map_counts(surface);
  std::vector<float> table;
  table.reserve(12 * static_cast<std::size_t>(counts.u) * static_cast<std::size_t>(counts.v));
  for (int i = 0; i < counts.u; ++i) {
    for (int j = 0; j < counts.v; ++j) {
      const auto [own_i, own_j] = surface.wrapped(i, j);
      const Eigen::Matrix4d map =
          tables_follow_maps(surface) ? Eigen::Matrix4d::Identity() : surface.model_map(own_i, own_j).matrix();
      for (int row = 0; row < 3; ++row) append_four(table, {map(row, 0), map(row, 1), map(row, 2), map(row, 3)});
    }
  }
  return table;
}

}  // namespace knotwork
