#pragma once

#include <span>

#include <Eigen/Core>

namespace knotwork {

/// The highest degree of Bezier curves and surfaces.
inline constexpr int max_bezier_degree = 16;

/// The Bernstein polynomials b_{p,k}(t) = C(p,k) t^k (1-t)^(p-k), k = 0..p, into `out` of p+1 numbers.
/// 0 <= p <= max_bezier_degree. On [0,1] all are at least 0 and their sum is 1; outside, the polynomials go on.
/// Built degree by degree from convex combinations: relative accuracy 1e-14 on [0,1]. Source: THEORY 2.3.
void bernstein(int degree, double t, std::span<double> out);

/// The derivative of the given order with respect to a parameter that runs delta times as slow as t:
/// delta^r D^r b_{p,k}(t), k = 0..p. All 0 for r > p. r >= 0.
void bernstein_derivative(int degree, double t, int order, double delta, std::span<double> out);

/// The Bernstein-Hermite matrix B_p(t), (p+1)x(p+1): row r holds delta^r D^r b_{p,k}(t), k = 0..p, so that
/// (c, c', .., c^(p)) = B_p(t) (Bezier points) where t = (x-s) delta, delta = 1/(e-s), x in [s,e]. Source: THEORY 2.3.
Eigen::MatrixXd bernstein_hermite(int degree, double t, double delta = 1);

}  // namespace knotwork
