#pragma once

#include <span>
#include <string>
#include <string_view>
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
  ParameterValue (*get)(const Document&) = nullptr;
  /// Changes nothing on an error (out of range, wrong type, unknown choice, refused closure). The error's path is empty:
  /// apply() fills in the id.
  Status (*set)(Document&, const ParameterValue&) = nullptr;
  /// Whether what is on the stage has this parameter. The functions around are for documents in which it has.
  bool (*applies)(const Document&) = nullptr;
  /// Why this row cannot be changed now, empty when it can (e.g. m of a B-function without parameter).
  std::string (*disabled)(const Document&) = nullptr;
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

}  // namespace knotwork::scene
