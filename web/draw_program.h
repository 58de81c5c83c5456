#pragma once

#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "web/gl_objects.h"

namespace knotwork::web {

/// A program whose uniforms are set by name. Each location is asked for once. Names must be string literals.
class DrawProgram {
 public:
  DrawProgram() = default;
  explicit DrawProgram(Program program) : program_(std::move(program)) {}

  GLuint name() const { return program_.get(); }
  void abandon() { program_.abandon(); }

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
  GLint at(const char* name) const {
    for (const auto& [known, location] : locations_) {
      if (known == name) return location;
    }
    locations_.emplace_back(name, glGetUniformLocation(program_.get(), name));
    return locations_.back().second;
  }

  Program program_;
  mutable std::vector<std::pair<const char*, GLint>> locations_;  ///< by the address of the name
};

}  // namespace knotwork::web
