#pragma once

#include <span>

#include "knotwork/basis/knot_vector.h"

namespace knotwork {

/// The p+1 B-splines of degree p = knots.degree() that are not 0 on the given span, and their derivatives:
/// out[k (p+1) + j] = D^k b_{span-p+j,p}(t), k = 0..order, j = 0..p. Row 0 is at least 0 and sums to 1, the others sum
/// to 0; rows above the degree are 0. `out` has (order+1)(p+1) numbers, order >= 0.
///
/// b = T_1(t) T_2(t) .. T_p(t) and D^k b = p!/(p-k)! T_1 .. T_{p-k} T'_{p-k+1} .. T'_p, the matrix factors of THEORY 2.1:
/// T_d is d x (d+1), its row r holds 1-w and w in columns r and r+1 with w = w_{d,span-d+1+r}(t). Inside the span every
/// w lies in [0,1], so row 0 is a chain of convex combinations: relative accuracy 1e-14.
/// Preconditions: `span` is not an empty interval (as from KnotVector::span); t is in its closure, or the polynomial
/// pieces are continued.
void bspline_basis(const KnotVector& knots, int span, double t, int order, std::span<double> out);

/// The values alone (row 0), for many parameters of one span, column after column: out[j m + k] = b_{span-p+j,p}(t[k]),
/// j = 0..p, k = 0..m-1, m = t.size(). A tenth of the time of as many calls of the above; relative accuracy 1e-14 too,
/// unless knots that bound a support lie closer together than 1e-290. Allocates nothing. Preconditions as above.
void bspline_basis_columns(const KnotVector& knots, int span, std::span<const double> t, std::span<double> out);

}  // namespace knotwork
