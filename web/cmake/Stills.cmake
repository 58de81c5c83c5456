# build/web/module/knotwork_stills.js: still pictures of the page's figures, under Node, for the site's build.

add_executable(knotwork_stills still_main.cpp)
knotwork_own_code(knotwork_stills)
target_link_libraries(knotwork_stills PRIVATE knotwork_still)
set_target_properties(knotwork_stills PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/module")
target_link_options(knotwork_stills PRIVATE
  -sMODULARIZE=1 -sEXPORT_NAME=createStills
  -sENVIRONMENT=node
  -sSINGLE_FILE=1              # one file, wherever it is copied to
  -sFILESYSTEM=0
  -sALLOW_MEMORY_GROWTH=1
  "-sEXPORTED_RUNTIME_METHODS=[ccall]"
  --no-entry
  $<$<CONFIG:Release>:-O1>)
add_dependencies(knotwork knotwork_stills)  # the site needs both
