#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "knotwork/scene/document.h"

namespace knotwork::scene {

/// A chapter of the page: its prose lives in shell/chapters/<file>, its start document here.
struct Chapter {
  std::string_view id;  ///< as `blending-surface`, the permanent link
  std::string_view title;
  Document (*start_document)();
  std::vector<std::string_view> parameters;  ///< the few rows that the chapter is about
};

std::span<const Chapter> chapters();
/// nullptr when there is no such id.
const Chapter* find_chapter(std::string_view id);

}  // namespace knotwork::scene
