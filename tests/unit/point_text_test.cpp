#include "knotwork/scene/point_text.h"

#include <string>

#include <doctest/doctest.h>

#include "unit/float_traps.h"

namespace knotwork::scene::point_text_test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points read(std::string_view text) {
  const Result<Points> points = parse_points(text);
  CAPTURE((points ? std::string() : points.error().path + ": " + points.error().message));
  REQUIRE(points);
  return points.value();
}

std::string refusal(std::string_view text) {
  const Result<Points> points = parse_points(text);
  REQUIRE_FALSE(points);
  return points.error().path + ": " + points.error().message;
}

const Points two{{1, 2, 0}, {-3.5, 4e-2, 5}};

}  // namespace

TEST_CASE("point text: tables, spaces, semicolons and JSON say the same") {
  for (const char* text : {
           "1 2\n-3.5 0.04 5",
           "1,2\n-3.5,4e-2,5\n",
           "1, 2,\r\n-3.5, 4E-2, +5\r\n\r\n",
           "\n\n  1\t2\n\n\t-3.5\t.04\t5  \n",
           "1;2\n-3.5;0.04;5.",
           "x,y,z\n1,2\n-3.5,0.04,5",
           "\357\273\2771,2\n-3.5,0.04,5",
           "\xEF\xBB\xBFx,y,z\n1,2\n-3.5,0.04,5",
           "\"x\",\"y\"\n\"1\",\"2\"\n\"-3.5\",\"0.04\",\"5\"",
           "# two points\n1 2 # the first\n-3.5 0.04 5",
           "[[1,2],[-3.5,0.04,5]]",
           "[\n  [\n    1,\n    2\n  ],\n  [-3.5, 4e-2, 5]\n]\n",
           "[1, 2]\n[-3.5, 0.04, 5]",
           "(1, 2), (-3.5, 0.04, 5)",
           "{{1, 2}, {-3.5, 0.04, 5}}",
       }) {
    CAPTURE(text);
    CHECK(read(text) == two);
  }
  CHECK(read("0 0").size() == 1);
  CHECK(read("1e6 -1e6 0").front() == Eigen::Vector3d(1e6, -1e6, 0));
}

TEST_CASE("point text: what is wrong is said, and in which line") {
  CHECK(refusal("1 2\n3 four 5") == "line 2: “four” is not a number; a point is 2 or 3 numbers, as 1.5, 2, 0.");
  CHECK(refusal("1 2\n\n3").find("line 3: There is one number alone") == 0);
  CHECK(refusal("1 2 3 4").find("line 1: There are more than 3 numbers") == 0);
  CHECK(refusal("[1, 2, 3, 4, 5, 6]").find("line 1: There are more than 3 numbers") == 0);
  CHECK(refusal("[[1,2],[3,4]").find(": A bracket is opened and never closed.") == 0);
  CHECK(refusal("1 2]").find("line 1: A bracket is closed") == 0);
  CHECK(refusal("[1 [2 3]]").find("line 1: A bracket opens in the middle") == 0);
  CHECK(refusal("1 2\n3 1e7").find("line 2: “1e7” is too large") == 0);
  CHECK(refusal("{\"x\": 1, \"y\": 2}").find("line 1: “x” is not a number") == 0);
  for (const char* text : {"", " \n\t\n", "# nothing", "[]", "[[],[]]"})
    CHECK(refusal(text) == ": There are no points here: write one on each line, as 1.5, 2 or 1.5, 2, 0.");
}

TEST_CASE("point text: what only looks like a number is none") {
  const test::FloatTrapsOff traps_off;  // strtod of 1e999
  for (const char* word : {"nan", "NaN", "inf", "-inf", "Infinity", "0x10", "1e", "1..2", "--1", "1e999", "-1e999",
                           "1.5.", "+", ".", "1_000", "½", "1e1e1"}) {
    CAPTURE(word);
    CHECK(refusal("0 0\n1 " + std::string(word)).find("line 2: ") == 0);
    CHECK(refusal(std::string(word) + " 1").find("line 1: ") == 0);
  }
  CHECK(refusal("nan nan\n1 2").find("line 1: “nan” is not a number") == 0);
  CHECK(refusal(std::string("1 2\n3 \0 4", 9)).find("line 2: “?” is not a number") == 0);
  CHECK(refusal("1 2\n<script>alert(1)</script> 2").find("line 2: “<script>alert") == 0);
}

TEST_CASE("point text: a million points and 50 MB of anything are refused at once, with what to do") {
  std::string million;
  for (int k = 0; k < 1000000; ++k) million += "1.25 2.5 3.75\n";
  CHECK(refusal(million) == "line 20001: There are more than 20000 points: keep fewer, for instance every tenth line.");
  CHECK(read(std::string_view(million).substr(0, 20000 * 14)).size() == 20000);
  const std::size_t size = 50u << 20;
  CHECK(refusal(std::string(size, 'a')).find("line 1: “aaaaaaaaaaaaaaaaaaaaaaaa…” is not a number") == 0);
  CHECK(refusal(std::string(size, '[')) == ": The text is longer than 8 MiB: keep fewer points.");
  CHECK(refusal(std::string(size, ' ')) == ": The text is longer than 8 MiB: keep fewer points.");
  CHECK(refusal(std::string(size, '\n')) == ": The text is longer than 8 MiB: keep fewer points.");
  CHECK(refusal(std::string(size, '7')).find("line 1: “777777777777777777777777…” is not a number") == 0);
  CHECK(refusal("1 2\n" + std::string(size, ' ')) == ": The text is longer than 8 MiB: keep fewer points.");
}

}  // namespace knotwork::scene::point_text_test
