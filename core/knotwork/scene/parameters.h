#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "knotwork/scene/document.h"

namespace knotwork::scene {

enum class ParameterKind : unsigned char { number, integer, choice, toggle };

/// A number (number, integer), a choice's id, or a toggle's state.
using ParameterValue = std::variant<double, std::string, bool>;

struct Choice {
  std::string id, label;
};

/// A function of a row: its own, or one that several rows share, told apart by an index.
template <class Signature>
class RowFunction;
template <class R, class... As>
class RowFunction<R(As...)> {
 public:
  RowFunction() = default;
  // Implicit on purpose: a row's functions are written as lambdas. Inline, as it would bear the name of the lambda's row
  // and so belong to a later part of the module (see later.h).
  template <class F>
  requires std::is_convertible_v<F, R (*)(As...)>
  [[gnu::always_inline]] RowFunction(F own) : own_(own) {}  // NOLINT(google-explicit-constructor)
  RowFunction(R (*shared)(std::size_t, As...), std::size_t index) : shared_(shared), index_(index) {}

  explicit operator bool() const { return own_ != nullptr || shared_ != nullptr; }
  R operator()(As... values) const {
    return shared_ != nullptr ? shared_(index_, static_cast<As>(values)...) : own_(static_cast<As>(values)...);
  }

 private:
  R (*own_)(As...) = nullptr;
  R (*shared_)(std::size_t, As...) = nullptr;
  std::size_t index_ = 0;
};

/// One row of the table that panel, HTML controls, script interface, share link and undo read.
struct Parameter {
  std::string_view id;     ///< as `topology.u`
  std::string_view label;  ///< as `u`
  std::string_view group;  ///< as `Topology`
  ParameterKind kind;
  double min = 0, max = 0, step = 0;  ///< of number and integer; range_of() says what holds at the moment
  double soft_max = 0;                ///< where a slider had better end; max itself can still be typed
  std::string_view unit;
  std::vector<Choice> choices;
  bool in_history = true;  ///< false for the clock: playing and seeking are not undone
  RowFunction<ParameterValue(const Document&)> get;
  /// Of a choice: the index of the present one in `choices`, for those who ask in every frame: get() makes a text of it.
  RowFunction<int(const Document&)> chosen;
  /// Changes nothing on an error (out of range, wrong type, unknown choice, refused closure). The error's path is empty:
  /// apply() fills in the id.
  RowFunction<Status(Document&, const ParameterValue&)> set;
  /// Whether what is on the stage has this parameter. The functions around are for documents in which it has.
  RowFunction<bool(const Document&)> applies;
  /// Why this row cannot be changed now, empty when it can (e.g. m of a B-function without parameter).
  RowFunction<std::string_view(const Document&)> disabled;
  /// The limits of a number now, where they are narrower than min and max; see range_of().
  RowFunction<Limits(const Document&)> range;
  /// Where a slider had better begin and end now, where soft_max does not say it; see soft_range_of().
  RowFunction<Limits(const Document&)> soft_range;
};

std::span<const Parameter> parameters();
/// nullptr when there is no such id.
const Parameter* find_parameter(std::string_view id);

/// Whether the row is about what is on the stage: a curve has no local patches.
inline bool applies(const Document& document, const Parameter& parameter) { return parameter.applies(document); }

/// Why the choice cannot be taken now ("The plane is not closed in u, ..."), empty when it can.
std::string refused_choice(const Document& document, const Parameter& parameter, std::string_view choice);

/// What else setting the parameter changes ("The plane is not closed in u, so u opens."), empty when nothing.
std::string side_effect(const Document& document, const Parameter& parameter, const ParameterValue& value);

/// The limits of a number now: those of blending.parameter are the B-function's, where it has a parameter.
Limits range_of(const Document& document, const Parameter& parameter);
/// Where a slider had better begin and end now: within range_of().
Limits soft_range_of(const Document& document, const Parameter& parameter);

}  // namespace knotwork::scene
