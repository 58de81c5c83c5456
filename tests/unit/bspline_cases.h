#pragma once

// B-spline curves and surfaces for tests: those of the oracles, and random ones.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/bspline_curve.h"
#include "knotwork/surface/bspline_surface.h"
#include "unit/oracle.h"

namespace knotwork::test {

/// What an oracle says of a curve: `points` holds its parameters with the expected numbers.
struct CurveOracle {
  std::string name;
  BSplineCurve curve;
  nlohmann::json inputs, points;
};

inline std::vector<Eigen::Vector3d> vectors(const nlohmann::json& list) {
  std::vector<Eigen::Vector3d> out;
  for (const nlohmann::json& item : list) out.push_back(vector3(item));
  return out;
}

/// All curves of oracle 01 (open) or 02 (closed); none when the file cannot be read.
inline std::vector<CurveOracle> curve_oracles(Topology topology) {
  const bool open = topology == Topology::open;
  const nlohmann::json& oracle = load_oracle(open ? "01_bspline_clamped.json" : "02_bspline_periodic.json");
  std::vector<CurveOracle> curves;
  if (!oracle.contains("cases")) return curves;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    // Given, or found by the oracle's interpolation.
    const nlohmann::json& points = open                                         ? inputs["control_points"]
                                   : inputs.contains("distinct_control_points") ? inputs["distinct_control_points"]
                                                                                : entry["control_points"];
    const KnotVector knots =
        KnotVector::make(inputs["degree"].get<int>(), topology, inputs["knots"].get<std::vector<double>>()).value();
    read_case(entry);
    curves.push_back({entry["name"].get<std::string>(), BSplineCurve::make(knots, vectors(points)).value(), inputs,
                      entry["points"]});
  }
  return curves;
}

/// What oracle 13 says of a surface.
struct SurfaceOracle {
  std::string name;
  BSplineSurface surface;
  nlohmann::json points;
};

/// All surfaces of oracle 13; none when the file cannot be read. Closed in u where its name says so: the net then has
/// the first rows again at its end.
inline std::vector<SurfaceOracle> surface_oracles() {
  const nlohmann::json& oracle = load_oracle("13_tensor_surfaces.json");
  std::vector<SurfaceOracle> surfaces;
  if (!oracle.contains("cases")) return surfaces;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    const std::string name = entry["name"].get<std::string>();
    const auto knots = [&](const char* direction, Topology topology) {
      return KnotVector::make(inputs["degree_" + std::string(direction)].get<int>(), topology,
                              inputs["knots_" + std::string(direction)].get<std::vector<double>>())
          .value();
    };
    const KnotVector u = knots("u", name.rfind("closed_u", 0) == 0 ? Topology::closed : Topology::open);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < static_cast<std::size_t>(u.count()); ++i) {
      for (const nlohmann::json& point : inputs["control_net_[i][j]"][i]) points.push_back(vector3(point));
    }
    read_case(entry);
    surfaces.push_back(
        {name, BSplineSurface::make(u, knots("v", Topology::open), std::move(points)).value(), entry["points"]});
  }
  return surfaces;
}

/// sum_j |D^k b_j(t)| weight(j), over the splines that are not 0 at t.
template <class Weight>
double weighted_basis_size(const KnotVector& knots, double t, int k, const Weight& weight) {
  const double inside = knots.reduced(t);
  const int span = knots.span(inside), p = knots.degree();
  const std::size_t width = static_cast<std::size_t>(p) + 1, row = static_cast<std::size_t>(k) * width;
  std::vector<double> basis(row + width);
  bspline_basis(knots, span, inside, k, basis);
  double size = 0;
  for (std::size_t j = 0; j < width; ++j) size += std::abs(basis[row + j]) * weight(span - p + static_cast<int>(j));
  return size;
}

/// The largest k-th derivative at t that control points of norm 1 can make.
inline double basis_size(const KnotVector& knots, double t, int k) {
  return weighted_basis_size(knots, t, k, [](int) { return 1.0; });
}

/// The terms that the k-th derivative at t is the sum of: sum_j |D^k b_j(t)| |c_j|. Rounding is relative to this.
inline double derivative_size(const BSplineCurve& curve, double t, int k) {
  return weighted_basis_size(curve.knots(), t, k, [&](int j) { return curve.point(j).norm(); });
}

/// Whether two curves have the same derivatives 0..order at t.
inline bool same_at(const BSplineCurve& a, const BSplineCurve& b, double t, int order, double tolerance) {
  std::vector<Eigen::Vector3d> left(static_cast<std::size_t>(order) + 1), right(left.size());
  a.evaluate(t, left);
  b.evaluate(t, right);
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double size =
        std::max(derivative_size(a, t, static_cast<int>(k)), derivative_size(b, t, static_cast<int>(k)));
    if (!close(right[k], left[k], tolerance, size).within) return false;
  }
  return true;
}

/// The largest control point: what errors of points are relative to.
inline double polygon_size(const BSplineCurve& curve) {
  double size = 0;
  for (const Eigen::Vector3d& point : curve.points()) size = std::max(size, point.norm());
  return size;
}

inline std::vector<Eigen::Vector3d> random_points(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  std::vector<Eigen::Vector3d> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

enum class Ends { clamped, unclamped, closed };

/// Knots drawn from few places, so that many are repeated; the domain is [0, 6], closed with any copy of the start as
/// t_p.
inline KnotVector random_knots(int degree, int count, Ends ends, std::mt19937& random) {
  std::uniform_int_distribution<int> place(0, 5), offset(0, degree);
  std::uniform_real_distribution<double> width(0.25, 1.5);
  const bool closed = ends == Ends::closed;
  const double places[] = {0, 1.5, 2, 3, 4.125, 5};
  for (;;) {
    std::vector<double> knots;
    const int inner = closed ? count : count - degree - 1;
    knots.reserve(static_cast<std::size_t>(count + 2 * degree + 1));
    for (int k = 0; k < inner; ++k) {
      // Some simple knots too, else long vectors would break the bound on multiplicity.
      const int p = place(random);
      knots.push_back(places[p] + (p > 0 && place(random) > 1 ? width(random) / 2 : 0));
    }
    std::sort(knots.begin(), knots.end());
    if (closed) {
      knots[0] = 0;
      std::vector<double> around;
      const int shift = std::min(offset(random), static_cast<int>(std::count(knots.begin(), knots.end(), 0.0)) - 1);
      for (int k = -degree + shift + count; k <= 2 * count + degree + shift; ++k) {
        const int turn = k / count - 1;
        around.push_back(knots[static_cast<std::size_t>(k % count)] + 6.0 * turn);
      }
      knots = around;
    } else {
      double before = 0, behind = 6;
      for (int k = 0; k <= degree; ++k) {
        knots.insert(knots.begin(), before);
        knots.push_back(behind);
        if (ends == Ends::unclamped) before -= width(random), behind += width(random);
      }
    }
    const bool inside = closed || (knots[static_cast<std::size_t>(degree) + 1] > 0 && inner >= 0);
    if (!inside) continue;
    Result<KnotVector> result = KnotVector::make(degree, closed ? Topology::closed : Topology::open, std::move(knots));
    if (result) return std::move(result).value();
  }
}

inline BSplineCurve random_curve(int degree, int count, Ends ends, std::mt19937& random) {
  KnotVector knots = random_knots(degree, count, ends, random);
  std::vector<Eigen::Vector3d> points = random_points(static_cast<std::size_t>(count), random);
  return BSplineCurve::make(std::move(knots), std::move(points)).value();
}

}  // namespace knotwork::test
