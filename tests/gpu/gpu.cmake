# The vertex shader beside the core, in a page of its own: build/web/tests/gpu. The browser's tests open it.

add_executable(knotwork_shader_check
  gpu/shader_check.cpp
  "${PROJECT_SOURCE_DIR}/web/gl_objects.cpp"
  "${PROJECT_SOURCE_DIR}/web/surface_textures.cpp")
knotwork_own_code(knotwork_shader_check)
target_link_libraries(knotwork_shader_check PRIVATE knotwork_web_logic)
set_target_properties(knotwork_shader_check PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/gpu"
  OUTPUT_NAME shader_check)
target_link_options(knotwork_shader_check PRIVATE
  -sMODULARIZE=1 -sEXPORT_ES6=1
  -sENVIRONMENT=web
  -sDYNAMIC_EXECUTION=0
  -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sALLOW_MEMORY_GROWTH=1
  -sEXIT_RUNTIME=1
  -sINVOKE_RUN=1
  $<$<CONFIG:Release>:-O1>)
foreach(file IN ITEMS index.html run.js)
  configure_file("gpu/${file}" "${CMAKE_CURRENT_BINARY_DIR}/gpu/${file}" COPYONLY)
endforeach()
