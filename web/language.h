#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <string_view>

#include "knotwork/later.h"
#include "web/words.h"

namespace knotwork::web {

/// Words as they are drawn. They come from say(), in the page's language, or from as_is(): a word that forgets to be
/// translated does not compile. It looks at words that others keep.
class Said {
 public:
  operator std::string_view() const { return words_; }  // NOLINT(google-explicit-constructor)
  bool empty() const { return words_.empty(); }

 private:
  explicit constexpr Said(std::string_view words) : words_(words) {}
  friend Said say(std::string_view english);
  friend constexpr Said as_is(std::string_view words);
  friend class Sentence;
  friend class Value;

  std::string_view words_;
};

/// Numbers, names of the mathematics, and what has been said before.
constexpr Said as_is(std::string_view words) { return Said(words); }

/// Gives words in the page's language; what has no translation comes back in English.
using Translator = std::string (*)(const std::string& english);

/// Is told of all words that are drawn.
using Listener = void (*)(std::string_view words);

/// From now on words are said by `translator`; null for English. What say() has given before is gone.
KNOTWORK_LATER void translate_by(Translator translator, Listener listener = nullptr);
bool translates();

/// English in the page's language, until the next translate_by(). The translator is asked once for each text; English
/// asks for nothing.
Said say(std::string_view english);
/// The same for what is not said again and again, as a sentence with values in it: nothing of it is kept.
std::string say_once(const std::string& english);
/// Words have been drawn.
void heard(Said words);

/// What a "{}" stands for: a number, or words that have been said or need not be.
class Value {
 public:
  // NOLINTBEGIN(google-explicit-constructor): what is written in a call
  template <std::integral Number>
  Value(Number number) : size_(static_cast<std::size_t>(number)) {}
  Value(const std::string& words) : words_(words.data()), size_(words.size()) {}
  Value(Said words) : words_(words.empty() ? "" : words.words_.data()), size_(words.words_.size()) {}
  // NOLINTEND(google-explicit-constructor)
  Value(const char*) = delete;  // an English word that nobody has said

  void add_to(Words& words) const { words_ ? words.add({words_, size_}) : words.add(static_cast<int>(size_)); }

 private:
  const char* words_ = nullptr;  ///< null: a number
  std::size_t size_;             ///< or the number
};

/// English, said, with its values: "{}" is the next one, "{2}" the second, since languages have orders of their own.
class Sentence {
 public:
  Sentence(std::string_view english, std::span<const Value> values);
  operator Said() const { return Said(words_); }        // NOLINT(google-explicit-constructor)
  operator std::string_view() const { return words_; }  // NOLINT(google-explicit-constructor)
  explicit operator std::string() const { return std::string(std::string_view(words_)); }

 private:
  Words words_;
};

template <class... Values>
requires(sizeof...(Values) > 0) Sentence say(std::string_view english, const Values&... values) {
  const std::array<Value, sizeof...(Values)> all{Value(values)...};
  return {english, all};
}

}  // namespace knotwork::web
