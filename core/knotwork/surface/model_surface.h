#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "knotwork/result.h"
#include "knotwork/surface/surface_catalogue.h"
#include "knotwork/surface/surface_domain.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

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

/// What a blending surface can be made over: the sheet that follows the topology, or any surface of the catalogue.
using ModelSurface = std::variant<Sheet, CatalogueSurface>;

SurfaceDomain domain(const ModelSurface& model);

/// The name in a sentence after "the", as `torus`.
std::string_view model_name(const ModelSurface& model);

/// A sheet's radii in [10^-6, 10^6] and bends in [0,1]; error path: the member's name. A catalogue surface as its own
/// validate().
Status validate(const ModelSurface& model);

/// Point and partials from one formula on truncated Taylor series. u, v are not reduced to the domain.
SurfaceJet evaluate(const ModelSurface& model, double u, double v);

/// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). Allocates nothing.
void evaluate_grid(const ModelSurface& model, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out);

}  // namespace knotwork
