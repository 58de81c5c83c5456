#include "web/surface_textures.h"

namespace knotwork::web {

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
  columns_ = tables.columns;
  rows_ = tables.rows;
  steps_ = {tables.steps_u, tables.steps_v};
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

void SurfaceTextures::bind(GlState& state, const DrawProgram& program) const {
  constexpr std::array<const char*, table_count> samplers{
      "u_points", "u_partials_u", "u_partials_v", "u_blend_u", "u_blend_v", "u_maps", "u_hues", "u_coefficients"};
  for (GLuint unit = 0; unit < table_count; ++unit) {
    // What this surface has no use for must still be a texture.
    state.bind(unit, tables_[unit] ? tables_[unit] : tables_[hues]);
    program.set(samplers[unit], static_cast<int>(unit));
  }
  program.set("u_kind", static_cast<int>(kind_));
  program.set("u_degrees", degrees_);
}

void SurfaceTextures::abandon() {
  for (Texture& table : tables_) table.abandon();
  const double bytes = uploaded_bytes_;
  *this = SurfaceTextures();
  uploaded_bytes_ = bytes;
}

}  // namespace knotwork::web
