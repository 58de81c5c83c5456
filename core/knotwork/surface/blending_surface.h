#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/later.h"
#include "knotwork/surface/model_surface.h"
#include "knotwork/surface/surface_frame.h"
#include "knotwork/surface/surface_jet.h"

namespace knotwork {

struct LocalBlend;

/// What the local surfaces are made of. With x = u - u_{i+1}, y = v - v_{j+1}, all partials of the model S^ at
/// (u_{i+1}, v_{j+1}), s_ij(u,v) = M_ij f_ij(u,v), f_ij(u_{i+1}, v_{j+1}) = 0:
enum class LocalSurfaceKind : unsigned char {
  sub_surface,     ///< f_ij = S^(u,v) - S^(u_{i+1}, v_{j+1})
  bezier_hermite,  ///< f_ij = sum_{p<=d_u, q<=d_v, p+q>0} D^(p,q)S^ x^p y^q/(p! q!): Bezier patch with Hermite data
};

struct LocalSurfaces {
  LocalSurfaceKind kind = LocalSurfaceKind::sub_surface;
  int degree_u = 3, degree_v = 3;  ///< d_u, d_v of Bezier-Hermite locals, from 1 to max_mixed_order

  bool operator==(const LocalSurfaces&) const = default;
};

/// The blending tensor-product surface over the local surfaces of one model surface (THEORY 2.8):
///
///   S(u,v) = sum_{a,b in {0,1}} bu_a bv_b s_{i-1+a, j-1+b}(u,v),   bu = (1-B(w_{1,i}(u)), B(w_{1,i}(u))), bv likewise.
///
/// n_u x n_v local surfaces; local (i,j) is centred at (u_{i+1}, v_{j+1}); in a closed direction index n is index 0
/// again, evaluated one period earlier. M_ij is any affine map, Translation(model(centre)) when unmoved. Unmoved
/// sub-surfaces give the model back, whatever B is; with B of order r the partials of S at a centre are those of its
/// local, to order r in each direction.
///
/// Closed in v where the model is twisted, S^(u, v+P) = S^(sigma(u), v): the locals beyond the seam are
/// s_{i,n}(u,v) = s_{rho(i),0}(sigma(u), v-P). That needs knots in u that sigma maps onto themselves, local i to
/// rho(i), and a symmetric B. Then S and S_v are continuous across the seam, and S_u changes its sign. In u likewise.
class BlendingSurface {
 public:
  /// `locals[i * n_v + j]` is M_ij. Error path: `model.<member>`; `knots_u` or `knots_v` (degree other than 1, a direction
  /// closed in which the model is not, a period other than the model's, knots off the model's domain, intervals below
  /// 1e-9 of it, knots that a twisted seam does not map onto themselves); `blending` (not symmetric, over a twisted
  /// seam); `shape.degree_u`, `shape.degree_v`; `locals` (wrong number); `locals[k]` (not affine, or an entry not finite
  /// or beyond 1e100).
  static Result<BlendingSurface> make(ModelSurface model, KnotVector knots_u, KnotVector knots_v,
                                      BlendingFunction blending, std::vector<Eigen::Affine3d> locals,
                                      LocalSurfaces shape = {});

  /// The maps of unmoved locals: Translation(model(u_{i+1}, v_{j+1})).
  static std::vector<Eigen::Affine3d> unmoved_locals(const ModelSurface& model, const KnotVector& knots_u,
                                                     const KnotVector& knots_v);

  const ModelSurface& model() const { return model_; }
  const KnotVector& knots_u() const { return knots_u_; }
  const KnotVector& knots_v() const { return knots_v_; }
  const BlendingFunction& blending() const { return blending_; }
  const LocalSurfaces& shape() const { return shape_; }

  /// What going round a direction once does to the other one, w.
  struct Twist {
    double reflection;  ///< sigma(w) = reflection - w
    int mirror;         ///< rho(k) = mirror - k, modulo the number of locals where w is closed
  };
  /// Nothing where u (v) is not closed with a twist.
  const std::optional<Twist>& twist_u() const { return twist_u_; }
  const std::optional<Twist>& twist_v() const { return twist_v_; }
  /// The local that index (i,j), 0 <= i <= n_u, 0 <= j <= n_v, means: n is 0 again, the other index reflected where the
  /// seam is twisted.
  std::pair<int, int> wrapped(int i, int j) const;

  const Eigen::Affine3d& local(int i, int j) const;
  /// Precondition: a map that make() accepts, 0 <= i < n_u, 0 <= j < n_v.
  void set_local(int i, int j, const Eigen::Affine3d& map);
  /// M^_ij = M_ij Translation(-model(centre)): takes model points to points of sub-surface locals.
  const Eigen::Affine3d& model_map(int i, int j) const;
  /// D^(p,q)S^/(p! q!) at p (d_v+1) + q, with 0 in place of the point itself: f_ij of a Bezier-Hermite local as a
  /// polynomial in x and y. Empty for sub-surfaces.
  std::span<const Eigen::Vector3d> coefficients(int i, int j) const;
  /// The model's at the centre of local (i,j).
  const SurfaceJet& centre_jet(int i, int j) const { return centre_jets_[index(i, j)]; }
  /// The centre (u_{i+1}, v_{j+1}) of local (i,j).
  Eigen::Vector2d centre(int i, int j) const;

  /// s_ij and partials at (u,v), not reduced.
  SurfaceJet evaluate_local(int i, int j, double u, double v) const;

  /// Sub-surfaces by the one-evaluation form S = A (model; 1), A = sum bu_a bv_b M^: one model evaluation a point. (u,v)
  /// is reduced to the domain: closed directions wrap, twisted ones reflecting the other parameter every odd time (and
  /// so the signs of S_u and S_uv, or S_v and S_uv), open ones clamp. At a knot the interval to its right counts, at the
  /// end of an open direction the last one.
  SurfaceJet evaluate(double u, double v) const;
  void evaluate(std::span<const Eigen::Vector2d> uv, std::span<SurfaceJet> out) const;
  /// All pairs: out[a * v.size() + b] belongs to (u[a], v[b]). Fast path: without a twist B is evaluated once a row and
  /// column. Allocates nothing.
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceJet> out) const;

  /// Points with first partials and unit normals (unit_normal() of the whole jet where the partials are parallel): the
  /// fast path for large grids of sub-surfaces over a model without a twist. The maps of a cell are blended over u once a
  /// row; so sorted v are the fastest. Agrees with evaluate() to rounding. Scratch memory: O(u.size() + v.size()).
  /// Bezier-Hermite locals, and all locals over a twisted model, are evaluated point by point.
  void evaluate_grid(std::span<const double> u, std::span<const double> v, std::span<SurfaceFrame> out) const;

  /// The four-patch form, term by term as in the formula above: the readable reference that the fast form is held to.
  SurfaceJet evaluate_four_patches(double u, double v) const;

  /// The weights bu_a bv_b at (u,v) with their locals.
  struct Weight {
    int i, j;
    double value;
  };
  std::array<Weight, 4> weights(double u, double v) const;

 private:
  /// A place in the domain, and whether a twisted seam on the way has reflected u or v.
  struct Place {
    double u, v;
    bool mirrored_u = false, mirrored_v = false;
  };

  BlendingSurface(ModelSurface model, KnotVector knots_u, KnotVector knots_v, BlendingFunction blending,
                  std::vector<Eigen::Affine3d> locals, LocalSurfaces shape, std::optional<Twist> twist_u,
                  std::optional<Twist> twist_v);
  std::size_t index(int i, int j) const;
  KNOTWORK_LATER void expand_model();
  Place reduced(double u, double v) const;
  const Eigen::Affine3d& wrapped_map(int i, int j) const;
  SurfaceJet polynomial(int i, int j, double x, double y) const;
  KNOTWORK_LATER SurfaceJet blended_polynomials(const LocalBlend& u, const LocalBlend& v, double at_u,
                                                double at_v) const;
  SurfaceJet evaluate_cell(const LocalBlend& u, const LocalBlend& v, const SurfaceJet& model) const;
  SurfaceJet evaluate_twisted(double u, double v) const;

  ModelSurface model_;
  KnotVector knots_u_, knots_v_;
  BlendingFunction blending_;
  LocalSurfaces shape_;
  std::optional<Twist> twist_u_, twist_v_;
  std::vector<SurfaceJet> centre_jets_;
  std::vector<Eigen::Affine3d> locals_, model_maps_;
  std::vector<Eigen::Vector3d> coefficients_;  ///< of Bezier-Hermite locals: (d_u+1)(d_v+1) each, D^(p,q)/(p! q!)
};

}  // namespace knotwork
