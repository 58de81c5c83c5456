#include "knotwork/curve/blending_curve.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/curve_measures.h"
#include "unit/model_curves.h"
#include "unit/oracle.h"

namespace knotwork::blending_curve_test {
using namespace test;
namespace {

using std::numbers::pi;
using Jet = std::array<Eigen::Vector3d, 4>;

LocalCurves oracle_shape(const nlohmann::json& inputs) {
  const std::string type = inputs.value("local_type", "");
  if (type.empty()) return {};
  if (type.starts_with("osculating arc")) return {LocalCurveKind::arc};
  REQUIRE(type.starts_with("Bezier-Hermite of degree "));
  return {LocalCurveKind::bezier_hermite, std::stoi(type.substr(std::string("Bezier-Hermite of degree ").size()))};
}

BlendingCurve oracle_curve(const nlohmann::json& inputs) {
  const bool closed = inputs["closed"].get<bool>();
  REQUIRE(inputs["model"].get<std::string>().starts_with(closed ? "report: " : "helix "));
  std::vector<Eigen::Affine3d> locals;
  for (const nlohmann::json& matrix : inputs["local_matrices_local_to_parent"]) locals.push_back(affine3(matrix));
  CHECK(locals.size() == inputs["n_local_curves"].get<std::size_t>());
  const BlendingKind kind = find_blending_family(inputs["B_function"].get<std::string>())->kind;
  return BlendingCurve::make(
             closed ? report_curve() : helix(),
             KnotVector::make(1, closed ? Topology::closed : Topology::open, inputs["knots"].get<std::vector<double>>())
                 .value(),
             BlendingFunction::make(kind).value(), oracle_shape(inputs), std::move(locals))
      .value();
}

/// The largest norm of each derivative over a case: what cancels where one of them is small.
std::array<double, 4> case_scale(const nlohmann::json& entry) {
  std::array<double, 4> scale{};
  for (const nlohmann::json& at : entry["points"]) {
    for (std::size_t k = 0; k < 4; ++k) scale[k] = std::max(scale[k], vector3(at["derivatives"][k]).norm());
  }
  return scale;
}

KnotVector knots(int n, const ModelCurve& model) {
  return KnotVector::uniform(1, n, model.topology(), model.start(), model.end()).value();
}
BlendingFunction polynomial2() { return BlendingFunction::make(BlendingKind::polynomial2).value(); }

/// Unmoved locals on equidistant knots.
Result<BlendingCurve> blend(const ModelCurve& model, int n, LocalCurves shape) {
  return BlendingCurve::make(model, knots(n, model), polynomial2(), shape,
                             BlendingCurve::unmoved_locals(model, knots(n, model)));
}

}  // namespace

TEST_CASE("oracle 08: length, speed, curvature and torsion of a blending curve with one local moved") {
  const char* name = "one_local_moved_polynomial1";
  const nlohmann::json& measured = read_case(load_oracle("08_differential_geometry.json")["cases"][name]);
  REQUIRE(measured["points"].size() == 8);
  const nlohmann::json& curves = load_oracle("06_blending_curve.json")["cases"];
  const auto found = std::find_if(curves.begin(), curves.end(), [&](const nlohmann::json& entry) {
    return entry["name"].get<std::string>() == name;
  });
  REQUIRE(found != curves.end());
  const BlendingCurve curve = oracle_curve((*found)["inputs"]);
  const KnotVector& t = curve.knots();
  CHECK(close(arc_length(curve_view(curve, t.start(), t.end(), Topology::closed, t.knots())),
              measured["length"].get<double>(), oracle_tolerance));
  for (const nlohmann::json& at : measured["points"]) {
    Jet c;
    curve.evaluate(at["t"].get<double>(), c);
    CHECK(close(speed(c), at["speed"].get<double>(), oracle_tolerance));
    // Relative to the derivatives that they are made of.
    const double v = c[1].norm(), cross = c[1].cross(c[2]).norm();
    const double bend = c[2].norm() / (v * v), twist = c[3].norm() * v * c[2].norm() / (cross * cross);
    CHECK(close(curvature(c), at["curvature"].get<double>(), oracle_tolerance, bend));
    CHECK(close(torsion(c), at["torsion"].get<double>(), oracle_tolerance, twist));
    CHECK_FALSE(close(curvature(c) + 1e-3 * bend, at["curvature"].get<double>(), oracle_tolerance, bend));
  }
}

TEST_CASE("blending curves meet oracle 06: derivatives to order 3, by both forms, and the locals' data at the knots") {
  const nlohmann::json& oracle = load_oracle("06_blending_curve.json");
  REQUIRE(oracle.contains("cases"));
  int cases = 0, vectors = 0, knot_vectors = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    read_case(entry);
    const std::string name = entry["name"].get<std::string>();
    CAPTURE(name);
    const BlendingCurve curve = oracle_curve(entry["inputs"]);
    const std::array<double, 4> scale = case_scale(entry);
    for (const nlohmann::json& at : entry["points"]) {
      const double t = at["t"].get<double>();
      CAPTURE(t);
      CHECK(curve.knots().span(t) == at["interval_i"].get<int>());
      CHECK(close(curve.blending()(at["w"].get<double>())[0], curve.weights(t)[1].value, oracle_tolerance));
      Jet fast, two;
      curve.evaluate(t, fast);
      curve.evaluate_two_curves(t, two);
      for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        CHECK(close(fast[k], vector3(at["derivatives"][k]), oracle_tolerance, scale[k]));
        CHECK(close(two[k], vector3(at["derivatives"][k]), oracle_tolerance, scale[k]));
        ++vectors;
      }
    }
    for (const nlohmann::json& at : entry["hermite_interpolation_at_knots"]) {
      const int i = at["i"].get<int>();
      CAPTURE(i);
      CHECK(close(curve.centre(i - 1), at["t_i"].get<double>(), oracle_tolerance));
      const nlohmann::json& expected = at["derivatives_up_to_order_of_B"];
      CHECK(static_cast<int>(expected.size()) == std::min(curve.blending().order(), 3) + 1);
      Jet jet, local;
      curve.evaluate(curve.centre(i - 1), jet);
      curve.evaluate_local(i - 1, curve.centre(i - 1), local);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(k);
        CHECK(close(jet[k], vector3(expected[k]), oracle_tolerance, scale[k]));
        CHECK(close(local[k], vector3(expected[k]), oracle_tolerance, scale[k]));
        ++knot_vectors;
      }
    }
    ++cases;
  }
  CHECK(cases == 17);
  CHECK(vectors > 1000);
  CHECK(knot_vectors > 400);
}

TEST_CASE("Bezier-Hermite locals are the Bezier curves of oracle 06, arcs have its speeds, curvatures and frames") {
  const nlohmann::json& oracle = load_oracle("06_blending_curve.json");
  REQUIRE(oracle.contains("cases"));
  int beziers = 0, arcs = 0;
  for (const nlohmann::json& entry : oracle["cases"]) {
    const nlohmann::json& inputs = entry["inputs"];
    const BlendingCurve curve = oracle_curve(inputs);
    const KnotVector& t = curve.knots();
    if (inputs.contains("local_bezier_control_points_relative_to_origin")) {
      for (int k = 0; k < t.count(); ++k) {
        std::vector<Eigen::Vector3d> points;
        for (const nlohmann::json& point :
             inputs["local_bezier_control_points_relative_to_origin"][static_cast<std::size_t>(k)]) {
          points.push_back(vector3(point));
        }
        const BezierCurve bezier = BezierCurve::make(points, t[k], t[k + 2]).value();
        CHECK(bezier.degree() == curve.shape().degree);
        for (const double share : {0.0, 0.3, 0.5, 1.0}) {
          const double at = std::lerp(t[k], t[k + 2], share);
          Jet expected, actual;
          bezier.evaluate(at, expected);
          curve.evaluate_local(k, at, actual);
          CHECK(close(actual[0], curve.local(k) * expected[0], oracle_tolerance, 2));
          for (std::size_t j = 1; j < 4; ++j) {
            CHECK(close(actual[j], curve.local(k).linear() * expected[j], oracle_tolerance, 50));
          }
        }
        ++beziers;
      }
    }
    if (inputs.contains("arc_speed_curvature_tangent_normal")) {
      for (int k = 0; k < t.count(); ++k) {
        const nlohmann::json& data = inputs["arc_speed_curvature_tangent_normal"][static_cast<std::size_t>(k)];
        const double v = data[0].get<double>(), kappa = data[1].get<double>();
        const Eigen::Vector3d tangent = vector3(data[2]), normal = vector3(data[3]);
        for (const double x : {-0.6, 0.0, 0.2, 1.5}) {
          const double turn = kappa * v * x, sine = std::sin(turn), cosine = std::cos(turn);
          Jet jet;
          curve.evaluate_local(k, t[k + 1] + x, jet);
          const auto& m = curve.local(k);
          CHECK(close(jet[0], m * (sine / kappa * tangent + (1 - cosine) / kappa * normal), oracle_tolerance, 1));
          CHECK(close(jet[1], m.linear() * (v * cosine * tangent + v * sine * normal), oracle_tolerance));
          CHECK(close(jet[2], m.linear() * (kappa * v * v * (cosine * normal - sine * tangent)), oracle_tolerance));
          CHECK(close(jet[3], -kappa * kappa * v * v * jet[1], oracle_tolerance));
        }
        ++arcs;
      }
    }
  }
  CHECK(beziers == 30);
  CHECK(arcs == 10);
}

TEST_CASE("arcs: a circle is its own arc, a line too, and the limit of small curvature is the line") {
  const ModelCurve round = circle(2, 3);
  const BlendingCurve arcs = blend(round, 5, {LocalCurveKind::arc}).value();
  for (int step = 0; step < 50; ++step) {
    const double t = round.end() * step / 50;
    Jet jet, expected;
    arcs.evaluate(t, jet);
    round.evaluate(t, expected);
    // B' and its kin meet the difference of two equal locals.
    const double scale[] = {2, 6, 60, 600};
    for (std::size_t k = 0; k < 4; ++k) CHECK(close(jet[k], expected[k], 1e-13, scale[k]));
  }

  const Eigen::Vector3d direction(1, -2, 0.5);
  const BlendingCurve line = blend(polynomial({{1, 1, 1}, direction}, 0, 3), 4, {LocalCurveKind::arc}).value();
  for (const double t : {0.0, 0.7, 1.0, 2.9, 3.0}) {
    Jet jet;
    line.evaluate(t, jet);
    CHECK(close(jet[0], Eigen::Vector3d::Ones() + t * direction, 1e-15));
    CHECK(close(jet[1], direction, 1e-14));
    CHECK(jet[2].norm() < 1e-13);
    CHECK(jet[3].norm() < 1e-12);
  }

  for (const double bend : {1e-3, 1e-8, 1e-150, 1e-300, 0.0}) {
    CAPTURE(bend);
    // At t = 0 the speed is 1 and the curvature is 2 bend.
    const ModelCurve bent = polynomial({{0, 0, 0}, {1, 0, 0}, {0, bend, 0}}, 0, 1);
    const BlendingCurve nearly = blend(bent, 2, {LocalCurveKind::arc}).value();
    Jet jet;
    nearly.evaluate_local(0, 0.5, jet);
    CHECK(close(jet[0], Eigen::Vector3d(0.5, bend / 4, 0), bend));
    CHECK(jet[0].y() == doctest::Approx(bend / 4).epsilon(1e-6));
    CHECK(close(jet[1], Eigen::Vector3d(1, bend, 0), bend));
    CHECK(close(jet[2], Eigen::Vector3d(0, 2 * bend, 0), 2 * bend));
  }
}

TEST_CASE("an arc where the model stands still, exactly or to rounding, is its point") {
  for (const double speed : {0.0, 1e-320, 1e-170, 1e-10}) {
    CAPTURE(speed);
    const ModelCurve cusp = polynomial({{1, 2, 3}, {speed, 0, 0}, {0, 1, 0}, {0, 0, 2}}, 0, 1);
    const BlendingCurve arcs = blend(cusp, 3, {LocalCurveKind::arc}).value();
    Jet jet;
    arcs.evaluate_local(0, 0.4, jet);
    CHECK(jet[0] == Eigen::Vector3d(1, 2, 3));
    for (std::size_t k = 1; k < 4; ++k) CHECK(jet[k] == Eigen::Vector3d::Zero());
    arcs.evaluate(0.2, jet);
    for (const Eigen::Vector3d& derivative : jet) CHECK(derivative.array().isFinite().all());
  }
  // Slow, but moving: an arc of its small radius.
  const ModelCurve slow = polynomial({{0, 0, 0}, {1e-6, 0, 0}, {0, 1, 0}}, 0, 1);
  Jet jet;
  blend(slow, 3, {LocalCurveKind::arc}).value().evaluate_local(0, 0.0, jet);
  CHECK(close(jet[1], Eigen::Vector3d(1e-6, 0, 0), 1e-15));
  CHECK(close(jet[2], Eigen::Vector3d(0, 2, 0), 1e-15));
}

TEST_CASE("Bezier-Hermite locals of the model's degree give a polynomial back, and have its data below it") {
  const ModelCurve cubic = polynomial({{1, 0, -1}, {0, 2, 1}, {1, 1, 0}, {-0.5, 0.2, 1}}, -1, 2);
  for (const int degree : {3, 4, 9, 16}) {
    const BlendingCurve same = blend(cubic, 4, {LocalCurveKind::bezier_hermite, degree}).value();
    for (const double t : {-1.0, -0.3, 0.5, 2.0}) {
      Jet jet, expected;
      same.evaluate(t, jet);
      cubic.evaluate(t, expected);
      for (std::size_t k = 0; k < 4; ++k) CHECK(close(jet[k], expected[k], 1e-12, 10));
    }
  }
  const BlendingCurve below = blend(cubic, 4, {LocalCurveKind::bezier_hermite, 1}).value();
  for (int k = 0; k < 4; ++k) {
    Jet jet, expected;
    below.evaluate(below.centre(k), jet);
    cubic.evaluate(below.centre(k), expected);
    for (std::size_t j = 0; j < 2; ++j) CHECK(close(jet[j], expected[j], 1e-14));
    CHECK_FALSE(close(jet[2], expected[2], 0.1));
  }
  CHECK_FALSE(close(below(0.4), cubic(0.4), 0.001));
}

TEST_CASE("a B-spline curve as a model: closed, and open with the parameter of its knots") {
  std::vector<Eigen::Vector3d> points{{5, 2, 8}, {2, 9, 2}, {2, 3, 4}, {3, 4, 5}, {3, 6, 0}, {1, 4, 0}, {5, 8, 3}};
  for (const Topology topology : {Topology::open, Topology::closed}) {
    const BSplineCurve spline = BSplineCurve::make(KnotVector::uniform(4, 7, topology, -1, 6).value(), points).value();
    const ModelCurve model = model_curve(spline);
    CHECK(model.topology() == topology);
    CHECK(model.start() == -1);
    CHECK(model.end() == 6);
    const BlendingCurve curve = blend(model, 5, {}).value();
    for (int step = 0; step <= 40; ++step) {
      const double t = -1 + 7 * step / 40.0;
      Jet jet, expected;
      curve.evaluate(t, jet);
      spline.evaluate(t, expected);
      for (std::size_t k = 0; k < 4; ++k) CHECK(close(jet[k], expected[k], 1e-12, 10));
    }
  }
}

TEST_CASE("a batch is the single evaluations, sorted or not, and a copy is a value of its own") {
  for (const LocalCurves shape :
       {LocalCurves{}, LocalCurves{LocalCurveKind::bezier_hermite, 2}, LocalCurves{LocalCurveKind::arc}}) {
    BlendingCurve curve = blend(report_curve(), 6, shape).value();
    const BlendingCurve before = curve;
    curve.set_local(2, curve.local(2) * Eigen::Translation3d(0.1, 0.2, 0.3));
    const std::vector<double> t{-1, 0, 0.1, 0.2, 1.9, 6.2, 2 * pi, 7, 3, 0.4};
    for (const int order : {0, 1, 3}) {
      const std::size_t values = static_cast<std::size_t>(order) + 1;
      std::vector<Eigen::Vector3d> batch(values * t.size()), one(values);
      curve.evaluate(t, order, batch);
      for (std::size_t m = 0; m < t.size(); ++m) {
        curve.evaluate(t[m], one);
        for (std::size_t k = 0; k < values; ++k) CHECK(batch[m * values + k] == one[k]);
      }
      curve.evaluate(std::span<const double>(), order, {});
    }
    CHECK(curve(2.5) != before(2.5));
    CHECK(before(2.5) == blend(report_curve(), 6, shape).value()(2.5));
  }
}

TEST_CASE("weights: of the two locals that meet, the seam included") {
  const BlendingCurve closed = blend(report_curve(), 6, {}).value(), open = blend(helix(), 6, {}).value();
  const auto check = [](const BlendingCurve& curve, double t, int first, int second, double value) {
    const auto [a, b] = curve.weights(t);
    CHECK(a.local == first);
    CHECK(b.local == second);
    CHECK(b.value == doctest::Approx(value).epsilon(1e-14));
    CHECK(a.value == 1 - b.value);
  };
  check(closed, 0, 0, 1, 0);
  check(closed, pi / 6, 0, 1, 0.5);
  check(closed, 2 * pi - pi / 6, 5, 0, 0.5);
  check(closed, 2 * pi, 0, 1, 0);
  check(closed, -pi / 6, 5, 0, 0.5);
  check(open, 4 * pi, 4, 5, 1);
  check(open, 99, 4, 5, 1);
  check(open, -1, 0, 1, 0);
}

TEST_CASE("what is no blending curve is refused, with the place") {
  const ModelCurve round = report_curve(), line = helix();
  const auto path = [](const Result<BlendingCurve>& result) {
    return result ? std::string("accepted") : result.error().path;
  };
  const auto made = [&](const ModelCurve& model, const KnotVector& on, LocalCurves shape = {}) {
    const std::vector<Eigen::Affine3d> locals(static_cast<std::size_t>(on.count()), Eigen::Affine3d::Identity());
    return BlendingCurve::make(model, on, polynomial2(), shape, locals);
  };
  const auto on = [](Topology topology, std::vector<double> values) {
    return KnotVector::make(1, topology, std::move(values)).value();
  };
  CHECK(path(made(round, knots(4, round))) == "accepted");
  CHECK(path(made(round, KnotVector::uniform(1, 4, Topology::open, 1, 5).value())) == "accepted");  // a part of it

  // The knots.
  CHECK(path(made(round, KnotVector::uniform(2, 4, Topology::closed, 0, 2 * pi).value())) == "knots");
  const auto unclosed = made(line, KnotVector::uniform(1, 4, Topology::closed, 0, 4 * pi).value());
  REQUIRE_FALSE(unclosed);
  CHECK(unclosed.error().path == "knots");
  CHECK(unclosed.error().message == "The model curve is not closed, so the curve cannot be closed.");
  CHECK(path(made(round, KnotVector::uniform(1, 4, Topology::closed, 0, 6).value())) == "knots");
  CHECK(path(made(line, KnotVector::uniform(1, 4, Topology::open, 0, 13).value())) == "knots");
  CHECK(path(made(line, KnotVector::uniform(1, 4, Topology::open, -0.1, 12).value())) == "knots");
  CHECK(path(made(line, on(Topology::open, {0, 0, 1, 1 + 1e-9, 4, 4}))) == "knots");

  // The shape of the locals.
  for (const int degree : {-1, 0, 17}) {
    CHECK(path(made(round, knots(4, round), {LocalCurveKind::bezier_hermite, degree})) == "shape.degree");
  }
  const auto no_formula = [](double, std::span<Eigen::Vector3d> out) {
    for (Eigen::Vector3d& derivative : out) derivative.setOnes();
  };
  const auto with_orders = [&](int orders) { return ModelCurve(0, 1, Topology::open, orders, no_formula); };
  const KnotVector unit = KnotVector::uniform(1, 3, Topology::open, 0, 1).value();
  const auto too_high = made(with_orders(3), unit, {LocalCurveKind::bezier_hermite, 4});
  REQUIRE_FALSE(too_high);
  CHECK(too_high.error().path == "shape.degree");
  CHECK(too_high.error().message.find("between 1 and 3") != std::string::npos);
  CHECK(path(made(with_orders(3), unit, {LocalCurveKind::bezier_hermite, 3})) == "accepted");
  CHECK(path(made(with_orders(2), unit)) == "model");
  CHECK(path(made(with_orders(3), unit)) == "accepted");
  CHECK(path(made(with_orders(1), unit, {LocalCurveKind::arc})) == "model");
  CHECK(path(made(with_orders(2), unit, {LocalCurveKind::arc})) == "accepted");

  // The model: its domain's length and its derivatives at the knots.
  for (const double length : {1e-10, 1e10}) {
    const ModelCurve model(0, length, Topology::open, 3, no_formula);
    CHECK(path(made(model, knots(3, model))) == "model");
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e101}) {
    const ModelCurve model(0, 1, Topology::open, 3, [bad](double t, std::span<Eigen::Vector3d> out) {
      for (Eigen::Vector3d& derivative : out) derivative.setOnes();
      if (t == 1) out.back().y() = bad;
    });
    for (const LocalCurves shape :
         {LocalCurves{}, LocalCurves{LocalCurveKind::bezier_hermite, 2}, LocalCurves{LocalCurveKind::arc}}) {
      CHECK(path(made(model, unit, shape)) == "model");
    }
  }

  // The locals' maps.
  std::vector<Eigen::Affine3d> locals(4, Eigen::Affine3d::Identity());
  const auto with = [&] { return BlendingCurve::make(round, knots(4, round), polynomial2(), {}, locals); };
  CHECK(path(with()) == "accepted");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 2e100}) {
    locals[2] = Eigen::Affine3d::Identity();
    locals[2].matrix()(1, 3) = bad;
    CHECK(path(with()) == "locals[2]");
  }
  locals[2] = Eigen::Affine3d::Identity();
  locals[2].matrix()(3, 1) = 0.5;
  CHECK(path(with()) == "locals[2]");
  locals.pop_back();
  CHECK(path(with()) == "locals");
  CHECK(with().error().message == "These knots need 4 local curves, but there are 3.");
}

}  // namespace knotwork::blending_curve_test
