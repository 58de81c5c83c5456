#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "knotwork/mesh/blending_tables.h"
#include "knotwork/mesh/net_tables.h"
#include "knotwork/mesh/surface_tables.h"
#include "knotwork/scene/document.h"
#include "web/camera.h"
#include "web/sheet_directions.h"
#include "web/theme.h"

namespace knotwork::web {

/// A segment of constant width on the screen.
struct Ribbon {
  glm::vec3 start, end;
  glm::vec4 colour;  ///< sRGB, alpha not multiplied in
  float width;       ///< CSS pixels
};

/// A handle or knob that faces the reader.
struct Disc {
  glm::vec3 centre;
  float radius;    ///< CSS pixels
  glm::vec4 fill;  ///< sRGB; its opacity is the whole disc's, and 0 leaves the rim alone
  glm::vec3 rim;
  float rim_width;  ///< CSS pixels
};

/// The floor that the surface throws its shadow on.
struct Floor {
  double x = 0, y = 0, height = -1, half_size = 4;
};

/// One picture of the stage: plain values, ready to be uploaded and drawn.
struct Picture {
  View view;
  glm::dvec3 target{0};  ///< what the camera turns about
  Theme theme;
  scene::Display display;
  bool surface = false;        ///< the tables uploaded last are shown
  double curvature_scale = 1;  ///< where the colours of the curvature uploaded last end
  Floor floor;
  int locals_u = 1, locals_v = 1;  ///< of the maps uploaded last
  SheetDirections sheets;
  std::optional<scene::PatchIndex> held;  ///< its own sheet is shown
  /// What is lit of the surface, in intervals of its knot lines: u from, to, v from, to. A closed direction goes round.
  std::optional<glm::vec4> support;
  glm::vec2 knot_period{0};             ///< number of intervals of a closed direction, 0 of an open one
  bool one_sided = false;               ///< both sides look the same: which is the back depends on where one began
  std::vector<Ribbon> ribbons;          ///< frames, normals, curves in this order: hidden by the surface
  std::vector<Ribbon> hidden_ribbons;   ///< drawn only where the surface hides them
  std::vector<Ribbon> overlay_ribbons;  ///< the gizmo: faint where hidden
  std::vector<Disc> discs, overlay_discs;

  /// Empty again; the lists keep their memory.
  void clear() {
    Picture empty;
    for (std::vector<Ribbon> Picture::*list :
         {&Picture::ribbons, &Picture::hidden_ribbons, &Picture::overlay_ribbons}) {
      (this->*list).clear();
      (empty.*list).swap(this->*list);
    }
    for (std::vector<Disc> Picture::*list : {&Picture::discs, &Picture::overlay_discs}) {
      (this->*list).clear();
      (empty.*list).swap(this->*list);
    }
    *this = std::move(empty);
  }
};

/// Counted over a frame (draw calls, state changes, vertices; without the interface's) and since start (bytes).
struct RendererStats {
  int draw_calls = 0;
  int state_changes = 0;  ///< of program, vertex array, texture, target, blending and depth
  std::int64_t vertices = 0;
  double upload_bytes = 0;
};

class GlState;

/// Draws pictures with WebGL2. Nothing but its own files (gl_objects, gl_state, draw_program, surface_textures) and ImGui's
/// backend speaks GL.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Makes programs and buffers in the current context; empty, or the log of what failed to compile.
  std::string prepare();
  /// The context is gone: forgets every GL name without touching GL.
  void abandon();

  // What SurfaceTextures has, with the indices of the grid.
  void upload(const BlendingTables& tables);
  void upload(const NetTables& tables);
  void upload(const SurfaceTables& tables);
  void upload_maps(const std::vector<float>& texels, int locals_u, int locals_v);
  void upload_net(const std::vector<float>& texels, int rows, int columns);
  void upload_hues(std::span<const glm::vec3> hues, int rows, int columns);
  void upload_curvature(std::span<const double> values);

  /// Begins the frame's counts and draws the picture over the whole canvas.
  void draw(const Picture& picture);
  RendererStats stats() const;

 private:
  struct Resources;
  template <class Tables>
  void upload_tables(const Tables& tables);
  void draw_background(GlState& state, const Picture& picture);
  void draw_shadow(GlState& state, const Picture& picture);
  void draw_ground(GlState& state, const Picture& picture);
  void draw_surface(GlState& state, const Picture& picture);
  void draw_ribbons(GlState& state, const Picture& picture, const std::vector<Ribbon>& ribbons);
  void upload_instances(const void* first, std::size_t bytes);
  void draw_discs(GlState& state, const Picture& picture, std::size_t count, float opacity);
  void draw_sheets(GlState& state, const Picture& picture);
  void draw_overlay(GlState& state, const Picture& picture);

  std::unique_ptr<Resources> gl_;
  RendererStats stats_;
};

}  // namespace knotwork::web
