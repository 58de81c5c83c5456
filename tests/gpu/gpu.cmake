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

# The least page of Dear ImGui, with its own typeface, for benchmark/loading.mjs alone.
get_target_property(imgui_sources knotwork_imgui KNOTWORK_IMGUI_SOURCES)
add_executable(knotwork_empty_page EXCLUDE_FROM_ALL
  gpu/empty_page.cpp
  "${imgui_sources}/imgui.cpp"
  "${imgui_sources}/imgui_draw.cpp"
  "${imgui_sources}/imgui_tables.cpp"
  "${imgui_sources}/imgui_widgets.cpp"
  "${imgui_sources}/backends/imgui_impl_opengl3.cpp")
target_compile_features(knotwork_empty_page PRIVATE cxx_std_20)
target_compile_options(knotwork_empty_page PRIVATE -Oz)
target_compile_definitions(knotwork_empty_page PRIVATE IMGUI_IMPL_OPENGL_ES3 IMGUI_DISABLE_FILE_FUNCTIONS)
target_include_directories(knotwork_empty_page SYSTEM PRIVATE "${imgui_sources}" "${imgui_sources}/backends")
set_target_properties(knotwork_empty_page PROPERTIES
  UNITY_BUILD OFF
  RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/gpu"
  OUTPUT_NAME empty_page)
target_link_options(knotwork_empty_page PRIVATE
  -sENVIRONMENT=web -sDYNAMIC_EXECUTION=0 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sALLOW_MEMORY_GROWTH=1 -Oz)
configure_file("gpu/empty.html" "${CMAKE_CURRENT_BINARY_DIR}/gpu/empty.html" COPYONLY)
