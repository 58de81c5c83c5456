#pragma once

#include <array>

namespace knotwork {

/// The Gauss-Legendre rule of 16 points on [-1,1], exact for polynomials up to degree 31: the nodes x and -x have the
/// same weight. Correctly rounded from 50 digits (Newton on the Legendre polynomial P_16).
struct GaussNode {
  double x, weight;
};
inline constexpr std::array<GaussNode, 8> gauss_legendre_16{{
    {0.09501250983763744, 0.1894506104550685},
    {0.2816035507792589, 0.18260341504492358},
    {0.45801677765722737, 0.16915651939500254},
    {0.6178762444026438, 0.14959598881657674},
    {0.755404408355003, 0.12462897125553388},
    {0.8656312023878318, 0.09515851168249279},
    {0.9445750230732326, 0.062253523938647894},
    {0.9894009349916499, 0.027152459411754096},
}};

}  // namespace knotwork
