#include "web/surface_textures.h"

#include <algorithm>

namespace knotwork::web {
namespace {

/// Texels of `grid` for a direction: the sample's place counted in knot intervals; the first sample of the interval that
/// is counted so.
int add_lines(std::span<float> row, const std::vector<int>& starts, bool parted) {
  int finest = 1;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    const int steps = starts[k + 1] - starts[k] - (parted && k + 2 < starts.size() ? 1 : 0);
    finest = std::max(finest, steps);
    for (int step = 0; step <= steps; ++step)
      row[4 * static_cast<std::size_t>(starts[k] + step)] =
          static_cast<float>(k) + static_cast<float>(step) / static_cast<float>(steps);
  }
  for (std::size_t k = 0; k < starts.size(); ++k) row[4 * k + 1] = static_cast<float>(starts[k]);
  return finest;
}

}  // namespace

/// New texels, into the texture that is there where its size is the same.
void SurfaceTextures::set(Table table, int width, int height, std::span<const float> texels) {
  const glm::ivec2 size{width, height};
  if (tables_[table] && sizes_[table] == size)
    update_float_texture(tables_[table], size, texels);
  else
    tables_[table] = make_float_texture(width, height, texels);
  sizes_[table] = size;
  uploaded_bytes_ += 4.0 * static_cast<double>(texels.size());
}

template <class Tables>
void SurfaceTextures::begin(Kind kind, const Tables& tables) {
  if (kind != kind_) tables_ = {};  // what the last one has left behind is of no use
  kind_ = kind;
  upload(tables.grid);
}

void SurfaceTextures::upload(const SampleGrid& lines) {
  columns_ = lines.columns();
  rows_ = lines.rows();
  intervals_ = {static_cast<int>(lines.starts_u.size()) - 1, static_cast<int>(lines.starts_v.size()) - 1};
  const int width = std::max(columns_, rows_);
  std::vector<float> texels(8 * static_cast<std::size_t>(width));
  finest_steps_ = {add_lines(std::span(texels).first(texels.size() / 2), lines.starts_u, lines.parted),
                   add_lines(std::span(texels).last(texels.size() / 2), lines.starts_v, lines.parted)};
  set(grid, width, 2, texels);
}

void SurfaceTextures::upload(const BlendingTables& tables) {
  begin(tables.coefficients.empty() ? Kind::sub_surfaces : Kind::polynomials, tables);
  degrees_ = {tables.degree_u, tables.degree_v};
  if (kind_ == Kind::sub_surfaces) {
    set(points, rows_, columns_, tables.points);
    set(partials_u, rows_, columns_, tables.partials_u);
    set(partials_v, rows_, columns_, tables.partials_v);
  } else {
    const MapCounts& counts = tables.counts;
    set(coefficients, counts.v * (tables.degree_v + 1), counts.u * (tables.degree_u + 1), tables.coefficients);
  }
  set(blend_u, columns_, 2, tables.blend_u);
  set(blend_v, rows_, 2, tables.blend_v);
}

void SurfaceTextures::upload(const NetTables& tables) {
  begin(Kind::net, tables);
  degrees_ = {tables.degree_u, tables.degree_v};
  set(blend_u, columns_, tables.degree_u + 2, tables.basis_u);
  set(blend_v, rows_, tables.degree_v + 2, tables.basis_v);
}

void SurfaceTextures::upload(const SurfaceTables& tables) {
  begin(Kind::evaluated, tables);
  set(points, rows_, columns_, tables.points);
  set(partials_u, rows_, columns_, tables.normals);
}

void SurfaceTextures::upload_maps(const std::vector<float>& texels, int locals_u, int locals_v) {
  set(maps, 3 * locals_v, locals_u, texels);
}

void SurfaceTextures::upload_net(const std::vector<float>& texels, int rows, int columns) {
  set(points, columns, rows, texels);
}

void SurfaceTextures::upload_hues(std::span<const glm::vec3> colours, int rows, int columns) {
  std::vector<float> texels;
  texels.reserve(colours.size() * 4);
  for (const glm::vec3& lab : colours) texels.insert(texels.end(), {lab.x, lab.y, lab.z, 0.0F});
  set(hues, columns, rows, texels);
}

void SurfaceTextures::upload_curvature(std::span<const double> values) {
  std::vector<float> texels(4 * values.size());
  for (std::size_t k = 0; k < values.size(); ++k) texels[4 * k] = static_cast<float>(values[k]);
  set(curvature, rows_, columns_, texels);
}

void SurfaceTextures::bind(GlState& state, const DrawProgram& program) const {
  constexpr std::array<const char*, table_count> samplers{"u_points",  "u_partials_u", "u_partials_v", "u_blend_u",
                                                          "u_blend_v", "u_maps",       "u_hues",       "u_coefficients",
                                                          "u_grid",    "u_curvature"};
  for (GLuint unit = 0; unit < table_count; ++unit) {
    // What this surface has no use for must still be a texture.
    state.bind(unit, tables_[unit] ? tables_[unit] : tables_[hues]);
    program.set(samplers[unit], static_cast<int>(unit));
  }
  program.set("u_kind", static_cast<int>(kind_));
  program.set("u_degrees", degrees_);
  program.set("u_intervals", intervals_);
}

void SurfaceTextures::bind_sheets(GlState& state, const DrawProgram& program, const SheetDirections& directions) const {
  bind(state, program);
  program.set("u_steps", finest_steps_);
  program.set("u_last", glm::ivec2(columns_ - 1, rows_ - 1));
  program.set("u_closed", directions.closed);
  program.set("u_period", directions.period);
  program.set("u_mirror", directions.mirror);
}

void SurfaceTextures::abandon() {
  for (Texture& table : tables_) table.abandon();
  *this = SurfaceTextures();
}

}  // namespace knotwork::web
