#pragma once

#include "knotwork/basis/interval.h"
#include "knotwork/basis/knot_vector.h"

namespace knotwork {

/// How a surface goes on beyond the domain of a direction, of length P. Closed in u: S(u+P, v) = S(u, v). Twisted in
/// u: S(u+P, v) = S(u, sigma(v)) with a reflection sigma, which makes it one-sided. In v with u and v exchanged.
/// A property of the surface; a knot vector over a direction that is closed or twisted may be closed or open.
enum class Closure : unsigned char { open, closed, twisted };

/// That of a direction without twist.
constexpr Closure closure_of(Topology topology) {
  return topology == Topology::closed ? Closure::closed : Closure::open;
}

/// Where a surface lives, and how it goes on beyond.
struct SurfaceDomain {
  Interval u, v;
  Closure closure_u = Closure::open, closure_v = Closure::open;
  /// Twisted in u: sigma(v) = reflection_u - v; in v: sigma(u) = reflection_v - u (where that other direction is
  /// closed, up to its period).
  double reflection_u = 0, reflection_v = 0;
};

}  // namespace knotwork
