#pragma once

#include <cstddef>
#include <cstring>

#include <Eigen/Core>

namespace knotwork {

// The one place that speaks of SIMD: the vector extensions of GCC and Clang, which turn arithmetic on these types into
// the widest instructions that the compiler may use (KNOTWORK_ARCHITECTURE).

template <std::size_t count>
struct VectorOf;
template <>
struct VectorOf<2> {
  using Type [[gnu::vector_size(2 * sizeof(double))]] = double;
};
template <>
struct VectorOf<4> {
  using Type [[gnu::vector_size(4 * sizeof(double))]] = double;
};
template <>
struct VectorOf<8> {
  using Type [[gnu::vector_size(8 * sizeof(double))]] = double;
};

using Pair = VectorOf<2>::Type;
using Quad = VectorOf<4>::Type;

/// How many doubles one instruction takes.
#if defined(__AVX512F__)
inline constexpr std::size_t lane_count = 8;
#elif defined(__AVX__)
inline constexpr std::size_t lane_count = 4;
#else
inline constexpr std::size_t lane_count = 2;
#endif

/// So many doubles that are computed with at once: the same coordinate of neighbouring points.
using Lanes = VectorOf<lane_count>::Type;

/// Element k = from[k]; no alignment is asked for.
template <class Vector>
[[gnu::always_inline]] inline void load(Vector& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}
template <class Vector>
[[gnu::always_inline]] inline void store(const Vector& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}
/// Of each lane; none is negative.
[[gnu::always_inline]] inline Lanes square_root(const Lanes& x) {
  // The one function that the extensions lack.
  Eigen::Array<double, lane_count, 1> values;
  store(x, values.data());
  values = values.sqrt();
  Lanes roots;
  load(roots, values.data());
  return roots;
}

/// x0 y0 z0 x1 y1 z1 ..: three coordinates of two or four points, as points.
[[gnu::always_inline]] inline void store_points(const Pair& x, const Pair& y, const Pair& z, double* to) {
  store(__builtin_shufflevector(x, y, 0, 2), to);
  store(__builtin_shufflevector(z, x, 0, 3), to + 2);
  store(__builtin_shufflevector(y, z, 1, 3), to + 4);
}
[[gnu::always_inline]] inline void store_points(const Quad& x, const Quad& y, const Quad& z, double* to) {
  const Quad xy = __builtin_shufflevector(x, y, 0, 4, 2, 6);  // x0 y0 x2 y2
  const Quad yz = __builtin_shufflevector(y, z, 1, 5, 3, 7);  // y1 z1 y3 z3
  const Quad zx = __builtin_shufflevector(z, x, 0, 5, 2, 7);  // z0 x1 z2 x3
  store(__builtin_shufflevector(xy, zx, 0, 1, 4, 5), to);
  store(__builtin_shufflevector(yz, xy, 0, 1, 6, 7), to + 4);
  store(__builtin_shufflevector(zx, yz, 2, 3, 6, 7), to + 8);
}

/// to[k stride ..] = a_k b_k c_k d_k: four numbers of two or four points, which are `stride` apart.
[[gnu::always_inline]] inline void store_fours(const Pair& a, const Pair& b, const Pair& c, const Pair& d, double* to,
                                               std::size_t stride) {
  store(__builtin_shufflevector(a, b, 0, 2), to);
  store(__builtin_shufflevector(c, d, 0, 2), to + 2);
  store(__builtin_shufflevector(a, b, 1, 3), to + stride);
  store(__builtin_shufflevector(c, d, 1, 3), to + stride + 2);
}
[[gnu::always_inline]] inline void store_fours(const Quad& a, const Quad& b, const Quad& c, const Quad& d, double* to,
                                               std::size_t stride) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  store(__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), to);
  store(__builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5), to + stride);
  store(__builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7), to + 2 * stride);
  store(__builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7), to + 3 * stride);
}

}  // namespace knotwork
