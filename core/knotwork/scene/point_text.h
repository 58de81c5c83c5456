#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "knotwork/result.h"
#include "knotwork/scene/later.h"
#include "knotwork/scene/limits.h"

namespace knotwork::scene {

/// No longer text is read.
inline constexpr std::size_t max_point_text_bytes = 8u << 20;

/// Points written as text, as they come from tables, data files and programs: 2 or 3 numbers a line (without a third, z
/// is 0), between them spaces, tabs, commas or semicolons; or JSON, a list of lists of 2 or 3 numbers, line breaks
/// anywhere. Empty lines count for nothing, nor does what follows a #, nor a first line of words, the heads of a table.
///
/// Errors have the line as path, `line 3`, none when the text as a whole is meant: a word that is no number, a number
/// outside limits::coordinate (NaN and infinity are words), another count of numbers, brackets that do not match, more
/// than max_data_points points, none at all. Reads no further than to the error; O(text).
KNOTWORK_LATER Result<std::vector<Eigen::Vector3d>> parse_points(std::string_view text);

}  // namespace knotwork::scene
