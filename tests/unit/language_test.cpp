#include "web/language.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>

namespace knotwork::web::language_test {
namespace {

std::vector<std::string> asked;  // NOLINT: a translator is a plain function
std::string last_heard;          // NOLINT

std::string shout(const std::string& english) {
  asked.push_back(english);
  if (english == "from {} to {}") return "BIS {2} VON {1}";
  return english == "point" ? "PUNKT" : "!" + english;
}

/// For the length of a test.
struct Abroad {
  Abroad() {
    asked.clear();
    translate_by(shout, [](std::string_view words) { last_heard = words; });
  }
  ~Abroad() { translate_by(nullptr); }
  Abroad(const Abroad&) = delete;
  Abroad& operator=(const Abroad&) = delete;
};

std::string_view view(const Sentence& sentence) { return sentence; }

TEST_CASE("English is said as it stands, in the memory where it stands") {
  const std::string_view english = "patches";
  CHECK(!translates());
  CHECK(std::string_view(say(english)).data() == english.data());
  CHECK(say_once("patches") == "patches");
  heard(say(english));  // nobody listens
}

TEST_CASE("another language is asked once for each text, and what it says stays where it is") {
  const Abroad abroad;
  CHECK(translates());
  const std::string_view first = say("point");
  CHECK(first == "PUNKT");
  std::vector<std::string_view> others;
  others.reserve(500);
  for (int k = 0; k < 500; ++k) others.push_back(say("number " + std::to_string(k)));
  CHECK(asked.size() == 501);
  for (int k = 0; k < 500; ++k) {
    CHECK(others[static_cast<std::size_t>(k)] == "!number " + std::to_string(k));
    CHECK(std::string_view(say("number " + std::to_string(k))).data() == others[static_cast<std::size_t>(k)].data());
  }
  CHECK(first == "PUNKT");
  CHECK(asked.size() == 501);
  CHECK(std::string_view(say("")).empty());
  CHECK(say_once("point") == "PUNKT");
  CHECK(asked.size() == 502);
}

TEST_CASE("what need not be said is not, and all that is drawn is heard") {
  const Abroad abroad;
  CHECK(std::string_view(as_is("K 0.25")) == "K 0.25");
  CHECK(asked.empty());
  heard(as_is("K 0.25"));
  CHECK(last_heard == "K 0.25");
}

TEST_CASE("a sentence has its values where the language wants them") {
  CHECK(view(say("{} points, {} control points", 12, 5)) == "12 points, 5 control points");
  CHECK(view(say("{} at t = {}", std::string("C²"), std::string("0.25"))) == "C² at t = 0.25");
  CHECK(view(say("from {} to {}", 1, 2)) == "from 1 to 2");
  CHECK(view(say("{} left", -3)) == "-3 left");
  const Abroad abroad;
  CHECK(view(say("from {} to {}", 1, 2)) == "BIS 2 VON 1");
  CHECK(view(say("{} × {}", say("point"), as_is("u"))) == "!PUNKT × u");
}

TEST_CASE("a form with a value too few or half a brace is no trap") {
  CHECK(view(say("{} of {}", 1)) == "1 of ");
  CHECK(view(say("{2}{9}", 1)).empty());
  CHECK(view(say("a {", 1)) == "a 1");
  CHECK(view(say("{x} {}", 1, 2)) == "1x} 2");
}

TEST_CASE("a long translation is cut between characters") {
  std::string long_words;
  for (int k = 0; k < 200; ++k) long_words += "é";
  for (const std::string& before : {std::string(), std::string("a")}) {
    const Sentence cut = say("{}", before + long_words);
    CHECK(view(cut).size() + 2 > 191);
    CHECK(view(cut).size() <= 191);
    CHECK((view(cut).size() - before.size()) % 2 == 0);
    CHECK(view(cut) == (before + long_words).substr(0, view(cut).size()));
  }
}

}  // namespace
}  // namespace knotwork::web::language_test
