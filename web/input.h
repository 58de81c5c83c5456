#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace knotwork::web {

enum class PointerType : unsigned char { move, down, up, cancel, leave };
enum class PointerDevice : unsigned char { mouse, pen, touch };

struct Modifiers {
  bool shift = false, control = false, alt = false, meta = false;
};

/// One DOM pointer event, positions in CSS pixels of the stage, time in milliseconds.
struct PointerEvent {
  PointerType type;
  int id;
  PointerDevice device;
  glm::dvec2 position;
  int button;  ///< 0 left, 1 middle, 2 right, -1 none
  Modifiers modifiers;
  double time;
};

struct WheelEvent {
  glm::dvec2 delta, position;
  Modifiers modifiers;
};

struct KeyEvent {
  bool down;
  std::string key;  ///< KeyboardEvent.key
  Modifiers modifiers;
};

}  // namespace knotwork::web
