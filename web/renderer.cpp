#include "web/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "knotwork/mesh/surface_sampling.h"
#include "web/curvature_colours.h"
#include "web/surface_textures.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr int shadow_size = 256, soft_shadow_size = 128;

/// Model units that a CSS pixel covers at what the camera turns about.
float pixel_size_at_target(const Picture& picture) {
  return static_cast<float>(picture.view.pixel_size(picture.target));
}

constexpr std::array<std::string_view, 2> surface_vertex_files{"blending.glsl", "surface.vert"};
constexpr std::array<std::string_view, 2> surface_fragment_files{"palette.glsl", "surface.frag"};
constexpr std::array<std::string_view, 3> sheet_vertex_files{"blending.glsl", "sheet.glsl", "sheet.vert"};
constexpr std::array<std::string_view, 2> sheet_fragment_files{"palette.glsl", "sheet.frag"};
constexpr std::array<std::string_view, 2> shadow_vertex_files{"blending.glsl", "shadow.vert"};
constexpr std::array<std::string_view, 1> shadow_fragment_files{"shadow.frag"};
constexpr std::array<std::string_view, 1> fullscreen_files{"fullscreen.vert"};
constexpr std::array<std::string_view, 2> background_files{"palette.glsl", "background.frag"};
constexpr std::array<std::string_view, 1> blur_files{"blur.frag"};
constexpr std::array<std::string_view, 1> ground_vertex_files{"ground.vert"};
constexpr std::array<std::string_view, 2> ground_fragment_files{"palette.glsl", "ground.frag"};
constexpr std::array<std::string_view, 1> ribbon_vertex_files{"ribbon.vert"};
constexpr std::array<std::string_view, 1> ribbon_fragment_files{"ribbon.frag"};
constexpr std::array<std::string_view, 1> disc_vertex_files{"disc.vert"};
constexpr std::array<std::string_view, 1> disc_fragment_files{"disc.frag"};

}  // namespace

struct Renderer::Resources {
  SurfaceTextures textures;
  DrawProgram background, surface, sheet, shadow, blur, ground, ribbon, disc;
  Buffer surface_indices, sheet_indices, instances;
  GLsizei surface_index_count = 0, sheet_index_count = 0;
  glm::ivec2 surface_grid{0}, sheet_grid{0};  ///< vertices that the indices are of
  VertexArray surface_array, sheet_array, empty_array, ribbon_array, disc_array;
  DrawTarget shadow_image, soft_a, soft_b;
  bool shadow_stale = true;
  glm::vec4 shadow_floor{0};

  std::int64_t surface_vertices() const { return static_cast<std::int64_t>(textures.columns()) * textures.rows(); }
  /// The triangles of a grid of vertices.
  static GLsizei upload_indices(const VertexArray& array, glm::ivec2 grid) {
    const std::vector<std::uint32_t> triangles = grid_indices(grid.x, grid.y, false, false);
    glBindVertexArray(array.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(std::uint32_t)),
                 triangles.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    return static_cast<GLsizei>(triangles.size());
  }
};

Renderer::Renderer() : gl_(std::make_unique<Resources>()) {}
Renderer::~Renderer() = default;

std::string Renderer::prepare() {
  std::string log;
  const auto program = [&log](std::string_view label, std::span<const std::string_view> vertex,
                              std::span<const std::string_view> fragment) {
    return log.empty() ? DrawProgram(make_program({label, vertex, fragment}, log)) : DrawProgram();
  };
  auto gl = std::make_unique<Resources>();
  gl->background = program("background", fullscreen_files, background_files);
  gl->surface = program("surface", surface_vertex_files, surface_fragment_files);
  gl->sheet = program("sheet", sheet_vertex_files, sheet_fragment_files);
  gl->shadow = program("shadow", shadow_vertex_files, shadow_fragment_files);
  gl->blur = program("blur", fullscreen_files, blur_files);
  gl->ground = program("ground", ground_vertex_files, ground_fragment_files);
  gl->ribbon = program("ribbon", ribbon_vertex_files, ribbon_fragment_files);
  gl->disc = program("disc", disc_vertex_files, disc_fragment_files);
  if (!log.empty()) return log;

  gl->surface_indices = make_buffer();
  gl->sheet_indices = make_buffer();
  gl->instances = make_buffer();
  gl->surface_array = make_vertex_array();
  glBindVertexArray(gl->surface_array.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gl->surface_indices.get());
  gl->sheet_array = make_vertex_array();
  glBindVertexArray(gl->sheet_array.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gl->sheet_indices.get());
  gl->empty_array = make_vertex_array();

  const auto instanced = [&gl](GLsizei stride, std::initializer_list<std::pair<GLint, std::size_t>> attributes) {
    VertexArray array = make_vertex_array();
    glBindVertexArray(array.get());
    glBindBuffer(GL_ARRAY_BUFFER, gl->instances.get());
    GLuint location = 0;
    for (const auto& [size, offset] : attributes) {
      glEnableVertexAttribArray(location);
      glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride,
                            reinterpret_cast<const void*>(offset));  // NOLINT: GL's own convention for offsets
      glVertexAttribDivisor(location, 1);
      ++location;
    }
    return array;
  };
  gl->ribbon_array = instanced(sizeof(Ribbon), {{3, offsetof(Ribbon, start)},
                                                {3, offsetof(Ribbon, end)},
                                                {4, offsetof(Ribbon, colour)},
                                                {1, offsetof(Ribbon, width)}});
  gl->disc_array =
      instanced(sizeof(Disc), {{4, offsetof(Disc, centre)}, {4, offsetof(Disc, fill)}, {4, offsetof(Disc, rim)}});
  glBindVertexArray(0);
  gl->shadow_image = make_draw_target(shadow_size);
  gl->soft_a = make_draw_target(soft_shadow_size);
  gl->soft_b = make_draw_target(soft_shadow_size);
  gl_ = std::move(gl);
  return {};
}

void Renderer::abandon() {
  const auto forget = [](auto&... names) { (names.abandon(), ...); };
  forget(gl_->background, gl_->surface, gl_->sheet, gl_->shadow, gl_->blur, gl_->ground, gl_->ribbon, gl_->disc);
  forget(gl_->surface_indices, gl_->sheet_indices, gl_->instances, gl_->surface_array, gl_->sheet_array,
         gl_->empty_array, gl_->ribbon_array, gl_->disc_array);
  stats_.upload_bytes += gl_->textures.uploaded_bytes();
  gl_->textures.abandon();
  for (DrawTarget* target : {&gl_->shadow_image, &gl_->soft_a, &gl_->soft_b})
    forget(target->texture, target->framebuffer);
  gl_ = std::make_unique<Resources>();
}

/// With the triangles of the surface and of a local's sheet, where their grids are others than before.
template <class Tables>
void Renderer::upload_tables(const Tables& tables) {
  gl_->textures.upload(tables);
  gl_->shadow_stale = true;
  const auto upload = [this](const VertexArray& array, glm::ivec2 grid, glm::ivec2& known, GLsizei& count) {
    if (known == grid) return;
    known = grid;
    count = Resources::upload_indices(array, grid);
    stats_.upload_bytes += 4.0 * static_cast<double>(count);
  };
  upload(gl_->surface_array, {gl_->textures.columns(), gl_->textures.rows()}, gl_->surface_grid,
         gl_->surface_index_count);
  if (gl_->textures.has_locals())
    upload(gl_->sheet_array, 2 * gl_->textures.finest_steps() + 1, gl_->sheet_grid, gl_->sheet_index_count);
}

void Renderer::upload(const BlendingTables& tables) { upload_tables(tables); }
void Renderer::upload(const NetTables& tables) { upload_tables(tables); }
void Renderer::upload(const SurfaceTables& tables) { upload_tables(tables); }

void Renderer::upload_maps(const std::vector<float>& texels, int locals_u, int locals_v) {
  gl_->textures.upload_maps(texels, locals_u, locals_v);
  gl_->shadow_stale = true;
}

void Renderer::upload_net(const std::vector<float>& texels, int rows, int columns) {
  gl_->textures.upload_net(texels, rows, columns);
  gl_->shadow_stale = true;
}

void Renderer::upload_hues(std::span<const glm::vec3> hues, int rows, int columns) {
  gl_->textures.upload_hues(hues, rows, columns);
}

void Renderer::upload_curvature(std::span<const double> values) { gl_->textures.upload_curvature(values); }

RendererStats Renderer::stats() const {
  RendererStats stats = stats_;
  stats.upload_bytes += gl_->textures.uploaded_bytes();
  return stats;
}

void Renderer::draw(const Picture& picture) {
  stats_.draw_calls = 0;
  stats_.vertices = 0;
  GlState state;
  const Viewport& viewport = picture.view.viewport;
  const bool drawable = picture.surface && gl_->surface_index_count > 0 && gl_->textures.complete();
  const bool lit = drawable && picture.display.surface;
  if (lit) draw_shadow(state, picture);

  state.target(0, static_cast<GLsizei>(std::lround(viewport.width * viewport.pixel_ratio)),
               static_cast<GLsizei>(std::lround(viewport.height * viewport.pixel_ratio)));
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  state.depth_mask(true);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_background(state, picture);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (lit && picture.view.eye.z > picture.floor.height) draw_ground(state, picture);

  state.depth_test(true);
  state.depth_function(GL_LEQUAL);
  if (lit) draw_surface(state, picture);

  state.blend(true);
  state.depth_mask(false);
  if (drawable && gl_->textures.has_locals() && (picture.display.local_patches || picture.held))
    draw_sheets(state, picture);
  if (lit) {
    state.depth_function(GL_GREATER);
    draw_ribbons(state, picture, picture.hidden_ribbons);
    state.depth_function(GL_LEQUAL);
  }
  draw_ribbons(state, picture, picture.ribbons);
  draw_overlay(state, picture);
  state.depth_mask(true);
  state.depth_test(false);
  glBindVertexArray(0);
  stats_.state_changes = state.changes();
}

void Renderer::draw_background(GlState& state, const Picture& picture) {
  const Viewport& viewport = picture.view.viewport;
  const DrawProgram& program = gl_->background;
  state.blend(false);
  state.depth_test(false);
  state.use(program);
  program.set("u_stage", to_glm(picture.theme.stage));
  program.set("u_stage_edge", to_glm(picture.theme.stage_edge));
  program.set("u_aspect", static_cast<float>(viewport.width / viewport.height));
  const double centre_x = 0.5 * (viewport.width + viewport.inset_left - viewport.inset_right) / viewport.width;
  program.set("u_centre", glm::vec2(static_cast<float>(centre_x), 0.56F));
  state.bind(gl_->empty_array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ++stats_.draw_calls;
}

/// The shadow on the floor, the fainter the flatter one looks at it.
void Renderer::draw_ground(GlState& state, const Picture& picture) {
  const DrawProgram& program = gl_->ground;
  const double above = picture.view.eye.z - picture.floor.height;
  state.blend(true);
  state.use(program);
  program.set("u_view_projection", glm::mat4(picture.view.projection * picture.view.view));
  program.set("u_floor", gl_->shadow_floor);
  state.bind(0, gl_->soft_a.texture);
  program.set("u_image", 0);
  program.set("u_shade", picture.theme.dark ? glm::vec3(0.0F) : glm::vec3(0.24F, 0.21F, 0.17F));
  const auto low = static_cast<float>(std::clamp(above / (0.35 * picture.floor.half_size), 0.0, 1.0));
  program.set("u_opacity", (picture.theme.dark ? 0.6F : 0.27F) * low);
  state.bind(gl_->empty_array);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  ++stats_.draw_calls;
}

void Renderer::draw_surface(GlState& state, const Picture& picture) {
  const View& view = picture.view;
  const DrawProgram& program = gl_->surface;
  const bool dark = picture.theme.dark;
  state.blend(false);
  state.use(program);
  gl_->textures.bind(state, program);
  program.set("u_view_projection", glm::mat4(view.projection * view.view));
  program.set("u_rows", gl_->textures.rows());
  program.set("u_eye", glm::vec3(view.eye));
  // The lights hang on the camera's heading, so that a turned surface is always well lit.
  const glm::dvec3 key =
      glm::normalize(-0.44 * view.right + 0.34 * view.up - 0.58 * view.forward + glm::dvec3(0, 0, 0.46));
  const glm::dvec3 fill = glm::normalize(0.8 * view.right + 0.1 * view.up - 0.1 * view.forward);
  program.set("u_key_light", glm::vec3(key));
  program.set("u_fill_light", glm::vec3(fill));
  program.set("u_ambient", dark ? 0.36F : 0.56F);
  program.set("u_lift", dark ? 0.0F : 0.04F);
  program.set("u_sheen", dark ? 0.62F : 1.0F);
  program.set("u_plain_hue", oklab(dark ? Colour{0.62F, 0.66F, 0.71F} : Colour{0.80F, 0.79F, 0.76F}));
  program.set("u_patch_colours", picture.display.patch_colours ? 1.0F : 0.0F);
  program.set("u_knot_lines", picture.display.knot_lines ? (dark ? 0.5F : 0.42F) : 0.0F);
  program.set("u_wireframe", picture.display.wireframe ? 0.34F : 0.0F);
  program.set("u_line_colour", dark ? glm::vec3(0.05F, 0.06F, 0.07F) : glm::vec3(0.12F, 0.13F, 0.15F));
  program.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  program.set("u_knot_period", picture.knot_period);
  program.set("u_held_cells", picture.support.value_or(glm::vec4(0)));
  program.set("u_held", picture.support ? 1.0F : 0.0F);
  program.set("u_back_shade", picture.one_sided ? 0.0F : 1.0F);
  // Both curvatures are drawn alike.
  program.set("u_shading", std::min(static_cast<int>(picture.display.shading), 3));
  const CurvatureColours colours;
  program.set("u_curvature_scale", static_cast<float>(picture.curvature_scale));
  program.set("u_least_hue", colours.least);
  program.set("u_zero_hue", colours.zero);
  program.set("u_greatest_hue", colours.greatest);
  state.bind(gl_->surface_array);
  glDrawElements(GL_TRIANGLES, gl_->surface_index_count, GL_UNSIGNED_INT, nullptr);
  ++stats_.draw_calls;
  stats_.vertices += gl_->surface_vertices();
}

void Renderer::draw_shadow(GlState& state, const Picture& picture) {
  const glm::vec4 floor(picture.floor.x, picture.floor.y, picture.floor.half_size, picture.floor.height);
  if (!gl_->shadow_stale && floor == gl_->shadow_floor) return;
  gl_->shadow_stale = false;
  gl_->shadow_floor = floor;

  state.target(gl_->shadow_image.framebuffer.get(), shadow_size, shadow_size);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  state.depth_test(false);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  state.blend(true);
  state.blend_equation(GL_MAX);
  const DrawProgram& program = gl_->shadow;
  state.use(program);
  gl_->textures.bind(state, program);
  program.set("u_rows", gl_->textures.rows());
  program.set("u_floor", floor);
  program.set("u_fall_off", 1.1F / static_cast<float>(picture.floor.half_size) * 2.0F);
  state.bind(gl_->surface_array);
  glDrawElements(GL_TRIANGLES, gl_->surface_index_count, GL_UNSIGNED_INT, nullptr);
  state.blend_equation(GL_FUNC_ADD);
  state.blend(false);

  state.use(gl_->blur);
  gl_->blur.set("u_image", 0);
  state.bind(gl_->empty_array);
  const Texture* source = &gl_->shadow_image.texture;
  constexpr float reach = 1.4F / static_cast<float>(soft_shadow_size);
  for (int pass = 0; pass < 4; ++pass) {
    const DrawTarget& target = pass % 2 == 0 ? gl_->soft_b : gl_->soft_a;
    state.target(target.framebuffer.get(), soft_shadow_size, soft_shadow_size);
    state.bind(0, *source);
    const float step = pass < 2 ? reach : 2.2F * reach;
    gl_->blur.set("u_step", pass % 2 == 0 ? glm::vec2(step, 0.0F) : glm::vec2(0.0F, step));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    source = &target.texture;
  }
  stats_.draw_calls += 5;
  stats_.vertices += gl_->surface_vertices();
}

void Renderer::draw_sheets(GlState& state, const Picture& picture) {
  const DrawProgram& program = gl_->sheet;
  const View& view = picture.view;
  state.use(program);
  gl_->textures.bind_sheets(state, program, picture.sheets);
  program.set("u_view_projection", glm::mat4(view.projection * view.view));
  program.set("u_locals", glm::ivec2(picture.locals_u, picture.locals_v));
  program.set("u_eye", glm::vec3(view.eye));
  program.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  program.set("u_pixel_size", pixel_size_at_target(picture));
  const bool all = picture.display.local_patches;
  program.set("u_opacity", all ? 0.34F : 0.22F);
  program.set("u_only", all || !picture.held ? glm::ivec2(-1) : glm::ivec2(picture.held->first, picture.held->second));
  state.bind(gl_->sheet_array);
  const int instances = all ? picture.locals_u * picture.locals_v : 1;
  glDrawElementsInstanced(GL_TRIANGLES, gl_->sheet_index_count, GL_UNSIGNED_INT, nullptr, instances);
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(gl_->sheet_grid.x) * gl_->sheet_grid.y * instances;
}

void Renderer::draw_ribbons(GlState& state, const Picture& picture, const std::vector<Ribbon>& ribbons) {
  if (ribbons.empty()) return;
  const View& view = picture.view;
  state.use(gl_->ribbon);
  gl_->ribbon.set("u_view_projection", glm::mat4(view.projection * view.view));
  gl_->ribbon.set("u_viewport", glm::vec2(view.viewport.width, view.viewport.height));
  gl_->ribbon.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  gl_->ribbon.set("u_near", 1e-3F);
  upload_instances(ribbons.data(), ribbons.size() * sizeof(Ribbon));
  state.bind(gl_->ribbon_array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(ribbons.size()));
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(4 * ribbons.size());
}

void Renderer::upload_instances(const void* first, std::size_t bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, gl_->instances.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), first, GL_STREAM_DRAW);
  stats_.upload_bytes += static_cast<double>(bytes);
}

/// Those that upload_instances() has had last.
void Renderer::draw_discs(GlState& state, const Picture& picture, std::size_t count, float opacity) {
  const View& view = picture.view;
  state.use(gl_->disc);
  gl_->disc.set("u_view_projection", glm::mat4(view.projection * view.view));
  gl_->disc.set("u_viewport", glm::vec2(view.viewport.width, view.viewport.height));
  gl_->disc.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  gl_->disc.set("u_eye", glm::vec3(view.eye));
  gl_->disc.set("u_pixel_size", pixel_size_at_target(picture));
  gl_->disc.set("u_opacity", opacity);
  state.bind(gl_->disc_array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(4 * count);
}

void Renderer::draw_overlay(GlState& state, const Picture& picture) {
  if (!picture.discs.empty()) {
    upload_instances(picture.discs.data(), picture.discs.size() * sizeof(Disc));
    state.depth_function(GL_GREATER);  // what the surface hides is hinted at, not lost
    draw_discs(state, picture, picture.discs.size(), 0.26F);
    state.depth_function(GL_LEQUAL);
    draw_discs(state, picture, picture.discs.size(), 1.0F);
  }
  state.depth_test(false);  // the gizmo is a tool, not a thing on the stage
  draw_ribbons(state, picture, picture.overlay_ribbons);
  if (picture.overlay_discs.empty()) return;
  upload_instances(picture.overlay_discs.data(), picture.overlay_discs.size() * sizeof(Disc));
  draw_discs(state, picture, picture.overlay_discs.size(), 1.0F);
}

}  // namespace knotwork::web
