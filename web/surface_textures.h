#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "knotwork/mesh/blending_tables.h"
#include "knotwork/mesh/net_tables.h"
#include "knotwork/mesh/surface_tables.h"
#include "web/gl_state.h"
#include "web/sheet_directions.h"

namespace knotwork::web {

/// The surface on the stage as shaders/blending.glsl reads it: the static part of a blending surface or a B-spline surface
/// with what moves it and its hues, or an evaluated surface's points and normals. Each upload replaces what it
/// is about.
class SurfaceTextures {
 public:
  /// New topology, resolution or model.
  void upload(const BlendingTables& tables);
  void upload(const NetTables& tables);
  /// A surface evaluated on the CPU.
  void upload(const SurfaceTables& tables);
  /// The moving part of a blending surface: 12 floats a local.
  void upload_maps(const std::vector<float>& texels, int locals_u, int locals_v);
  /// The moving part of a B-spline surface: x y z 0 a control point.
  void upload_net(const std::vector<float>& texels, int rows, int columns);
  /// OKLab of the hue of each local or control point, or of an evaluated surface.
  void upload_hues(std::span<const glm::vec3> hues, int rows, int columns);

  /// A curvature at each vertex of the grid uploaded last; it stays until there is another one.
  void upload_curvature(std::span<const double> values);

  /// Binds the textures and sets what else blending.glsl asks for. Precondition: the program is in use.
  void bind(GlState& state, const DrawProgram& program) const;
  /// The same with what sheet.glsl asks for. Precondition: has_locals().
  void bind_sheets(GlState& state, const DrawProgram& program, const SheetDirections& directions) const;
  /// Whether all parts are there.
  bool complete() const { return columns_ > 0 && tables_[hues] && tables_[has_locals() ? maps : points]; }
  /// Whether there are local patches to show.
  bool has_locals() const { return kind_ <= Kind::polynomials; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Steps in the finest knot interval each way.
  glm::ivec2 finest_steps() const { return finest_steps_; }
  /// Since start.
  double uploaded_bytes() const { return uploaded_bytes_; }
  /// The context is gone: forgets every GL name without touching GL.
  void abandon();

 private:
  enum class Kind : unsigned char { sub_surfaces, polynomials, net, evaluated };  ///< the shader's u_kind
  enum Table : unsigned char {
    points,
    partials_u,
    partials_v,
    blend_u,
    blend_v,
    maps,
    hues,
    coefficients,
    grid,
    curvature,
    table_count
  };

  template <class Tables>
  void begin(Kind kind, const Tables& tables);
  void upload(const SampleGrid& lines);
  void set(Table table, int width, int height, std::span<const float> texels);

  Kind kind_ = Kind::sub_surfaces;
  std::array<Texture, table_count> tables_;
  std::array<glm::ivec2, table_count> sizes_{};
  glm::ivec2 finest_steps_{1}, intervals_{1}, degrees_{-1};
  int columns_ = 0, rows_ = 0;
  double uploaded_bytes_ = 0;
};

}  // namespace knotwork::web
