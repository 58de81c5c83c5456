# Laws that RapidCheck tries on what it draws, and agreement with SISL where that is on the system: a program of its own,
# native only. RapidCheck reports by exceptions, which the WebAssembly build is without.

knotwork_require_rapidcheck()
knotwork_find_sisl()

add_executable(knotwork_properties
  property/properties_main.cpp
  property/blending_properties.cpp
  property/bspline_properties.cpp
  property/fit_properties.cpp
  property/tensor_properties.cpp)
knotwork_own_code(knotwork_properties)
# Two batches, for two cores.
set_target_properties(knotwork_properties PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 3)
target_compile_options(knotwork_properties PRIVATE $<$<CONFIG:Release>:-O0>)
if(KNOTWORK_SANITIZE)
  target_compile_options(knotwork_properties PRIVATE -O0 -g1)
endif()
target_include_directories(knotwork_properties PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(knotwork_properties PRIVATE knotwork_geometry rapidcheck doctest::doctest
                                                  nlohmann_json::nlohmann_json)
if(TARGET SISL::SISL)
  target_sources(knotwork_properties PRIVATE property/sisl_agreement.cpp)
  target_link_libraries(knotwork_properties PRIVATE SISL::SISL)
else()
  message(STATUS "SISL is not on this system: the tests of agreement with it are not built")
  target_sources(knotwork_properties PRIVATE property/no_sisl.cpp)
endif()
target_compile_definitions(knotwork_properties PRIVATE KNOTWORK_TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/data")
add_test(NAME rapidcheck COMMAND knotwork_properties --no-colors)
