#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"

namespace knotwork {

class BezierCurve;
class BlendingCurve;
class BSplineCurve;
class ModelCurve;
struct CatalogueCurve;

/// Any parametric curve c(t), t in [start, end], as the measures (arc length, closest point, box, moving frames) see
/// it: a reference to the curve and a function that evaluates it. It owns nothing: the curve and its breaks must
/// outlive it. Two pointers instead of a template or a base class, so that every measure is compiled once and curves
/// need not know of each other. The curve is finite, and its coordinates lie below 1e100.
struct CurveView {
  const void* curve;
  /// out[k] = the k-th derivative of *curve at t, k = 0 .. out.size()-1 <= 3; start <= t <= end.
  void (*function)(const void* curve, double t, std::span<Eigen::Vector3d> out);
  double start, end;
  Topology topology = Topology::open;
  /// Sorted parameters between which the curve is smooth, as knots; repeated ones and ones outside (start, end) count
  /// for nothing. At a break, `function` gives the derivatives of the piece on its right.
  std::span<const double> breaks = {};
  /// How many intervals of each smooth piece a search looks at first: the degree of polynomial pieces; otherwise enough
  /// for a cubic to come near each coordinate of the curve on each of them (8 to an oscillation).
  int detail = 64;

  bool closed() const { return topology == Topology::closed; }
  void evaluate(double t, std::span<Eigen::Vector3d> out) const { function(curve, t, out); }
  Eigen::Vector3d operator()(double t) const;
};

/// The view of a curve that has evaluate(t, out); for other curves the function is written out. The curve must outlive
/// it.
template <class Curve>
CurveView curve_view(const Curve& curve, double start, double end, Topology topology = Topology::open,
                     std::span<const double> breaks = {}, int detail = 64) {
  const auto function = [](const void* self, double t, std::span<Eigen::Vector3d> out) {
    static_cast<const Curve*>(self)->evaluate(t, out);
  };
  return {&curve, function, start, end, topology, breaks, detail};
}
CurveView curve_view(const BezierCurve& curve);
CurveView curve_view(const BSplineCurve& curve);
CurveView curve_view(const BlendingCurve& curve);
/// Precondition: the curve passes validate().
CurveView curve_view(const CatalogueCurve& curve);
/// Of a curve with three derivatives.
CurveView curve_view(const ModelCurve& curve);

/// The ends of the smooth pieces of [from, to]: from, the breaks strictly between, each once, to. from < to.
std::vector<double> piece_ends(double from, double to, std::span<const double> breaks);

/// The last parameter before `end`: where a piece is evaluated for its own derivatives at its end, not for those of the
/// next one. Moves the point by rounding only. Before 0 it is the least normal number: of lesser ones the inverse
/// overflows.
double just_before(double end);

}  // namespace knotwork
