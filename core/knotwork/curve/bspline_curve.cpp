#include "knotwork/curve/bspline_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>

#include "knotwork/basis/bspline_basis.h"
#include "knotwork/curve/point_check.h"

namespace knotwork {
namespace {

constexpr int order_without_allocation = 3;
constexpr std::size_t most_values = (order_without_allocation + 1) * (KnotVector::max_degree + 1);

/// floor(a / b), b > 0.
int floor_divided(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// t_k and c_k for every integer k of a closed curve, for those in range of an open one.
struct Sequence {
  const KnotVector& knots;
  std::span<const Eigen::Vector3d> points;

  double knot(int k) const {
    if (!knots.closed()) return knots[k];
    const int round = floor_divided(k - knots.degree(), knots.count());
    return knots[k - round * knots.count()] + round * knots.period();
  }
  const Eigen::Vector3d& point(int k) const {
    return points[static_cast<std::size_t>(k - floor_divided(k, knots.count()) * knots.count())];
  }
};

}  // namespace

Result<BSplineCurve> BSplineCurve::make(KnotVector knots, std::vector<Eigen::Vector3d> points) {
  if (points.size() != static_cast<std::size_t>(knots.count())) {
    return Error{"points", "These knots belong to " + std::to_string(knots.count()) + " control points, not to " +
                               std::to_string(points.size()) + "."};
  }
  if (Status status = check_points(points); !status) return status.error();
  return BSplineCurve(std::move(knots), std::move(points));
}

BSplineCurve::BSplineCurve(KnotVector knots, std::vector<Eigen::Vector3d> points)
    : knots_(std::move(knots)), points_(std::move(points)) {}

Eigen::Vector3d BSplineCurve::operator()(double t) const {
  Eigen::Vector3d point;
  evaluate(t, {&point, 1});
  return point;
}

void BSplineCurve::evaluate(double t, std::span<Eigen::Vector3d> out) const {
  const double inside = knots_.reduced(t);
  evaluate_on(knots_.span(inside), inside, out);
}

void BSplineCurve::evaluate(std::span<const double> t, int order, std::span<Eigen::Vector3d> out) const {
  const std::size_t values = static_cast<std::size_t>(order) + 1;
  assert(out.size() == t.size() * values);
  int span = degree();
  for (std::size_t m = 0; m < t.size(); ++m) {
    const double inside = knots_.reduced(t[m]);
    span = knots_.span(inside, span);
    evaluate_on(span, inside, out.subspan(m * values, values));
  }
}

void BSplineCurve::evaluate_on(int span, double t, std::span<Eigen::Vector3d> out) const {
  if (out.empty()) return;
  const std::size_t width = static_cast<std::size_t>(degree()) + 1;
  std::array<double, most_values> few;
  std::vector<double> many;
  if (out.size() * width > few.size()) many.resize(out.size() * width);
  const std::span<double> basis = many.empty() ? std::span(few).first(out.size() * width) : std::span(many);
  bspline_basis(knots_, span, t, static_cast<int>(out.size()) - 1, basis);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].setZero();
    for (std::size_t j = 0; j < width; ++j)
      out[k] += basis[k * width + j] * point(span - degree() + static_cast<int>(j));
  }
}

PointTriangle BSplineCurve::de_boor(double t) const {
  const double inside = knots_.reduced(t);
  const int p = degree(), i = knots_.span(inside);
  std::vector<Eigen::Vector3d> points;
  for (int j = i - p; j <= i; ++j) points.push_back(point(j));
  return point_triangle(std::move(points), [&](int round, int row) {
    const int d = p - round;
    return translation_and_scaling(knots_, d, i - d + 1 + row, inside);
  });
}

Eigen::Vector3d BSplineCurve::blossom(int span, std::span<const double> arguments) const {
  const int derivative = degree() - static_cast<int>(arguments.size());
  assert(derivative >= 0 && knots_[span] < knots_[span + 1]);
  // Arguments that are the knots next to the span, going outwards, need no work: they are t_{left+1} .. t_{right-1}.
  std::array<double, KnotVector::max_degree> others{};
  int count = 0, left = span, right = span + 1;
  const auto take = [&](double argument, int& place, int step) {
    if (argument == knots_[place]) {
      place += step;
    } else {
      others[static_cast<std::size_t>(count++)] = argument;
    }
  };
  const auto middle = std::lower_bound(arguments.begin(), arguments.end(), knots_[right]);
  for (auto a = middle; a != arguments.begin(); --a) take(*(a - 1), left, -1);
  for (auto a = middle; a != arguments.end(); ++a) take(*a, right, 1);

  // De Boor's rounds for the others only: each replaces one of them, x, by the next knot on the left and on the right.
  // Before them the rounds of differences, over the widest intervals.
  const int rounds = count + derivative;
  std::array<Eigen::Vector3d, KnotVector::max_degree + 1> row;
  for (int k = 0; k <= rounds; ++k) row[static_cast<std::size_t>(k)] = point(left - k);
  for (int round = rounds; round > 0; --round) {
    for (int k = 0; k < round; ++k) {
      const double from = knots_[left - k], to = knots_[right + round - 1 - k];
      Eigen::Vector3d& here = row[static_cast<std::size_t>(k)];
      const Eigen::Vector3d& other = row[static_cast<std::size_t>(k) + 1];
      if (round > count) {
        here = (degree() - rounds + round) * (here - other) / (to - from);
      } else {
        const double x = others[static_cast<std::size_t>(round - 1)];
        here = ((to - x) * other + (x - from) * here) / (to - from);
      }
    }
  }
  return row[0];
}

std::vector<double> BSplineCurve::greville_abscissae() const {
  std::vector<double> abscissae;
  for (int i = 0; i < knots_.count(); ++i) {
    double sum = 0;
    for (int k = i + 1; k <= i + degree(); ++k) sum += knots_[k];
    abscissae.push_back(sum / degree());
  }
  return abscissae;
}

Result<BSplineCurve> BSplineCurve::with_knot(double t) const {
  if (!std::isfinite(t) || (!knots_.closed() && (t < knots_.start() || t > knots_.end()))) {
    return Error{"t", "A knot can be inserted within the curve's domain only."};
  }
  const int p = degree(), n = knots_.count();
  const double inside = knots_.reduced(t);
  const Sequence old{knots_, points_};
  // The new sequence u: u_s = t at s, and every n+1 places when closed. `before` counts the new knots in front of u_x.
  const int s = knots_.span(inside) + 1;
  const auto before = [&](int x) { return knots_.closed() ? -floor_divided(s - x, n + 1) : (x > s ? 1 : 0); };
  const auto is_new = [&](int x) { return before(x + 1) > before(x); };

  std::vector<double> knots;
  for (int x = 0; x < static_cast<int>(knots_.knots().size()) + 1; ++x) {
    knots.push_back(is_new(x) ? inside + before(x) * knots_.period() : old.knot(x - before(x)));
  }
  Result<KnotVector> refined = KnotVector::make(p, knots_.topology(), std::move(knots));
  if (!refined) return Error{"t", "There are as many knots here as the degree allows."};

  // Point j is the curve's blossom at u_{j+1} .. u_{j+p}. With no new knot among them it is an old point; with one (there
  // are never two), it lies between the two old points whose arguments contain the rest.
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j <= n; ++j) {
    int place = j + 1;
    while (place <= j + p && !is_new(place)) ++place;
    const int a = j - before(place);
    if (place > j + p) {
      points.push_back(old.point(a));
      continue;
    }
    const double from = old.knot(a), to = old.knot(a + p);
    const double knot = inside + before(place) * knots_.period();
    points.emplace_back(((to - knot) * old.point(a - 1) + (knot - from) * old.point(a)) / (to - from));
  }
  return make(refined.value(), std::move(points));
}

std::vector<BezierCurve> BSplineCurve::bezier_pieces() const {
  const int p = degree();
  std::vector<BezierCurve> pieces;
  std::vector<double> arguments(static_cast<std::size_t>(p));
  for (int i = p; i <= knots_.last_span(); ++i) {
    const double from = knots_[i], to = knots_[i + 1];
    if (!(from < to)) continue;
    std::fill(arguments.begin(), arguments.end(), from);
    std::vector<Eigen::Vector3d> points{pieces.empty() ? blossom(i, arguments) : pieces.back().points().back()};
    for (std::size_t k = arguments.size(); k > 0; --k) {
      arguments[k - 1] = to;
      const bool seam = k == 1 && knots_.closed() && to == knots_.end() && !pieces.empty();
      points.push_back(seam ? pieces.front().points().front() : blossom(i, arguments));
    }
    pieces.push_back(BezierCurve::make(std::move(points), from, to).value());
  }
  return pieces;
}

}  // namespace knotwork
