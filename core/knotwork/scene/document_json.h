#pragma once

#include <string>
#include <string_view>

#include "knotwork/scene/document.h"

namespace knotwork::scene {

inline constexpr int document_version = 1;
inline constexpr std::size_t max_document_bytes = 8u << 20;

/// Reads a document. Every error names the path of the offending member (`objects[0].locals.u`) and a reason; unknown
/// members are errors too, so that a typing slip is seen. Numbers keep all their bits.
Result<Document> parse_document(std::string_view json);

/// Writes what parse_document reads; parse(write(d)) == d, bit for bit.
std::string write_document(const Document& document);

}  // namespace knotwork::scene
