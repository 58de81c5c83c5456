#include "knotwork/scene/messages.h"

#include <cstdio>

namespace knotwork::scene {

std::string number_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", x);
  return text;
}

std::string number_message(const Limits& limits) {
  return "Must be a number from " + number_text(limits.min) + " to " + number_text(limits.max) + ".";
}

std::string integer_message(const Limits& limits) {
  return "Must be a whole number from " + number_text(limits.min) + " to " + number_text(limits.max) + ".";
}

}  // namespace knotwork::scene
