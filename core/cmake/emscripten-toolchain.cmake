# Finds the Emscripten toolchain file wherever Emscripten is: an active emsdk, a distribution's package, or Homebrew.

if(NOT KNOTWORK_EMSCRIPTEN_ROOT)
  if(DEFINED ENV{EMSDK} AND EXISTS "$ENV{EMSDK}/upstream/emscripten")
    set(KNOTWORK_EMSCRIPTEN_ROOT "$ENV{EMSDK}/upstream/emscripten")
  else()
    find_program(KNOTWORK_EM_CONFIG em-config)
    if(KNOTWORK_EM_CONFIG)
      execute_process(COMMAND "${KNOTWORK_EM_CONFIG}" EMSCRIPTEN_ROOT
                      OUTPUT_VARIABLE KNOTWORK_EMSCRIPTEN_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
    endif()
  endif()
endif()
if(NOT EXISTS "${KNOTWORK_EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake")
  message(FATAL_ERROR "Emscripten was not found. Install it (Debian: apt-get install emscripten) or activate an emsdk, "
                      "so that em-config is on the PATH.")
endif()
set(KNOTWORK_EMSCRIPTEN_ROOT "${KNOTWORK_EMSCRIPTEN_ROOT}" CACHE PATH "Folder of emcc")
include("${KNOTWORK_EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake")
