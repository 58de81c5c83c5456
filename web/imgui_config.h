#pragma once

// ImGui's own configuration (IMGUI_USER_CONFIG): weight in the download that nothing here uses. It reads window settings
// and typed numbers with sscanf; there are neither.

#include <cstdio>

#define sscanf(...) 0               // NOLINT: ImGui calls it by this name
#define IMGUI_DISABLE_DEFAULT_FONT  // known from 1.92 on; for 1.90 see ImGui.cmake
#define IMGUI_DISABLE_OBSOLETE_FUNCTIONS
#define IMGUI_DISABLE_DEMO_WINDOWS
#define IMGUI_DISABLE_DEBUG_TOOLS
#define IMGUI_DISABLE_FILE_FUNCTIONS  // no file system in the page
#define IMGUI_DISABLE_DEFAULT_SHELL_FUNCTIONS
