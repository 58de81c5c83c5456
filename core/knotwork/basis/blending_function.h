#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "knotwork/result.h"

namespace knotwork {

/// The eleven families of B-functions of THEORY 2.6, in the table's order.
enum class BlendingKind : unsigned char {
  linear,
  trigonometric,
  polynomial1,
  polynomial2,
  polynomial3,
  polynomial_m,  ///< I_t(m+1, m+1), integer m
  trigonometric2,
  trigonometric3,
  rational,  ///< t^p / (t^p + (1-t)^p), integer p
  expo_rational,
  logistic_expo_rational,
};

/// One row of the table that page, panel, documents and tests iterate.
struct BlendingFamily {
  BlendingKind kind;
  std::string_view id;       ///< in documents, as `polynomial2`
  std::string_view label;    ///< for readers
  std::string_view formula;  ///< TeX
  int order;       ///< m with B^(k)(0) = B^(k)(1) = 0 for k = 1..m; -1: given by the parameter; smooth_order: all k
  bool symmetric;  ///< B(t) + B(1-t) = 1
  int parameter_min, parameter_max, parameter_default;  ///< integer m or p; all 0 where there is none
};
inline constexpr int smooth_order = 1000;

std::span<const BlendingFamily> blending_families();
const BlendingFamily& blending_family(BlendingKind kind);
/// nullptr when there is no such id.
const BlendingFamily* find_blending_family(std::string_view id);

/// Intrinsic parameters of phi(s) = exp(-beta |s-lambda|^(alpha(1+gamma)) / (s (1-s)^gamma)^alpha).
struct ExpoRationalParameters {
  double alpha = 1, beta = 1, gamma = 1, lambda = 0.5;

  /// The range of alpha, beta and gamma: far beyond what changes the picture, near enough for double precision.
  static constexpr double least = 1.0 / 16, greatest = 16;
};

/// {B, B', B'', B'''} at one w.
using BlendingValue = std::array<double, 4>;

/// A B-function B: [0,1] -> [0,1], B(0)=0, B(1)=1, monotone. Cheap to copy; valid once constructed.
class BlendingFunction {
 public:
  /// `parameter` is m or p for the families that have one and ignored by the others. Error path: `parameter`.
  static Result<BlendingFunction> make(BlendingKind kind, int parameter = 0);
  /// Expo-rational with other intrinsic parameters: alpha, beta, gamma in [1/16, 16], 0 <= lambda <= 1. Prepares a table
  /// (well under a millisecond). Error path: the member's name.
  static Result<BlendingFunction> make(const ExpoRationalParameters& parameters);

  BlendingKind kind() const { return kind_; }
  int parameter() const { return parameter_; }
  /// The order m; smooth_order for the expo-rational families, but 0 where lambda is 0 or 1.
  int order() const;
  bool symmetric() const;

  /// B and three derivatives. w outside [0,1] is clamped: B = 0 or 1, all derivatives 0 (not at the ends themselves,
  /// where the one-sided derivatives are given). Never NaN or infinite for a number w. Relative accuracy 1e-12 against
  /// oracle 05, next to the ends too, where B or 1-B is many orders of magnitude below 1.
  BlendingValue operator()(double w) const;
  void evaluate(std::span<const double> w, std::span<BlendingValue> out) const;

  /// S = 1 / int_0^1 phi of an expo-rational function; 1 for the others.
  double expo_rational_scale() const;

 private:
  struct ExpoRationalTable;
  BlendingFunction(BlendingKind kind, int parameter, std::shared_ptr<const ExpoRationalTable> table);

  BlendingKind kind_;
  int parameter_;
  std::shared_ptr<const ExpoRationalTable> table_;
};

}  // namespace knotwork
