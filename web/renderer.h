#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "knotwork/mesh/blending_tables.h"
#include "knotwork/mesh/surface_tables.h"
#include "knotwork/scene/document.h"
#include "web/camera.h"
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
  glm::vec4 fill;  ///< sRGB
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
  bool surface = false;  ///< the tables uploaded last are shown
  Floor floor;
  int locals_u = 1, locals_v = 1;           ///< of the maps uploaded last
  bool closed_u = false, closed_v = false;  ///< wraps on the stage
  /// Local k of u becomes mirror.x - k where v goes round a twisted seam, of v mirror.y - k where u does; -1: no twist.
  glm::ivec2 mirror{-1};
  std::optional<scene::PatchIndex> held;  ///< its own sheet is shown
  /// What is lit of the surface, in intervals of its knot lines: u from, to, v from, to. A closed direction goes round.
  std::optional<glm::vec4> support;
  glm::vec2 knot_period{0};             ///< number of intervals of a closed direction, 0 of an open one
  bool one_sided = false;               ///< both sides look the same: which is the back depends on where one began
  std::vector<Ribbon> ribbons;          ///< frames, normals, curves in this order: hidden by the surface
  std::vector<Ribbon> hidden_ribbons;   ///< drawn only where the surface hides them
  std::vector<Ribbon> overlay_ribbons;  ///< the gizmo: faint where hidden
  std::vector<Disc> discs, overlay_discs;
};

/// Counted over a frame (draw calls, vertices) and since start (bytes).
struct RendererStats {
  int draw_calls = 0;
  std::int64_t vertices = 0;
  double upload_bytes = 0;
};

/// Draws pictures with WebGL2. The only file beside gl_objects and ImGui's backend that speaks GL.
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

  /// New topology, resolution or model: the static part and its indices.
  void upload(const BlendingTables& tables);
  /// A surface of another kind, evaluated on the CPU: its points and normals, in place of the blending surface's tables.
  void upload(const SurfaceTables& tables);
  /// Its colours, OKLab 0 a vertex.
  void upload_colours(const std::vector<float>& texels, int columns, int rows);
  /// The moving part: 12 floats a local.
  void upload_maps(const std::vector<float>& maps, int locals_u, int locals_v);
  /// OKLab of each local's hue, from sRGB colours.
  void upload_hues(const std::vector<Colour>& hues, int locals_u, int locals_v);

  /// Begins the frame's counts and draws the picture over the whole canvas.
  void draw(const Picture& picture);
  const RendererStats& stats() const { return stats_; }

 private:
  struct Resources;
  void draw_shadow(const Picture& picture);
  void draw_ribbons(const Picture& picture, const std::vector<Ribbon>& ribbons);
  void draw_discs(const Picture& picture, const std::vector<Disc>& discs, float opacity);
  void draw_sheets(const Picture& picture);
  void draw_overlay(const Picture& picture);

  std::unique_ptr<Resources> gl_;
  RendererStats stats_;
};

}  // namespace knotwork::web
