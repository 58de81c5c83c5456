# The time of every evaluator, with Google Benchmark. Native only, and worth its name in an optimized build only.

knotwork_require_benchmark()

add_executable(knotwork_benchmark
  benchmark/main.cpp
  benchmark/curve_kernels.cpp
  benchmark/fitting_kernels.cpp
  benchmark/measure_kernels.cpp
  benchmark/surface_kernels.cpp)
knotwork_own_code(knotwork_benchmark)
# Optimized like the library: of the inline functions that both contain, the program keeps its own.
set_target_properties(knotwork_benchmark PROPERTIES UNITY_BUILD ON)
target_include_directories(knotwork_benchmark PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(knotwork_benchmark PRIVATE knotwork_geometry benchmark::benchmark)
# The comparison with the references alone: tests assert nothing about time.
add_test(NAME benchmark COMMAND knotwork_benchmark --check)
