#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/basis/blending_function.h"
#include "knotwork/basis/knot_vector.h"
#include "knotwork/curve/model_curve.h"
#include "knotwork/result.h"

namespace knotwork {

/// What the local curves of a blending curve are made of. With x = t - t_{k+1}, all derivatives of the model m at
/// t_{k+1}, l_k(t) = M_k f_k(t), f_k(t_{k+1}) = 0:
enum class LocalCurveKind : unsigned char {
  sub_curve,       ///< f_k = m(t) - m(t_{k+1})
  bezier_hermite,  ///< f_k = sum_{1<=j<=d} m^(j) x^j/j!: Bezier curve with the model's Hermite data, degree d
  arc,             ///< f_k = sin(kappa v x)/kappa T + (1-cos(kappa v x))/kappa N, the osculating circle at the speed v
};

struct LocalCurves {
  LocalCurveKind kind = LocalCurveKind::sub_curve;
  int degree = 3;  ///< d of Bezier-Hermite locals, from 1 to max_bezier_degree and model.max_order()
};

/// The blending curve over n local curves of one model curve (THEORY 2.7):
///
///   c(t) = (1 - B(w)) l_{i-1}(t) + B(w) l_i(t),   w = w_{1,i}(t),   t in [t_i, t_{i+1}).
///
/// Local k lives on (t_k, t_{k+2}) and is centred at t_{k+1}; in a closed curve index n is index 0 again, evaluated one
/// period earlier. M_k is any affine map, Translation(m(t_{k+1})) when unmoved. With B of order r, c has at t_{k+1} the
/// point and the first r derivatives of l_k. Unmoved sub-curves give the model back, whatever B is.
///
/// An arc becomes a straight line at the speed v where kappa is 0, and a single point where the model stands still:
/// where v = 0, or so small that the arc would turn by more than 10^9 rad over the domain of the local.
class BlendingCurve {
 public:
  /// Derivatives are given up to this order, as B has them.
  static constexpr int max_order = 3;

  /// `locals[k]` is M_k. Error path: `model` (a domain shorter than 1e-9 or longer than 1e9, a sub-curve's model with
  /// fewer than 3 derivatives or an arc's with fewer than 2, derivatives at a knot that are not finite or beyond
  /// 1e100); `knots` (as BlendingSurface::make); `shape.degree`; `locals` (wrong number); `locals[k]` (not affine, or
  /// an entry not finite or beyond 1e100).
  static Result<BlendingCurve> make(ModelCurve model, KnotVector knots, BlendingFunction blending, LocalCurves shape,
                                    std::vector<Eigen::Affine3d> locals);

  /// The maps of unmoved locals: Translation(m(t_{k+1})).
  static std::vector<Eigen::Affine3d> unmoved_locals(const ModelCurve& model, const KnotVector& knots);

  const ModelCurve& model() const { return model_; }
  const KnotVector& knots() const { return knots_; }
  const BlendingFunction& blending() const { return blending_; }
  const LocalCurves& shape() const { return shape_; }

  const Eigen::Affine3d& local(int k) const { return locals_[static_cast<std::size_t>(k)]; }
  /// Precondition: a map that make() accepts, 0 <= k < n.
  void set_local(int k, const Eigen::Affine3d& map);
  /// The centre t_{k+1} of local k.
  double centre(int k) const { return knots_[k + 1]; }

  /// out[j] = the j-th derivative of l_k at t, which is not reduced; j = 0 .. out.size()-1, at most max_order.
  void evaluate_local(int k, double t, std::span<Eigen::Vector3d> out) const;

  /// out[j] = c^(j)(t), j = 0 .. out.size()-1, at most max_order. t is reduced to the domain: closed wraps, open
  /// clamps. At a knot the interval to its right counts, at the end of an open curve the last one. Sub-curves by the
  /// one-evaluation form: c(t) = A(t) (m(t); 1), A = (1-B) M^_{i-1} + B M^_i, M^_k = M_k Translation(-m(t_{k+1})). t
  /// must be finite.
  void evaluate(double t, std::span<Eigen::Vector3d> out) const;
  Eigen::Vector3d operator()(double t) const;
  /// The same for many parameters: out[m (order+1) + j] at t[m], 0 <= order <= max_order. Sorted parameters find their
  /// interval in O(1). Allocates nothing.
  void evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const;

  /// The two-curve form, term by term as in the formula above: the readable reference that the fast form is held to.
  void evaluate_two_curves(double t, std::span<Eigen::Vector3d> out) const;

  /// The weights 1-B and B at t with their locals.
  struct Weight {
    int local;
    double value;
  };
  std::array<Weight, 2> weights(double t) const;

 private:
  BlendingCurve(ModelCurve model, KnotVector knots, BlendingFunction blending, LocalCurves shape,
                std::vector<Eigen::Affine3d> locals, std::vector<Eigen::Vector3d> centre_data);
  int evaluate_near(int hint, double t, std::span<Eigen::Vector3d> out) const;
  void evaluate_shape(int k, double x, std::span<Eigen::Vector3d> out) const;
  std::span<const Eigen::Vector3d> centre_data(int k) const;

  ModelCurve model_;
  KnotVector knots_;
  BlendingFunction blending_;
  LocalCurves shape_;
  std::vector<Eigen::Affine3d> locals_, model_maps_;
  std::vector<Eigen::Vector3d> centre_data_;  ///< the same number of vectors for every local, as its kind needs
};

}  // namespace knotwork
