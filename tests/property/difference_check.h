#pragma once

#include <functional>

#include "unit/oracle.h"

namespace knotwork::test {

/// Each partial of a jet against an eighth-order central difference of the one before (S_u and S_v of S, S_uu and S_uv
/// of S_u, S_uv and S_vv of S_v), with a relative bound.
struct DifferenceCheck {
  double tolerance = 1e-6;
  /// The norm below which a partial counts as cancelled, per vector of the jet.
  double scale[6] = {};
};

/// True when all differences agree with the jet. Precondition: the function is smooth within four steps.
inline bool partials_agree(const std::function<SurfaceJet(double, double)>& f, double u, double v, double h_u,
                           double h_v, const DifferenceCheck& check) {
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  SurfaceJet by_u, by_v;  // differences of S, S_u, S_v in the first three places
  for (int k = 1; k <= 4; ++k) {
    const SurfaceJet right = f(u + k * h_u, v), left = f(u - k * h_u, v);
    const SurfaceJet up = f(u, v + k * h_v), down = f(u, v - k * h_v);
    const double a = weights[k - 1] / h_u, b = weights[k - 1] / h_v;
    by_u.s += a * (right.s - left.s), by_u.su += a * (right.su - left.su), by_u.sv += a * (right.sv - left.sv);
    by_v.s += b * (up.s - down.s), by_v.su += b * (up.su - down.su), by_v.sv += b * (up.sv - down.sv);
  }
  const SurfaceJet jet = f(u, v);
  const auto agree = [&](const Eigen::Vector3d& analytic, const Eigen::Vector3d& difference, int part) {
    return close(analytic, difference, check.tolerance, check.scale[part]).within;
  };
  return agree(jet.su, by_u.s, 1) && agree(jet.sv, by_v.s, 2) && agree(jet.suu, by_u.su, 3) &&
         agree(jet.suv, by_v.su, 4) && agree(jet.suv, by_u.sv, 4) && agree(jet.svv, by_v.sv, 5);
}

}  // namespace knotwork::test
