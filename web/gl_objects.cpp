#include "web/gl_objects.h"

#include <array>
#include <vector>

#include "web/shader_sources.h"

namespace knotwork::web {

void delete_program(GLuint name) { glDeleteProgram(name); }
void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
void delete_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }

namespace {

using Shader = GlName<glDeleteShader>;

Shader compile(GLenum stage, std::span<const std::string_view> files, std::string_view label, std::string& log) {
  std::string source = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
  for (const std::string_view file : files) {
    source += shader_source(file);
    source += '\n';
  }
  Shader shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = 0;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  std::array<char, 2048> words{};
  glGetShaderInfoLog(shader.get(), static_cast<GLsizei>(words.size()), nullptr, words.data());
  log = std::string(label) + (stage == GL_VERTEX_SHADER ? " (vertex): " : " (fragment): ") + words.data();
  return {};
}

Texture make_texture(GLint filter, GLint wrap) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  return Texture(name);
}

}  // namespace

Program make_program(const ProgramDescription& description, std::string& log) {
  const Shader vertex = compile(GL_VERTEX_SHADER, description.vertex, description.label, log);
  const Shader fragment = compile(GL_FRAGMENT_SHADER, description.fragment, description.label, log);
  if (!vertex || !fragment) return {};
  Program program(glCreateProgram());
  glAttachShader(program.get(), vertex.get());
  glAttachShader(program.get(), fragment.get());
  glLinkProgram(program.get());
  GLint linked = 0;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (linked != 0) return program;
  std::array<char, 2048> words{};
  glGetProgramInfoLog(program.get(), static_cast<GLsizei>(words.size()), nullptr, words.data());
  log = std::string(description.label) + " (link): " + words.data();
  return {};
}

Texture make_float_texture(int width, int height, std::span<const float> texels) {
  Texture texture = make_texture(GL_NEAREST, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT,
               texels.empty() ? nullptr : texels.data());
  return texture;
}

void update_float_texture(const Texture& texture, glm::ivec2 size, std::span<const float> texels) {
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
}

DrawTarget make_draw_target(int size) {
  DrawTarget target;
  target.size = size;
  target.texture = make_texture(GL_LINEAR, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, size, size, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  target.framebuffer = Framebuffer(name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.get(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return target;
}

Buffer make_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return Buffer(name);
}

VertexArray make_vertex_array() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return VertexArray(name);
}

}  // namespace knotwork::web
