#pragma once

#include <string_view>

namespace knotwork::web {

/// The text of a file of web/shaders, embedded by the build (web/cmake/embed_shaders.cmake).
/// `name` is the file's name, for instance "surface.vert". An unknown name yields an empty view.
std::string_view shader_source(std::string_view name);

}  // namespace knotwork::web
