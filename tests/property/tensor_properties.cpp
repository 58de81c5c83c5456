#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "knotwork/basis/bernstein.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/surface/bezier_surface.h"
#include "knotwork/surface/bspline_surface.h"
#include "property/generators.h"

namespace knotwork::tensor_properties {
using namespace test;
namespace {

double largest(std::span<const Eigen::Vector3d> list) {
  double most = 0;
  for (const Eigen::Vector3d& point : list) most = std::max(most, point.norm());
  return most;
}

BSplineSurface drawn_surface() {
  const KnotWish wish{.most_degree = 5, .most_intervals = 3};
  const KnotVector u = *knot_vectors(wish), v = *knot_vectors(wish);
  const std::size_t count = static_cast<std::size_t>(u.count()) * static_cast<std::size_t>(v.count());
  return BSplineSurface::make(u, v, *points(count)).value();
}

/// The size of what partial (a, b) at (u, v) is the sum of.
double partial_size(const BSplineSurface& surface, double u, double v, int a, int b) {
  return largest(surface.points()) * basis_size(surface.knots_u(), u, a) * basis_size(surface.knots_v(), v, b);
}
constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

void expect_same(const BSplineSurface& surface, const SurfaceJet& actual, const SurfaceJet& expected, double u,
                 double v, double tolerance, const char* what) {
  for (int k = 0; k < 6; ++k) {
    const double size = partial_size(surface, u, v, orders[k][0], orders[k][1]);
    expect(close(jet_part(actual, k), jet_part(expected, k), tolerance, size), what);
  }
}

/// A parameter of [0,1], the ends among them.
double drawn_share() { return *rc::gen::inRange(0, 1025) / 1024.0; }

BezierCurve drawn_bezier() {
  const std::size_t count = *rc::gen::inRange<std::size_t>(1, max_bezier_degree + 2);
  const double start = *rc::gen::arbitrary<std::int16_t>();
  const double width = std::ldexp(1.0, *rc::gen::inRange(-30, 31));
  return BezierCurve::make(*points(count), start * width, start * width + width).value();
}

/// The largest k-th derivative of a curve of this degree and size.
double bezier_size(const BezierCurve& curve, int k) {
  double size = largest(curve.points());
  for (int i = 0; i < k; ++i) size *= 2 * std::max(0, curve.degree() - i) / (curve.end() - curve.start());
  return size;
}

}  // namespace

TEST_CASE("Bernstein: not negative, sum 1, symmetric, the recurrence, derivatives from one degree less") {
  CHECK(rc::check([] {
    const int p = *rc::gen::inRange(1, max_bezier_degree + 1);
    const double t = drawn_share();
    const std::size_t width = static_cast<std::size_t>(p) + 1;
    std::vector<double> b(width), mirrored(width), less(width), d(width);
    bernstein(p, t, b);
    bernstein(p, 1 - t, mirrored);
    bernstein(p - 1, t, std::span(less).first(width - 1));
    bernstein_derivative(p, t, 1, 1, d);
    double sum = 0, slope = 0;
    for (std::size_t k = 0; k < width; ++k) {
      holds(b[k] >= 0);
      sum += b[k], slope += d[k];
      expect(close(mirrored[width - 1 - k], b[k], 1e-13), "mirrored");
      const double left = k > 0 ? less[k - 1] : 0, right = k < width - 1 ? less[k] : 0;
      expect(close(b[k], t * left + (1 - t) * right, 1e-14, 1e-300), "recurrence");
      expect(close(d[k], p * (left - right), 1e-13, p), "derivative");
    }
    expect(close(sum, 1, 1e-14), "sum");
    expect(close(slope, 0, 1e-13, 2 * p), "sum of derivatives");
  }));
}

TEST_CASE("the Bernstein-Hermite matrix takes Bezier points to the derivatives") {
  CHECK(rc::check([] {
    const BezierCurve curve = drawn_bezier();
    const double width = curve.end() - curve.start(), t = std::lerp(curve.start(), curve.end(), drawn_share());
    const Eigen::MatrixXd matrix = bernstein_hermite(curve.degree(), (t - curve.start()) / width, 1 / width);
    std::vector<Eigen::Vector3d> expected(curve.points().size());
    curve.evaluate(t, expected);
    for (int r = 0; r <= curve.degree(); ++r) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int k = 0; k <= curve.degree(); ++k) sum += matrix(r, k) * curve.points()[static_cast<std::size_t>(k)];
      expect(close(sum, expected[static_cast<std::size_t>(r)], 1e-13, bezier_size(curve, r)), "derivative");
    }
  }));
}

TEST_CASE("Bezier: ends, de Casteljau, elevation, halves, the other direction, the derivative's own curve") {
  CHECK(rc::check([] {
    const BezierCurve curve = drawn_bezier();
    const int p = curve.degree();
    const double width = curve.end() - curve.start(), share = drawn_share();
    const double t = curve.start() + share * width, size = largest(curve.points());
    holds(curve(curve.start()) == curve.points().front());
    holds(curve(curve.end()) == curve.points().back());
    const PointTriangle triangle = curve.de_casteljau(t);
    expect(close(triangle.back().front(), curve(t), 1e-14, size), "de Casteljau");

    std::vector<Eigen::Vector3d> reversed(curve.points().rbegin(), curve.points().rend());
    const BezierCurve back = BezierCurve::make(reversed, -curve.end(), -curve.start()).value();
    expect(close(back(-t), curve(t), 1e-13, size), "reversed");
    if (p < max_bezier_degree) expect(close(curve.elevated()(t), curve(t), 1e-13, size), "elevated");
    if (share > 0 && share < 1) {
      const auto [before, behind] = curve.split(t);
      holds(before.points().back() == behind.points().front());
      const double other = curve.start() + drawn_share() * width;
      expect(close((other < t ? before : behind)(other), curve(other), 1e-13, size), "half");
    }
    if (p == 0) return;
    std::vector<Eigen::Vector3d> legs;
    for (std::size_t k = 1; k < curve.points().size(); ++k)
      legs.emplace_back(p * (curve.points()[k] - curve.points()[k - 1]) / width);
    const BezierCurve hodograph = BezierCurve::make(legs, curve.start(), curve.end()).value();
    std::vector<Eigen::Vector3d> of_curve(static_cast<std::size_t>(p) + 2), of_hodograph(of_curve.size());
    curve.evaluate(t, of_curve);
    hodograph.evaluate(t, of_hodograph);
    for (int k = 1; k <= p + 1; ++k) {
      expect(close(of_curve[static_cast<std::size_t>(k)], of_hodograph[static_cast<std::size_t>(k) - 1], 1e-13,
                   bezier_size(curve, k)),
             "hodograph");
    }
  }));
}

TEST_CASE("a B-spline surface is its isoparametric curves, with all partials") {
  CHECK(rc::check([] {
    const BSplineSurface surface = drawn_surface();
    const double u = drawn_parameter(surface.knots_u()), v = drawn_parameter(surface.knots_v());
    const SurfaceJet jet = surface.evaluate(u, v);
    std::vector<Eigen::Vector3d> along_u(3), along_v(3), any(12);
    surface.curve_u(v).evaluate(u, along_u);
    surface.curve_v(u).evaluate(v, along_v);
    const SurfaceJet curves{along_u[0], along_u[1], along_v[1], along_u[2], jet.suv, along_v[2]};
    expect_same(surface, curves, jet, u, v, 1e-13, "curve");
    expect(close(along_v[0], jet.s, 1e-13, partial_size(surface, u, v, 0, 0)), "curve v");
    surface.evaluate(u, v, 2, 3, any);
    expect_same(surface, {any[0], any[4], any[1], any[8], any[5], any[2]}, jet, u, v, 1e-13, "any order");
  }));
}

TEST_CASE("grids and batches of a B-spline surface are its single points") {
  CHECK(rc::check([] {
    const BSplineSurface surface = drawn_surface();
    std::vector<double> u, v;
    std::vector<Eigen::Vector2d> pairs;
    for (int k = 0; k < 3; ++k) {
      u.push_back(drawn_parameter(surface.knots_u()));
      v.push_back(drawn_parameter(surface.knots_v()));
    }
    for (const double a : u) {
      for (const double b : v) pairs.emplace_back(a, b);
    }
    std::vector<SurfaceJet> grid(9), batch(9);
    surface.evaluate_grid(u, v, grid);
    surface.evaluate(pairs, batch);
    for (std::size_t k = 0; k < 9; ++k) {
      const SurfaceJet jet = surface.evaluate(pairs[k].x(), pairs[k].y());
      expect_same(surface, grid[k], jet, pairs[k].x(), pairs[k].y(), 1e-13, "grid");
      expect_same(surface, batch[k], jet, pairs[k].x(), pairs[k].y(), 1e-13, "batch");
    }
  }));
}

TEST_CASE("a B-spline surface: affine maps and exchanged directions pass through, one point is itself") {
  CHECK(rc::check([] {
    const BSplineSurface surface = drawn_surface();
    const Eigen::Affine3d map = drawn_map();
    const KnotVector &knots_u = surface.knots_u(), &knots_v = surface.knots_v();
    const double u = drawn_parameter(knots_u), v = drawn_parameter(knots_v);
    const SurfaceJet jet = surface.evaluate(u, v);
    std::vector<Eigen::Vector3d> mapped, exchanged;
    for (const Eigen::Vector3d& point : surface.points()) mapped.emplace_back(map * point);
    for (int j = 0; j < knots_v.count(); ++j) {
      for (int i = 0; i < knots_u.count(); ++i) exchanged.push_back(surface.point(i, j));
    }
    const SurfaceJet image = BSplineSurface::make(knots_u, knots_v, mapped).value().evaluate(u, v);
    const SurfaceJet other = BSplineSurface::make(knots_v, knots_u, exchanged).value().evaluate(v, u);
    expect_same(surface, {other.s, other.sv, other.su, other.svv, other.suv, other.suu}, jet, u, v, 1e-13, "exchanged");
    for (int k = 0; k < 6; ++k) {
      const double size =
          map.linear().norm() * partial_size(surface, u, v, orders[k][0], orders[k][1]) +
          map.translation().norm() * basis_size(knots_u, u, orders[k][0]) * basis_size(knots_v, v, orders[k][1]);
      const Eigen::Vector3d expected = k == 0 ? map * jet_part(jet, k) : map.linear() * jet_part(jet, k);
      expect(close(jet_part(image, k), expected, 1e-13, size), "mapped");
    }
    const Eigen::Vector3d one = drawn_point();
    const BSplineSurface still =
        BSplineSurface::make(knots_u, knots_v, std::vector<Eigen::Vector3d>(mapped.size(), one)).value();
    expect_same(still, still.evaluate(u, v), SurfaceJet{.s = one}, u, v, 1e-13, "one point");
  }));
}

TEST_CASE("a knot more in either direction keeps a B-spline surface; a closed direction repeats bit for bit") {
  CHECK(rc::check([] {
    const BSplineSurface surface = drawn_surface();
    const double u = drawn_parameter(surface.knots_u()), v = drawn_parameter(surface.knots_v());
    const SurfaceJet jet = surface.evaluate(u, v);
    const Result<BSplineSurface> by_u = surface.with_knot_u(drawn_parameter(surface.knots_u()));
    const Result<BSplineSurface> by_v = surface.with_knot_v(drawn_parameter(surface.knots_v()));
    for (const Result<BSplineSurface>* refined : {&by_u, &by_v}) {
      if (!*refined) continue;
      const SurfaceJet same = refined->value().evaluate(u, v);
      for (int k = 0; k < 6; ++k) {
        const int a = orders[k][0], b = orders[k][1];
        const double size = std::max(partial_size(surface, u, v, a, b), partial_size(refined->value(), u, v, a, b));
        expect(close(jet_part(same, k), jet_part(jet, k), 1e-13, size), "refined");
      }
    }
    const double turn_u = surface.knots_u().closed() ? surface.knots_u().period() : 0;
    const double turn_v = surface.knots_v().closed() ? surface.knots_v().period() : 0;
    holds(surface.evaluate(u + turn_u, v - 2 * turn_v).s == jet.s);
  }));
}

TEST_CASE("a Bezier surface: corners, de Casteljau, elevation and parts of it") {
  CHECK(rc::check([] {
    const int p = *rc::gen::inRange(1, 8), q = *rc::gen::inRange(1, 8);
    const double width = std::ldexp(1.0, *rc::gen::inRange(-30, 31));
    const BezierSurface surface =
        BezierSurface::make(p, q, *points(static_cast<std::size_t>((p + 1) * (q + 1))), {0, -width}, {width, width})
            .value();
    const double size = largest(surface.points());
    const double u = drawn_share() * width, v = (2 * drawn_share() - 1) * width;
    const auto at = [&](const BezierSurface& s) { return s.evaluate(u, v).s; };
    holds(surface.evaluate(0, -width).s == surface.point(0, 0));
    holds(surface.evaluate(width, width).s == surface.point(p, q));
    expect(close(surface.de_casteljau(u, v).back().points.front(), at(surface), 1e-13, size), "de Casteljau");
    expect(close(at(surface.elevated_u()), at(surface), 1e-13, size), "elevated u");
    expect(close(at(surface.elevated_v()), at(surface), 1e-13, size), "elevated v");
    const double cut = *rc::gen::inRange(1, 64) / 64.0;
    const auto [left, right] = surface.split_u(cut * width);
    const auto [below, above] = surface.split_v((2 * cut - 1) * width);
    expect(close(at(u < cut * width ? left : right), at(surface), 1e-13, size), "part u");
    expect(close(at(v < (2 * cut - 1) * width ? below : above), at(surface), 1e-13, size), "part v");
  }));
}

}  // namespace knotwork::tensor_properties
