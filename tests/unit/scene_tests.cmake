# Paths relative to tests/.
#
# The schema's test reads core/knotwork/scene/document.schema.json from KNOTWORK_SCENE_DIR, a path without a slash at its
# end: the folder itself natively, /scene in WebAssembly, where the file is embedded. Both are set at the end of this
# list, which is included before the test executable is made.
set(KNOTWORK_SCENE_TESTS
  unit/blending_curve_edits_test.cpp
  unit/blending_curve_figure_test.cpp
  unit/catalogue_parameters_test.cpp
  unit/chapters_test.cpp
  unit/commands_test.cpp
  unit/curvature_field_test.cpp
  unit/curve_edits_test.cpp
  unit/curve_figure_test.cpp
  unit/curve_sampling_test.cpp
  unit/document_json_test.cpp
  unit/document_schema_test.cpp
  unit/facts_test.cpp
  unit/fit_edits_test.cpp
  unit/fit_figure_test.cpp
  unit/fitted_grid_test.cpp
  unit/history_test.cpp
  unit/measures_test.cpp
  unit/model_curve_figure_test.cpp
  unit/model_figure_test.cpp
  unit/motion_test.cpp
  unit/net_edits_test.cpp
  unit/net_roll_test.cpp
  unit/palette_test.cpp
  unit/parameters_test.cpp
  unit/picking_test.cpp
  unit/point_text_test.cpp
  unit/subdivision_edits_test.cpp
  unit/subdivision_figure_test.cpp
  unit/surface_builder_test.cpp
  unit/surface_joints_test.cpp
  fuzz/document_mutation_test.cpp
)

set(scene_folder "${CMAKE_CURRENT_SOURCE_DIR}/../core/knotwork/scene")
if(EMSCRIPTEN)
  add_link_options("--embed-file=${scene_folder}/document.schema.json@/scene/document.schema.json")
  set(scene_folder /scene)
endif()
add_compile_definitions("KNOTWORK_SCENE_DIR=\"${scene_folder}\"")
