#pragma once

#include <type_traits>
#include <variant>

#include "knotwork/later.h"

namespace knotwork::scene {

/// std::visit over all alternatives but the first.
template <class F, class Variant>
KNOTWORK_LATER auto visit_later(F& f, Variant& variant)
    -> std::invoke_result_t<F&, decltype(*std::get_if<0>(&variant))> {
  using First = decltype(*std::get_if<0>(&variant));
  return std::visit(
      [&f](auto& alternative) -> std::invoke_result_t<F&, First> {
        if constexpr (std::is_same_v<decltype(alternative), First>) {
          __builtin_unreachable();
        } else {
          return f(alternative);
        }
      },
      variant);
}

/// std::visit over a variant whose first alternative is what the first figure is made of; the others may come later.
template <class F, class Variant>
decltype(auto) visit_first(F f, Variant& variant) {
  if (auto* first = std::get_if<0>(&variant)) return f(*first);
  return visit_later(f, variant);
}

}  // namespace knotwork::scene
