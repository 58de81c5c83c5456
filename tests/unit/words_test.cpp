#include "web/words.h"

#include <string>

#include <doctest/doctest.h>

namespace knotwork::web::words_test {
namespace {

TEST_CASE("words are put together, figures lowered and raised") {
  CHECK(std::string_view(Words().add("t").below(12)) == "t₁₂");
  CHECK(std::string_view(Words().add("n = ").add(-7)) == "n = -7");
  CHECK(subscript(305) == "₃₀₅");
  CHECK(superscript(2) == "²");
  CHECK(superscript(-1) == "⁰");
  CHECK(superscript(12) == "⁹");
}

TEST_CASE("what is too long is cut off, and the end is a zero") {
  const std::string long_text(300, 'x');
  const Words words = Words().add(long_text).add("y");
  CHECK(std::string_view(words) == long_text.substr(0, 191));
  CHECK(words.c_str()[191] == '\0');
}

TEST_CASE("numbers have the typographic minus, and none where they round to zero") {
  CHECK(text_of("%.2f", -1.5) == "−1.50");
  CHECK(text_of("%.2f", -0.001) == "0.00");
  CHECK(text_of("%.0f", -0.1) == "0");
}

}  // namespace
}  // namespace knotwork::web::words_test
