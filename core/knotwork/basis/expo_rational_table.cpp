#include "knotwork/basis/expo_rational_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// exp(-decay_limit) is the smallest phi that counts.
constexpr double decay_limit = 700;
/// Closer to an end than this nothing changes any more; keeps the powers of the distance finite.
constexpr double least_distance = 1e-60;

// Bounds on the cells. With a change of the exponent of at most 5 and singularities at least four cell widths away the
// ten-point Gauss-Legendre rule is exact to rounding.
constexpr double widest_cell = 1.0 / 32;
constexpr double steepest_cell = 5;
constexpr double narrowest_graded_cell = 1e-12;

struct Node {
  double x, weight;
};
/// Ten-point Gauss-Legendre rule on [-1,1], the positive half.
constexpr std::array<Node, 5> gauss_legendre{{
    {0.14887433898163121088, 0.29552422471475287017},
    {0.43339539412924719080, 0.26926671930999635509},
    {0.67940956829902440623, 0.21908636251598204399},
    {0.86506336668898451073, 0.14945134915058059314},
    {0.97390652851717172007, 0.06667134430868813759},
}};

bool is_default(const ExpoRationalParameters& p) {
  return p.alpha == 1 && p.beta == 1 && p.gamma == 1 && p.lambda == 0.5;
}

}  // namespace

ExpoRationalTable::ExpoRationalTable(const ExpoRationalParameters& parameters)
    : parameters_(parameters),
      default_(is_default(parameters)),
      left_(make_side(true)),
      right_(make_side(false)),
      scale_(1 / (left_.integral.back() + right_.integral.back())) {}

ExpoRationalTable::Place ExpoRationalTable::place(bool left, double distance_from_end) const {
  const double near = std::max(distance_from_end, least_distance), far = std::max(1 - near, least_distance);
  return left ? Place{near, far, near - parameters_.lambda} : Place{far, near, (1 - parameters_.lambda) - near};
}

double ExpoRationalTable::decay(const Place& p) const {
  if (default_) {
    const double q = p.s * p.r;
    return q * decay_limit > p.x * p.x ? p.x * p.x / q : infinity;
  }
  if (p.x == 0) return 0;
  const auto& [alpha, beta, gamma, lambda] = parameters_;
  const double logarithm = std::log(beta) + alpha * (1 + gamma) * std::log(std::abs(p.x)) - alpha * std::log(p.s) -
                           alpha * gamma * std::log(p.r);
  return logarithm < std::log(decay_limit) ? std::exp(logarithm) : infinity;
}

ExpoRationalTable::Density ExpoRationalTable::density(const Place& p) const {
  const double m = decay(p);
  if (m == infinity) return {0, 0, 0};
  const double phi = std::exp(-m);
  if (default_) {
    const double q = p.s * p.r;
    return {phi, -p.x / (2 * q * q), -(1 + 4 * p.x * p.x / q) / (2 * q * q)};
  }
  const auto& [alpha, beta, gamma, lambda] = parameters_;
  const double a = alpha * (1 + gamma);
  if (std::abs(p.x) < least_distance) {
    // Only the term beta a (a-1) |x|^(a-2) / (s (1-s)^gamma)^alpha can be left at lambda, and only for a = 2.
    return {phi, 0, a == 2 ? -2 * beta / std::pow(p.s * std::pow(p.r, gamma), alpha) : 0.0};
  }
  const double l = a / p.x - alpha / p.s + alpha * gamma / p.r;
  const double l1 = -a / (p.x * p.x) + alpha / (p.s * p.s) + alpha * gamma / (p.r * p.r);
  return {phi, -m * l, -m * (l * l + l1)};
}

double ExpoRationalTable::quadrature(bool left, double a, double b) const {
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0;
  for (const Node& node : gauss_legendre) {
    sum += node.weight * (std::exp(-decay(place(left, middle - half * node.x))) +
                          std::exp(-decay(place(left, middle + half * node.x))));
  }
  return half * sum;
}

ExpoRationalTable::Side ExpoRationalTable::make_side(bool left) const {
  const double mode = left ? parameters_.lambda : 1 - parameters_.lambda;
  const double a = parameters_.alpha * (1 + parameters_.gamma);
  const bool smooth_at_mode = std::fmod(a, 2.0) == 0;

  Side side{left, {mode}, {}};
  double width = widest_cell;
  double decay_above = 0;
  for (double y = mode; y > least_distance;) {
    width = std::min({2 * width, widest_cell, y / 5, std::max((1 - y) / 4, narrowest_graded_cell)});
    if (!smooth_at_mode) width = std::min(width, std::max((mode - y) / 4, narrowest_graded_cell));
    const auto too_steep = [&] {
      const Place below = place(left, y - width);
      const double m = decay(below);
      if (m == infinity) return true;
      return m - decay_above > steepest_cell || std::abs(density(below).h) * width > steepest_cell;
    };
    while (too_steep() && width > 1e-15 * y) width /= 2;
    const double lower = y - width, decay_lower = decay(place(left, lower));
    if (decay_lower == infinity || !(lower < y)) break;
    side.edge.push_back(lower);
    decay_above = decay_lower;
    y = lower;
  }
  std::reverse(side.edge.begin(), side.edge.end());

  side.integral.reserve(side.edge.size());
  side.integral.push_back(0);
  for (std::size_t k = 1; k < side.edge.size(); ++k) {
    side.integral.push_back(side.integral.back() + quadrature(left, side.edge[k - 1], side.edge[k]));
  }
  return side;
}

double ExpoRationalTable::from_end(const Side& side, double distance) const {
  if (distance <= side.edge.front()) return 0;
  if (distance >= side.edge.back()) return side.integral.back();
  const auto above = std::upper_bound(side.edge.begin(), side.edge.end(), distance);
  const auto k = static_cast<std::size_t>(above - side.edge.begin()) - 1;
  return side.integral[k] + quadrature(side.left, side.edge[k], distance);
}

BlendingValue ExpoRationalTable::operator()(double t) const {
  const bool left = t <= parameters_.lambda;
  const double distance = left ? t : 1 - t;
  // Ever so slowly for small alpha and gamma, but phi is 0 at an end with all its derivatives unless lambda is there.
  if (distance == 0 && t != parameters_.lambda) return {left ? 0.0 : 1.0, 0, 0, 0};
  const double part = scale_ * from_end(left ? left_ : right_, distance);
  const Density d = density(place(left, distance));
  const double b1 = scale_ * d.phi;
  return {left ? part : 1 - part, b1, b1 * d.h, b1 * (d.h * d.h + d.h1)};
}

}  // namespace knotwork
