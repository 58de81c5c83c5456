# Paths relative to core/. Explicit on purpose: a file that is not named here is not built.
set(KNOTWORK_GEOMETRY_SOURCES
  knotwork/basis/blending_function.cpp
  knotwork/basis/expo_rational_table.cpp
  knotwork/basis/knot_vector.cpp
  knotwork/mesh/blending_tables.cpp
  knotwork/mesh/surface_sampling.cpp
  knotwork/surface/blending_surface.cpp
  knotwork/surface/model_surface.cpp
  knotwork/surface/surface_measures.cpp
)
set(KNOTWORK_GEOMETRY_HEADERS
  knotwork/result.h
  knotwork/basis/blending_function.h
  knotwork/basis/knot_vector.h
  knotwork/mesh/blending_tables.h
  knotwork/mesh/mesh_data.h
  knotwork/mesh/surface_sampling.h
  knotwork/surface/blending_surface.h
  knotwork/surface/model_surface.h
  knotwork/surface/surface_jet.h
  knotwork/surface/surface_measures.h
  knotwork/surface/taylor2.h
)
# Used by the sources above only, not installed.
set(KNOTWORK_GEOMETRY_PRIVATE_HEADERS
  knotwork/basis/expo_rational_table.h
)
