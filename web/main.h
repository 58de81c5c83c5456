#pragma once

#include <string>

#include "web/app.h"

namespace knotwork::web {

/// The one pointer at the platform boundary: the page's program, made by knotwork_start.
App* app();

/// Makes the program and a WebGL2 context on the canvas. Empty, or why there is none.
std::string start(const char* canvas_selector);
/// The context was lost, or is back on the same canvas. False when the stage cannot be drawn now.
bool context_changed(bool present);
/// Gives the canvas its size in device pixels and tells the program.
void resize(double css_width, double css_height, double pixel_ratio);
/// Asks the page for a frame, if the program wants one.
void ask_for_frame();

}  // namespace knotwork::web
