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
  "-sEXPORTED_FUNCTIONS=[_main,_malloc,_free]"
  "-sEXPORTED_RUNTIME_METHODS=[ccall,UTF8ToString,stringToUTF8,lengthBytesUTF8,writeArrayToMemory]"
  $<$<CONFIG:Release>:-flto>
  $<$<CONFIG:Release>:-Oz>)

# Binaryen once more over what em++ leaves: a good hundredth less to download. (Newer releases turn on more features than
# are named here, and optimize more themselves.)
find_program(KNOTWORK_WASM_OPT wasm-opt HINTS "${EMSCRIPTEN_ROOT_PATH}/../bin")
if(KNOTWORK_WASM_OPT AND CMAKE_BUILD_TYPE STREQUAL "Release" AND EMSCRIPTEN_VERSION VERSION_LESS 4)
  add_custom_command(TARGET knotwork POST_BUILD
    COMMAND "${KNOTWORK_WASM_OPT}" --enable-simd --enable-nontrapping-float-to-int --enable-sign-ext
            --enable-bulk-memory --enable-mutable-globals --flatten --rereloop -Oz -Oz
            "$<TARGET_FILE_DIR:knotwork>/knotwork.wasm" -o "$<TARGET_FILE_DIR:knotwork>/knotwork.wasm"
    COMMENT "Optimizing knotwork.wasm"
    VERBATIM)
endif()
