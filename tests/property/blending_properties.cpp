#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "knotwork/curve/blending_curve.h"
#include "knotwork/surface/blending_surface.h"
#include "property/generators.h"
#include "unit/model_curves.h"

namespace knotwork::blending_properties {
using namespace test;
namespace {

using Jet = std::array<Eigen::Vector3d, BlendingCurve::max_order + 1>;

Topology drawn_topology() { return *rc::gen::element(Topology::open, Topology::closed); }

/// Any B-function of the table, with any parameter, and expo-rational ones with their own.
BlendingFunction drawn_function() {
  const std::span<const BlendingFamily> families = blending_families();
  const std::size_t row = *rc::gen::inRange<std::size_t>(0, families.size() + 1);
  if (row < families.size()) {
    const BlendingFamily& family = families[row];
    return BlendingFunction::make(family.kind, *rc::gen::inRange(family.parameter_min, family.parameter_max + 1))
        .value();
  }
  ExpoRationalParameters parameters;
  parameters.alpha = *rc::gen::inRange(2, 33) / 16.0;
  parameters.beta = *rc::gen::inRange(2, 33) / 16.0;
  parameters.gamma = *rc::gen::inRange(8, 33) / 16.0;
  parameters.lambda = *rc::gen::inRange(1, 16) / 16.0;
  return BlendingFunction::make(parameters).value();
}

/// Knots of degree 1 over [0, 1] with intervals of 2^-28 and more: exact, as those of generators.h, by a last interval
/// that fills the domain up to a power of two.
KnotVector drawn_knots(Topology topology) {
  const bool closed = topology == Topology::closed;
  const int intervals = *rc::gen::inRange(closed ? 2 : 1, 8);
  std::vector<double> at{0};
  for (int k = 0; k + 1 < intervals; ++k)
    at.push_back(at.back() + std::ldexp(*rc::gen::inRange(1, 16), *rc::gen::inRange(0, 21)));
  at.push_back(std::exp2(std::floor(std::log2(at.back() + 1)) + 1));
  const double length = at.back();
  for (double& t : at) t /= length;
  const double before = closed ? at[at.size() - 2] - 1 : 0, after = closed ? 1 + at[1] : 1;
  at.insert(at.begin(), before);
  at.push_back(after);
  return KnotVector::make(1, topology, std::move(at)).value();
}

/// A closed curve over [0, 1], with torsion.
ModelCurve knot_curve() {
  using std::numbers::pi;
  return {0, 1, Topology::closed, 16, [](double t, std::span<Eigen::Vector3d> out) {
            for (std::size_t k = 0; k < out.size(); ++k) {
              out[k] = Eigen::Vector3d(wave(2, 2 * pi, pi / 2, t, k) + wave(1, 4 * pi, 0, t, k),
                                       wave(2, 2 * pi, 0, t, k), wave(0.5, 6 * pi, 1, t, k));
            }
          }};
}

/// A map near the identity: the locals keep the size of the model.
Eigen::Affine3d moderate_map() {
  const Eigen::Affine3d drawn = drawn_map();
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.matrix().topRows<3>() += drawn.matrix().topRows<3>() / 512;
  return map;
}

LocalCurves drawn_shape() {
  return {.kind = *rc::gen::element(LocalCurveKind::sub_curve, LocalCurveKind::bezier_hermite, LocalCurveKind::arc),
          .degree = *rc::gen::inRange(1, 7)};
}

BlendingCurve drawn_curve_of(const LocalCurves& shape, bool moved) {
  const ModelCurve model = knot_curve();
  const KnotVector knots = drawn_knots(drawn_topology());
  std::vector<Eigen::Affine3d> locals = BlendingCurve::unmoved_locals(model, knots);
  if (moved) {
    for (Eigen::Affine3d& local : locals) local = local * moderate_map();
  }
  return BlendingCurve::make(model, knots, drawn_function(), shape, locals).value();
}

Jet jet_at(const BlendingCurve& curve, double t) {
  Jet jet;
  curve.evaluate(t, jet);
  return jet;
}

/// The terms that the derivatives at t are made of: the locals' derivatives with B's, by Leibniz.
std::array<double, 4> jet_size(const BlendingCurve& curve, double t) {
  const KnotVector& knots = curve.knots();
  const double inside = knots.reduced(t);
  const int i = knots.span(inside), n = knots.count();
  const double delta = 1 / (knots[i + 1] - knots[i]);
  const BlendingValue b = curve.blending()((inside - knots[i]) * delta);
  Jet left, right;
  curve.evaluate_local(i - 1, inside, left);
  curve.evaluate_local(i % n, i == n ? inside - knots.period() : inside, right);
  std::array<double, 4> size{};
  for (std::size_t k = 0; k < 4; ++k) {
    double choose = 1;
    for (std::size_t j = 0; j <= k; ++j) {
      size[k] += choose * std::pow(delta, static_cast<double>(j)) * (j == 0 ? 1 : std::abs(b[j])) *
                 (left[k - j].norm() + right[k - j].norm());
      choose = choose * static_cast<double>(k - j) / static_cast<double>(j + 1);
    }
  }
  return size;
}

}  // namespace

TEST_CASE("a B-function runs from 0 to 1 without turning back; symmetric ones mirror") {
  CHECK(rc::check([] {
    const BlendingFunction b = drawn_function();
    const double w = *rc::gen::inRange(0, 1025) / 1024.0, behind = std::min(1.0, w + *rc::gen::inRange(1, 64) / 1024.0);
    const BlendingValue at = b(w);
    holds(b(0)[0] == 0.0);
    holds(b(1)[0] == 1.0);
    holds(at[0] >= 0 && at[0] <= 1 && at[1] >= 0);
    holds(at[0] <= b(behind)[0]);
    holds(b(w + 2)[0] == 1 && b(-w - 1)[0] == 0 && b(w + 2)[1] == 0);
    for (int k = 1; k <= std::min(3, b.order()); ++k)
      holds(b(0)[static_cast<std::size_t>(k)] == 0 && std::abs(b(1)[static_cast<std::size_t>(k)]) <= 1e-12);
    if (!b.symmetric()) return;
    const BlendingValue mirrored = b(1 - w);
    expect(close(at[0] + mirrored[0], 1, 1e-14), "B(w) + B(1-w)");
    double sign = 1;
    for (std::size_t k = 1; k < 4; ++k, sign = -sign)
      expect(close(sign * mirrored[k], at[k], 1e-11, 1e-300 + std::abs(at[1])), "mirrored derivative");
  }));
}

TEST_CASE("blending curve: at the knots it has the locals' derivatives up to the order of B (Hermite property)") {
  CHECK(rc::check([] {
    const BlendingCurve curve = drawn_curve_of(drawn_shape(), true);
    const int k = *rc::gen::inRange(0, curve.knots().count()), order = std::min(3, curve.blending().order());
    const double t = curve.centre(k);
    const Jet jet = jet_at(curve, t);
    const std::array<double, 4> size = jet_size(curve, t);
    Jet local;
    curve.evaluate_local(k, t, local);
    for (int j = 0; j <= order; ++j) {
      const std::size_t at = static_cast<std::size_t>(j);
      expect(close(jet[at], local[at], 1e-12, size[at]), "derivative");
    }
  }));
}

TEST_CASE("blending curve: unmoved sub-curves give the model back, whatever B and the knots are") {
  CHECK(rc::check([] {
    const BlendingCurve curve = drawn_curve_of({}, false);
    const double t = drawn_parameter(curve.knots());
    const Jet jet = jet_at(curve, t);
    const std::array<double, 4> size = jet_size(curve, t);
    Jet model;
    curve.model().evaluate(curve.knots().reduced(t), model);
    for (std::size_t k = 0; k < 4; ++k) expect(close(jet[k], model[k], 1e-13, size[k] + 100), "model");
  }));
}

TEST_CASE("blending curve: both forms agree; a local moves its support by its weight and nothing else, bit for bit") {
  CHECK(rc::check([] {
    BlendingCurve curve = drawn_curve_of(drawn_shape(), true);
    const KnotVector& knots = curve.knots();
    const double t = drawn_parameter(knots);
    const Jet jet = jet_at(curve, t);
    const std::array<double, 4> size = jet_size(curve, t);
    Jet two;
    curve.evaluate_two_curves(t, two);
    for (std::size_t k = 0; k < 4; ++k) expect(close(jet[k], two[k], 1e-12, size[k]), "two curves");

    const int moved = *rc::gen::inRange(0, knots.count());
    const Eigen::Vector3d by = drawn_point() / 64;
    double weight = 0;
    for (const BlendingCurve::Weight& w : curve.weights(t)) weight += w.local == moved ? w.value : 0;
    curve.set_local(moved, Eigen::Translation3d(by) * curve.local(moved));
    const Eigen::Vector3d step = curve(t) - jet[0];
    expect(close(step, weight * by, 1e-13, size[0] + by.norm()), "step");
    if (weight == 0) holds(step == Eigen::Vector3d(0, 0, 0));
  }));
}

TEST_CASE("blending surface: both forms, grid and single, the Hermite property, the model, affine maps") {
  CHECK(rc::check([] {
    // Plane, half-rolled sheet, cylinders and torus.
    const double bend_u = *rc::gen::element(0.0, 0.6, 1.0), bend_v = *rc::gen::element(0.0, 0.6, 1.0);
    const ModelSurface model = Sheet{bend_u, bend_v};
    const auto over = domain(model);
    // Moderate intervals: 2 pi is not a whole number of units, and its copies round.
    const auto knots = [](const Interval& range, double bend) {
      const Topology topology = bend < 1 ? Topology::open : drawn_topology();
      const KnotVector drawn = drawn_knots(topology);
      const bool closed = topology == Topology::closed;
      std::vector<double> at;
      for (int i = 1; i + 1 < static_cast<int>(drawn.knots().size()); ++i)
        at.push_back(0.5 * drawn[i] + 0.5 * (i - 1.0) / (drawn.interval_count()));
      for (double& t : at) t = std::lerp(range.start, range.end, t);
      const double length = range.end - range.start;
      const double before = closed ? at[at.size() - 2] - length : range.start;
      const double after = closed ? at[1] + length : range.end;
      at.insert(at.begin(), before);
      at.push_back(after);
      return KnotVector::make(1, topology, at).value();
    };
    const KnotVector u = knots(over.u, bend_u), v = knots(over.v, bend_v);
    const std::vector<Eigen::Affine3d> unmoved = BlendingSurface::unmoved_locals(model, u, v);
    BlendingSurface surface = BlendingSurface::make(model, u, v, drawn_function(), unmoved).value();
    const double a = drawn_parameter(u), b = drawn_parameter(v);
    const SurfaceJet still = surface.evaluate(a, b), of_model = evaluate(model, u.reduced(a), v.reduced(b));
    // What second partials are made of: B'' over the interval squared, times the locals.
    const double du = u[u.span(u.reduced(a)) + 1] - u[u.span(u.reduced(a))];
    const double dv = v[v.span(v.reduced(b)) + 1] - v[v.span(v.reduced(b))];
    const double steep = 200, size[6] = {10,
                                         10 * steep / du,
                                         10 * steep / dv,
                                         10 * steep * steep / (du * du),
                                         10 * steep * steep / (du * dv),
                                         10 * steep * steep / (dv * dv)};
    for (int k = 0; k < 6; ++k) expect(close(jet_part(still, k), jet_part(of_model, k), 1e-14, size[k]), "model");

    for (int i = 0; i < u.count(); ++i) {
      for (int j = 0; j < v.count(); ++j) surface.set_local(i, j, surface.local(i, j) * moderate_map());
    }
    const SurfaceJet jet = surface.evaluate(a, b), four = surface.evaluate_four_patches(a, b);
    SurfaceJet grid;
    surface.evaluate_grid({&a, 1}, {&b, 1}, {&grid, 1});
    for (int k = 0; k < 6; ++k) {
      expect(close(jet_part(jet, k), jet_part(four, k), 1e-14, size[k]), "four patches");
      expect(close(jet_part(grid, k), jet_part(jet, k), 1e-14, size[k]), "grid");
    }
    const int i = *rc::gen::inRange(0, u.count()), j = *rc::gen::inRange(0, v.count());
    const Eigen::Vector2d centre = surface.centre(i, j);
    const SurfaceJet at = surface.evaluate(centre.x(), centre.y());
    const SurfaceJet local = surface.evaluate_local(i, j, centre.x(), centre.y());
    const int highest[6] = {0, 1, 1, 2, 1, 2};
    const int order = std::min(surface.blending().order(), 2);
    for (int k = 0; k < 6; ++k) {
      if (highest[k] <= order) expect(close(jet_part(at, k), jet_part(local, k), 1e-12, 100), "Hermite");
    }
    const Eigen::Affine3d map = moderate_map();
    for (int k = 0; k < u.count(); ++k) {
      for (int m = 0; m < v.count(); ++m) surface.set_local(k, m, map * surface.local(k, m));
    }
    const SurfaceJet image = surface.evaluate(a, b);
    for (int k = 0; k < 6; ++k) {
      const Eigen::Vector3d expected = k == 0 ? map * jet.s : map.linear() * jet_part(jet, k);
      expect(close(jet_part(image, k), expected, 1e-13, size[k]), "image");
    }
  }));
}

}  // namespace knotwork::blending_properties
