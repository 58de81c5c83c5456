#include "knotwork/surface/model_surface.h"

#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include <Eigen/Geometry>

#include "knotwork/surface/taylor2_point.h"

namespace knotwork {
namespace {

using std::numbers::pi;
/// Bound on lengths and coordinates of a model, so that nothing computed from them overflows.
constexpr double largest_length = 1e6, smallest_length = 1e-6;

/// Finite first: comparing a NaN is itself a floating-point exception, and tests trap those.
bool within(double x, double least, double greatest) { return std::isfinite(x) && x >= least && x <= greatest; }

Taylor2Point formula(const Plane& m, Taylor2 u, Taylor2 v) {
  const auto coordinate = [&](int k) { return m.origin[k] + u * m.u_axis[k] + v * m.v_axis[k]; };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

Taylor2Point formula(const Cylinder& m, Taylor2 u, Taylor2 v) {
  return {m.radius_x * sin(v), m.radius_y * cos(v), m.height * u};
}

Taylor2Point formula(const Torus& m, Taylor2 u, Taylor2 v) {
  const Taylor2 radius = m.wheel_radius + m.tube_radius * cos(v);
  return {radius * cos(u), radius * sin(u), m.tube_height * sin(v)};
}

Taylor2Point formula(const Sheet& m, Taylor2 u, Taylor2 v) {
  const double a = m.bend_u, b = m.bend_v;
  const double radius_u = std::lerp(m.flat_radius_u, m.closed_radius_u, a);
  const double radius_v = std::lerp(m.flat_radius_v, m.closed_radius_v, b);
  const Taylor2 p = radius_v * b * (1 - v * v * cosc(b * v));
  const Taylor2 q = radius_v * v * sinc(b * v);
  return {radius_u * a * (1 - u * u * cosc(a * u)) + p * cos(a * u), radius_u * u * sinc(a * u) + p * sin(a * u), q};
}

template <class Model>
SurfaceJet model_jet(const Model& model, double u, double v) {
  return jet(formula(model, Taylor2::variable_u(u), Taylor2::variable_v(v)));
}

SurfaceDomain domain_of(const Plane&) { return {{0, 1}, {0, 1}, Topology::open, Topology::open}; }
SurfaceDomain domain_of(const Cylinder&) {
  return {{-0.5, 0.5}, {-1.5 * pi, 0.5 * pi}, Topology::open, Topology::closed};
}
SurfaceDomain domain_of(const Torus&) { return {{0, 2 * pi}, {0, 2 * pi}, Topology::closed, Topology::closed}; }
SurfaceDomain domain_of(const Sheet& m) {
  const auto closure = [](double bend) { return bend == 1 ? Topology::closed : Topology::open; };
  return {{-pi, pi}, {-pi, pi}, closure(m.bend_u), closure(m.bend_v)};
}

struct NamedLength {
  const char* name;
  double value;
};
Status check_lengths(std::initializer_list<NamedLength> lengths) {
  for (const NamedLength& length : lengths) {
    if (!within(length.value, smallest_length, largest_length)) {
      return Error{length.name, "This length must be a positive number between 0.000001 and 1000000."};
    }
  }
  return success();
}

struct NamedVector {
  const char* name;
  Eigen::Vector3d value;
};
Status check(const Plane& m) {
  for (const NamedVector& vector : {NamedVector{"origin", m.origin}, {"u_axis", m.u_axis}, {"v_axis", m.v_axis}}) {
    for (int k = 0; k < 3; ++k) {
      if (!within(vector.value[k], -largest_length, largest_length)) {
        return Error{vector.name, "Each coordinate must be a number of absolute value at most 1000000."};
      }
    }
  }
  const double length_u = m.u_axis.norm(), length_v = m.v_axis.norm();
  if (Status lengths = check_lengths({{"u_axis", length_u}, {"v_axis", length_v}}); !lengths) return lengths;
  if (m.u_axis.cross(m.v_axis).norm() < 1e-9 * length_u * length_v) {
    return Error{"v_axis", "The axes of the plane must not be parallel."};
  }
  return success();
}

Status check(const Cylinder& m) {
  return check_lengths({{"radius_x", m.radius_x}, {"radius_y", m.radius_y}, {"height", m.height}});
}

Status check(const Torus& m) {
  return check_lengths(
      {{"wheel_radius", m.wheel_radius}, {"tube_radius", m.tube_radius}, {"tube_height", m.tube_height}});
}

Status check(const Sheet& m) {
  if (!within(m.bend_u, 0, 1)) return Error{"bend_u", "A bend must lie between 0 (flat) and 1 (closed)."};
  if (!within(m.bend_v, 0, 1)) return Error{"bend_v", "A bend must lie between 0 (flat) and 1 (closed)."};
  return check_lengths({{"flat_radius_u", m.flat_radius_u},
                        {"closed_radius_u", m.closed_radius_u},
                        {"flat_radius_v", m.flat_radius_v},
                        {"closed_radius_v", m.closed_radius_v}});
}

}  // namespace

SurfaceDomain domain(const ModelSurface& model) {
  return std::visit([](const auto& m) { return domain_of(m); }, model);
}

std::string_view model_name(const ModelSurface& model) {
  constexpr std::string_view names[] = {"plane", "cylinder", "torus", "sheet"};
  static_assert(std::size(names) == std::variant_size_v<ModelSurface>);
  return names[model.index()];
}

Status validate(const ModelSurface& model) {
  return std::visit([](const auto& m) { return check(m); }, model);
}

SurfaceJet evaluate(const ModelSurface& model, double u, double v) {
  return std::visit([&](const auto& m) { return model_jet(m, u, v); }, model);
}

void evaluate_grid(const ModelSurface& model, std::span<const double> u, std::span<const double> v,
                   std::span<SurfaceJet> out) {
  assert(out.size() == u.size() * v.size());
  std::visit(
      [&](const auto& m) {
        std::size_t k = 0;
        for (const double a : u) {
          for (const double b : v) out[k++] = model_jet(m, a, b);
        }
      },
      model);
}

}  // namespace knotwork
