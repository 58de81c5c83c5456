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

/// Those of one span, p + 1 of them.
using PrecisePoints = std::array<PrecisePoint, KnotVector::max_degree + 1>;

/// A spline's point and first derivatives from the points p_{i-p} .. p_i of one span, by de Boor's recursion on the
/// control points of each derivative: nothing of the code that is measured.
template <std::size_t values>
std::array<PrecisePoint, values> precise_spline(const KnotVector& knots, int span, double t,
                                                const PrecisePoints& span_points) {
  const int p = knots.degree();
  const auto knot = [&](int k) { return static_cast<Precise>(knots[k]); };
  PrecisePoints points, row;
  std::copy_n(span_points.begin(), p + 1, points.begin());
  std::array<PrecisePoint, values> result;
  for (std::size_t order = 0; order < result.size(); ++order) {
    const int q = p - static_cast<int>(order);
    if (q < 0) {
      result[order].setZero();
      continue;
    }
    std::copy_n(points.begin(), q + 1, row.begin());
    for (int d = q; d > 0; --d) {
      for (int k = 0; k < d; ++k) {
        const Precise from = knot(span - d + 1 + k), to = knot(span + 1 + k), w = (t - from) / (to - from);
        const std::size_t at = static_cast<std::size_t>(k);
        row[at] = (1 - w) * row[at] + w * row[at + 1];
      }
    }
    result[order] = row[0];
    if (order + 1 == values) break;
    // The next derivative's points: q (c_{k+1} - c_k) / (t_{k+q+1} - t_{k+1}).
    for (int k = 0; k < q; ++k) {
      const std::size_t at = static_cast<std::size_t>(k);
      points[at] = q * (points[at + 1] - points[at]) / (knot(span + 1 + k) - knot(span - q + 1 + k));
    }
  }
  return result;
}

/// The point and `values - 1` derivatives.
template <std::size_t values>
std::array<PrecisePoint, values> precise_curve(const BSplineCurve& curve, double t) {
  const KnotVector& knots = curve.knots();
  const double reduced = knots.reduced(t);
  const int span = knots.span(reduced);
  PrecisePoints points;
  auto point = points.begin();
  for (int i = span - knots.degree(); i <= span; ++i) *point++ = curve.point(i).cast<Precise>();
  return precise_spline<values>(knots, span, reduced, points);
}

/// S, S_u, S_v and the unit normal.
using PreciseFrame = Eigen::Matrix<Precise, 3, 4>;

inline PreciseFrame with_normal(const PrecisePoint& s, const PrecisePoint& su, const PrecisePoint& sv) {
  PreciseFrame frame;
  frame << s, su, sv, su.cross(sv).normalized();
  return frame;
}

/// A surface along v at one u: the curves of S and of S_u there, whose control points all places of a grid's row share.
class PreciseRow {
 public:
  PreciseRow(const BSplineSurface& surface, double u) : knots_(surface.knots_v()) {
    const KnotVector& knots = surface.knots_u();
    const double at = knots.reduced(u);
    const int span = knots.span(at);
    const std::size_t count = static_cast<std::size_t>(knots_.count());
    points_.reserve(count);
    slopes_.reserve(count);
    for (int j = 0; j < knots_.count(); ++j) {
      PrecisePoints column;
      auto point = column.begin();
      for (int i = span - knots.degree(); i <= span; ++i) *point++ = surface.point(i, j).cast<Precise>();
      const auto along_u = precise_spline<2>(knots, span, at, column);
      points_.push_back(along_u[0]);
      slopes_.push_back(along_u[1]);
    }
  }

  PreciseFrame operator()(double v) const {
    const double at = knots_.reduced(v);
    const int span = knots_.span(at);
    const auto first = span - knots_.degree();
    PrecisePoints points, slopes;
    std::copy_n(points_.begin() + first, knots_.degree() + 1, points.begin());
    std::copy_n(slopes_.begin() + first, knots_.degree() + 1, slopes.begin());
    const auto along_v = precise_spline<2>(knots_, span, at, points);
    return with_normal(along_v[0], precise_spline<1>(knots_, span, at, slopes)[0], along_v[1]);
  }

 private:
  KnotVector knots_;
  std::vector<PrecisePoint> points_, slopes_;
};

}  // namespace knotwork::benchmark
