# The page's module: build/web/module/knotwork.js and knotwork.wasm.

add_executable(knotwork ${KNOTWORK_WEB_APP_SOURCES})
knotwork_own_code(knotwork)
knotwork_small(knotwork)
target_link_libraries(knotwork PRIVATE knotwork_web_logic knotwork_imgui nlohmann_json::nlohmann_json)
target_compile_definitions(knotwork PRIVATE KNOTWORK_VERSION="${PROJECT_VERSION}" JSON_NO_IO)
set_target_properties(knotwork PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/module")

target_link_options(knotwork PRIVATE
  -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=createKnotwork # the shell imports one factory function
  -sENVIRONMENT=web            # no code for Node or workers
  -sDYNAMIC_EXECUTION=0        # no eval: the page's security policy forbids it
  -sFILESYSTEM=0               # nothing is read or written
  -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 # the renderer speaks WebGL2 only
  -sALLOW_MEMORY_GROWTH=1      # 1024x1024 samples need more than the usual page, most readers far less
  -sMALLOC=emmalloc            # smaller than dlmalloc; nothing here allocates per vertex
  -sEXIT_RUNTIME=0             # main() returns, the page goes on calling exported functions
  -sSTRICT=1                   # no deprecated defaults
  -lGL -lhtml5.js -lhtml5_webgl.js # what strictness no longer links by itself
  -sALLOW_UNIMPLEMENTED_SYSCALLS=1 # ImGui's and libc++'s printing refer to calls that are never made
  --profiling-funcs            # names of functions, by which the module is split; the parts lose them
  # Inlined where they are called once, functions of a later part would be in the first.
  -sBINARYEN_EXTRA_PASSES=--one-caller-inline-max-function-size=0
  "-sEXPORTED_FUNCTIONS=[_main,_malloc,_free]"
  "-sEXPORTED_RUNTIME_METHODS=[ccall,UTF8ToString,stringToUTF8,lengthBytesUTF8,writeArrayToMemory]"
  $<$<CONFIG:Release>:-flto>
  $<$<CONFIG:Release>:-Oz>)

# Binaryen cuts the module in three (split_module.mjs) and optimizes the parts once more: a good hundredth less to
# download. Newer releases turn on more features than are named here.
find_program(KNOTWORK_NODE NAMES node nodejs REQUIRED)
find_program(KNOTWORK_WASM_SPLIT wasm-split HINTS "${EMSCRIPTEN_ROOT_PATH}/../bin" REQUIRED)
cmake_path(GET KNOTWORK_WASM_SPLIT PARENT_PATH binaryen_folder)
if(EMSCRIPTEN_VERSION VERSION_LESS 4)
  set(wasm_features --enable-simd --enable-nontrapping-float-to-int --enable-sign-ext --enable-bulk-memory
                    --enable-mutable-globals)
else()
  set(wasm_features -all)
endif()
set(wasm_passes $<$<CONFIG:Release>:--flatten> $<$<CONFIG:Release>:--rereloop> $<$<CONFIG:Release>:-Oz> -Oz)
set(split_script "${CMAKE_CURRENT_LIST_DIR}/split_module.mjs")
set_property(TARGET knotwork APPEND PROPERTY LINK_DEPENDS "${split_script}")
add_custom_command(TARGET knotwork POST_BUILD
  COMMAND "${KNOTWORK_NODE}" "${split_script}" "${binaryen_folder}" "$<TARGET_FILE_DIR:knotwork>/knotwork.wasm"
          "$<TARGET_FILE_DIR:knotwork>/later.wasm" "$<TARGET_FILE_DIR:knotwork>/last.wasm"
          ${wasm_features} ${wasm_passes}
  COMMAND_EXPAND_LISTS
  COMMENT "Splitting knotwork.wasm"
  VERBATIM)
