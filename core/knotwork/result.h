#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace knotwork {

/// What went wrong and where, in words a reader of the page understands.
struct Error {
  std::string path;     ///< where in the input, as `objects[0].locals.u`; empty when the whole input is meant
  std::string message;  ///< one sentence
};

/// A value or the reason why there is none. The wall between input and core: nothing inside it throws.
template <class T>
class [[nodiscard]] Result {
 public:
  // Implicit on purpose: `return value;` and `return Error{...};` both read as what they are.
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// Precondition: `has_value()`.
  const T& value() const& { return assert(has_value()), *std::get_if<0>(&state_); }
  T& value() & { return assert(has_value()), *std::get_if<0>(&state_); }
  /// By value: a reference into a temporary would not outlive the statement, as in `for (x : f().value())`.
  T value() && { return assert(has_value()), std::move(*std::get_if<0>(&state_)); }

  /// Precondition: `!has_value()`.
  const Error& error() const { return assert(!has_value()), *std::get_if<1>(&state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or the reason of failure.
using Status = Result<std::monostate>;

inline Status success() { return std::monostate{}; }

}  // namespace knotwork
