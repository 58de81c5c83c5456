#include "web/language.h"

#include <memory>
#include <utility>

namespace knotwork::web {
namespace {

struct Translation {
  std::string english, words;
  std::unique_ptr<Translation> next;
};
using Translations = std::array<std::unique_ptr<Translation>, 64>;  // in chains of a few

struct Language {
  Translator translator = nullptr;
  Listener listener = nullptr;
  Translations* known = nullptr;  // not owned by name: a page's last words need no tidying up
};
Language language;  // NOLINT: known at the platform's boundary alone, and asked for wherever a word is

KNOTWORK_LATER std::string_view translation(std::string_view english) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(english[k]); };
  const std::size_t mark = english.size() + 7 * byte(english.size() / 2) + 31 * byte(english.size() - 1);
  std::unique_ptr<Translation>& first = (*language.known)[mark % language.known->size()];
  for (const Translation* known = first.get(); known; known = known->next.get())
    if (known->english == english) return known->words;
  auto found = std::make_unique<Translation>();
  found->english = english;
  found->words = language.translator(found->english);
  found->next = std::move(first);
  first = std::move(found);
  return first->words;
}

}  // namespace

void translate_by(Translator translator, Listener listener) {
  delete language.known;
  language = {translator, listener, translator ? new Translations : nullptr};
}

bool translates() { return language.translator != nullptr; }

Said say(std::string_view english) {
  return Said(language.translator && !english.empty() ? translation(english) : english);
}

std::string say_once(const std::string& english) {
  return language.translator ? language.translator(english) : english;
}

void heard(Said words) {
  if (language.listener) language.listener(words);
}

Sentence::Sentence(std::string_view english, std::span<const Value> values) {
  std::string_view form = say(english);
  for (std::size_t next = 0;; ++next) {
    const std::size_t brace = form.find('{');
    words_.add(form.substr(0, brace));
    if (brace == std::string_view::npos) return;
    form.remove_prefix(brace + 1);
    std::size_t which = next;
    if (!form.empty() && form.front() >= '1' && form.front() <= '9') {
      which = static_cast<std::size_t>(form.front() - '1');
      form.remove_prefix(1);
    }
    if (form.starts_with('}')) form.remove_prefix(1);
    if (which < values.size()) values[which].add_to(words_);
  }
}

}  // namespace knotwork::web
