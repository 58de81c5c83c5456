# What the evaluators cost, alone (knotwork_benchmark) and beside their rivals (knotwork_contest, see compare). Worth
# their name in an optimized build only.

if(EMSCRIPTEN)
  # Google Benchmark needs more of a system than a page has: a main of its own.
  add_executable(knotwork_contest benchmark/wasm_main.cpp benchmark/work_kernels.cpp)
  knotwork_own_code(knotwork_contest)
  target_include_directories(knotwork_contest PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(knotwork_contest PRIVATE knotwork_geometry)
  target_link_options(knotwork_contest PRIVATE
    -sENVIRONMENT=node,web
    -sSINGLE_FILE=1              # the same file under Node.js and in a page
    -sEXIT_RUNTIME=1
    -sALLOW_MEMORY_GROWTH=1
    $<$<CONFIG:Release>:-O3>)
  add_test(NAME contest COMMAND knotwork_contest --check)
  return()
endif()

knotwork_require_benchmark()

# knotwork_benchmark_program(<target> SOURCES <source>...)
function(knotwork_benchmark_program target)
  cmake_parse_arguments(PARSE_ARGV 1 program "" "" "SOURCES")
  add_executable(${target} benchmark/main.cpp ${program_SOURCES})
  knotwork_own_code(${target})
  # Optimized like the library: of the inline functions that both contain, the program keeps its own.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE knotwork_geometry benchmark::benchmark)
  # The comparison with the references alone: tests assert nothing about time.
  add_test(NAME ${target} COMMAND ${target} --check)
endfunction()

knotwork_benchmark_program(knotwork_benchmark SOURCES
  benchmark/curve_kernels.cpp
  benchmark/evaluators.cpp
  benchmark/fitting_kernels.cpp
  benchmark/measure_kernels.cpp
  benchmark/surface_kernels.cpp)

# It asks glibc (2.33 and newer) for what is allocated.
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(mallinfo2 malloc.h KNOTWORK_HAS_MALLINFO2)
if(KNOTWORK_HAS_MALLINFO2)
  knotwork_benchmark_program(knotwork_scaling SOURCES benchmark/scaling.cpp)
endif()

# The works of the contest (see compare), with the rivals that are on the system.
knotwork_find_sisl()
knotwork_find_opencascade()
knotwork_benchmark_program(knotwork_contest SOURCES
  benchmark/contest.cpp
  benchmark/rival_eigen.cpp
  benchmark/rival_kernels.cpp
  benchmark/work_kernels.cpp)
# Not their files: each defines its own names for the same helpers.
set_target_properties(knotwork_contest PROPERTIES UNITY_BUILD OFF)
if(TARGET SISL::SISL)
  target_sources(knotwork_contest PRIVATE benchmark/rival_sisl.cpp)
  target_compile_definitions(knotwork_contest PRIVATE KNOTWORK_WITH_SISL)
  target_link_libraries(knotwork_contest PRIVATE SISL::SISL)
endif()
if(TARGET OpenCASCADE::OpenCASCADE)
  target_sources(knotwork_contest PRIVATE benchmark/rival_opencascade.cpp)
  target_compile_definitions(knotwork_contest PRIVATE KNOTWORK_WITH_OPENCASCADE)
  target_link_libraries(knotwork_contest PRIVATE OpenCASCADE::OpenCASCADE)
endif()

# The works as data, for rivals in other languages.
add_executable(knotwork_contest_samples benchmark/samples.cpp benchmark/work_kernels.cpp)
knotwork_own_code(knotwork_contest_samples)
target_include_directories(knotwork_contest_samples PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(knotwork_contest_samples PRIVATE knotwork_geometry nlohmann_json::nlohmann_json)

# For counting instructions (see instructions.mjs).
add_executable(knotwork_contest_once benchmark/once_main.cpp benchmark/work_kernels.cpp)
knotwork_own_code(knotwork_contest_once)
target_include_directories(knotwork_contest_once PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(knotwork_contest_once PRIVATE knotwork_geometry)
