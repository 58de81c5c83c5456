#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "knotwork/curve/bspline_curve.h"
#include "knotwork/surface/bspline_surface.h"

namespace knotwork::benchmark {

/// As precise as the machine can: 64 bits on x86, 113 in WebAssembly and on ARM. Where it is no more than double, as with
/// Microsoft's compiler, a comparison with it says less.
using Precise = long double;
using PrecisePoint = Eigen::Matrix<Precise, 3, 1>;

/// A spline's point and first two derivatives from the points p_{i-p} .. p_i of one span, by de Boor's recursion on the
/// control points of each derivative: nothing of the code that is measured.
inline std::array<PrecisePoint, 3> precise_spline(const KnotVector& knots, int span, double t,
                                                  std::vector<PrecisePoint> points) {
  const int p = knots.degree();
  const auto knot = [&](int k) { return static_cast<Precise>(knots[k]); };
  std::array<PrecisePoint, 3> result;
  for (std::size_t order = 0; order < result.size(); ++order) {
    const int q = p - static_cast<int>(order);
    if (q < 0) {
      result[order].setZero();
      continue;
    }
    std::vector<PrecisePoint> row = points;
    for (int d = q; d > 0; --d) {
      for (int k = 0; k < d; ++k) {
        const Precise from = knot(span - d + 1 + k), to = knot(span + 1 + k), w = (t - from) / (to - from);
        const std::size_t at = static_cast<std::size_t>(k);
        row[at] = (1 - w) * row[at] + w * row[at + 1];
      }
    }
    result[order] = row[0];
    // The next derivative's points: q (c_{k+1} - c_k) / (t_{k+q+1} - t_{k+1}).
    for (int k = 0; k < q; ++k) {
      const std::size_t at = static_cast<std::size_t>(k);
      points[at] = q * (points[at + 1] - points[at]) / (knot(span + 1 + k) - knot(span - q + 1 + k));
    }
  }
  return result;
}

inline std::array<PrecisePoint, 3> precise_curve(const BSplineCurve& curve, double t) {
  const KnotVector& knots = curve.knots();
  const double reduced = knots.reduced(t);
  const int span = knots.span(reduced);
  std::vector<PrecisePoint> points;
  for (int i = span - knots.degree(); i <= span; ++i) points.push_back(curve.point(i).cast<Precise>());
  return precise_spline(knots, span, reduced, std::move(points));
}

/// S, S_u, S_v and the unit normal.
using PreciseFrame = Eigen::Matrix<Precise, 3, 4>;

inline PreciseFrame with_normal(const PrecisePoint& s, const PrecisePoint& su, const PrecisePoint& sv) {
  PreciseFrame frame;
  frame << s, su, sv, su.cross(sv).normalized();
  return frame;
}

inline PreciseFrame precise_surface(const BSplineSurface& surface, double u, double v) {
  const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
  const double at_u = knots_u.reduced(u), at_v = knots_v.reduced(v);
  const int i = knots_u.span(at_u), j = knots_v.span(at_v);
  std::vector<PrecisePoint> rows, slopes;
  for (int a = i - knots_u.degree(); a <= i; ++a) {
    std::vector<PrecisePoint> row;
    for (int b = j - knots_v.degree(); b <= j; ++b) row.push_back(surface.point(a, b).cast<Precise>());
    const auto along_v = precise_spline(knots_v, j, at_v, std::move(row));
    rows.push_back(along_v[0]);
    slopes.push_back(along_v[1]);
  }
  const auto along_u = precise_spline(knots_u, i, at_u, std::move(rows));
  return with_normal(along_u[0], along_u[1], precise_spline(knots_u, i, at_u, std::move(slopes))[0]);
}

}  // namespace knotwork::benchmark
