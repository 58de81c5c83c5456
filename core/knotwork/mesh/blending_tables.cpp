#include "knotwork/mesh/blending_tables.h"

#include <array>

namespace knotwork {
namespace {

void append_four(std::vector<float>& out, const std::array<double, 4>& x) {
  for (const double value : x) out.push_back(static_cast<float>(value));
}

void append_point(std::vector<float>& out, const Eigen::Vector3d& x) { append_four(out, {x[0], x[1], x[2], 0.0}); }

/// Parameters of a direction as the evaluator sees them: the repeated seam falls on the start.
std::vector<double> reduced(const KnotVector& knots, const std::vector<double>& t) {
  std::vector<double> result;
  result.reserve(t.size());
  for (const double x : t) result.push_back(knots.reduced(x));
  return result;
}

std::vector<float> blend_table(const KnotVector& knots, const BlendingFunction& blending, std::span<const double> t) {
  std::vector<float> table;
  table.reserve(4 * t.size());
  int i = knots.degree();
  for (const double x : t) {
    i = knots.span(x, i);
    const double delta = 1 / (knots[i + 1] - knots[i]);
    const BlendingValue b = blending(translation_and_scaling(knots, 1, i, x));
    append_four(table, {b[0], b[1] * delta, static_cast<double>(i - 1), static_cast<double>(i % knots.count())});
  }
  return table;
}

}  // namespace

BlendingTables blending_tables(const BlendingSurface& surface, int samples_u, int samples_v) {
  SampleGrid grid = sample_grid(surface.knots_u(), surface.knots_v(), samples_u, samples_v, Seam::repeated);
  const std::vector<double> u = reduced(surface.knots_u(), grid.u), v = reduced(surface.knots_v(), grid.v);

  BlendingTables tables;
  tables.columns = static_cast<int>(u.size());
  tables.rows = static_cast<int>(v.size());
  tables.steps_u = grid.steps_u;
  tables.steps_v = grid.steps_v;
  for (std::vector<float>* table : {&tables.points, &tables.partials_u, &tables.partials_v}) {
    table->reserve(4 * u.size() * v.size());
  }
  std::vector<SurfaceJet> jets(v.size());
  for (const double a : u) {
    evaluate_grid(surface.model(), {&a, 1}, v, jets);
    for (const SurfaceJet& jet : jets) {
      append_point(tables.points, jet.s);
      append_point(tables.partials_u, jet.su);
      append_point(tables.partials_v, jet.sv);
    }
  }
  tables.blend_u = blend_table(surface.knots_u(), surface.blending(), u);
  tables.blend_v = blend_table(surface.knots_v(), surface.blending(), v);
  tables.u = std::move(grid.u);
  tables.v = std::move(grid.v);
  return tables;
}

std::vector<float> map_table(const BlendingSurface& surface) {
  std::vector<float> table;
  table.reserve(12 * static_cast<std::size_t>(surface.knots_u().count()) *
                static_cast<std::size_t>(surface.knots_v().count()));
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    for (int j = 0; j < surface.knots_v().count(); ++j) {
      const Eigen::Matrix4d& map = surface.model_map(i, j).matrix();
      for (int row = 0; row < 3; ++row) append_four(table, {map(row, 0), map(row, 1), map(row, 2), map(row, 3)});
    }
  }
  return table;
}

}  // namespace knotwork
