#pragma once

#include <span>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/model_surface.h"

namespace knotwork::scene {

/// What stands on the stage of a model surface: the surface over evenly spaced parameter lines, which are knots of
/// degree 1. They are an even number in each direction, so that one lies in the middle, where the classic Klein bottle
/// is pieced together, and as many as make cells about as long as wide.
class ModelFigure {
 public:
  /// Precondition: the model is valid.
  explicit ModelFigure(const ModelSurface& model);

  const ModelSurface& model() const { return model_; }
  /// Closed where the model is; a direction closed with a twist counts as open.
  const KnotVector& knots_u() const { return knots_u_; }
  const KnotVector& knots_v() const { return knots_v_; }
  SurfaceJet evaluate(double u, double v) const { return knotwork::evaluate(model_, u, v); }
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out) const {
    knotwork::evaluate_grid(model_, u, v, out);
  }
  /// Whether a way round brings one to the other side, so that it has none.
  bool one_sided() const;

 private:
  ModelSurface model_;
  KnotVector knots_u_, knots_v_;
};

}  // namespace knotwork::scene
