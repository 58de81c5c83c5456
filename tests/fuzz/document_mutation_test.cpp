#include <array>
#include <string>

#include <doctest/doctest.h>

#include "fuzz/document_properties.h"
#include "knotwork/scene/chapters.h"
#include "unit/float_traps.h"

namespace knotwork::scene::document_mutation_test {
namespace {

/// Marsaglia's xorshift: the same texts on every machine and in every build.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_ % n;
  }

 private:
  std::uint32_t state_;
};

/// Fragments that hurt parsers and limits.
constexpr std::array<std::string_view, 20> fragments{
    "0", "-1", "1e999", "NaN", "null", "true", "\"\"", "{}",       "[",          "]",
    "{", "}",  ",",     ":",   "\\u",  "\xff", "1e-5", "\"open\"", "1000000000", "0.30000000000000004"};

std::string mutated(std::string text, Random& random) {
  const std::size_t mutations = 1 + random.below(3);
  for (std::size_t k = 0; k < mutations; ++k) {
    const std::size_t place = random.below(text.size()), length = random.below(12);
    switch (random.below(5)) {
      case 0:
        text[place] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(place, length);
        break;
      case 2:
        text.insert(place, fragments[random.below(fragments.size())]);
        break;
      case 3:
        text.insert(place, text.substr(random.below(text.size()), length));
        break;
      default: {
        // A whole number replaced: what most often still parses.
        const std::size_t digit = text.find_first_of("0123456789", place);
        if (digit == std::string::npos) break;
        const std::size_t end = text.find_first_not_of("0123456789.e-", digit);
        text.replace(digit, end == std::string::npos ? std::string::npos : end - digit,
                     fragments[random.below(fragments.size())]);
      }
    }
    if (text.empty()) text = "{";
  }
  return text;
}

}  // namespace

TEST_CASE("document mutations: damaged documents are refused in words or are documents") {
  Document document = find_chapter("blending-surface")->start_document();
  blending_surface(document).edits[{1, 3}].translation = {0.1, 0.2, 0.3};
  const std::string text = write_document(document);
  Random random(20240607);
  const test::FloatTrapsOff traps_off;
  int accepted_count = 0, refused_count = 0;
  for (int k = 0; k < 4000; ++k) {
    const std::string candidate = mutated(text, random);
    CAPTURE(candidate);
    bool accepted = false;
    REQUIRE(test::text_is_handled(candidate, accepted));
    ++(accepted ? accepted_count : refused_count);
  }
  // Both ways must have been tried, or the mutations show nothing.
  CHECK(accepted_count > 50);
  CHECK(refused_count > 1000);
}

}  // namespace knotwork::scene::document_mutation_test
