#include "web/words.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdio>

namespace knotwork::web {

std::string text_of(const char* format, double value) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  std::string text(buffer.data());
  // A value that rounds to zero has no sign.
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  // The typographic minus is as wide as a figure.
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> figures{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return std::string(figures[static_cast<std::size_t>(std::clamp(number, 0, 9))]);
}

std::string subscript(int number) {
  const Words words = Words().below(number);
  return std::string(std::string_view(words));
}

Words& Words::add(std::string_view words) {
  std::size_t fits = std::min(words.size(), text_.size() - 1 - size_);
  // Not in the middle of a character's bytes.
  while (fits > 0 && fits < words.size() && (static_cast<unsigned char>(words[fits]) & 0xC0U) == 0x80) --fits;
  std::copy_n(words.begin(), fits, text_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += fits;
  return *this;
}

Words& Words::add(int number) {
  std::array<char, 12> figures{};
  const auto end = std::to_chars(figures.begin(), figures.end(), number).ptr;
  return add({figures.data(), static_cast<std::size_t>(end - figures.data())});
}

Words& Words::below(int number) {
  assert(number >= 0);
  std::array<char, 12> figures{};
  const auto end = std::to_chars(figures.begin(), figures.end(), number).ptr;
  for (const char* figure = figures.data(); figure != end; ++figure) {
    const std::array<char, 3> lowered{'\xE2', '\x82', static_cast<char>(0x80 + (*figure - '0'))};
    add({lowered.data(), lowered.size()});
  }
  return *this;
}

}  // namespace knotwork::web
