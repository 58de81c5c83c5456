#pragma once

#include <array>

#include "web/draw_program.h"

namespace knotwork::web {

/// GL's state while a picture is drawn: sets what is not so already, and counts. What others leave behind is unknown, so
/// each picture begins with a new one.
class GlState {
 public:
  static constexpr GLuint texture_units = 16;  ///< that a vertex shader of WebGL2 has at least

  int changes() const { return changes_; }

  void use(const DrawProgram& program) {
    if (program_ == program.name()) return;
    glUseProgram(program_ = program.name());
    ++changes_;
  }
  void bind(const VertexArray& array) {
    if (array_ == array.get()) return;
    glBindVertexArray(array_ = array.get());
    ++changes_;
  }
  /// Precondition: unit < texture_units.
  void bind(GLuint unit, const Texture& texture) {
    if (textures_[unit] == texture.get()) return;
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    textures_[unit] = texture.get();
    ++changes_;
  }
  void target(GLuint framebuffer, GLsizei width, GLsizei height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    changes_ += 2;
  }
  void blend(bool on) { set(GL_BLEND, on, blend_); }
  void depth_test(bool on) { set(GL_DEPTH_TEST, on, depth_test_); }
  void depth_function(GLenum function) {
    if (depth_function_ == function) return;
    glDepthFunc(depth_function_ = function);
    ++changes_;
  }
  void depth_mask(bool on) {
    glDepthMask(on ? GL_TRUE : GL_FALSE);
    ++changes_;
  }
  void blend_equation(GLenum equation) {
    glBlendEquation(equation);
    ++changes_;
  }

 private:
  static constexpr GLuint unknown = ~0U;

  void set(GLenum capability, bool on, int& known) {
    if (known == (on ? 1 : 0)) return;
    known = on ? 1 : 0;
    if (on)
      glEnable(capability);
    else
      glDisable(capability);
    ++changes_;
  }

  int changes_ = 0;
  GLuint program_ = unknown, array_ = unknown;
  std::array<GLuint, texture_units> textures_ = [] {
    std::array<GLuint, texture_units> units{};
    units.fill(unknown);
    return units;
  }();
  int blend_ = -1, depth_test_ = -1;
  GLenum depth_function_ = 0;
};

}  // namespace knotwork::web
