#pragma once

// ImGui's own configuration (IMGUI_USER_CONFIG): weight in the download that nothing here uses.

#include <cstdio>

// ImGui reads window settings and typed numbers with sscanf; there are neither. Its GL backend reads the number in
// "#version 300 es" with it.
#ifdef KNOTWORK_IMGUI_BACKEND
inline int knotwork_scan_number(const char* text, const char* /*format*/, int* number, ...) {
  while (*text != '\0' && (*text < '0' || *text > '9')) ++text;
  if (*text == '\0') return 0;
  for (*number = 0; *text >= '0' && *text <= '9'; ++text) *number = 10 * *number + (*text - '0');
  return 1;
}
#define sscanf knotwork_scan_number  // NOLINT: the backend calls it by this name
#else
#define sscanf(...) 0  // NOLINT: ImGui calls it by this name
#endif

#define IMGUI_DISABLE_DEFAULT_FONT  // known from 1.92 on; for 1.90 see ImGui.cmake
#define IMGUI_DISABLE_OBSOLETE_FUNCTIONS
#define IMGUI_DISABLE_DEMO_WINDOWS
#define IMGUI_DISABLE_DEBUG_TOOLS
#define IMGUI_DISABLE_FILE_FUNCTIONS  // no file system in the page
#define IMGUI_DISABLE_DEFAULT_SHELL_FUNCTIONS
