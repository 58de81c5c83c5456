# Script: writes OUTPUT, a C++ source that defines knotwork::web::shader_source() over the files SHADERS.
# usage: cmake -DOUTPUT=<file> "-DSHADERS=<file>;<file>" -P embed_shaders.cmake

set(rows "")
foreach(shader IN LISTS SHADERS)
  get_filename_component(name "${shader}" NAME)
  file(READ "${shader}" text)
  # Comments and indentation are for readers of the file; the lines stay, so that a compiler's log still names them.
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n[ \t]+" "\n" text "${text}")
  # The delimiter never occurs in GLSL, so any text fits between the brackets unescaped.
  string(APPEND rows "    Shader{\"${name}\", R\"~glsl~(${text})~glsl~\"},\n")
endforeach()

list(LENGTH SHADERS count)
file(WRITE "${OUTPUT}" "// Written by web/cmake/embed_shaders.cmake.
#include \"web/shader_sources.h\"

#include <array>

namespace knotwork::web {
namespace {

struct Shader {
  std::string_view name;
  std::string_view text;
};

constexpr std::array<Shader, ${count}> shaders{{
${rows}}};

}  // namespace

std::string_view shader_source(std::string_view name) {
  for (const Shader& shader : shaders) {
    if (shader.name == name) return shader.text;
  }
  return {};
}

}  // namespace knotwork::web
")
