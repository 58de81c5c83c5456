#include "knotwork/curve/spline_pieces.h"

#include <algorithm>
#include <cassert>

namespace knotwork {

namespace {

/// Points of one piece that are evaluated together.
using Block = Eigen::Array4d;

/// Value m goes to out[m stride].
void store(double x, double y, double z, std::size_t, Eigen::Vector3d* out) { *out = {x, y, z}; }
void store(const Block& x, const Block& y, const Block& z, std::size_t stride, Eigen::Vector3d* out) {
  for (Eigen::Index m = 0; m < x.size(); ++m, out += stride) *out = {x[m], y[m], z[m]};
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
        coefficients_[static_cast<std::size_t>(order)].emplace_back(binomial * curve.blossom(span, ends));
        binomial = binomial * (top - k) / (k + 1);
      }
    }
  }
  breaks_.push_back(knots_.end());

  breaks_before_.assign(breaks_.size() + 1, 0);
  for (std::size_t k = 1; k + 1 < breaks_.size(); ++k) ++breaks_before_[bucket_of(breaks_[k]) + 1];
  for (std::size_t b = 1; b < breaks_before_.size(); ++b) breaks_before_[b] += breaks_before_[b - 1];
}

/// Does not decrease with t: breaks in buckets before t's lie before t, those in buckets behind it behind t. The first
/// bucket is half as wide as the others, so that equidistant breaks lie in the middle of theirs, and not at the ends by
/// chance.
std::size_t SplinePieces::bucket_of(double t) const {
  constexpr double half_a_bucket = 0.5;
  const double share = (t - knots_.start()) / knots_.period();
  return static_cast<std::size_t>(share * static_cast<double>(piece_count()) + half_a_bucket);
}

std::size_t SplinePieces::piece_at(double t) const {
  const std::size_t bucket = bucket_of(t);
  const std::ptrdiff_t before = breaks_before_[bucket], inside = breaks_before_[bucket + 1] - before;
  // One break in a bucket is the rule: no search.
  const auto first = breaks_.begin() + 1 + before;
  if (inside == 1) return static_cast<std::size_t>(before + (t >= *first ? 1 : 0));
  return static_cast<std::size_t>(std::upper_bound(first, first + inside, t) - breaks_.begin()) - 1;
}

template <class Lanes>
void SplinePieces::evaluate_in(std::size_t piece, const Lanes& t, std::size_t values, Eigen::Vector3d* out) const {
  const Lanes w = (t - breaks_[piece]) * inverse_widths_[piece], rest = 1 - w, zero = w * 0;
  const std::size_t width = static_cast<std::size_t>(degree()) + 1;
  for (std::size_t order = 0; order < values; ++order) {
    if (order >= width) {
      store(zero, zero, zero, values, out + order);
      continue;
    }
    const Eigen::Vector3d* q = coefficients_[order].data() + piece * (width - order);
    Lanes power = w, x = zero + q[0].x(), y = zero + q[0].y(), z = zero + q[0].z();
    for (std::size_t k = 1; k < width - order; ++k) {
      x = rest * x + power * q[k].x();
      y = rest * y + power * q[k].y();
      z = rest * z + power * q[k].z();
      power *= w;
    }
    store(x, y, z, values, out + order);
  }
}

Eigen::Vector3d SplinePieces::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate({&t, 1}, 0, {&point, 1});
  return point;
}

void SplinePieces::evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const {
  assert(order >= 0 && order <= max_order);
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  assert(out.size() == t.size() * values);
  constexpr std::size_t block_size = Block::SizeAtCompileTime;
  std::size_t piece = 0;
  // One comparison: for shuffled parameters each end alone is a coin toss, which a processor predicts badly. The piece's
  // start is left to the search.
  const auto in_piece = [&](double least, double most) {
    return std::min(least - breaks_[piece], breaks_[piece + 1] - most) > 0;
  };
  for (std::size_t m = 0; m < t.size();) {
    const bool reduced = t[m] >= knots_.start() && t[m] < knots_.end();
    const double inside = reduced ? t[m] : knots_.reduced(t[m]);
    if (!in_piece(inside, inside)) piece = piece_at(inside);
    const std::size_t first = m;
    for (; m + block_size <= t.size(); m += block_size) {
      const Block block = Eigen::Map<const Block>(&t[m]);
      if (!in_piece(block.minCoeff(), block.maxCoeff())) break;
      evaluate_in(piece, block, values, &out[m * values]);
    }
    if (m > first) continue;
    evaluate_in(piece, inside, values, &out[m * values]);
    ++m;
  }
}

}  // namespace knotwork
