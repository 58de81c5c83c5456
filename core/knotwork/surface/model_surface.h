#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "knotwork/basis/interval.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// S(u,v) = origin + u u_axis + v v_axis on [0,1]^2, open in u and v.
struct Plane {
  Eigen::Vector3d origin{-1, -1, 0}, u_axis{2, 0, 0}, v_axis{0, 2, 0};

  bool operator==(const Plane&) const = default;
};

/// S(u,v) = (rx sin v, ry cos v, h u) on [-1/2,1/2] x [-3pi/2, pi/2], closed in v. Elliptic when rx != ry.
struct Cylinder {
  double radius_x = 1, radius_y = 1, height = 2;

  bool operator==(const Cylinder&) const = default;
};

/// S(u,v) = ((a + b cos v) cos u, (a + b cos v) sin u, c sin v) on [0,2pi]^2, closed in u and v.
struct Torus {
  double wheel_radius = 1, tube_radius = 0.4, tube_height = 0.4;  ///< a, b, c

  bool operator==(const Torus&) const = default;
};

/// A rubber sheet on [-pi,pi]^2 that rolls up: bend 0 is flat and bend 1 closed, in u and in v, so that the corners of
/// the unit square of bends are a plane, two cylinders and a torus. In between, each direction is an arc that turns
/// through 2pi*bend; radii grow from flat_* to closed_* with the bend. With a = bend_u, b = bend_v,
/// ru = lerp(flat_radius_u, closed_radius_u, a), rv = lerp(flat_radius_v, closed_radius_v, b):
///
///   p(v) = rv (b + (cos(bv) - 1)/b),  q(v) = rv sin(bv)/b                       cross-section, p outwards
///   S(u,v) = (ru (a + (cos(au) - 1)/a) + p cos(au),  ru sin(au)/a + p sin(au),  q)
///
/// whose quotients are entire in a and b too: at a = 0 the first is 0 and ru sin(au)/a is ru u, likewise for b.
/// (0,0) is the rectangle (0, ru u, rv v), upright in the yz-plane, of size 2pi ru x 2pi rv; (1,0) the cylinder of radius
/// ru about the z-axis; (0,1) the cylinder of radius rv about the y-axis; (1,1) the torus
/// ((ru + rv cos v) cos u, (ru + rv cos v) sin u, rv sin v). Everywhere the point u = v = 0 has its normal S_u x S_v
/// along +x, and the normal points out of the tube.
/// Entire in u and v, hence defined outside the domain too. Closed in a direction exactly when its bend is 1.
struct Sheet {
  double bend_u = 1, bend_v = 1;  ///< in [0,1]
  double flat_radius_u = 0.56, closed_radius_u = 1.0;
  double flat_radius_v = 0.38, closed_radius_v = 0.45;

  bool operator==(const Sheet&) const = default;
};

using ModelSurface = std::variant<Plane, Cylinder, Torus, Sheet>;

/// Where a model surface lives and in which directions it is periodic.
struct SurfaceDomain {
  Interval u, v;
  Topology closure_u, closure_v;
};

SurfaceDomain domain(const ModelSurface& model);

/// The name in a sentence, as `torus`.
std::string_view model_name(const ModelSurface& model);

/// Coordinates at most 10^6, axes not parallel, radii and heights in [10^-6, 10^6], bends in [0,1]. Error path: the
/// member's name.
Status validate(const ModelSurface& model);

/// Point and partials from one formula on truncated Taylor series. u, v are not reduced to the domain.
SurfaceJet evaluate(const ModelSurface& model, double u, double v);

/// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). Allocates nothing.
void evaluate_grid(const ModelSurface& model, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out);

}  // namespace knotwork
