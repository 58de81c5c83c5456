#include "knotwork/curve/bspline_refinement.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>

#include "knotwork/basis/bspline_basis.h"

namespace knotwork {
namespace {

/// The knots of one period in [start, end), of which a closed vector stores as many as it has points.
std::vector<double> one_period(const KnotVector& knots) {
  std::vector<double> period;
  for (int i = knots.degree(); i <= knots.last_span(); ++i) {
    period.push_back(knots[i] < knots.end() ? knots[i] : knots.start());
  }
  std::sort(period.begin(), period.end());
  return period;
}

/// The knots strictly inside the domain.
std::vector<double> inner_knots(const KnotVector& knots) {
  std::vector<double> inner;
  for (const double t : knots.knots()) {
    if (t > knots.start() && t < knots.end()) inner.push_back(t);
  }
  return inner;
}

/// The closed knot vector that repeats `period`; its first knot is the start, t_p the last copy of it.
Result<KnotVector> closed_knots(int degree, const std::vector<double>& period, double end) {
  const double start = period.front(), length = end - start;
  const int n = static_cast<int>(period.size());
  const int copies = static_cast<int>(std::count(period.begin(), period.end(), start));
  std::vector<double> knots;
  for (int k = 0; k <= n + 2 * degree; ++k) {
    // From a multiple of n so large that the remainder is not negative.
    const int place = k - degree + copies - 1 + n * degree;
    const int round = place / n - degree;
    const double t = period[static_cast<std::size_t>(place % n)];
    knots.push_back(round == 1 && t == start ? end : t + round * length);
  }
  return KnotVector::make(degree, Topology::closed, std::move(knots));
}

/// Each knot with one more copy of its value.
std::vector<double> repeated_once_more(std::span<const double> knots) {
  std::vector<double> out;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    out.push_back(knots[i]);
    if (i + 1 == knots.size() || knots[i] < knots[i + 1]) out.push_back(knots[i]);
  }
  return out;
}

/// The knots of the curve of the next degree. The domain stays, and no knots beyond those that its splines need.
Result<KnotVector> elevated_knots(const KnotVector& knots) {
  const int degree = knots.degree() + 1;
  if (knots.closed()) return closed_knots(degree, repeated_once_more(one_period(knots)), knots.end());
  const std::vector<double> all = repeated_once_more(knots.knots());
  const auto first_inside = std::upper_bound(all.begin(), all.end(), knots.start());
  const auto first_end = std::lower_bound(all.begin(), all.end(), knots.end());
  return KnotVector::make(degree, Topology::open,
                          std::vector<double>(first_inside - degree - 1, first_end + degree + 1));
}

/// The points that belong to other knots u for the same domain: point j is point_at(span, u_{j+1} .. u_{j+degree}),
/// with that span of the old curve which holds the widest interval of u where point j counts.
template <class PointAt>
Result<BSplineCurve> on_knots(const BSplineCurve& curve, const Result<KnotVector>& knots, const PointAt& point_at) {
  if (!knots) return knots.error();
  const KnotVector& u = knots.value();
  const int degree = u.degree();
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j < u.count(); ++j) {
    int widest = std::max(j, degree);
    for (int i = widest + 1; i <= std::min(j + degree, u.last_span()); ++i) {
      if (u[i + 1] - u[i] > u[widest + 1] - u[widest]) widest = i;
    }
    const double middle = u[widest] + (u[widest + 1] - u[widest]) / 2;
    const std::span<const double> arguments = u.knots().subspan(static_cast<std::size_t>(j) + 1);
    points.push_back(point_at(curve.knots().span(middle), arguments.first(static_cast<std::size_t>(degree))));
  }
  return BSplineCurve::make(u, std::move(points));
}

/// The same degree on other knots.
Result<BSplineCurve> on_knots(const BSplineCurve& curve, const Result<KnotVector>& knots) {
  return on_knots(curve, knots,
                  [&](int span, std::span<const double> arguments) { return curve.blossom(span, arguments); });
}

/// The derivatives at one end of a span with the size of the terms that they are made of, seen from the point `origin`.
struct SideDerivatives {
  std::array<Eigen::Vector3d, KnotVector::max_degree + 1> value;
  std::array<double, KnotVector::max_degree + 1> size;
};

SideDerivatives side_derivatives(const BSplineCurve& curve, int span, double t, const Eigen::Vector3d& origin) {
  const int p = curve.degree();
  const std::size_t width = static_cast<std::size_t>(p) + 1;
  std::array<double, (KnotVector::max_degree + 1) * (KnotVector::max_degree + 1)> rows;
  const std::span<double> basis = std::span(rows).first(width * width);
  bspline_basis(curve.knots(), span, t, p, basis);
  SideDerivatives side;
  for (std::size_t k = 0; k < width; ++k) {
    side.value[k].setZero();
    side.size[k] = 0;
    for (std::size_t j = 0; j < width; ++j) {
      const Eigen::Vector3d arm = curve.point(span - p + static_cast<int>(j)) - origin;
      side.value[k] += basis[k * width + j] * arm;
      side.size[k] += std::abs(basis[k * width + j]) * arm.norm();
    }
  }
  return side;
}

/// How many derivatives, from the 0th on, agree between the end of one span and the start of another.
int agreeing_derivatives(const BSplineCurve& curve, int before, int after) {
  const KnotVector& knots = curve.knots();
  const Eigen::Vector3d& origin = curve.point(after);
  const SideDerivatives left = side_derivatives(curve, before, knots[before + 1], origin);
  const SideDerivatives right = side_derivatives(curve, after, knots[after], origin);
  for (int k = 0; k <= knots.degree(); ++k) {
    const std::size_t at = static_cast<std::size_t>(k);
    const double size = std::max(left.size[at], right.size[at]);
    if ((left.value[at] - right.value[at]).norm() > smoothness_tolerance * size) return k;
  }
  return knots.degree() + 1;
}

/// The last span before the end of the domain.
int final_span(const KnotVector& knots) {
  int span = knots.last_span();
  while (!(knots[span] < knots[span + 1])) --span;
  return span;
}

}  // namespace

Result<KnotRemoval> without_knot(const BSplineCurve& curve, double t) {
  const KnotVector& old = curve.knots();
  const int p = old.degree(), n = old.count();
  const bool closed = old.closed();
  if (!std::isfinite(t) || (!closed && (t <= old.start() || t >= old.end())) || old.multiplicity(t) == 0) {
    return Error{"t", "There is no knot here inside the curve's domain."};
  }
  if (closed && n - 1 < std::max(2, p)) return Error{"t", "The closed curve has no point to spare."};

  // c_j for j = r-p .. r-1 lies between the new points d_{j-1} and d_j, a_j of the way; a_j does not increase with j.
  // All other points stay: d_j = c_j before them, d_{j-1} = c_j behind.
  const double x = old.reduced(t);
  const int r = old.span(x);
  const auto share = [&](int j) { return (x - old[j]) / (old[j + p + 1] - old[j]); };
  // Solved forwards a division is by a_j, backwards by 1-a_j: each as long as that is 1/2 or more. The equation left
  // over is one of the two where they meet.
  int unmet = r - p;
  while (unmet < r - 1 && share(unmet) >= 0.5) ++unmet;
  if (unmet > r - p && share(unmet - 1) - 0.5 < std::abs(0.5 - share(unmet))) --unmet;
  // d_{r-p-1} .. d_{r-1}, the two outer ones known.
  std::vector<Eigen::Vector3d> solved(static_cast<std::size_t>(p) + 1);
  const auto d = [&](int j) -> Eigen::Vector3d& { return solved[static_cast<std::size_t>(j - (r - p - 1))]; };
  d(r - p - 1) = curve.point(r - p - 1 + n);
  d(r - 1) = curve.point(r);
  for (int j = r - p; j < unmet; ++j) d(j) = (curve.point(j) - (1 - share(j)) * d(j - 1)) / share(j);
  for (int j = r - 1; j > unmet; --j) d(j - 1) = (curve.point(j) - share(j) * d(j)) / (1 - share(j));
  const double a = share(unmet);
  const double deviation = (curve.point(unmet) - ((1 - a) * d(unmet - 1) + a * d(unmet))).norm();

  std::vector<Eigen::Vector3d> points;
  const auto removal = [&](const Result<KnotVector>& knots) -> Result<KnotRemoval> {
    if (!knots) return Error{"t", "Without this knot the others are too close together."};
    Result<BSplineCurve> made = BSplineCurve::make(knots.value(), std::move(points));
    if (!made) return made.error();
    return KnotRemoval{std::move(made).value(), deviation};
  };
  if (!closed) {
    for (int j = 0; j < n - 1; ++j) {
      points.push_back(j < r - p ? curve.point(j) : j < r - 1 ? d(j) : curve.point(j + 1));
    }
    std::vector<double> knots(old.knots().begin(), old.knots().end());
    knots.erase(knots.begin() + r);
    return removal(KnotVector::make(p, Topology::open, std::move(knots)));
  }
  std::vector<double> period = one_period(old);
  period.erase(std::find(period.begin(), period.end(), x));
  const double start = period.front();
  // The new vector begins p places before the last copy of its start, which stood at `first + p` without the knot r.
  const int last_copy = old.span(start), first = (last_copy < r ? last_copy : last_copy - 1) - p;
  for (int k = 0; k < n - 1; ++k) {
    // As a place in d_{r-p}, d_{r-p+1}, .., d_{r-p+n-2}, after which they repeat.
    const int place = (k + first - (r - p) + 2 * (n - 1)) % (n - 1);
    points.push_back(place < p - 1 ? d(r - p + place) : curve.point(r - p + place + 1));
  }
  return removal(closed_knots(p, period, start > old.start() ? start + old.period() : old.end()));
}

Result<BSplineCurve> elevated(const BSplineCurve& curve) {
  if (curve.degree() == KnotVector::max_degree) {
    return Error{"degree", "The degree may be at most " + std::to_string(KnotVector::max_degree) + "."};
  }
  return on_knots(curve, elevated_knots(curve.knots()), [&](int span, std::span<const double> arguments) {
    std::array<double, KnotVector::max_degree> others{};
    std::copy(arguments.begin() + 1, arguments.end(), others.begin());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t left_out = 0; left_out < arguments.size(); ++left_out) {
      if (left_out > 0) others[left_out - 1] = arguments[left_out - 1];
      sum += curve.blossom(span, std::span(others).first(arguments.size() - 1));
    }
    return Eigen::Vector3d(sum / static_cast<double>(arguments.size()));
  });
}

std::vector<KnotContinuity> continuity(const BSplineCurve& curve) {
  const KnotVector& knots = curve.knots();
  const int p = knots.degree(), last = final_span(knots);
  std::vector<KnotContinuity> list;
  int before = knots.closed() ? last : -1;
  for (int i = p; i <= last; ++i) {
    if (!(knots[i] < knots[i + 1])) continue;
    if (before >= 0) {
      const int multiplicity = knots.multiplicity(knots[i]);
      list.push_back({knots[i], multiplicity, p - multiplicity, agreeing_derivatives(curve, before, i) - 1});
    }
    before = i;
  }
  return list;
}

Result<BSplineCurve> clamped(const BSplineCurve& curve) {
  const KnotVector& old = curve.knots();
  const std::size_t ends = static_cast<std::size_t>(old.degree()) + 1;
  std::vector<double> knots = inner_knots(old);
  knots.insert(knots.begin(), ends, old.start());
  knots.insert(knots.end(), ends, old.end());
  return on_knots(curve, KnotVector::make(old.degree(), Topology::open, std::move(knots)));
}

Result<BSplineCurve> unclamped(const BSplineCurve& curve) {
  const KnotVector& old = curve.knots();
  const int p = old.degree();
  if (old.closed()) {
    std::vector<Eigen::Vector3d> points(curve.points().begin(), curve.points().end());
    for (int i = 0; i < p; ++i) points.push_back(curve.point(old.count() + i));
    const Result<KnotVector> knots =
        KnotVector::make(p, Topology::open, std::vector<double>(old.knots().begin(), old.knots().end()));
    return knots ? BSplineCurve::make(knots.value(), std::move(points)) : Result<BSplineCurve>(knots.error());
  }
  const int first = old.span(old.start()), last = final_span(old);
  std::vector<double> knots;
  for (int k = p; k >= 0; --k) knots.push_back(old.start() - k * (old[first + 1] - old[first]));
  const std::vector<double> inner = inner_knots(old);
  knots.insert(knots.end(), inner.begin(), inner.end());
  for (int k = 0; k <= p; ++k) knots.push_back(old.end() + k * (old[last + 1] - old[last]));
  return on_knots(curve, KnotVector::make(p, Topology::open, std::move(knots)));
}

Result<BSplineCurve> closed(const BSplineCurve& curve, int seam_multiplicity) {
  if (curve.knots().closed()) return curve;
  const int p = curve.degree();
  if (seam_multiplicity < 1 || seam_multiplicity > p) {
    return Error{"seam_multiplicity", "The multiplicity of the start must lie between 1 and the degree."};
  }
  const Result<BSplineCurve> open = clamped(curve);
  if (!open) return open.error();
  const KnotVector& knots = open.value().knots();
  const int agreeing = agreeing_derivatives(open.value(), final_span(knots), knots.span(knots.start()));
  if (agreeing == 0) return Error{"points", "The curve's ends are not at the same place."};
  if (agreeing <= p - seam_multiplicity) {
    return Error{"points", "At the curve's ends the derivatives of order " + std::to_string(agreeing) + " differ."};
  }
  const int count = knots.count() - 1 - (p - seam_multiplicity), least = std::max(2, p);
  if (count < least) {
    return Error{"count", "The closed curve would have " + std::to_string(count) + " control points; it needs " +
                              std::to_string(least) + ". Insert knots first."};
  }
  // A start of multiplicity p asks for no smoothness: its points are those of the clamped curve. The copies that are
  // too many are then removable knots.
  std::vector<double> period = inner_knots(knots);
  period.insert(period.begin(), static_cast<std::size_t>(p), knots.start());
  const Result<KnotVector> around = closed_knots(p, period, knots.end());
  if (!around) return around.error();
  const std::span<const Eigen::Vector3d> points = open.value().points();
  Result<BSplineCurve> result = BSplineCurve::make(around.value(), {points.begin(), points.end() - 1});
  for (int copies = p; result && copies > seam_multiplicity; --copies) {
    const Result<KnotRemoval> removal = without_knot(result.value(), knots.start());
    if (!removal) return removal.error();
    result = removal.value().curve;
  }
  return result;
}

}  // namespace knotwork
