// The least that a page of Dear ImGui on WebGL2 is: what the loading of ours is measured beside (benchmark/loading.mjs).

#include <GLES3/gl3.h>
#include <emscripten.h>
#include <emscripten/html5.h>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace {

void draw_frame() {
  ImGui::GetIO().DisplaySize = {640, 400};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  ImGui::Begin("Empty");
  ImGui::TextUnformatted("Nothing");
  ImGui::End();
  ImGui::Render();
  glViewport(0, 0, 640, 400);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace

int main() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  emscripten_webgl_make_context_current(emscripten_webgl_create_context("#canvas", &attributes));
  ImGui::CreateContext();
  ImGui_ImplOpenGL3_Init("#version 300 es");
  emscripten_set_main_loop(draw_frame, 0, 0);
}
