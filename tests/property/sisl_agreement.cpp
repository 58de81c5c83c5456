// Agreement with SISL, SINTEF's spline library, on what RapidCheck draws. Compiled where SISL is on the system.
//
// For SISL, parameters nearer than 1e-12 of their size, or of 1, are the same; so the intervals here are of moderate
// width, and those from 1e-9 to 1e9 in one vector are for the laws. SISL works with the same doubles and adds up the same
// terms in another order: 1e-13 of these terms for each round of the recursion is what two right answers may differ by.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <sisl.h>

#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/bspline_refinement.h"
#include "knotwork/curve/closest_point.h"
#include "property/generators.h"
#include "unit/float_traps.h"

namespace knotwork::sisl_agreement {
using namespace test;
namespace {

struct Free {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
  void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
using CurvePointer = std::unique_ptr<SISLCurve, Free>;
using SurfacePointer = std::unique_ptr<SISLSurf, Free>;

std::vector<double> numbers(std::span<const Eigen::Vector3d> points) {
  std::vector<double> list;
  for (const Eigen::Vector3d& point : points) list.insert(list.end(), {point.x(), point.y(), point.z()});
  return list;
}
Eigen::Vector3d vector(std::span<const double> list, std::size_t k) {
  return {list[3 * k], list[3 * k + 1], list[3 * k + 2]};
}

/// The same curve for SISL; a closed one as the open curve on its knots that goes round once.
CurvePointer sisl_curve(const BSplineCurve& curve) {
  const BSplineCurve open = curve.knots().closed() ? unclamped(curve).value() : curve;
  std::vector<double> knots(open.knots().knots().begin(), open.knots().knots().end());
  std::vector<double> points = numbers(open.points());
  constexpr int polynomial = 1, dimension = 3, copies = 1;
  return CurvePointer(
      newCurve(open.knots().count(), open.degree() + 1, knots.data(), points.data(), polynomial, dimension, copies));
}

constexpr int most_exponent = 4;
KnotWish moderate() { return {.most_exponent = most_exponent}; }

}  // namespace

TEST_CASE("SISL: points and all derivatives of curves, from the right (s1221) and from the left (s1227)") {
  CHECK(rc::check([] {
    const BSplineCurve curve = drawn_curve(moderate());
    const KnotVector& knots = curve.knots();
    const int p = curve.degree(), i = *rc::gen::elementOf(spans(knots));
    const double share = *rc::gen::inRange(0, 65) / 64.0, t = std::lerp(knots[i], knots[i + 1], share);
    const FloatTrapsOff sisl_divides_as_it_likes;
    const CurvePointer other = sisl_curve(curve);
    std::vector<double> found(3 * static_cast<std::size_t>(p + 1));
    int left = 0, status = 0;
    // At the right end of an interval, its own derivatives are those from the left.
    (share == 1 ? s1227 : s1221)(other.get(), p, t, &left, found.data(), &status);
    holds(status >= 0);
    std::vector<double> basis(static_cast<std::size_t>((p + 1) * (p + 1)));
    bspline_basis(knots, i, t, p, basis);
    for (int k = 0; k <= p; ++k) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double size = 0;
      for (int j = 0; j <= p; ++j) {
        const double value = basis[static_cast<std::size_t>(k * (p + 1) + j)];
        sum += value * curve.point(i - p + j);
        size += std::abs(value) * curve.point(i - p + j).norm();
      }
      expect(close(sum, vector(found, static_cast<std::size_t>(k)), 1e-13 * (p + 1), size), "derivative");
      if (share < 1) {
        std::vector<Eigen::Vector3d> here(static_cast<std::size_t>(p) + 1);
        curve.evaluate(t, here);
        expect(close(here.back(), vector(found, static_cast<std::size_t>(p)), 1e-13 * (p + 1),
                     derivative_size(curve, t, p)),
               "evaluate");
      }
    }
  }));
}

TEST_CASE("SISL: points and partials of surfaces (s1421, s1424)") {
  CHECK(rc::check([] {
    KnotWish wish = moderate();
    wish.most_intervals = 3;
    wish.ends = {Ends::clamped, Ends::unclamped};
    const KnotVector u = *knot_vectors(wish), v = *knot_vectors(wish);
    const int n = u.count(), m = v.count(), p = u.degree(), q = v.degree();
    const BSplineSurface surface =
        BSplineSurface::make(u, v, *points(static_cast<std::size_t>(n) * static_cast<std::size_t>(m))).value();
    const double a = drawn_inner_parameter(u), b = drawn_inner_parameter(v);
    // SISL's first parameter runs fastest in its list of points: it gets v, and then u.
    std::vector<double> knots_u(u.knots().begin(), u.knots().end()), knots_v(v.knots().begin(), v.knots().end());
    std::vector<double> list = numbers(surface.points());
    const FloatTrapsOff sisl_divides_as_it_likes;
    const SurfacePointer other(newSurf(m, n, q + 1, p + 1, knots_v.data(), knots_u.data(), list.data(), 1, 3, 1));
    double parameters[2] = {b, a}, normal[3];
    int left_v = 0, left_u = 0, status = 0;
    // s1421, with its derivatives of total order up to 2: S, S_v, S_u, S_vv, S_uv, S_uu.
    std::vector<double> found(18);
    s1421(other.get(), 2, parameters, &left_v, &left_u, found.data(), normal, &status);
    holds(status >= 0);
    const SurfaceJet jet = surface.evaluate(a, b);
    const Eigen::Vector3d parts[6] = {jet.s, jet.sv, jet.su, jet.svv, jet.suv, jet.suu};
    const int orders[6][2] = {{0, 0}, {0, 1}, {1, 0}, {0, 2}, {1, 1}, {2, 0}};
    double largest = 0;
    for (const Eigen::Vector3d& point : surface.points()) largest = std::max(largest, point.norm());
    const auto size = [&](int du, int dv) { return largest * basis_size(u, a, du) * basis_size(v, b, dv); };
    for (std::size_t k = 0; k < 6; ++k)
      expect(close(parts[k], vector(found, k), 1e-12, size(orders[k][0], orders[k][1])), "s1421");
    // s1424: all partials up to an order in each direction, v the faster.
    const int order_u = std::min(p, 3), order_v = std::min(q, 3);
    const std::size_t count = static_cast<std::size_t>((order_u + 1) * (order_v + 1));
    std::vector<double> more(3 * count);
    s1424(other.get(), order_v, order_u, parameters, &left_v, &left_u, more.data(), &status);
    holds(status >= 0);
    std::vector<Eigen::Vector3d> partials(count);
    surface.evaluate(a, b, order_u, order_v, partials);
    for (int du = 0; du <= order_u; ++du) {
      for (int dv = 0; dv <= order_v; ++dv) {
        const std::size_t k = static_cast<std::size_t>(du * (order_v + 1) + dv);
        expect(close(partials[k], vector(more, k), 1e-12, size(du, dv)), "s1424");
      }
    }
  }));
}

TEST_CASE("SISL: knot insertion (s1018) gives the same points") {
  CHECK(rc::check([] {
    KnotWish wish = moderate();
    wish.ends = {Ends::clamped};
    const BSplineCurve curve = drawn_curve(wish);
    std::vector<double> places{drawn_inner_parameter(curve.knots()), drawn_inner_parameter(curve.knots())};
    std::sort(places.begin(), places.end());
    BSplineCurve refined = curve;
    for (const double t : places) {
      const Result<BSplineCurve> next = refined.with_knot(t);
      if (!next) return;  // twice in one place, at degree 1
      refined = next.value();
    }
    const FloatTrapsOff sisl_divides_as_it_likes;
    const CurvePointer other = sisl_curve(curve);
    SISLCurve* made = nullptr;
    int status = 0;
    s1018(other.get(), places.data(), static_cast<int>(places.size()), &made, &status);
    const CurvePointer owned(made);
    holds(status >= 0 && made != nullptr && made->in == refined.knots().count());
    const std::size_t n = refined.points().size();
    for (std::size_t i = 0; i < n; ++i) {
      expect(close(refined.points()[i], vector({made->ecoef, 3 * n}, i), 1e-13 * (curve.degree() + 1),
                   polygon_size(curve)),
             "point");
    }
  }));
}

TEST_CASE("SISL: arc length (s1240) to its tolerance, and the closest point (s1957)") {
  CHECK(rc::check([] {
    // Smooth curves that do not turn back. SISL stops where its estimate of the error falls below 1e-8.
    const int degree = *rc::gen::inRange(2, 6), count = degree + *rc::gen::inRange(1, 8);
    std::vector<Eigen::Vector3d> points = *test::points(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      Eigen::Vector3d& point = points[static_cast<std::size_t>(i)];
      point = point / 64 + Eigen::Vector3d(20.0 * i, 0, 0);
    }
    const KnotVector knots = KnotVector::uniform(degree, count, Topology::open, 0, count).value();
    const BSplineCurve curve = BSplineCurve::make(knots, points).value();
    const Eigen::Vector3d seen = curve(drawn_parameter(knots)) + drawn_point() / 16;
    const double length = arc_length(curve_view(curve));
    const ClosestPoint nearest = closest_point(curve_view(curve), seen).value();

    const FloatTrapsOff sisl_divides_as_it_likes;
    const CurvePointer other = sisl_curve(curve);
    double sisl_length = 0, distance = 0, parameter = 0;
    int status = 0;
    s1240(other.get(), 1e-8, &sisl_length, &status);
    holds(status >= 0);
    expect(close(length, sisl_length, 1e-6), "length");
    double place[3] = {seen.x(), seen.y(), seen.z()};
    s1957(other.get(), place, 3, 1e-12, 1e-10, &parameter, &distance, &status);
    holds(status >= 0);
    // SISL's answer is a point of the curve: ours is never farther, and its Newton iteration ends at 1e-10.
    holds(nearest.distance <= distance + 1e-9 * (1 + polygon_size(curve)));
    holds((curve(parameter) - seen).norm() >= nearest.distance - 1e-12 * polygon_size(curve));
    expect(close(nearest.distance, distance, 1e-8, polygon_size(curve)), "distance");
  }));
}

}  // namespace knotwork::sisl_agreement
