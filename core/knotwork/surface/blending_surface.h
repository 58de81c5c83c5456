#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

/// The blending tensor-product surface over sub-surface local patches of one model surface (THEORY 2.8):
///
///   S(u,v) = sum_{a,b in {0,1}} bu_a bv_b s_{i-1+a, j-1+b}(u,v),   bu = (1-B(w_{1,i}(u)), B(w_{1,i}(u))), bv likewise,
///   s_ij(u,v) = M_ij (model(u,v) - model(u_{i+1}, v_{j+1})).
///
/// n_u x n_v local surfaces; local (i,j) is centred at (u_{i+1}, v_{j+1}); in a closed direction index n is index 0
/// again, evaluated one period earlier. M_ij is any affine map, Translation(model(centre)) when unmoved.
class BlendingSurface {
 public:
  /// `locals[i * n_v + j]` is M_ij. Error path: `model.<member>`; `knots_u` or `knots_v` (degree other than 1, a direction
  /// closed in which the model is not, a period other than the model's, knots off the model's domain, intervals below
  /// 1e-9 of it); `locals` (wrong number); `locals[k]` (not affine, or an entry not finite or beyond 1e100).
  static Result<BlendingSurface> make(ModelSurface model, KnotVector knots_u, KnotVector knots_v,
                                      BlendingFunction blending, std::vector<Eigen::Affine3d> locals);

  /// The maps of unmoved locals: Translation(model(u_{i+1}, v_{j+1})).
  static std::vector<Eigen::Affine3d> unmoved_locals(const ModelSurface& model, const KnotVector& knots_u,
                                                     const KnotVector& knots_v);

  const ModelSurface& model() const { return model_; }
  const KnotVector& knots_u() const { return knots_u_; }
  const KnotVector& knots_v() const { return knots_v_; }
  const BlendingFunction& blending() const { return blending_; }

  const Eigen::Affine3d& local(int i, int j) const;
  /// Precondition: a map that make() accepts, 0 <= i < n_u, 0 <= j < n_v.
  void set_local(int i, int j, const Eigen::Affine3d& map);
  /// M^_ij = M_ij Translation(-model(centre)): takes model points to local patch points.
  const Eigen::Affine3d& model_map(int i, int j) const;
  /// The centre (u_{i+1}, v_{j+1}) of local (i,j).
  Eigen::Vector2d centre(int i, int j) const;

  /// s_ij and partials at (u,v), not reduced.
  SurfaceJet evaluate_local(int i, int j, double u, double v) const;

  /// The one-evaluation form S = A (model; 1), A = sum bu_a bv_b M^: one model evaluation a point. (u,v) is reduced to
  /// the domain: closed directions wrap, open ones clamp. At a knot the interval to its right counts, at the end of an
  /// open direction the last one.
  SurfaceJet evaluate(double u, double v) const;
  void evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const;
  /// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). Fast path: B is evaluated once a row and column.
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out) const;

  /// The four-patch form, term by term as in the formula above: the readable reference that the fast form is held to.
  SurfaceJet evaluate_four_patches(double u, double v) const;

  /// The weights bu_a bv_b at (u,v) with their locals.
  struct Weight {
    int i, j;
    double value;
  };
  std::array<Weight, 4> weights(double u, double v) const;

 private:
  BlendingSurface(ModelSurface model, KnotVector knots_u, KnotVector knots_v, BlendingFunction blending,
                  std::vector<Eigen::Affine3d> locals);
  std::size_t index(int i, int j) const;

  ModelSurface model_;
  KnotVector knots_u_, knots_v_;
  BlendingFunction blending_;
  std::vector<Eigen::Affine3d> locals_, model_maps_;
};

}  // namespace knotwork
