#pragma once

#include <array>
#include <string>
#include <string_view>

namespace knotwork::web {

/// printf's format for one number; without the sign of what rounds to zero, with the typographic minus.
std::string text_of(const char* format, double value);
/// Raised figures, from 0 to 9.
std::string superscript(int number);
/// Figures below the line.
std::string subscript(int number);

/// A few words put together without asking for memory; what is too long is cut off.
class Words {
 public:
  Words& add(std::string_view words);
  Words& add(int number);
  /// Figures below the line.
  Words& below(int number);
  const char* c_str() const { return text_.data(); }
  operator std::string_view() const { return {text_.data(), size_}; }  // NOLINT(google-explicit-constructor)

 private:
  std::array<char, 64> text_{};  ///< with a zero behind the words
  std::size_t size_ = 0;
};

}  // namespace knotwork::web
