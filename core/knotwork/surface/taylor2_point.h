#pragma once

#include "knotwork/surface/surface_jet.h"
#include "knotwork/surface/taylor2.h"

namespace knotwork {

/// A point whose coordinates are functions of (u,v), as truncated series.
template <class Series>
struct PointOf {
  Series x, y, z;
};
using Taylor2Point = PointOf<Taylor2>;

/// The point and its partials.
inline SurfaceJet jet(const Taylor2Point& p) {
  return {{p.x.value, p.y.value, p.z.value}, {p.x.u, p.y.u, p.z.u},    {p.x.v, p.y.v, p.z.v},
          {p.x.uu, p.y.uu, p.z.uu},          {p.x.uv, p.y.uv, p.z.uv}, {p.x.vv, p.y.vv, p.z.vv}};
}

}  // namespace knotwork
