# Paths relative to tests/.
#
# For whoever writes the build: these tests need two macros, each a path as a string literal without a slash at its end,
#   KNOTWORK_SCENE_DIR  the folder of document.schema.json (core/knotwork/scene; embedded at /scene in WebAssembly),
#   KNOTWORK_TEST_DATA_DIR  tests/data (embedded at /data in WebAssembly),
# and nlohmann/json.hpp on the include path, as document_json.cpp does.
set(KNOTWORK_SCENE_TESTS
  unit/chapters_test.cpp
  unit/commands_test.cpp
  unit/document_json_test.cpp
  unit/document_schema_test.cpp
  unit/history_test.cpp
  unit/motion_test.cpp
  unit/palette_test.cpp
  unit/parameters_test.cpp
  unit/picking_test.cpp
  unit/surface_builder_test.cpp
  fuzz/document_mutation_test.cpp
)
