#include "knotwork/curve/spline_pieces.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "knotwork/basis/fixed_degree.h"
#include "knotwork/basis/lanes.h"
#include "knotwork/basis/point_columns.h"

namespace knotwork {

namespace {

/// So many parameters are looked at at once: all in one piece, they are evaluated together, a lane each; else one by
/// one, a lane for each coordinate.
constexpr std::size_t block_size = 16;

struct Range {
  double least, most;
};

Range least_and_most(const double* block) {
  Lanes least, most, t;
  load(least, block);
  most = least;
  for (std::size_t m = lane_count; m < block_size; m += lane_count) {
    load(t, block + m);
    least = t < least ? t : least;
    most = t > most ? t : most;
  }
  Range range{least[0], most[0]};
  for (std::size_t k = 1; k < lane_count; ++k) {
    range.least = std::min(range.least, least[k]);
    range.most = std::max(range.most, most[k]);
  }
  return range;
}

}  // namespace

SplinePieces::SplinePieces(const BSplineCurve& curve) : knots_(curve.knots()) {
  std::array<double, KnotVector::max_degree> arguments;
  for (int span = degree(); span <= knots_.last_span(); ++span) {
    const double from = knots_[span], to = knots_[span + 1];
    if (!(from < to)) continue;
    breaks_.push_back(from);
    inverse_widths_.push_back(1 / (to - from));
    // Each derivative's points from the control points: differences of the piece's own would lose the digits that
    // neighbouring points have in common where the piece is short.
    for (int order = 0; order <= std::min(max_order, degree()); ++order) {
      const int top = degree() - order;
      const std::span<double> ends = std::span(arguments).first(static_cast<std::size_t>(top));
      std::fill(ends.begin(), ends.end(), from);
      double binomial = 1;
      for (int k = 0; k <= top; ++k) {
        if (k > 0) ends[static_cast<std::size_t>(top - k)] = to;
        const Eigen::Vector3d q = binomial * curve.blossom(span, ends);
        coefficients_[static_cast<std::size_t>(order)].push_back({q.x(), q.y(), q.z(), 0});
        binomial = binomial * (top - k) / (k + 1);
      }
    }
  }
  breaks_.push_back(knots_.end());

  buckets_per_unit_ = static_cast<double>(piece_count()) / knots_.period();
  breaks_before_.assign(breaks_.size() + 1, 0);
  for (std::size_t k = 1; k + 1 < breaks_.size(); ++k) ++breaks_before_[bucket_of(breaks_[k]) + 1];
  for (std::size_t b = 1; b < breaks_before_.size(); ++b) breaks_before_[b] += breaks_before_[b - 1];
}

/// Does not decrease with t: breaks in buckets before t's lie before t, those in buckets behind it behind t. The first
/// bucket is half as wide as the others, so that equidistant breaks lie in the middle of theirs, and not at the ends by
/// chance.
std::size_t SplinePieces::bucket_of(double t) const {
  constexpr double half_a_bucket = 0.5;
  return static_cast<std::size_t>(
      static_cast<std::ptrdiff_t>((t - knots_.start()) * buckets_per_unit_ + half_a_bucket));
}

std::size_t SplinePieces::piece_at(double t) const {
  const std::size_t bucket = bucket_of(t);
  const std::ptrdiff_t before = breaks_before_[bucket], inside = breaks_before_[bucket + 1] - before;
  // One break in a bucket is the rule: no search.
  const auto first = breaks_.begin() + 1 + before;
  if (inside == 1) return static_cast<std::size_t>(before + (t >= *first ? 1 : 0));
  return static_cast<std::size_t>(std::upper_bound(first, first + inside, t) - breaks_.begin()) - 1;
}

/// A block of parameters of one piece: the coefficients are the same for all lanes.
template <int fixed_degree, std::size_t values>
void SplinePieces::evaluate_together(std::size_t piece, const double* t, double* out) const {
  const std::size_t width = degree_or_fixed<fixed_degree>(degree()) + 1;
  const double from = breaks_[piece], inverse = inverse_widths_[piece];
  PointColumns<3 * values, block_size> columns;
  for (std::size_t m = 0; m < block_size; m += lane_count) {
    Lanes w;
    load(w, t + m);
    w = (w - from) * inverse;
    const Lanes rest = 1 - w;
    for (std::size_t order = 0; order < values; ++order) {
      Lanes power = w, x{}, y{}, z{};
      if (order < width) {
        const Coefficient* q = coefficients(piece, order);
        x += q->x;
        y += q->y;
        z += q->z;
        for (std::size_t k = 1; k + order < width; ++k) {
          ++q;
          x = rest * x + power * q->x;
          y = rest * y + power * q->y;
          z = rest * z + power * q->z;
          power *= w;
        }
      }
      store(x, columns.at(3 * order, m));
      store(y, columns.at(3 * order + 1, m));
      store(z, columns.at(3 * order + 2, m));
    }
  }
  columns.hand_over(out);
}

template <int fixed_degree, std::size_t values>
void SplinePieces::evaluate_alone(double t, double* out) const {
  const std::size_t width = degree_or_fixed<fixed_degree>(degree()) + 1;
  const double inside = t >= knots_.start() && t < knots_.end() ? t : knots_.reduced(t);
  const std::size_t piece = piece_at(inside);
  const double w = (inside - breaks_[piece]) * inverse_widths_[piece], rest = 1 - w;
  for (std::size_t order = 0; order < values; ++order, out += 3) {
    double x = 0, y = 0, z = 0;
    if (order < width) {
      const Coefficient* q = coefficients(piece, order);
      x = q->x;
      y = q->y;
      z = q->z;
      double power = w;
      for (std::size_t k = 1; k + order < width; ++k) {
        ++q;
        x = rest * x + power * q->x;
        y = rest * y + power * q->y;
        z = rest * z + power * q->z;
        power *= w;
      }
    }
    out[0] = x;
    out[1] = y;
    out[2] = z;
  }
}

template <int fixed_degree, std::size_t values>
void SplinePieces::evaluate_all(std::span<const double> t, double* out) const {
  const double start = knots_.start(), end = knots_.end();
  std::size_t m = 0, piece = 0;
  for (; m + block_size <= t.size(); m += block_size, out += 3 * values * block_size) {
    const auto [least, most] = least_and_most(&t[m]);
    if (least >= start && most < end) {
      if (!(breaks_[piece] <= least && least < breaks_[piece + 1])) piece = piece_at(least);
      if (most < breaks_[piece + 1]) {
        evaluate_together<fixed_degree, values>(piece, &t[m], out);
        continue;
      }
    }
    for (std::size_t k = 0; k < block_size; ++k) evaluate_alone<fixed_degree, values>(t[m + k], out + 3 * values * k);
  }
  for (; m < t.size(); ++m, out += 3 * values) evaluate_alone<fixed_degree, values>(t[m], out);
}

Eigen::Vector3d SplinePieces::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate({&t, 1}, 0, {&point, 1});
  return point;
}

void SplinePieces::evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const {
  assert(order >= 0 && order <= max_order);
  assert(out.size() == t.size() * (static_cast<std::size_t>(order) + 1));
  if (out.empty()) return;
  double* const to = out.front().data();
  const auto evaluate_values = [&]<std::size_t count>(std::integral_constant<std::size_t, count>) {
    // The usual degrees with loops of a length that the compiler knows.
    switch (degree()) {
      case 1:
        return evaluate_all<1, count>(t, to);
      case 2:
        return evaluate_all<2, count>(t, to);
      case 3:
        return evaluate_all<3, count>(t, to);
      case 4:
        return evaluate_all<4, count>(t, to);
      case 5:
        return evaluate_all<5, count>(t, to);
      default:
        return evaluate_all<any_degree, count>(t, to);
    }
  };
  switch (order) {
    case 0:
      return evaluate_values(std::integral_constant<std::size_t, 1>());
    case 1:
      return evaluate_values(std::integral_constant<std::size_t, 2>());
    default:
      return evaluate_values(std::integral_constant<std::size_t, 3>());
  }
}

}  // namespace knotwork
