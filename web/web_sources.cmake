# Needs neither GL nor Emscripten nor ImGui: also built natively, with tests.
set(KNOTWORK_WEB_LOGIC_SOURCES
  camera.cpp
  composition.cpp
  gizmo.cpp
  holding.cpp
  interaction.cpp
  patch_drag.cpp
  theme.cpp)

# The browser's part.
set(KNOTWORK_WEB_APP_SOURCES
  app.cpp
  bridge.cpp
  curve_ornaments.cpp
  gl_objects.cpp
  interface_style.cpp
  interface_widgets.cpp
  knot_strip.cpp
  main.cpp
  panels.cpp
  renderer.cpp
  script_interface.cpp
  stage_ornaments.cpp)

set(KNOTWORK_SHADERS
  shaders/background.frag
  shaders/blending.glsl
  shaders/blur.frag
  shaders/disc.frag
  shaders/disc.vert
  shaders/fullscreen.vert
  shaders/ground.frag
  shaders/ground.vert
  shaders/palette.glsl
  shaders/ribbon.frag
  shaders/ribbon.vert
  shaders/shadow.frag
  shaders/shadow.vert
  shaders/sheet.frag
  shaders/sheet.vert
  shaders/surface.frag
  shaders/surface.vert)
