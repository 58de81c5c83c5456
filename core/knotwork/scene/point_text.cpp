#include "knotwork/scene/point_text.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "knotwork/scene/messages.h"

namespace knotwork::scene {

namespace {

/// No number that a double can tell from its neighbours needs more characters.
constexpr std::size_t longest_number = 400, longest_excerpt = 24;

bool separates(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';' || c == '"' || c == '\''; }
bool opens(char c) { return c == '[' || c == '(' || c == '{'; }
bool shuts(char c) { return c == ']' || c == ')' || c == '}'; }
bool belongs_to_word(char c) { return !separates(c) && !opens(c) && !shuts(c) && c != '\n' && c != '#'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool begins_number(char c) { return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.'; }

std::optional<double> number_of(std::string_view word) {
  if (word.size() > longest_number || !begins_number(word.front())) return std::nullopt;
  // strtod knows more spellings than a reader means: 0x10, nan, inf.
  for (const char c : word)
    if (is_letter(c) && c != 'e' && c != 'E') return std::nullopt;
  std::array<char, longest_number + 1> digits{};
  std::memcpy(digits.data(), word.data(), word.size());
  char* end = nullptr;
  const double value = std::strtod(digits.data(), &end);
  if (end != digits.data() + word.size()) return std::nullopt;
  return value;
}

std::string quoted(std::string_view word) {
  std::string text = "“";
  for (const char c : word.substr(0, longest_excerpt)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return text + (word.size() > longest_excerpt ? "…”" : "”");
}

class PointReader {
 public:
  explicit PointReader(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  }

  Result<std::vector<Eigen::Vector3d>> read() {
    skip_heads();
    while (place_ < text_.size() && ok()) step();
    if (ok() && depth_ > 0) error_ = {"", "A bracket is opened and never closed."};
    if (ok()) finish_point();
    if (ok() && points_.empty()) {
      error_ = {"", "There are no points here: write one on each line, as 1.5, 2 or 1.5, 2, 0."};
    }
    if (!ok()) return error_;
    return std::move(points_);
  }

 private:
  bool ok() const { return error_.message.empty(); }
  void fail(std::string message) { error_ = {"line " + std::to_string(line_), std::move(message)}; }

  std::string_view word_at(std::size_t place) const {
    std::size_t end = place;
    while (end < text_.size() && belongs_to_word(text_[end])) ++end;
    return text_.substr(place, end - place);
  }

  /// A first line without any number, but with a word that is not a number's: x, y, z.
  void skip_heads() {
    const std::string_view first = text_.substr(0, text_.find('\n'));
    bool words = false;
    for (std::size_t place = 0; place < first.size(); ++place) {
      const char c = first[place];
      if (separates(c)) continue;
      if (!is_letter(c)) return;
      const std::string_view word = word_at(place);
      if (word == "NaN" || word == "nan" || word.substr(0, 3) == "inf" || word.substr(0, 3) == "Inf") return;
      words = true;
      place += word.size() - 1;
    }
    if (words && first.size() < text_.size()) place_ = first.size();
  }

  void step() {
    const char c = text_[place_];
    if (c == '\n') {
      // Within a pair of brackets a line break is a space.
      if (depth_ == 0) finish_point();
      ++line_;
      ++place_;
    } else if (c == '#') {
      const std::size_t end = text_.find('\n', place_);
      place_ = end == std::string_view::npos ? text_.size() : end;
    } else if (separates(c)) {
      ++place_;
    } else if (opens(c)) {
      if (numbers_ > 0) return fail("A bracket opens in the middle of a point.");
      ++depth_;
      ++place_;
    } else if (shuts(c)) {
      if (depth_ == 0) return fail("A bracket is closed that was never opened.");
      finish_point();
      --depth_;
      ++place_;
    } else {
      take_number();
    }
  }

  void take_number() {
    const std::string_view word = word_at(place_);
    const std::optional<double> value = number_of(word);
    if (!value) return fail(quoted(word) + " is not a number; a point is 2 or 3 numbers, as 1.5, 2, 0.");
    if (!limits::coordinate.contains(*value)) {
      return fail(quoted(word) + " is too large: coordinates lie between " + number_text(limits::coordinate.min) +
                  " and " + number_text(limits::coordinate.max) + ".");
    }
    if (numbers_ == 3) return fail("There are more than 3 numbers; a point is 2 or 3, and a line for each.");
    point_[numbers_++] = *value;
    place_ += word.size();
  }

  void finish_point() {
    if (numbers_ == 0) return;
    if (numbers_ == 1) return fail("There is one number alone; a point is 2 or 3 of them.");
    if (points_.size() == static_cast<std::size_t>(max_data_points)) {
      return fail("There are more than " + std::to_string(max_data_points) +
                  " points: keep fewer, for instance every tenth line.");
    }
    points_.emplace_back(point_[0], point_[1], numbers_ == 3 ? point_[2] : 0.0);
    numbers_ = 0;
  }

  std::string_view text_;
  std::size_t place_ = 0, line_ = 1;
  int depth_ = 0;
  std::array<double, 3> point_{};
  std::size_t numbers_ = 0;
  std::vector<Eigen::Vector3d> points_;
  Error error_;
};

}  // namespace

Result<std::vector<Eigen::Vector3d>> parse_points(std::string_view text) {
  // What has too many points says so before its length matters.
  Result<std::vector<Eigen::Vector3d>> points = PointReader(text.substr(0, max_point_text_bytes)).read();
  if (text.size() <= max_point_text_bytes) return points;
  if (!points && points.error().path.starts_with("line")) return points.error();
  return Error{"", "The text is longer than 8 MiB: keep fewer points."};
}

}  // namespace knotwork::scene
