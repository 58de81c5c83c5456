#pragma once

#include <cassert>
#include <memory>
#include <span>
#include <utility>

#include <Eigen/Core>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/bspline_curve.h"

namespace knotwork {

/// Any parametric curve c on [start, end] as a plain value: what blends over a curve, or measures it, needs to know
/// of it and no more. The curve itself is kept behind a pointer, shared by copies and never changed, with the one
/// function that evaluates it.
class ModelCurve {
 public:
  /// `formula(t, out)`, out a span<Vector3d>, writes the k-th derivative at t into out[k], k = 0 .. out.size()-1, for
  /// up to `max_order`. It must give finite numbers on the domain; closed, it repeats outside with the period end -
  /// start. Preconditions: start < end, max_order >= 0.
  template <class Formula>
  ModelCurve(double start, double end, Topology topology, int max_order, Formula formula)
      : start_(start),
        end_(end),
        topology_(topology),
        max_order_(max_order),
        formula_(std::make_shared<const Formula>(std::move(formula))),
        evaluate_([](const void* stored, double t, std::span<Eigen::Vector3d> out) {
          (*static_cast<const Formula*>(stored))(t, out);
        }) {
    assert(start < end && max_order >= 0);
  }

  double start() const { return start_; }
  double end() const { return end_; }
  Topology topology() const { return topology_; }
  /// The highest derivative that there is a formula for.
  int max_order() const { return max_order_; }

  /// out[k] = the k-th derivative, k = 0 .. out.size()-1. t is not reduced. Precondition: out.size() <= max_order() +
  /// 1.
  void evaluate(double t, std::span<Eigen::Vector3d> out) const {
    assert(out.size() <= static_cast<std::size_t>(max_order_) + 1);
    evaluate_(formula_.get(), t, out);
  }
  Eigen::Vector3d operator()(double t) const {
    Eigen::Vector3d point;
    evaluate(t, {&point, 1});
    return point;
  }

 private:
  double start_, end_;
  Topology topology_;
  int max_order_;
  std::shared_ptr<const void> formula_;
  void (*evaluate_)(const void*, double, std::span<Eigen::Vector3d>);
};

/// A B-spline curve as a model. It has derivatives of every order, but at a knot only those from the right, and brings
/// parameters outside into its domain.
ModelCurve model_curve(BSplineCurve curve);

}  // namespace knotwork
