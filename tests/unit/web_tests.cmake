# Paths relative to tests/. What the front end does without GL, ImGui and Emscripten.
set(KNOTWORK_WEB_TESTS
  unit/camera_test.cpp
  unit/composition_test.cpp
  unit/curve_ornaments_test.cpp
  unit/curve_path_test.cpp
  unit/curve_tools_test.cpp
  unit/drawing_test.cpp
  unit/freehand_test.cpp
  unit/gizmo_test.cpp
  unit/interaction_test.cpp
  unit/local_curve_hold_test.cpp
  unit/patch_drag_test.cpp
  unit/stage_grid_test.cpp
  unit/still_test.cpp
  unit/surface_quality_test.cpp
  unit/words_test.cpp
)
