#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "knotwork/curve/lane_riesenfeld.h"
#include "knotwork/curve/least_squares.h"
#include "knotwork/curve/parameterization.h"
#include "property/generators.h"

namespace knotwork::fit_properties {
using namespace test;
namespace {

LaneRiesenfeld drawn_scheme() {
  return {.degree = *rc::gen::inRange(1, LaneRiesenfeld::max_degree + 1),
          .topology = *rc::gen::element(Topology::open, Topology::closed)};
}

/// As many points as the scheme needs, and up to 7 more.
std::vector<Eigen::Vector3d> drawn_polygon(const LaneRiesenfeld& scheme) {
  const int least = scheme.topology == Topology::closed ? 1 : scheme.degree + 1;
  return *points(static_cast<std::size_t>(least + *rc::gen::inRange(0, 8)));
}

double largest(const std::vector<Eigen::Vector3d>& list) {
  double most = 0;
  for (const Eigen::Vector3d& point : list) most = std::max(most, point.norm());
  return most;
}

double binomial(int n, int k) {
  double value = k < 0 || k > n ? 0 : 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace

TEST_CASE("least squares: data on a spline of the space bring that spline back") {
  CHECK(rc::check([] {
    // Unclamped, the domain may be a tiny part of the supports, which the data on it then cannot tell apart.
    const BSplineCurve curve = drawn_curve({.ends = {Ends::clamped, Ends::closed}});
    const KnotVector& knots = curve.knots();
    // p+1 parameters in each interval, spread to its ends as Chebyshev's, determine each piece for itself.
    std::vector<double> parameters;
    std::vector<Eigen::Vector3d> data;
    const int p = knots.degree();
    for (const int i : spans(knots)) {
      for (int k = 0; k <= p; ++k) {
        const double share = 0.5 - 0.5 * std::cos((2 * k + 1) * 3.141592653589793 / (2 * p + 2));
        parameters.push_back(std::lerp(knots[i], knots[i + 1], share));
        data.push_back(curve(parameters.back()));
      }
    }
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, data, parameters);
    holds(fit.has_value());
    const double size = polygon_size(curve) + 1e-300;
    holds(fit.value().maximum <= 1e-12 * size);
    holds(fit.value().rms <= fit.value().maximum);
    for (int k = 0; k < 4; ++k) {
      const double t = drawn_parameter(knots);
      expect(close(fit.value().curve(t), curve(t), 1e-11, size), "between the data");
    }
  }));
}

TEST_CASE("least squares: no other control points are nearer to the data") {
  CHECK(rc::check([] {
    const KnotVector knots = *knot_vectors({.most_degree = 5, .most_exponent = 8, .most_intervals = 5});
    std::vector<double> parameters;
    for (const int i : spans(knots)) {
      for (int k = 0; k <= knots.degree() + 1; ++k)
        parameters.push_back(std::lerp(knots[i], knots[i + 1], (k + 0.5) / (knots.degree() + 2)));
    }
    const std::vector<Eigen::Vector3d> data = *points(parameters.size());
    const LeastSquaresFit fit = fit_least_squares(knots, data, parameters).value();
    std::vector<Eigen::Vector3d> other(fit.curve.points().begin(), fit.curve.points().end());
    other[*rc::gen::inRange<std::size_t>(0, other.size())] += drawn_point() / 64;
    const BSplineCurve moved = BSplineCurve::make(knots, other).value();
    double sum = 0;
    for (std::size_t j = 0; j < data.size(); ++j) sum += (moved(parameters[j]) - data[j]).squaredNorm();
    const double rms = std::sqrt(sum / static_cast<double>(data.size()));
    holds(fit.rms <= rms * (1 + 1e-13) + 1e-13 * largest(data));
  }));
}

TEST_CASE("parameters increase with the points, and their averaged knots carry a curve through them") {
  CHECK(rc::check([] {
    const Topology topology = *rc::gen::element(Topology::open, Topology::closed);
    const int degree = *rc::gen::inRange(1, 6), count = degree + *rc::gen::inRange(2, 9);
    std::vector<Eigen::Vector3d> data = *points(static_cast<std::size_t>(count));
    for (int j = 0; j < count; ++j) data[static_cast<std::size_t>(j)].z() += 2000.0 * j;  // no two in one place
    const double exponent = *rc::gen::element(0.0, 0.5, 1.0);
    const std::vector<double> x = parameterize(data, exponent, topology, 0, 1).value();
    holds(std::is_sorted(x.begin(), x.end()));
    const KnotVector knots = averaged_knots(degree, count, topology, x, 1).value();
    const Result<LeastSquaresFit> fit = fit_least_squares(knots, data, x);
    holds(fit.has_value());
    holds(fit.value().maximum <= 1e-9 * largest(data));
  }));
}

TEST_CASE("Lane-Riesenfeld: a level is a split and d averages, bit for bit, and the mask C(d+1, 2i+1-j) / 2^d") {
  CHECK(rc::check([] {
    const LaneRiesenfeld scheme = drawn_scheme();
    const std::vector<Eigen::Vector3d> polygon = drawn_polygon(scheme);
    const int n = static_cast<int>(polygon.size());
    const std::vector<Eigen::Vector3d> level = subdivide(scheme, polygon, 1).value();
    std::vector<Eigen::Vector3d> step = split_points(polygon);
    for (int pass = 0; pass < scheme.degree; ++pass) step = averaged_points(step, scheme.topology);
    holds(level == step);
    holds(level.size() == subdivided_count(scheme, polygon.size(), 1));
    for (int j = 0; j < static_cast<int>(level.size()); ++j) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int i = 0; 2 * i + 1 - j <= scheme.degree + 1; ++i)
        sum += binomial(scheme.degree + 1, 2 * i + 1 - j) * polygon[static_cast<std::size_t>(i % n)];
      expect(close(level[static_cast<std::size_t>(j)], sum / std::exp2(scheme.degree), 1e-14, largest(polygon)),
             "mask");
    }
  }));
}

TEST_CASE("Lane-Riesenfeld: every level has the same limit, and its points are those of the limit on halved knots") {
  CHECK(rc::check([] {
    const LaneRiesenfeld scheme = drawn_scheme();
    const std::vector<Eigen::Vector3d> polygon = drawn_polygon(scheme);
    const int levels = *rc::gen::inRange(1, 4), d = scheme.degree;
    const BSplineCurve limit = limit_curve(scheme, polygon).value();
    const std::vector<Eigen::Vector3d> fine = subdivide(scheme, polygon, levels).value();
    const BSplineCurve same = limit_curve(scheme, fine).value();
    const double size = largest(polygon), t = drawn_parameter(limit.knots());
    expect(close(same(d + std::ldexp(t - d, levels)), limit(t), 1e-13, size), "limit");
    if (levels > 1 || limit.knots().count() != static_cast<int>(polygon.size())) return;
    // Halving all knots by insertion yields the points of the level: the unclamped ends of an open one lie outside.
    BSplineCurve halved = limit;
    const double start = limit.knots().start(), end = limit.knots().end();
    for (double knot = start + 0.5; knot < end; knot += 1) halved = halved.with_knot(knot).value();
    for (int k = 0; k < 4; ++k) {
      const double at = drawn_parameter(limit.knots());
      expect(close(halved(at), limit(at), 1e-13, size), "halved");
    }
    if (scheme.topology == Topology::open) return;
    // Both have the same knots, the half integers, so that their points are the same but for where they are counted from.
    double best = 1e300;
    const int n = halved.knots().count();
    for (int turn = 0; turn < n; ++turn) {
      double worst = 0;
      for (int j = 0; j < n; ++j)
        worst = std::max(worst, (halved.point(j + turn) - fine[static_cast<std::size_t>(j)]).norm());
      best = std::min(best, worst);
    }
    holds(best <= 1e-13 * size);
  }));
}

TEST_CASE("Lane-Riesenfeld: affine maps pass through, and for degree 1 the points stay") {
  CHECK(rc::check([] {
    const LaneRiesenfeld scheme = drawn_scheme();
    const std::vector<Eigen::Vector3d> polygon = drawn_polygon(scheme);
    const Eigen::Affine3d map = drawn_map();
    std::vector<Eigen::Vector3d> mapped;
    mapped.reserve(polygon.size());
    for (const Eigen::Vector3d& point : polygon) mapped.emplace_back(map * point);
    const auto fine = subdivide(scheme, polygon, 2).value(), other = subdivide(scheme, mapped, 2).value();
    const double size = map.linear().norm() * largest(polygon) + map.translation().norm();
    for (std::size_t j = 0; j < fine.size(); ++j)
      expect(close(other[j], Eigen::Vector3d(map * fine[j]), 1e-14, size), "point");
    if (scheme.degree > 1) return;
    for (std::size_t i = 0; i < polygon.size(); ++i) holds(fine[4 * i] == polygon[i]);
  }));
}

}  // namespace knotwork::fit_properties
