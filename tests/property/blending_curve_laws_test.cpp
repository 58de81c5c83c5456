#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/blending_curve.h"
#include "property/surface_cases.h"
#include "unit/model_curves.h"

namespace knotwork::blending_curve_laws_test {
using namespace test;
namespace {

using Jet = std::array<Eigen::Vector3d, 4>;

struct CurveCase {
  std::string name;
  BlendingCurve curve;
};

BlendingCurve unmoved_curve(const ModelCurve& model, const KnotVector& knots, const BlendingFunction& b,
                            LocalCurves shape) {
  return BlendingCurve::make(model, knots, b, shape, BlendingCurve::unmoved_locals(model, knots)).value();
}

/// Every kind of locals over open and closed curves, n from 2 up, uniform and not, every B-function. Every local is
/// moved by its own affine map: unmoved sub-curves would detect nothing (THEORY 2.7, P1).
std::vector<CurveCase> make_curve_cases() {
  struct Model {
    const char* name;
    ModelCurve curve;
    Topology topology;
  };
  const Model models[] = {{"report closed", report_curve(), Topology::closed},
                          {"report open", report_curve(), Topology::open},
                          {"helix", helix(), Topology::open}};
  const LocalCurves shapes[] = {{LocalCurveKind::sub_curve},
                                {LocalCurveKind::bezier_hermite, 1},
                                {LocalCurveKind::bezier_hermite, 2},
                                {LocalCurveKind::bezier_hermite, 5},
                                {LocalCurveKind::arc},
                                {LocalCurveKind::sub_curve}};
  struct Size {
    int n;
    bool uniform;
  };
  const Size sizes[] = {{2, true}, {3, false}, {5, false}, {10, true}};
  std::vector<CurveCase> cases;
  for (const BlendingFunction& b : case_functions()) {
    for (const Model& model : models) {
      for (const LocalCurves& shape : shapes) {
        const Size& size = sizes[cases.size() % 4];
        const Interval range{model.curve.start(), model.curve.end()};
        BlendingCurve curve =
            unmoved_curve(model.curve, case_knots(size.n, model.topology, range, size.uniform), b, shape);
        Numbers numbers(cases.size() + 1);
        for (int k = 0; k < size.n; ++k) curve.set_local(k, curve.local(k) * numbers.affine());
        const int kind = static_cast<int>(shape.kind);
        cases.push_back({std::string(model.name) + ", " + std::to_string(size.n) +
                             (size.uniform ? " uniform" : " non-uniform") + " locals of kind " + std::to_string(kind) +
                             ", " + std::string(blending_family(b.kind()).id),
                         std::move(curve)});
      }
    }
  }
  return cases;
}
const std::vector<CurveCase>& curve_cases() {
  static const std::vector<CurveCase> cases = make_curve_cases();
  return cases;
}

Jet jet_at(const BlendingCurve& curve, double t) {
  Jet jet;
  curve.evaluate(t, jet);
  return jet;
}

/// The largest norm of each derivative over a coarse grid: its natural magnitude on this curve.
std::array<double, 4> curve_scale(const BlendingCurve& curve) {
  std::array<double, 4> scale{};
  for (const double t : interval_parameters(curve.knots(), {0, 0.1, 0.3, 0.5, 0.8, 0.93})) {
    const Jet jet = jet_at(curve, t);
    for (std::size_t k = 0; k < 4; ++k) scale[k] = std::max(scale[k], jet[k].norm());
  }
  return scale;
}

/// How many orders of derivatives, 0 to 3, a curve keeps across its knots.
std::size_t kept_order(const BlendingCurve& curve) {
  return static_cast<std::size_t>(std::min(3, curve.blending().order()));
}

/// Whether each derivative agrees with an eighth-order central difference of the one before. `scale[k]`: the norm below
/// which derivative k counts as cancelled.
bool derivatives_agree(const std::function<Jet(double)>& f, double t, double h, const std::array<double, 4>& scale) {
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  Jet difference;
  difference.fill(Eigen::Vector3d::Zero());
  for (int step = 1; step <= 4; ++step) {
    const Jet right = f(t + step * h), left = f(t - step * h);
    for (std::size_t k = 1; k < 4; ++k) difference[k] += weights[step - 1] / h * (right[k - 1] - left[k - 1]);
  }
  const Jet jet = f(t);
  for (std::size_t k = 1; k < 4; ++k) {
    if (!close(jet[k], difference[k], 1e-6, scale[k])) return false;
  }
  return true;
}

/// The seed's mistake: the derivatives of the blending weights left out.
Jet without_weight_derivatives(const BlendingCurve& curve, double t) {
  Jet sum = jet_at(curve, t);
  for (std::size_t k = 1; k < 4; ++k) sum[k].setZero();
  for (const BlendingCurve::Weight& weight : curve.weights(t)) {
    Jet local;
    const bool wraps = weight.local == 0 && t > curve.knots()[2];
    curve.evaluate_local(weight.local, wraps ? t - curve.knots().period() : t, local);
    for (std::size_t k = 1; k < 4; ++k) sum[k] += weight.value * local[k];
  }
  return sum;
}

}  // namespace

TEST_CASE("curve: both evaluation forms agree to 1e-13") {
  for (const CurveCase& entry : curve_cases()) {
    CAPTURE(entry.name);
    const std::array<double, 4> scale = curve_scale(entry.curve);
    for (const double t : interval_parameters(entry.curve.knots(), {0, 0.03, 0.4, 0.5, 0.9, 1})) {
      const Jet fast = jet_at(entry.curve, t);
      Jet two;
      entry.curve.evaluate_two_curves(t, two);
      for (std::size_t k = 0; k < 4; ++k) REQUIRE(close(fast[k], two[k], 1e-13, scale[k]));
    }
  }
}

TEST_CASE("curve: derivatives are the derivatives, relative to their size; wrong ones are rejected") {
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    CAPTURE(entry.name);
    std::array<double, 4> scale = curve_scale(curve);
    // A derivative much smaller than usual on the curve is a cancellation; a thousandth of the largest is not.
    for (double& s : scale) s *= 1e-3;
    int points = 0, wrong_ones = 0, halved = 0, slightly_wrong = 0, seed = 0;
    for (const double t : interval_parameters(curve.knots(), {0.3})) {
      const int i = curve.knots().span(t);
      const double h = 0.004 * (curve.knots()[i + 1] - curve.knots()[i]);
      REQUIRE(derivatives_agree([&](double x) { return jet_at(curve, x); }, t, h, scale));
      ++points;
      for (std::size_t part = 1; part < 4; ++part) {
        // Linear B over straight locals: a parabola. Its third derivative is 0, and so is every multiple of it.
        if (scale[part] < 1e-9 * scale[1]) continue;
        ++wrong_ones;
        for (const double factor : {0.5, 1.001}) {
          const auto wrong = [&](double x) {
            Jet jet = jet_at(curve, x);
            jet[part] *= factor;
            return jet;
          };
          (factor == 0.5 ? halved : slightly_wrong) += derivatives_agree(wrong, t, h, scale) ? 0 : 1;
        }
      }
      seed += derivatives_agree([&](double x) { return without_weight_derivatives(curve, x); }, t, h, scale) ? 0 : 1;
    }
    CHECK(wrong_ones >= 2 * points);
    CHECK(halved == wrong_ones);
    CHECK(slightly_wrong == wrong_ones);
    CHECK(seed == points);
  }
}

TEST_CASE("curve: P2, a local has influence on its support, all of it, and nowhere else, by its weight") {
  const Eigen::Vector3d translation(0.1, -0.2, 0.3);
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    CAPTURE(entry.name);
    std::vector<double> parameters = interval_parameters(curve.knots(), {0, 0.3, 0.7});
    if (!curve.knots().closed()) parameters.push_back(curve.knots().end());
    for (int k = 0; k < curve.knots().count(); ++k) {
      CAPTURE(k);
      BlendingCurve changed = curve;
      changed.set_local(k, Eigen::Translation3d(translation) * curve.local(k));
      for (const double t : parameters) {
        CAPTURE(t);
        const Eigen::Vector3d before = curve(t), after = changed(t);
        // Bit for bit: what is outside the support is not even rounded otherwise.
        REQUIRE((before != after) == in_support(curve.knots(), k, t));
        double weight = 0;
        for (const BlendingCurve::Weight& w : curve.weights(t)) weight += w.local == k ? w.value : 0;
        REQUIRE(close(after - before, weight * translation, 1e-13, 1));
      }
    }
  }
}

TEST_CASE(
    "curve: Hermite property, at its knot the curve has the local's derivatives up to the order of B, no further") {
  int exceeded = 0;
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    CAPTURE(entry.name);
    const std::array<double, 4> scale = curve_scale(curve);
    for (int k = 0; k < curve.knots().count(); ++k) {
      CAPTURE(k);
      Jet local;
      curve.evaluate_local(k, curve.centre(k), local);
      const Jet jet = jet_at(curve, curve.centre(k));
      for (std::size_t j = 0; j <= kept_order(curve); ++j) REQUIRE(close(jet[j], local[j], 1e-13, scale[j]));
      if (kept_order(curve) < 3) {
        const std::size_t beyond = kept_order(curve) + 1;
        REQUIRE_FALSE(close(jet[beyond], local[beyond], 1e-9, scale[beyond]));
        ++exceeded;
      }
    }
  }
  CHECK(exceeded > 100);
}

TEST_CASE("curve: continuous with its derivatives up to the order across knots and the closed seam, no further") {
  int crossings = 0, jumps_beyond_order = 0;
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    const KnotVector& knots = curve.knots();
    CAPTURE(entry.name);
    const std::array<double, 4> scale = curve_scale(curve);
    const int last = knots.closed() ? knots.count() + 1 : knots.count() - 1;
    for (int i = 2; i <= last; ++i) {
      const double before = std::nextafter(knots[i], -1e9);  // in the interval before
      const Jet left = jet_at(curve, before), right = jet_at(curve, knots[i]);
      ++crossings;
      for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        const Closeness same = close(left[k], right[k], 1e-11, scale[k]);
        if (k <= kept_order(curve)) {
          REQUIRE(same);
        } else if (!same && k == kept_order(curve) + 1) {
          ++jumps_beyond_order;
        }
      }
    }
  }
  CHECK(crossings > 500);
  CHECK(jumps_beyond_order > 100);
}

TEST_CASE("curve: P3, mapping every local maps the curve") {
  Numbers numbers(4711);
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    CAPTURE(entry.name);
    const Eigen::Affine3d map = numbers.affine();
    BlendingCurve mapped = curve;
    for (int k = 0; k < curve.knots().count(); ++k) mapped.set_local(k, map * curve.local(k));
    const std::array<double, 4> scale = curve_scale(curve);
    for (const double t : interval_parameters(curve.knots(), {0, 0.3, 0.8})) {
      const Jet before = jet_at(curve, t), after = jet_at(mapped, t);
      REQUIRE(close(after[0], map * before[0], 1e-13, scale[0]));
      for (std::size_t k = 1; k < 4; ++k) REQUIRE(close(after[k], map.linear() * before[k], 1e-13, 2 * scale[k]));
    }
  }
}

TEST_CASE("curve: P1, unmoved sub-curves give the model back whatever the blending function, and only they do") {
  for (const BlendingFunction& b : case_functions()) {
    for (const ModelCurve& model : {report_curve(), helix()}) {
      const KnotVector knots = case_knots(5, model.topology(), {model.start(), model.end()}, false);
      const BlendingCurve same = unmoved_curve(model, knots, b, {});
      const BlendingCurve cubic = unmoved_curve(model, knots, b, {LocalCurveKind::bezier_hermite, 3});
      const BlendingCurve arcs = unmoved_curve(model, knots, b, {LocalCurveKind::arc});
      for (const double t : interval_parameters(knots, {0, 0.2, 0.5, 0.9})) {
        Jet expected;
        model.evaluate(t, expected);
        const Jet jet = jet_at(same, t);
        // The derivatives of the weights cancel: magnitude of the largest, those of the steepest function.
        const double scale[] = {1, 10, 100, 1000};
        for (std::size_t k = 0; k < 4; ++k) REQUIRE(close(jet[k], expected[k], 1e-13, scale[k]));
      }
      for (const double t : interval_parameters(knots, {0.5})) {
        CHECK_FALSE(close(cubic(t), model(t), 1e-4));
        // Arcs keep the circle that a helix turns in, if not its rise.
        CHECK_FALSE(close(arcs(t), model(t), 1e-4));
      }
    }
  }
}

TEST_CASE("curve: unmoved Bezier-Hermite locals give it the model's derivatives at the knots up to degree and order") {
  int beyond = 0;
  for (const BlendingFunction& b : case_functions()) {
    for (const int degree : {1, 2, 3}) {
      const ModelCurve model = report_curve();
      const KnotVector knots = case_knots(7, Topology::closed, {model.start(), model.end()}, false);
      const BlendingCurve curve = unmoved_curve(model, knots, b, {LocalCurveKind::bezier_hermite, degree});
      const std::size_t kept = std::min(static_cast<std::size_t>(degree), kept_order(curve));
      for (int k = 0; k < knots.count(); ++k) {
        Jet expected;
        model.evaluate(curve.centre(k), expected);
        const Jet jet = jet_at(curve, curve.centre(k));
        const double scale[] = {2, 5, 20, 60};
        for (std::size_t j = 0; j <= kept; ++j) REQUIRE(close(jet[j], expected[j], 1e-13, scale[j]));
        if (kept < 3) beyond += close(jet[kept + 1], expected[kept + 1], 1e-6).within ? 0 : 1;
      }
    }
  }
  CHECK(beyond > 100);
}

TEST_CASE("curve: a closed one repeats with its period, an open one stops at its ends") {
  for (const CurveCase& entry : curve_cases()) {
    const BlendingCurve& curve = entry.curve;
    const KnotVector& knots = curve.knots();
    CAPTURE(entry.name);
    const double t = knots.start() + 0.37 * knots.period();
    if (knots.closed()) {
      CHECK(close(curve(t + knots.period()), curve(t), 1e-13, 1));
      CHECK(close(curve(t - 3 * knots.period()), curve(t), 1e-13, 1));
      CHECK(curve(knots.end()) == curve(knots.start()));
    } else {
      CHECK(curve(knots.end() + 1) == curve(knots.end()));
      CHECK(curve(knots.start() - 1) == curve(knots.start()));
      // The ends are those of the first and the last local, alone.
      Jet first, last;
      curve.evaluate_local(0, knots.start(), first);
      curve.evaluate_local(knots.count() - 1, knots.end(), last);
      CHECK(close(curve(knots.start()), first[0], 1e-14, 1));
      CHECK(close(curve(knots.end()), last[0], 1e-14, 1));
    }
  }
}

}  // namespace knotwork::blending_curve_laws_test
