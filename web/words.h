#pragma once

#include <array>
#include <string>
#include <string_view>

namespace knotwork::web {

/// printf's format for one number, at most 47 bytes of it; without the sign of what rounds to zero, with the typographic
/// minus.
std::string text_of(const char* format, double value);
/// A raised figure: "²". From 0 to 9; what lies outside is the nearer of the two.
std::string superscript(int number);
/// Figures below the line: "₁₂". Precondition: number >= 0.
std::string subscript(int number);

/// A few words put together without asking for memory; what is longer than 191 bytes is cut off between
/// characters.
class Words {
 public:
  Words& add(std::string_view words);
  Words& add(int number);
  /// Figures below the line. Precondition: number >= 0.
  Words& below(int number);
  const char* c_str() const { return text_.data(); }
  operator std::string_view() const { return {text_.data(), size_}; }  // NOLINT(google-explicit-constructor)

 private:
  std::array<char, 192> text_{};  ///< with a zero behind the words
  std::size_t size_ = 0;
};

}  // namespace knotwork::web
