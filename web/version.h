#pragma once

namespace knotwork::web {

/// The project's version in CMakeLists.txt, handed over by the build.
inline constexpr const char* version = KNOTWORK_VERSION;

}  // namespace knotwork::web
