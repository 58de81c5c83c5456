#include "knotwork/curve/curve_measures.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/bezier_curve.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::curve_measures_test {
using namespace test;
namespace {

using Derivatives = std::array<Eigen::Vector3d, 4>;

template <class Curve>
Derivatives derivatives(const Curve& curve, double t) {
  Derivatives c;
  curve.evaluate(t, c);
  return c;
}

/// The natural magnitudes of curvature and torsion, for the comparison rule of oracle.h: each derivative is known
/// relative to its length, not to the part of it that counts.
struct BendScale {
  double curvature, torsion;
};
BendScale bend_scale(const Derivatives& c) {
  const double cross = c[1].cross(c[2]).norm(), speed = c[1].norm();
  if (cross == 0) return {c[2].norm() / (speed * speed), 1};
  return {c[2].norm() / (speed * speed), c[3].norm() / cross * (speed * c[2].norm() / cross)};
}

bool right_handed(const FrenetFrame& f, double tolerance) {
  Eigen::Matrix3d m;
  m << f.tangent, f.normal, f.binormal;
  return (m.transpose() * m - Eigen::Matrix3d::Identity()).norm() <= tolerance && m.determinant() > 0;
}

/// The derivatives of c(phi(t)) where phi, phi', phi'', phi''' are given.
Derivatives reparameterised(const Derivatives& c, double a, double b, double d) {
  return {c[0], a * c[1], b * c[1] + a * a * c[2], d * c[1] + 3 * a * b * c[2] + a * a * a * c[3]};
}

}  // namespace

TEST_CASE("oracle 08: Frenet frames, speed, curvature and torsion of the report's model curve") {
  const nlohmann::json& frames =
      read_case(load_oracle("08_differential_geometry.json")["cases"]["report_model_curve"])["frenet"];
  REQUIRE(frames.size() == 21);
  const WaveCurve curve = report_model();
  for (const nlohmann::json& at : frames) {
    const double t = at["t"].get<double>();
    CAPTURE(t);
    const Derivatives c = derivatives(curve, t);
    const FrenetFrame frame = frenet_frame(c);
    const BendScale scale = bend_scale(c);
    CHECK(frame.regular);
    CHECK_FALSE(frame.straight);
    CHECK(close(frame.speed, at["speed"].get<double>(), oracle_tolerance));
    CHECK(close(frame.curvature, at["curvature"].get<double>(), oracle_tolerance, scale.curvature));
    CHECK(close(frame.torsion, at["torsion"].get<double>(), oracle_tolerance, scale.torsion));
    CHECK(close(frame.tangent, vector3(at["T"]), oracle_tolerance));
    CHECK(close(frame.normal, vector3(at["N"]), oracle_tolerance));
    CHECK(close(frame.binormal, vector3(at["B"]), oracle_tolerance));
    CHECK(speed(c) == frame.speed);
    CHECK(curvature(c) == frame.curvature);
    CHECK(torsion(c) == frame.torsion);
    CHECK(unit_tangent(c) == frame.tangent);
    CHECK(right_handed(frame, 1e-15));
  }
}

TEST_CASE("oracle 08: helix, circle and the report's clamped cubic") {
  const nlohmann::json& cases = load_oracle("08_differential_geometry.json")["cases"];
  REQUIRE(cases.contains("helix_1_0.25_0_4pi"));
  const nlohmann::json &coil = read_case(cases["helix_1_0.25_0_4pi"]), &ring = read_case(cases["circle_radius_5"]);
  const nlohmann::json& spline = read_case(cases["report_clamped_cubic_bspline"]);
  const WaveCurve left_out = helix(1, 1, 0.25, 2), flat = circle(5);
  for (int k = 0; k < 20; ++k) {
    CHECK(close(curvature(derivatives(left_out, 0.6 * k)), coil["curvature"].get<double>(), oracle_tolerance));
    CHECK(close(torsion(derivatives(left_out, 0.6 * k)), coil["torsion"].get<double>(), oracle_tolerance));
    CHECK(close(curvature(derivatives(flat, 0.3 * k)), ring["curvature"].get<double>(), oracle_tolerance));
    CHECK(close(torsion(derivatives(flat, 0.3 * k)), 0, oracle_tolerance, 0.2));
  }
  const nlohmann::json& inputs = load_oracle("01_bspline_clamped.json")["cases"][0]["inputs"];
  std::vector<Eigen::Vector3d> points;
  for (const nlohmann::json& point : inputs["control_points"]) points.push_back(vector3(point));
  const KnotVector knots = KnotVector::make(3, Topology::open, inputs["knots"].get<std::vector<double>>()).value();
  const BSplineCurve curve = BSplineCurve::make(knots, points).value();
  CHECK(spline["points"].size() == 8);
  for (const nlohmann::json& at : spline["points"]) {
    const Derivatives c = derivatives(curve, at["t"].get<double>());
    const BendScale scale = bend_scale(c);
    CHECK(close(speed(c), at["speed"].get<double>(), oracle_tolerance));
    CHECK(close(curvature(c), at["curvature"].get<double>(), oracle_tolerance, scale.curvature));
    CHECK(close(torsion(c), at["torsion"].get<double>(), oracle_tolerance, scale.torsion));
  }
}

TEST_CASE("oracle 09: curvature and torsion of every curve of the catalogue, from its derivatives") {
  const nlohmann::json& curves = load_oracle("09_catalog.json")["curves"];
  REQUIRE(curves.size() == 18);
  int points = 0;
  for (const nlohmann::json& curve : curves) {
    const std::string name = curve["name"].get<std::string>();
    CAPTURE(name);
    for (const nlohmann::json& at : curve["points"]) {
      const Derivatives c{vector3(at["c"]), vector3(at["c1"]), vector3(at["c2"]), vector3(at["c3"])};
      const BendScale scale = bend_scale(c);
      CHECK(close(curvature(c), at["curvature"].get<double>(), oracle_tolerance, scale.curvature));
      CHECK(close(torsion(c), at["torsion"].get<double>(), oracle_tolerance, scale.torsion));
      // The comparison sees a wrong value.
      if (curvature(c) > 0.01 * scale.curvature)
        CHECK_FALSE(close(1.0001 * curvature(c), at["curvature"].get<double>(), oracle_tolerance, scale.curvature));
      CHECK(right_handed(frenet_frame(c), 1e-15));
      ++points;
    }
  }
  CHECK(points == 90);
}

TEST_CASE("measures of shape do not see the parameter, a motion, or the origin; they scale") {
  std::mt19937 random(21);
  const WaveCurve curve = report_model();
  for (int k = 0; k < 200; ++k) {
    const Derivatives c = derivatives(curve, 0.03 * k);
    const FrenetFrame frame = frenet_frame(c);
    const BendScale scale = bend_scale(c);
    const Eigen::Vector3d by = random_point(random, 2);
    const double a = 0.1 + std::abs(by.x());
    const FrenetFrame faster = frenet_frame(reparameterised(c, a, by.y(), by.z()));
    CHECK(close(faster.curvature, frame.curvature, 1e-11, scale.curvature));
    CHECK(close(faster.torsion, frame.torsion, 1e-10, scale.torsion));
    CHECK(close(faster.binormal, frame.binormal, 1e-10));
    CHECK(close(faster.speed, a * frame.speed, 1e-14));
    // The other way, tangent and binormal turn round; curvature and torsion stay.
    const FrenetFrame back = frenet_frame(reparameterised(c, -a, 0, 0));
    CHECK(close(back.tangent, Eigen::Vector3d(-frame.tangent), 1e-14));
    CHECK(close(back.normal, frame.normal, 1e-12));
    CHECK(close(back.torsion, frame.torsion, 1e-12, scale.torsion));

    const RigidMotion motion = random_motion(random);
    Derivatives moved;
    for (std::size_t m = 0; m < 4; ++m) moved[m] = motion.turn * c[m];
    moved[0] += motion.move;
    const FrenetFrame there = frenet_frame(moved);
    CHECK(close(there.curvature, frame.curvature, 1e-12, scale.curvature));
    CHECK(close(there.torsion, frame.torsion, 1e-12, scale.torsion));
    CHECK(close(there.normal, Eigen::Vector3d(motion.turn * frame.normal), 1e-12));
    // A mirror image winds the other way.
    Derivatives mirrored = c;
    for (Eigen::Vector3d& m : mirrored) m.x() = -m.x();
    CHECK(close(torsion(mirrored), -frame.torsion, 1e-13, scale.torsion));
    CHECK(close(curvature(mirrored), frame.curvature, 1e-14, scale.curvature));
  }
}

TEST_CASE("sizes and speeds far from 1 lose nothing") {
  const Derivatives c = derivatives(report_model(), 0.7);
  for (const double size : {1e-40, 1e-3, 1e5, 1e40}) {
    for (const double fast : {1e-15, 1.0, 1e12}) {
      Derivatives scaled = reparameterised(c, fast, 0, 0);
      for (Eigen::Vector3d& x : scaled) x *= size;
      const FrenetFrame frame = frenet_frame(scaled);
      CHECK(close(frame.curvature * size, curvature(c), 1e-13));
      CHECK(close(frame.torsion * size, torsion(c), 1e-12));
      CHECK(close(frame.normal, frenet_frame(c).normal, 1e-13));
      CHECK(close(frame.speed, size * fast * speed(c), 1e-14));
    }
  }
}

TEST_CASE("the signed curvature of a plane curve is positive to the left") {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Derivatives left = derivatives(circle(4), 1.1);
  const Derivatives right = reparameterised(left, -1, 0, 0);
  CHECK(close(signed_curvature(left, up), 0.25, 1e-15));
  CHECK(close(signed_curvature(right, up), -0.25, 1e-15));
  CHECK(close(signed_curvature(left, -up), -0.25, 1e-15));
  // (t, t^3): its curvature changes sign at 0 and is 6t / (1 + 9t^4)^(3/2).
  for (const double t : {-0.5, 0.0, 0.25}) {
    const Derivatives c{{{t, t * t * t, 0}, {1, 3 * t * t, 0}, {0, 6 * t, 0}, {0, 6, 0}}};
    CHECK(close(signed_curvature(c, up), 6 * t / std::pow(1 + 9 * t * t * t * t, 1.5), 1e-14));
  }
}

TEST_CASE("Frenet's equations: the frame turns by curvature and torsion, and by nothing else") {
  const WaveCurve curve = report_model();
  const double h = 1e-3;
  for (int k = 0; k < 40; ++k) {
    const double t = 0.15 * k;
    const FrenetFrame at = frenet_frame(derivatives(curve, t));
    constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    Eigen::Vector3d t1 = Eigen::Vector3d::Zero(), n1 = t1, b1 = t1;
    for (int m = 1; m <= 4; ++m) {
      const FrenetFrame right = frenet_frame(derivatives(curve, t + m * h));
      const FrenetFrame left = frenet_frame(derivatives(curve, t - m * h));
      const double w = weights[m - 1] / (h * at.speed);
      t1 += w * (right.tangent - left.tangent), n1 += w * (right.normal - left.normal);
      b1 += w * (right.binormal - left.binormal);
    }
    const double size = at.curvature + std::abs(at.torsion);
    CHECK(close(t1, Eigen::Vector3d(at.curvature * at.normal), 1e-9, size));
    CHECK(close(n1, Eigen::Vector3d(-at.curvature * at.tangent + at.torsion * at.binormal), 1e-9, size));
    CHECK(close(b1, Eigen::Vector3d(-at.torsion * at.normal), 1e-9, size));
    CHECK_FALSE(close(t1, Eigen::Vector3d(1.001 * at.curvature * at.normal), 1e-9, 0));
  }
}

TEST_CASE("a straight line has no curvature, no torsion, and the frame that is stated") {
  const Derivatives line{{{1, 2, 3}, {0, 2, 0}, {0, 5, 0}, {0, 0, 0}}};
  const FrenetFrame frame = frenet_frame(line);
  CHECK(frame.regular);
  CHECK(frame.straight);
  CHECK(frame.curvature == 0);
  CHECK(frame.torsion == 0);
  CHECK(frame.tangent == Eigen::Vector3d::UnitY());
  CHECK(frame.normal == Eigen::Vector3d::UnitX());
  CHECK(frame.binormal == Eigen::Vector3d(0, 0, -1));
  // Rounding in c'' is curvature unless the caller says what is none.
  const Derivatives rough{{{1, 2, 3}, {0, 2, 0}, {1e-16, 5e-17, 0}, {0, 3e-16, 2e-16}}};
  CHECK_FALSE(frenet_frame(rough).straight);
  CHECK(frenet_frame(rough, 1e-12).straight);
  CHECK(frenet_frame(rough, 1e-12).torsion == 0);
  CHECK(frenet_frame(rough, 1e-12).curvature > 0);
  CHECK(right_handed(frenet_frame(rough, 1e-12), 1e-15));
}

TEST_CASE("at an inflection the normal is its limit as t grows") {
  // (t, t^3, t^4): N of (0, 6t, 12t^2) for t > 0 tends to y.
  const Derivatives at{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 6, 0}}};
  const double t = 1e-5;
  const Derivatives behind{
      {{t, t * t * t, t * t * t * t}, {1, 3 * t * t, 4 * t * t * t}, {0, 6 * t, 12 * t * t}, {0, 6, 24 * t}}};
  CHECK(frenet_frame(at).straight);
  CHECK_FALSE(frenet_frame(behind).straight);
  CHECK(close(frenet_frame(at).normal, frenet_frame(behind).normal, 1e-4));
  // Without c''' there is no limit to see.
  CHECK(right_handed(frenet_frame(std::span(at).first(3)), 1e-15));
}

TEST_CASE("at a cusp the tangent is its limit as t grows, and curvature is 0") {
  // (t^2, t^3) at 0: infinite curvature.
  const Derivatives cusp{{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 6, 0}}};
  const FrenetFrame frame = frenet_frame(cusp);
  CHECK_FALSE(frame.regular);
  CHECK(frame.tangent == Eigen::Vector3d::UnitX());
  CHECK(frame.normal == Eigen::Vector3d::UnitY());
  CHECK(frame.speed == 0);
  CHECK(frame.curvature == 0);
  CHECK(frame.torsion == 0);
  CHECK(curvature(cusp) == 0);
  CHECK(signed_curvature(cusp, Eigen::Vector3d::UnitZ()) == 0);
  // What rounding leaves of c' is no tangent.
  Derivatives rough = cusp;
  rough[0] = {5, 5, 0};
  rough[1] = {-3e-16, 7e-16, 0};
  CHECK(frenet_frame(rough).tangent == Eigen::Vector3d::UnitX());
  CHECK_FALSE(frenet_frame(rough).regular);
  // Two control points in one place.
  const Eigen::Vector3d twice(1, 1, 1);
  const BezierCurve pause = BezierCurve::make({twice, twice, {2, 1, 1}, {3, 5, 0}}).value();
  CHECK(close(frenet_frame(derivatives(pause, 0)).tangent, {1, 0, 0}, 1e-15));
  // All of them: a point.
  const FrenetFrame point = frenet_frame(derivatives(BezierCurve::make({twice, twice, twice}).value(), 0.5));
  CHECK_FALSE(point.regular);
  CHECK(point.curvature == 0);
  CHECK(right_handed(point, 1e-15));
  const Derivatives nothing{{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  CHECK(frenet_frame(nothing).tangent == Eigen::Vector3d::UnitX());
  const Derivatives third_only{{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 3}}};
  CHECK(frenet_frame(third_only).tangent == Eigen::Vector3d::UnitZ());
}

TEST_CASE("no derivatives make a NaN, and every frame is orthonormal") {
  const double sizes[] = {0.0, 1e-300, 1e-150, 1e-61, 1e-12, 1.0, 1e12, 1e90};
  for (const double a : sizes) {
    for (const double b : sizes) {
      for (const double d : sizes) {
        const Derivatives c{{{a, b, d}, {a, b, 0}, {b, 0, d}, {d, a, -b}}};
        const FrenetFrame frame = frenet_frame(c);
        CHECK(right_handed(frame, 1e-14));
        CHECK(std::isfinite(frame.curvature));
        CHECK(std::isfinite(frame.torsion));
      }
    }
  }
}

TEST_CASE("a unit vector across another one") {
  const Eigen::Vector3d tangent = Eigen::Vector3d(1, 2, 2) / 3;
  CHECK(close(unit_across(tangent, {1, 0, 0}).dot(tangent), 0, 1e-15, 1));
  CHECK(close(unit_across(tangent, tangent).dot(tangent), 0, 1e-15, 1));
  CHECK(unit_across(tangent, tangent).x() > 0.9);  // x is the axis farthest from it
  CHECK(unit_across(tangent, {0, 0, 0}) == unit_across(tangent, Eigen::Vector3d(-7 * tangent)));
  CHECK(unit_across(Eigen::Vector3d::UnitZ(), {0, 0, 1}) == Eigen::Vector3d::UnitX());
}

}  // namespace knotwork::curve_measures_test
