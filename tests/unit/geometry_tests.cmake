# Paths relative to tests/. unit/main.cpp holds the one main() and is not listed.
set(KNOTWORK_GEOMETRY_TESTS
  unit/blending_function_test.cpp
  unit/blending_surface_test.cpp
  unit/blending_tables_test.cpp
  unit/knot_vector_test.cpp
  unit/model_surface_test.cpp
  unit/oracle_test.cpp
  unit/result_test.cpp
  unit/surface_measures_test.cpp
  unit/surface_sampling_test.cpp
  unit/taylor2_test.cpp
  property/blending_function_laws_test.cpp
  property/blending_surface_laws_test.cpp
  property/model_surface_laws_test.cpp
  property/surface_sampling_laws_test.cpp
)
