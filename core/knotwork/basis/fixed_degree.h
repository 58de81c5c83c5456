#pragma once

#include <cstddef>

namespace knotwork {

/// As the template argument of a kernel, in the place of a degree: it is known at run time only.
inline constexpr int any_degree = 0;

/// The template argument, or the degree itself where that says any_degree: then loops have no length that the compiler
/// knows.
template <int fixed_degree>
constexpr std::size_t degree_or_fixed(int degree) {
  return static_cast<std::size_t>(fixed_degree == any_degree ? degree : fixed_degree);
}

}  // namespace knotwork
