// The program that the site's build runs under Node (shell/plugins/stills.ts): a figure of the page as an SVG picture.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include <emscripten/emscripten.h>

#include "knotwork/scene/chapters.h"
#include "knotwork/scene/commands.h"
#include "knotwork/scene/document_json.h"
#include "web/still.h"

namespace knotwork::web {
namespace {

/// As the page reads values (parseValue() in shell/src/goals.ts): true, false, a finite number, else a word.
scene::ParameterValue value_of(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (!text.empty() && end == text.c_str() + text.size() && std::isfinite(number)) return number;
  return text;
}

/// Sets every id=value of a list that is joined by &.
Status set_all(scene::Document& document, std::string_view values) {
  while (!values.empty()) {
    const std::string_view pair = values.substr(0, values.find('&'));
    values.remove_prefix(std::min(pair.size() + 1, values.size()));
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos) return Error{std::string(pair), "There is no value."};
    const std::string id(pair.substr(0, equals)), value(pair.substr(equals + 1));
    Status status = scene::apply(document, scene::SetParameter{id, value_of(value)});
    if (!status) return Error{id, status.error().message};
  }
  return std::monostate{};
}

Result<std::string> picture_of(std::string_view start, std::string_view scene, std::string_view values,
                               const StillSize& size) {
  const scene::Chapter* chapter = scene::find_chapter(start);
  if (scene.empty() && chapter == nullptr) return Error{std::string(start), "There is no such start document."};
  Result<scene::Document> document =
      scene.empty() ? Result<scene::Document>(chapter->start_document()) : scene::parse_document(scene);
  if (!document) return document.error();
  Status status = set_all(document.value(), values);
  if (!status) return status.error();
  return still(document.value(), size);
}

}  // namespace
}  // namespace knotwork::web

extern "C" {

/// The picture of a start document, or of a scene (a document's JSON) where one is given, with values set; else a
/// sentence that does not begin with "<". A coarse one has fewer pieces. It stands until the next call.
EMSCRIPTEN_KEEPALIVE const char* knotwork_still(const char* start, const char* scene, const char* values, bool coarse) {
  static std::string answer;
  knotwork::web::StillSize size;
  if (coarse) size = {.pieces_u = 30, .pieces_v = 20};
  const knotwork::Result<std::string> picture = knotwork::web::picture_of(start, scene, values, size);
  answer = picture ? picture.value() : picture.error().path + ": " + picture.error().message;
  return answer.c_str();
}
}
