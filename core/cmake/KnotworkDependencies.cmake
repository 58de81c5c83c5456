# Third-party libraries: the system's first, else the pinned release by commit. Of those that the libraries and the page
# use, only headers are taken; those at the end are compiled, for native tests and benchmarks alone.

include_guard(GLOBAL)
include(FetchContent)

# knotwork_header_library(<package> TARGET <imported target> VERSION <minimum> PROBE <a header> FOLDERS <folder>...
#                         PREFIX <folder below an include folder> REPOSITORY <url> COMMIT <hash> INCLUDE <subfolder>)
#
# Makes the imported target exist. Natively find_package() looks first. A wasm build must never see the system's include
# folder, whose C library headers are another machine's: there the library's own folders are copied into the build
# folder and only that copy is on the include path.
function(knotwork_header_library package)
  cmake_parse_arguments(PARSE_ARGV 1 library "" "TARGET;VERSION;PROBE;PREFIX;REPOSITORY;COMMIT;INCLUDE" "FOLDERS")
  if(TARGET ${library_TARGET})
    return()
  endif()

  if(EMSCRIPTEN)
    knotwork_stage_headers(staged ${package} PROBE ${library_PROBE} PREFIX "${library_PREFIX}"
                           FOLDERS ${library_FOLDERS})
    if(staged)
      knotwork_imported_headers(${library_TARGET} "${staged}")
      return()
    endif()
  endif()

  # A SOURCE_SUBDIR without a CMakeLists.txt: the download is unpacked and none of its own targets, tests or install
  # rules join this project.
  FetchContent_Declare(${package}
    GIT_REPOSITORY ${library_REPOSITORY}
    GIT_TAG ${library_COMMIT}
    SOURCE_SUBDIR headers-only
    FIND_PACKAGE_ARGS ${library_VERSION} CONFIG GLOBAL)
  FetchContent_MakeAvailable(${package})
  if(NOT TARGET ${library_TARGET})
    string(TOLOWER ${package} lower)
    if(${lower}_SOURCE_DIR)
      knotwork_imported_headers(${library_TARGET} "${${lower}_SOURCE_DIR}/${library_INCLUDE}")
    else()
      message(FATAL_ERROR "${package} was found but does not define ${library_TARGET}")
    endif()
  endif()
endfunction()

# Imported, so that its headers count as system headers: warnings inside them are not ours.
function(knotwork_imported_headers target folder)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${folder}")
endfunction()

# Sets <result> to an include folder holding copies of <FOLDERS> from the host's include folder, or to "".
function(knotwork_stage_headers result package)
  cmake_parse_arguments(PARSE_ARGV 2 stage "" "PROBE;PREFIX" "FOLDERS")
  find_path(KNOTWORK_HOST_${package} "${stage_PROBE}"
    PATHS /usr/include /usr/local/include /opt/homebrew/include
    PATH_SUFFIXES "${stage_PREFIX}" NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  if(NOT KNOTWORK_HOST_${package})
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  set(staged "${PROJECT_BINARY_DIR}/staged/${package}")
  # file(COPY) keeps what is already there with the same time stamp.
  foreach(folder IN LISTS stage_FOLDERS)
    file(COPY "${KNOTWORK_HOST_${package}}/${folder}" DESTINATION "${staged}")
  endforeach()
  set(${result} "${staged}" PARENT_SCOPE)
endfunction()

macro(knotwork_require_eigen)
  knotwork_header_library(Eigen3
    TARGET Eigen3::Eigen VERSION 3.4 PROBE Eigen/Core PREFIX eigen3 FOLDERS Eigen INCLUDE "."
    REPOSITORY https://gitlab.com/libeigen/eigen.git
    COMMIT 3147391d946bb4b6c68edd901f2add6ac1f31f8c) # 3.4.0
endmacro()

macro(knotwork_require_json)
  knotwork_header_library(nlohmann_json
    TARGET nlohmann_json::nlohmann_json VERSION 3.11.2 PROBE nlohmann/json.hpp PREFIX "" FOLDERS nlohmann INCLUDE include
    REPOSITORY https://github.com/nlohmann/json.git
    COMMIT bc889afb4c5bf1c0d8ee29ef35eaaf4c8bef8a5d) # 3.11.2
endmacro()

macro(knotwork_require_glm)
  knotwork_header_library(glm
    TARGET glm::glm VERSION 0.9.9.8 PROBE glm/glm.hpp PREFIX "" FOLDERS glm INCLUDE "."
    REPOSITORY https://github.com/g-truc/glm.git
    COMMIT 0af55ccecd98d4e5a8d1fad7de25ba429d60e863) # 1.0.1
endmacro()

macro(knotwork_require_doctest)
  knotwork_header_library(doctest
    TARGET doctest::doctest VERSION 2.4.9 PROBE doctest/doctest.h PREFIX "" FOLDERS doctest INCLUDE "."
    REPOSITORY https://github.com/doctest/doctest.git
    COMMIT ae7a13539fb71f270b87eb2e874fbac80bc8dda2) # 2.4.11
endmacro()

# knotwork_compiled_library(<package> TARGET <imported target> REPOSITORY <url> COMMIT <hash>)
#
# For native tests and benchmarks: find_package() first, else the download is compiled with the options that are set
# where this is called. Excluded from all: nothing of it is built that no test links, and nothing of it is installed.
function(knotwork_compiled_library package)
  cmake_parse_arguments(PARSE_ARGV 1 library "" "TARGET;REPOSITORY;COMMIT" "")
  if(TARGET ${library_TARGET})
    return()
  endif()
  FetchContent_Declare(${package}
    GIT_REPOSITORY ${library_REPOSITORY}
    GIT_TAG ${library_COMMIT}
    SOURCE_SUBDIR without-a-project # so that it can be added as below
    FIND_PACKAGE_ARGS CONFIG GLOBAL)
  FetchContent_MakeAvailable(${package})
  string(TOLOWER ${package} lower)
  if(NOT TARGET ${library_TARGET} AND ${lower}_SOURCE_DIR)
    add_subdirectory("${${lower}_SOURCE_DIR}" "${${lower}_BINARY_DIR}" EXCLUDE_FROM_ALL SYSTEM)
  endif()
  if(NOT TARGET ${library_TARGET})
    message(FATAL_ERROR "${package} was found but does not define ${library_TARGET}")
  endif()
endfunction()

macro(knotwork_require_rapidcheck)
  knotwork_compiled_library(rapidcheck TARGET rapidcheck
    REPOSITORY https://github.com/emil-e/rapidcheck.git
    COMMIT ff6af6fc683159deb51c543b065eba14dfcf329b) # of 2023-12-14; there are no releases
endmacro()

macro(knotwork_require_benchmark)
  set(BENCHMARK_ENABLE_TESTING OFF)
  set(BENCHMARK_ENABLE_WERROR OFF)
  set(BENCHMARK_ENABLE_INSTALL OFF)
  knotwork_compiled_library(benchmark TARGET benchmark::benchmark
    REPOSITORY https://github.com/google/benchmark.git
    COMMIT d572f4777349d43653b21d6c2fc63020ab326db2) # 1.7.1
endmacro()

# SISL, SINTEF's spline library, has no CMake package: the target SISL::SISL exists afterwards exactly where its header
# and its library are on the system (Debian: libsisl-dev). Never downloaded; who has it not tests without it.
function(knotwork_find_sisl)
  if(TARGET SISL::SISL)
    return()
  endif()
  find_path(KNOTWORK_SISL_INCLUDE sisl.h)
  find_library(KNOTWORK_SISL_LIBRARY sisl)
  mark_as_advanced(KNOTWORK_SISL_INCLUDE KNOTWORK_SISL_LIBRARY)
  if(KNOTWORK_SISL_INCLUDE AND KNOTWORK_SISL_LIBRARY)
    add_library(SISL::SISL UNKNOWN IMPORTED GLOBAL)
    set_target_properties(SISL::SISL PROPERTIES IMPORTED_LOCATION "${KNOTWORK_SISL_LIBRARY}"
                                                INTERFACE_INCLUDE_DIRECTORIES "${KNOTWORK_SISL_INCLUDE}")
  endif()
endfunction()

# OpenCASCADE's geometry, for the contest of benchmarks: the target OpenCASCADE::OpenCASCADE exists afterwards exactly
# where its package is on the system (Debian: libocct-modeling-data-dev). Its headers count as the system's.
function(knotwork_find_opencascade)
  if(TARGET OpenCASCADE::OpenCASCADE)
    return()
  endif()
  find_path(KNOTWORK_OPENCASCADE_INCLUDE GeomAdaptor_Curve.hxx PATH_SUFFIXES opencascade)
  find_library(KNOTWORK_OPENCASCADE_KERNEL TKernel)
  find_library(KNOTWORK_OPENCASCADE_MATH TKMath)
  find_library(KNOTWORK_OPENCASCADE_GEOMETRY TKG3d)
  mark_as_advanced(KNOTWORK_OPENCASCADE_INCLUDE KNOTWORK_OPENCASCADE_KERNEL KNOTWORK_OPENCASCADE_MATH
                   KNOTWORK_OPENCASCADE_GEOMETRY)
  if(KNOTWORK_OPENCASCADE_INCLUDE AND KNOTWORK_OPENCASCADE_KERNEL AND KNOTWORK_OPENCASCADE_MATH
     AND KNOTWORK_OPENCASCADE_GEOMETRY)
    add_library(OpenCASCADE::OpenCASCADE INTERFACE IMPORTED GLOBAL)
    set_target_properties(OpenCASCADE::OpenCASCADE PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${KNOTWORK_OPENCASCADE_INCLUDE}"
      INTERFACE_LINK_LIBRARIES
        "${KNOTWORK_OPENCASCADE_GEOMETRY};${KNOTWORK_OPENCASCADE_MATH};${KNOTWORK_OPENCASCADE_KERNEL}")
  endif()
endfunction()
