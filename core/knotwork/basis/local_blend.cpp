#include "knotwork/basis/local_blend.h"

#include <cmath>
#include <string>

namespace knotwork {
namespace {

/// Knots may leave the model's domain, and periods differ, by this much of the domain's length: rounding, no more.
constexpr double domain_tolerance = 1e-9;
constexpr double largest_entry = 1e100;

}  // namespace

LocalBlend local_blend(const KnotVector& knots, const BlendingFunction& blending, double reduced, int hint) {
  const int i = knots.span(reduced, hint);
  const double delta = 1 / (knots[i + 1] - knots[i]);
  // w by a division, not by delta: exactly 1 at the end of an open direction.
  const BlendingValue b = blending(translation_and_scaling(knots, 1, i, reduced));
  const double b1 = b[1] * delta, b2 = b[2] * delta * delta, b3 = b[3] * delta * delta * delta;
  return {i - 1, i == knots.count() ? 0 : i, {1 - b[0], -b1, -b2, -b3}, {b[0], b1, b2, b3}};
}

Status check_blending_knots(const char* path, const KnotVector& knots, const ModelDirection& direction) {
  const std::string geometry(direction.geometry), model(direction.model), letter(direction.letter);
  const std::string in_letter = letter.empty() ? "" : " in " + letter;
  if (knots.degree() != 1) return Error{path, "A blending " + geometry + " needs knot vectors of degree 1."};
  if (knots.closed() && direction.closure == Topology::open) {
    return Error{path, "The " + model + " is not closed" + in_letter + ", so the " + geometry + " cannot be closed" +
                           (letter.empty() ? "." : " there.")};
  }
  const double length = direction.end - direction.start, slack = domain_tolerance * length;
  if (knots.closed() && !(std::abs(knots.period() - length) <= slack)) {
    return Error{path, "The period of the knots" + in_letter + " must be that of the " + model + "."};
  }
  if (knots.start() < direction.start - slack || knots.end() > direction.end + slack) {
    return Error{path, "The knots" + in_letter + " must stay within the domain of the " + model + "."};
  }
  for (int i = 0; i < knots.interval_count(); ++i) {
    // Derivatives carry powers of the inverse width.
    if (!(knots[i + 2] - knots[i + 1] >= slack)) {
      return Error{path, "Neighbouring knots" + in_letter + " are too close together."};
    }
  }
  return success();
}

Status check_local_maps(std::span<const Eigen::Affine3d> maps, std::size_t expected, std::string_view geometry) {
  const std::string what(geometry);
  if (maps.size() != expected) {
    return Error{"locals", "These knots need " + std::to_string(expected) + " local " + what + "s, but there are " +
                               std::to_string(maps.size()) + "."};
  }
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (!usable_local_map(maps[k])) {
      return Error{"locals[" + std::to_string(k) + "]",
                   "The map of a local " + what + " must be affine, with finite entries."};
    }
  }
  return success();
}

bool usable_local_map(const Eigen::Affine3d& map) {
  constexpr double bottom[4] = {0, 0, 0, 1};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      // Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
      const double entry = map.matrix()(row, column);
      if (!std::isfinite(entry) || std::abs(entry) > largest_entry) return false;
      if (row == 3 && entry != bottom[column]) return false;
    }
  }
  return true;
}

}  // namespace knotwork
