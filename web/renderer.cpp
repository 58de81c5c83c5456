#include "web/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "knotwork/mesh/surface_sampling.h"
#include "web/gl_objects.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

constexpr int shadow_size = 256, soft_shadow_size = 128;

/// A program with the uniform locations looked up once, by name, when asked for.
class DrawProgram {
 public:
  DrawProgram() = default;
  explicit DrawProgram(Program program) : program_(std::move(program)) {}

  void use() const { glUseProgram(program_.get()); }
  void abandon() { program_.abandon(); }

  GLint at(const char* name) const { return glGetUniformLocation(program_.get(), name); }
  void set(const char* name, int value) const { glUniform1i(at(name), value); }
  void set(const char* name, float value) const { glUniform1f(at(name), value); }
  void set(const char* name, glm::vec2 value) const { glUniform2fv(at(name), 1, glm::value_ptr(value)); }
  void set(const char* name, glm::vec3 value) const { glUniform3fv(at(name), 1, glm::value_ptr(value)); }
  void set(const char* name, glm::vec4 value) const { glUniform4fv(at(name), 1, glm::value_ptr(value)); }
  void set(const char* name, glm::ivec2 value) const { glUniform2iv(at(name), 1, glm::value_ptr(value)); }
  void set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, glm::value_ptr(value));
  }

 private:
  Program program_;
};

/// Model units that a CSS pixel covers at what the camera turns about.
float pixel_size_at_target(const Picture& picture) {
  return static_cast<float>(picture.view.pixel_size(picture.target));
}

constexpr std::array<std::string_view, 2> surface_vertex_files{"blending.glsl", "surface.vert"};
constexpr std::array<std::string_view, 2> surface_fragment_files{"palette.glsl", "surface.frag"};
constexpr std::array<std::string_view, 2> sheet_vertex_files{"blending.glsl", "sheet.vert"};
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

/// Texture units of blending.glsl's samplers, in this order.
constexpr std::array<const char*, 7> table_samplers{"u_points",  "u_partials_u", "u_partials_v", "u_blend_u",
                                                    "u_blend_v", "u_maps",       "u_hues"};

}  // namespace

struct Renderer::Resources {
  DrawProgram background, surface, sheet, shadow, blur, ground, ribbon, disc;
  std::array<Texture, 7> tables;
  glm::ivec2 maps_size{0}, hues_size{0};
  bool sampled = false;  ///< the tables are those of an evaluated surface
  int columns = 0, rows = 0;
  glm::ivec2 steps{1};
  Buffer surface_indices, sheet_indices, instances;
  GLsizei surface_index_count = 0, sheet_index_count = 0;
  VertexArray surface_array, sheet_array, empty_array, ribbon_array, disc_array;
  DrawTarget shadow_image, soft_a, soft_b;
  bool shadow_stale = true;
  glm::vec4 shadow_floor{0};

  void bind_tables(const DrawProgram& program) const {
    for (std::size_t unit = 0; unit < tables.size(); ++unit) {
      glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
      // What an evaluated surface has no use for must still be a texture.
      const bool needed = !sampled || unit < 2 || unit == 6;
      glBindTexture(GL_TEXTURE_2D, tables[needed ? unit : 0].get());
      program.set(table_samplers[unit], static_cast<int>(unit));
    }
    glActiveTexture(GL_TEXTURE0);
    program.set("u_sampled", sampled ? 1 : 0);
  }

  /// The triangles of a grid of vertices.
  static GLsizei upload_indices(const VertexArray& array, int columns, int rows) {
    const std::vector<std::uint32_t> triangles = grid_indices(columns, rows, false, false);
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
  for (Texture& table : gl_->tables) table.abandon();
  for (DrawTarget* target : {&gl_->shadow_image, &gl_->soft_a, &gl_->soft_b})
    forget(target->texture, target->framebuffer);
  gl_ = std::make_unique<Resources>();
}

void Renderer::upload(const BlendingTables& tables) {
  const auto count = [this](std::size_t floats) { stats_.upload_bytes += 4.0 * static_cast<double>(floats); };
  gl_->columns = tables.columns;
  gl_->rows = tables.rows;
  gl_->tables[0] = make_float_texture(tables.rows, tables.columns, tables.points);
  gl_->tables[1] = make_float_texture(tables.rows, tables.columns, tables.partials_u);
  gl_->tables[2] = make_float_texture(tables.rows, tables.columns, tables.partials_v);
  gl_->tables[3] = make_float_texture(tables.columns, 1, tables.blend_u);
  gl_->tables[4] = make_float_texture(tables.rows, 1, tables.blend_v);
  count(3 * tables.points.size() + tables.blend_u.size() + tables.blend_v.size());

  gl_->surface_index_count = Resources::upload_indices(gl_->surface_array, tables.columns, tables.rows);
  gl_->steps = {tables.steps_u, tables.steps_v};
  gl_->sheet_index_count = Resources::upload_indices(gl_->sheet_array, 2 * tables.steps_u + 1, 2 * tables.steps_v + 1);
  count(static_cast<std::size_t>(gl_->surface_index_count) + static_cast<std::size_t>(gl_->sheet_index_count));
  gl_->sampled = false;
  gl_->shadow_stale = true;
}

void Renderer::upload(const SurfaceTables& tables) {
  const bool same_grid = gl_->sampled && gl_->columns == tables.columns && gl_->rows == tables.rows;
  const std::array<const std::vector<float>*, 2> parts{&tables.points, &tables.normals};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (same_grid)
      update_float_texture(gl_->tables[k], tables.rows, tables.columns, *parts[k]);
    else
      gl_->tables[k] = make_float_texture(tables.rows, tables.columns, *parts[k]);
    stats_.upload_bytes += 4.0 * static_cast<double>(parts[k]->size());
  }
  if (!same_grid) {
    gl_->surface_index_count = Resources::upload_indices(gl_->surface_array, tables.columns, tables.rows);
    stats_.upload_bytes += 4.0 * static_cast<double>(gl_->surface_index_count);
  }
  gl_->columns = tables.columns;
  gl_->rows = tables.rows;
  gl_->steps = {tables.steps_u, tables.steps_v};
  gl_->sampled = true;
  gl_->shadow_stale = true;
}

void Renderer::upload_colours(const std::vector<float>& texels, int columns, int rows) {
  gl_->tables[6] = make_float_texture(rows, columns, texels);
  gl_->hues_size = {rows, columns};
  stats_.upload_bytes += 4.0 * static_cast<double>(texels.size());
}

void Renderer::upload_maps(const std::vector<float>& maps, int locals_u, int locals_v) {
  const glm::ivec2 size{3 * locals_v, locals_u};
  if (gl_->maps_size != size) {
    gl_->tables[5] = make_float_texture(size.x, size.y, maps);
    gl_->maps_size = size;
  } else {
    update_float_texture(gl_->tables[5], size.x, size.y, maps);
  }
  stats_.upload_bytes += 4.0 * static_cast<double>(maps.size());
  gl_->shadow_stale = true;
}

void Renderer::upload_hues(const std::vector<Colour>& hues, int locals_u, int locals_v) {
  std::vector<float> texels;
  texels.reserve(hues.size() * 4);
  for (const Colour& hue : hues) {
    const glm::vec3 lab = oklab(hue);
    texels.insert(texels.end(), {lab.x, lab.y, lab.z, 0.0F});
  }
  gl_->tables[6] = make_float_texture(locals_v, locals_u, texels);
  gl_->hues_size = {locals_v, locals_u};
  stats_.upload_bytes += 4.0 * static_cast<double>(texels.size());
}

void Renderer::draw(const Picture& picture) {
  stats_.draw_calls = 0;
  stats_.vertices = 0;
  const View& view = picture.view;
  const glm::mat4 view_projection(view.projection * view.view);
  const auto ratio = static_cast<float>(view.viewport.pixel_ratio);
  const bool uploaded = gl_->surface_index_count > 0 && (gl_->sampled || gl_->maps_size.x > 0) && gl_->hues_size.x > 0;
  const bool drawable = picture.surface && uploaded, lit = drawable && picture.display.surface;
  if (lit) draw_shadow(picture);

  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, static_cast<GLsizei>(std::lround(view.viewport.width * view.viewport.pixel_ratio)),
             static_cast<GLsizei>(std::lround(view.viewport.height * view.viewport.pixel_ratio)));
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);

  gl_->background.use();
  gl_->background.set("u_stage", to_glm(picture.theme.stage));
  gl_->background.set("u_stage_edge", to_glm(picture.theme.stage_edge));
  gl_->background.set("u_aspect", static_cast<float>(view.viewport.width / view.viewport.height));
  const double centre_x =
      0.5 * (view.viewport.width + view.viewport.inset_left - view.viewport.inset_right) / view.viewport.width;
  gl_->background.set("u_centre", glm::vec2(static_cast<float>(centre_x), 0.56F));
  glBindVertexArray(gl_->empty_array.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ++stats_.draw_calls;

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const double above = view.eye.z - picture.floor.height;
  if (lit && above > 0) {
    gl_->ground.use();
    gl_->ground.set("u_view_projection", view_projection);
    gl_->ground.set("u_floor", gl_->shadow_floor);
    glBindTexture(GL_TEXTURE_2D, gl_->soft_a.texture.get());
    gl_->ground.set("u_image", 0);
    gl_->ground.set("u_shade", picture.theme.dark ? glm::vec3(0.0F) : glm::vec3(0.24F, 0.21F, 0.17F));
    const auto low = static_cast<float>(std::clamp(above / (0.35 * picture.floor.half_size), 0.0, 1.0));
    gl_->ground.set("u_opacity", (picture.theme.dark ? 0.6F : 0.27F) * low);
    glBindVertexArray(gl_->empty_array.get());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    ++stats_.draw_calls;
  }

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  if (lit) {
    const DrawProgram& program = gl_->surface;
    glDisable(GL_BLEND);
    program.use();
    gl_->bind_tables(program);
    program.set("u_view_projection", view_projection);
    program.set("u_rows", gl_->rows);
    program.set("u_steps", glm::vec2(gl_->steps));
    program.set("u_eye", glm::vec3(view.eye));
    // The lights hang on the camera's heading, so that a turned surface is always well lit.
    const glm::dvec3 key =
        glm::normalize(-0.44 * view.right + 0.34 * view.up - 0.58 * view.forward + glm::dvec3(0, 0, 0.46));
    const glm::dvec3 fill = glm::normalize(0.8 * view.right + 0.1 * view.up - 0.1 * view.forward);
    program.set("u_key_light", glm::vec3(key));
    program.set("u_fill_light", glm::vec3(fill));
    program.set("u_ambient", picture.theme.dark ? 0.36F : 0.56F);
    program.set("u_lift", picture.theme.dark ? 0.0F : 0.04F);
    program.set("u_sheen", picture.theme.dark ? 0.62F : 1.0F);
    program.set("u_plain_hue", oklab(picture.theme.dark ? Colour{0.62F, 0.66F, 0.71F} : Colour{0.80F, 0.79F, 0.76F}));
    program.set("u_patch_colours", picture.display.patch_colours ? 1.0F : 0.0F);
    program.set("u_knot_lines", picture.display.knot_lines ? (picture.theme.dark ? 0.5F : 0.42F) : 0.0F);
    program.set("u_wireframe", picture.display.wireframe ? 0.34F : 0.0F);
    program.set("u_line_colour", picture.theme.dark ? glm::vec3(0.05F, 0.06F, 0.07F) : glm::vec3(0.12F, 0.13F, 0.15F));
    program.set("u_pixel_ratio", ratio);
    program.set("u_knot_period", picture.knot_period);
    program.set("u_held_cells", picture.support.value_or(glm::vec4(0)));
    program.set("u_held", picture.support ? 1.0F : 0.0F);
    program.set("u_back_shade", picture.one_sided ? 0.0F : 1.0F);
    glBindVertexArray(gl_->surface_array.get());
    glDrawElements(GL_TRIANGLES, gl_->surface_index_count, GL_UNSIGNED_INT, nullptr);
    ++stats_.draw_calls;
    stats_.vertices += static_cast<std::int64_t>(gl_->columns) * gl_->rows;
  }

  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  if (drawable && !gl_->sampled && (picture.display.local_patches || picture.held)) draw_sheets(picture);
  if (lit) {
    glDepthFunc(GL_GREATER);
    draw_ribbons(picture, picture.hidden_ribbons);
    glDepthFunc(GL_LEQUAL);
  }
  draw_ribbons(picture, picture.ribbons);
  draw_overlay(picture);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
}

void Renderer::draw_shadow(const Picture& picture) {
  const glm::vec4 floor(picture.floor.x, picture.floor.y, picture.floor.half_size, picture.floor.height);
  if (!gl_->shadow_stale && floor == gl_->shadow_floor) return;
  gl_->shadow_stale = false;
  gl_->shadow_floor = floor;

  glBindFramebuffer(GL_FRAMEBUFFER, gl_->shadow_image.framebuffer.get());
  glViewport(0, 0, shadow_size, shadow_size);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  gl_->shadow.use();
  gl_->bind_tables(gl_->shadow);
  gl_->shadow.set("u_rows", gl_->rows);
  gl_->shadow.set("u_floor", floor);
  gl_->shadow.set("u_slant", glm::vec2(0.0F, 0.0F));
  gl_->shadow.set("u_fall_off", 1.1F / static_cast<float>(picture.floor.half_size) * 2.0F);
  glBindVertexArray(gl_->surface_array.get());
  glDrawElements(GL_TRIANGLES, gl_->surface_index_count, GL_UNSIGNED_INT, nullptr);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);

  gl_->blur.use();
  gl_->blur.set("u_image", 0);
  glBindVertexArray(gl_->empty_array.get());
  glViewport(0, 0, soft_shadow_size, soft_shadow_size);
  const Texture* source = &gl_->shadow_image.texture;
  constexpr float reach = 1.4F / static_cast<float>(soft_shadow_size);
  for (int pass = 0; pass < 4; ++pass) {
    const DrawTarget& target = pass % 2 == 0 ? gl_->soft_b : gl_->soft_a;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glBindTexture(GL_TEXTURE_2D, source->get());
    const float step = pass < 2 ? reach : 2.2F * reach;
    gl_->blur.set("u_step", pass % 2 == 0 ? glm::vec2(step, 0.0F) : glm::vec2(0.0F, step));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    source = &target.texture;
  }
  stats_.draw_calls += 5;
}

void Renderer::draw_sheets(const Picture& picture) {
  const DrawProgram& program = gl_->sheet;
  const View& view = picture.view;
  program.use();
  gl_->bind_tables(program);
  program.set("u_view_projection", glm::mat4(view.projection * view.view));
  program.set("u_steps", gl_->steps);
  const glm::ivec2 last{gl_->columns - 1, gl_->rows - 1};
  program.set("u_last", last);
  program.set("u_locals", glm::ivec2(picture.locals_u, picture.locals_v));
  program.set("u_closed", glm::ivec2(picture.closed_u ? 1 : 0, picture.closed_v ? 1 : 0));
  program.set("u_mirror", picture.mirror * gl_->steps);
  program.set("u_eye", glm::vec3(view.eye));
  program.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  program.set("u_pixel_size", pixel_size_at_target(picture));
  const bool all = picture.display.local_patches;
  program.set("u_opacity", all ? 0.34F : 0.22F);
  program.set("u_only", all || !picture.held ? glm::ivec2(-1) : glm::ivec2(picture.held->first, picture.held->second));
  glBindVertexArray(gl_->sheet_array.get());
  const int instances = all ? picture.locals_u * picture.locals_v : 1;
  glDrawElementsInstanced(GL_TRIANGLES, gl_->sheet_index_count, GL_UNSIGNED_INT, nullptr, instances);
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(2 * gl_->steps.x + 1) * (2 * gl_->steps.y + 1) * instances;
}

void Renderer::draw_ribbons(const Picture& picture, const std::vector<Ribbon>& ribbons) {
  if (ribbons.empty()) return;
  const View& view = picture.view;
  gl_->ribbon.use();
  gl_->ribbon.set("u_view_projection", glm::mat4(view.projection * view.view));
  gl_->ribbon.set("u_viewport", glm::vec2(view.viewport.width, view.viewport.height));
  gl_->ribbon.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  gl_->ribbon.set("u_near", 1e-3F);
  glBindBuffer(GL_ARRAY_BUFFER, gl_->instances.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ribbons.size() * sizeof(Ribbon)), ribbons.data(),
               GL_STREAM_DRAW);
  glBindVertexArray(gl_->ribbon_array.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(ribbons.size()));
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(4 * ribbons.size());
  stats_.upload_bytes += static_cast<double>(ribbons.size() * sizeof(Ribbon));
}

void Renderer::draw_discs(const Picture& picture, const std::vector<Disc>& discs, float opacity) {
  if (discs.empty()) return;
  const View& view = picture.view;
  gl_->disc.use();
  gl_->disc.set("u_view_projection", glm::mat4(view.projection * view.view));
  gl_->disc.set("u_viewport", glm::vec2(view.viewport.width, view.viewport.height));
  gl_->disc.set("u_pixel_ratio", static_cast<float>(view.viewport.pixel_ratio));
  gl_->disc.set("u_eye", glm::vec3(view.eye));
  gl_->disc.set("u_pixel_size", pixel_size_at_target(picture));
  gl_->disc.set("u_opacity", opacity);
  glBindBuffer(GL_ARRAY_BUFFER, gl_->instances.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(discs.size() * sizeof(Disc)), discs.data(), GL_STREAM_DRAW);
  glBindVertexArray(gl_->disc_array.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(discs.size()));
  ++stats_.draw_calls;
  stats_.vertices += static_cast<std::int64_t>(4 * discs.size());
  stats_.upload_bytes += static_cast<double>(discs.size() * sizeof(Disc));
}

void Renderer::draw_overlay(const Picture& picture) {
  glDepthFunc(GL_GREATER);  // what the surface hides is hinted at, not lost
  draw_discs(picture, picture.discs, 0.26F);
  glDepthFunc(GL_LEQUAL);
  draw_discs(picture, picture.discs, 1.0F);
  glDisable(GL_DEPTH_TEST);  // the gizmo is a tool, not a thing on the stage
  draw_ribbons(picture, picture.overlay_ribbons);
  draw_discs(picture, picture.overlay_discs, 1.0F);
}

}  // namespace knotwork::web
