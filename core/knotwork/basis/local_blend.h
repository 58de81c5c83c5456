#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"

namespace knotwork {

// What blending curves and either direction of a blending surface have in common (THEORY 2.7, 2.8).

/// One direction at one parameter t of [t_i, t_{i+1}): the locals i-1 and i that meet there, the second wrapped to 0
/// at a closed seam, and their weights with derivatives with respect to t.
struct LocalBlend {
  int first, second;                 ///< local indices; first is the one centred at t_i, the interval's start
  std::array<double, 4> one, other;  ///< (1-B, -B' delta, -B'' delta^2, -B''' delta^3) and (B, B' delta, ..)

  /// i: the span, and the next parameter's hint.
  int span() const { return first + 1; }
};

/// `reduced` is in the domain, as from KnotVector::reduced; `hint` as in KnotVector::span. At w = 0 and w = 1 the
/// weights are exactly 0 and 1.
LocalBlend local_blend(const KnotVector& knots, const BlendingFunction& blending, double reduced, int hint);

/// A direction of a model geometry, and how to speak of it.
struct ModelDirection {
  std::string_view model;     ///< "torus"
  std::string_view geometry;  ///< what is blended over it: "surface"
  std::string_view letter;    ///< "u", or empty where there is one direction only
  double start, end;
  Topology closure;
};

/// Knots that locals can be blended on: degree 1, closed only where the model is, with its period, within its domain,
/// no interval below 1e-9 of it. Error path: `path`.
Status check_blending_knots(const char* path, const KnotVector& knots, const ModelDirection& direction);

/// As many maps as `expected`, all usable. Error path: `locals` or `locals[k]`.
Status check_local_maps(std::span<const Eigen::Affine3d> maps, std::size_t expected, std::string_view geometry);
/// Affine, with entries that are finite and at most 1e100, so that nothing computed from them overflows.
bool usable_local_map(const Eigen::Affine3d& map);

}  // namespace knotwork
