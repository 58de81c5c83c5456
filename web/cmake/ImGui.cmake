# Dear ImGui 1.90.1 with its OpenGL ES 3 backend as the static library knotwork_imgui.

include_guard(GLOBAL)

set(KNOTWORK_IMGUI_SOURCE_DIR "" CACHE PATH "Dear ImGui's sources, where they are already at hand")
set(imgui_sources "${KNOTWORK_IMGUI_SOURCE_DIR}")
if(NOT imgui_sources)
  set(imgui_sources "${KNOTWORK_DEPENDENCY_CACHE}/imgui")
  execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/fetch-imgui.sh" "${imgui_sources}" RESULT_VARIABLE imgui_result)
  if(NOT imgui_result EQUAL 0)
    message(STATUS "Dear ImGui: not from a Debian archive, downloading the pinned commit")
    FetchContent_Declare(imgui
      GIT_REPOSITORY https://github.com/ocornut/imgui.git
      GIT_TAG d6cb3c923d28dcebb2d8d9605ccc7229ccef19eb) # 1.90.1
    FetchContent_MakeAvailable(imgui)
    set(imgui_sources "${imgui_SOURCE_DIR}")
  endif()
endif()

# The page brings its own typefaces. ImGui's built-in one is 12 KB that do not compress, and 1.90 has no switch against
# it: its data are left out of a copy. (1.92 has IMGUI_DISABLE_DEFAULT_FONT.)
set(imgui_draw "${CMAKE_CURRENT_BINARY_DIR}/generated/imgui_draw.cpp")
file(READ "${imgui_sources}/imgui_draw.cpp" imgui_draw_text)
string(FIND "${imgui_draw_text}" "static const char proggy_clean_ttf_compressed_data_base85[" font_begin)
string(FIND "${imgui_draw_text}" "static const char* GetDefaultCompressedFontDataTTFBase85()\n{" font_end)
if(font_begin GREATER 0 AND font_end GREATER font_begin)
  string(SUBSTRING "${imgui_draw_text}" 0 ${font_begin} before_font)
  string(SUBSTRING "${imgui_draw_text}" ${font_end} -1 after_font)
  set(imgui_draw_text
      "${before_font}static const char proggy_clean_ttf_compressed_data_base85[] = \"\";\n\n${after_font}")
endif()
file(CONFIGURE OUTPUT "${imgui_draw}" CONTENT "${imgui_draw_text}" @ONLY)

add_library(knotwork_imgui STATIC
  "${imgui_sources}/imgui.cpp"
  "${imgui_draw}"
  "${imgui_sources}/imgui_tables.cpp"
  "${imgui_sources}/imgui_widgets.cpp"
  "${imgui_sources}/backends/imgui_impl_opengl3.cpp")
set_source_files_properties("${imgui_sources}/backends/imgui_impl_opengl3.cpp" PROPERTIES
  COMPILE_DEFINITIONS KNOTWORK_IMGUI_BACKEND)
set_target_properties(knotwork_imgui PROPERTIES
  UNITY_BUILD OFF  # its files are not written for it
  KNOTWORK_IMGUI_SOURCES "${imgui_sources}")
target_include_directories(knotwork_imgui SYSTEM PUBLIC "${imgui_sources}" "${imgui_sources}/backends")
target_compile_features(knotwork_imgui PUBLIC cxx_std_20)
target_include_directories(knotwork_imgui PUBLIC "${PROJECT_SOURCE_DIR}")
target_compile_definitions(knotwork_imgui PUBLIC
  IMGUI_IMPL_OPENGL_ES3                         # WebGL2 is OpenGL ES 3
  IMGUI_USER_CONFIG=\"web/imgui_config.h\")
knotwork_small(knotwork_imgui)
knotwork_floating_point(knotwork_imgui)
knotwork_webassembly(knotwork_imgui)
knotwork_exceptions(knotwork_imgui)
