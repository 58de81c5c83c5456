#pragma once

#include <GLES3/gl3.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <glm/vec2.hpp>

namespace knotwork::web {

/// Owns one GL name; moves, never copies. After a lost context the names are forgotten, not deleted: `abandon`.
template <void (*Delete)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;
  ~GlName() {
    if (name_ != 0) Delete(name_);
  }

  GLuint get() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  void abandon() { name_ = 0; }

 private:
  GLuint name_ = 0;
};

void delete_program(GLuint name);
void delete_texture(GLuint name);
void delete_buffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_framebuffer(GLuint name);

using Program = GlName<delete_program>;
using Texture = GlName<delete_texture>;
using Buffer = GlName<delete_buffer>;
using VertexArray = GlName<delete_vertex_array>;
using Framebuffer = GlName<delete_framebuffer>;

/// What a program is made of: file names under web/shaders, joined in order behind the one version line.
struct ProgramDescription {
  std::string_view label;
  std::span<const std::string_view> vertex, fragment;
};

/// The program, or an empty one with the compiler's or linker's words in `log`.
Program make_program(const ProgramDescription& description, std::string& log);

/// A texture of 32-bit floats, four a texel, read with texelFetch only. `texels` is row by row, empty to allocate.
Texture make_float_texture(int width, int height, std::span<const float> texels);
/// New texels for a texture of this size.
void update_float_texture(const Texture& texture, glm::ivec2 size, std::span<const float> texels);

/// A grey image that can be drawn into and is read with linear filtering.
struct DrawTarget {
  Texture texture;
  Framebuffer framebuffer;
  int size = 0;
};
DrawTarget make_draw_target(int size);

Buffer make_buffer();
VertexArray make_vertex_array();

}  // namespace knotwork::web
