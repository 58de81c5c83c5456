#include "knotwork/mesh/blending_tables.h"

#include <array>

#include "knotwork/later.h"
#include "knotwork/mesh/texel.h"

namespace knotwork {
namespace {

bool has_polynomials(const BlendingSurface& surface) {
  return surface.shape().kind == LocalSurfaceKind::bezier_hermite;
}

void append_four(std::vector<float>& out, const std::array<double, 4>& x) {
  for (const double value : x) out.push_back(static_cast<float>(value));
}

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
  std::vector<float> table, offsets;
  table.reserve(8 * t.size());
  offsets.reserve(4 * t.size());
  int i = knots.degree();
  for (const double x : t) {
    i = knots.span(x, i);
    const double delta = 1 / (knots[i + 1] - knots[i]);
    const BlendingValue b = blending(translation_and_scaling(knots, 1, i, x));
    append_four(table,
                {b[0], b[1] * delta, static_cast<double>(i - 1), static_cast<double>(twisted ? i : i % knots.count())});
    append_four(offsets, {x - knots[i], x - knots[i + 1], x, 0});
  }
  table.insert(table.end(), offsets.begin(), offsets.end());
  return table;
}

void append_model(BlendingTables& tables, const ModelSurface& model, std::span<const double> u,
                  std::span<const double> v) {
  for (std::vector<float>* table : {&tables.points, &tables.partials_u, &tables.partials_v})
    table->resize(4 * u.size() * v.size());
  std::vector<SurfaceJet> jets(v.size());
  std::size_t texel = 0;
  for (std::size_t a = 0; a < u.size(); ++a) {
    evaluate_grid(model, u.subspan(a, 1), v, jets);
    for (const SurfaceJet& jet : jets) {
      for (int k = 0; k < 3; ++k) {
        const std::size_t at = texel + static_cast<std::size_t>(k);
        tables.points[at] = static_cast<float>(jet.s[k]);
        tables.partials_u[at] = static_cast<float>(jet.su[k]);
        tables.partials_v[at] = static_cast<float>(jet.sv[k]);
      }
      texel += 4;
    }
  }
}

KNOTWORK_LATER std::vector<float> coefficient_table(const BlendingSurface& surface) {
  const MapCounts counts = map_counts(surface);
  const int degree_u = surface.shape().degree_u, degree_v = surface.shape().degree_v;
  std::vector<float> table;
  table.reserve(4 * static_cast<std::size_t>((degree_u + 1) * counts.u * (degree_v + 1) * counts.v));
  for (int i = 0; i < counts.u; ++i) {
    for (int p = 0; p <= degree_u; ++p) {
      for (int j = 0; j < counts.v; ++j) {
        const auto [own_i, own_j] = surface.wrapped(i, j);
        const std::span<const Eigen::Vector3d> own = surface.coefficients(own_i, own_j);
        const bool mirrored_u = surface.twist_v() && j == surface.knots_v().count();
        const bool mirrored_v = surface.twist_u() && i == surface.knots_u().count();
        for (int q = 0; q <= degree_v; ++q) {
          const bool odd = (mirrored_u && p % 2 == 1) != (mirrored_v && q % 2 == 1);
          append_texel(table, (odd ? -1 : 1) * own[static_cast<std::size_t>(p * (degree_v + 1) + q)]);
        }
      }
    }
  }
  return table;
}

}  // namespace

BlendingTables blending_tables(const BlendingSurface& surface, SampleGrid grid) {
  BlendingTables tables;
  const std::vector<double> u = table_parameters(surface.knots_u(), grid.u, surface.twist_u().has_value());
  const std::vector<double> v = table_parameters(surface.knots_v(), grid.v, surface.twist_v().has_value());
  tables.counts = map_counts(surface);
  if (has_polynomials(surface)) {
    tables.degree_u = surface.shape().degree_u;
    tables.degree_v = surface.shape().degree_v;
    tables.coefficients = coefficient_table(surface);
  } else {
    append_model(tables, surface.model(), u, v);
  }
  tables.blend_u = blend_table(surface.knots_u(), surface.blending(), u, surface.twist_u().has_value());
  tables.blend_v = blend_table(surface.knots_v(), surface.blending(), v, surface.twist_v().has_value());
  tables.grid = std::move(grid);
  return tables;
}

MapCounts map_counts(const BlendingSurface& surface) {
  return {surface.knots_u().count() + (surface.twist_u() ? 1 : 0),
          surface.knots_v().count() + (surface.twist_v() ? 1 : 0)};
}

std::vector<float> map_table(const BlendingSurface& surface) {
  std::vector<float> table;
  map_table(surface, table);
  return table;
}

void map_table(const BlendingSurface& surface, std::vector<float>& table) {
  const MapCounts counts = map_counts(surface);
  table.clear();
  table.reserve(12 * static_cast<std::size_t>(counts.u) * static_cast<std::size_t>(counts.v));
  for (int i = 0; i < counts.u; ++i) {
    for (int j = 0; j < counts.v; ++j) {
      const auto [own_i, own_j] = surface.wrapped(i, j);
      const Eigen::Affine3d& own =
          has_polynomials(surface) ? surface.local(own_i, own_j) : surface.model_map(own_i, own_j);
      const Eigen::Matrix4d& map = own.matrix();
      for (int row = 0; row < 3; ++row) append_four(table, {map(row, 0), map(row, 1), map(row, 2), map(row, 3)});
    }
  }
}

}  // namespace knotwork
