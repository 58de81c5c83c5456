#include "knotwork/curve/moving_frame.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "knotwork/curve/arc_length.h"
#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/curve_measures.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::moving_frame_test {
using namespace test;
namespace {

std::vector<double> steps(double from, double to, int count) {
  std::vector<double> t;
  t.reserve(static_cast<std::size_t>(count) + 1);
  for (int k = 0; k < count; ++k) t.push_back(from + (to - from) * k / count);
  return t;
}

MovingFrames frames(const CurveView& curve, const std::vector<double>& t, const MovingFrameOptions& options = {}) {
  return rotation_minimising_frames(curve, t, options).value();
}

double off_orthonormal(const MovingFrame& f) {
  Eigen::Matrix3d m;
  m << f.tangent, f.normal, f.binormal;
  return std::max((m.transpose() * m - Eigen::Matrix3d::Identity()).norm(), std::abs(m.determinant() - 1));
}

/// The integral of torsion by length, the turn of Frenet's frame against one that does not turn; periodic integrand.
double total_torsion(const WaveCurve& curve, int count) {
  double sum = 0;
  for (const double t : steps(curve.start, curve.end, count)) {
    std::array<Eigen::Vector3d, 4> c;
    curve.evaluate(t, c);
    sum += torsion(c) * speed(c) * (curve.end - curve.start) / count;
  }
  return sum;
}

double wrapped(double angle) { return std::remainder(angle, round); }

}  // namespace

TEST_CASE("on a helix the frame turns against Frenet's by the torsion, to the fourth order of the step") {
  const WaveCurve coil = helix(1, 1, 0.25, 1);
  const double torsion_of_coil = 0.25 / 1.0625, length = arc_length(coil.view());
  const auto error = [&](int count) {
    std::vector<double> t = steps(0, round, count);
    t.push_back(round);
    const MovingFrames moving = frames(coil.view(), t, {{-1, 0, 0}});
    std::array<Eigen::Vector3d, 4> c;
    coil.evaluate(round, c);
    const FrenetFrame end = frenet_frame(c);
    return std::abs(
        wrapped(turn_about(end.tangent, moving.frames.back().normal, end.normal) - torsion_of_coil * length));
  };
  CHECK(error(100) < 1e-6);
  CHECK(error(100) > 1e-10);  // it is a method with steps
  const double ratio = error(20) / error(40);
  CHECK(ratio > 15);
  CHECK(ratio < 17);
}

TEST_CASE("the frame has no rotation about the tangent: N' is parallel to T") {
  const WaveCurve curve = report_model();
  const double h = 1e-3;
  for (int k = 0; k < 30; ++k) {
    const double t = 0.1 + 0.2 * k;
    const std::vector<double> around{t - 2 * h, t - h, t, t + h, t + 2 * h};
    const MovingFrames moving = frames(curve.view(), around, {{0.3, 1, 0.2}, 20});
    const auto& f = moving.frames;
    const Eigen::Vector3d derivative = (8 * (f[3].normal - f[1].normal) - (f[4].normal - f[0].normal)) / (12 * h);
    CHECK(close(derivative.dot(f[2].binormal), 0, 1e-7, derivative.norm() + 1));
    CHECK(close(derivative.dot(f[2].normal), 0, 1e-7, 1));
    // Frenet's frame is told apart: it turns by the torsion.
    const auto frenet = [&](double at) {
      std::array<Eigen::Vector3d, 4> c;
      curve.evaluate(at, c);
      return frenet_frame(c);
    };
    const FrenetFrame middle = frenet(t);
    const Eigen::Vector3d turning =
        (8 * (frenet(t + h).normal - frenet(t - h).normal) - (frenet(t + 2 * h).normal - frenet(t - 2 * h).normal)) /
        (12 * h);
    CHECK(close(turning.dot(middle.binormal), middle.torsion * middle.speed, 1e-4, turning.norm()));
    if (std::abs(middle.torsion) > 0.1) CHECK_FALSE(close(turning.dot(middle.binormal), 0, 1e-7, turning.norm() + 1));
  }
}

TEST_CASE("frames are orthonormal, on the curve, along its tangent, and begin as asked") {
  std::mt19937 random(61);
  for (int degree = 1; degree <= 5; ++degree) {
    const BSplineCurve spline = random_spline(degree, degree + 6, Topology::open, random);
    const Eigen::Vector3d wish = random_point(random);
    const std::vector<double> t = steps(0, 6, 100);
    const MovingFrames moving = frames(curve_view(spline), t, {wish, 3});
    REQUIRE(moving.frames.size() == t.size());
    CHECK(moving.mismatch == 0);
    CHECK(moving.frames[0].normal.dot(wish) > 0);
    CHECK(close(moving.frames[0].binormal.dot(wish), 0, 1e-14, wish.norm()));
    for (std::size_t k = 0; k < t.size(); ++k) {
      std::array<Eigen::Vector3d, 4> c;
      spline.evaluate(t[k], c);
      CHECK(off_orthonormal(moving.frames[k]) <= 1e-14);
      CHECK(close(moving.frames[k].point, c[0], 1e-14));
      CHECK(close(moving.frames[k].tangent, unit_tangent(c), 1e-12));
    }
  }
}

TEST_CASE("frames move with the curve and do not see its parameter") {
  std::mt19937 random(62);
  const WaveCurve curve = report_model();
  const RigidMotion motion = random_motion(random);
  WaveCurve moved = curve;
  moved.origin = motion.move;
  for (WaveCurve::Wave& wave : moved.waves) wave.amplitude = motion.turn * wave.amplitude;
  const std::vector<double> t = steps(0, round, 50);
  const Eigen::Vector3d wish(0.1, 0.2, 0.3);
  const MovingFrames here = frames(curve.view(), t, {wish}), there = frames(moved.view(), t, {motion.turn * wish});
  CHECK(close(there.mismatch, here.mismatch, 1e-12, 1));
  for (std::size_t k = 0; k < t.size(); ++k)
    CHECK(close(there.frames[k].normal, Eigen::Vector3d(motion.turn * here.frames[k].normal), 1e-12));
}

TEST_CASE("a plane curve keeps its normal to the plane, and a closed one has no mismatch") {
  const WaveCurve ellipse = helix(3, 1, 0, 1);
  const MovingFrames moving = frames(ellipse.view(), steps(0, round, 40), {{0, 0, 1}});
  CHECK(close(moving.mismatch, 0, 1e-13, 1));
  for (const MovingFrame& frame : moving.frames) CHECK(close(frame.normal, {0, 0, 1}, 1e-14));
}

TEST_CASE("the mismatch of a closed curve is its total torsion; spread, the frame meets itself") {
  // The trefoil; the report's curve, which is its own image in the origin, has no total torsion.
  const WaveCurve curve{
      {{{1, 0, 0}, 1, sine}, {{2, 0, 0}, 2, sine}, {{0, 1, 0}, 1, 0}, {{0, -2, 0}, 2, 0}, {{0, 0, -1}, 3, sine}},
      0,
      round};
  CHECK(close(frames(report_model().view(), {0, 1}, {{0, 0, 1}, 300}).mismatch, 0, 1e-7, 1));
  const std::vector<double> t = steps(0, round, 200);
  const MovingFrames moving = frames(curve.view(), t, {{0, 0, 1}, 10});
  // Frenet's frame comes back to itself after turning by the total torsion against a frame that does not turn.
  CHECK(close(wrapped(moving.mismatch + total_torsion(curve, 4000)), 0, 1e-8, 1));
  CHECK(std::abs(moving.mismatch) > 0.05);
  // From anywhere, with any normal, it is the same.
  const MovingFrames other = frames(curve.view(), steps(1, 6, 7), {{1, 0, 0}, 300});
  CHECK(close(other.mismatch, moving.mismatch, 1e-8, 1));

  const MovingFrames even = frames(curve.view(), t, {{0, 0, 1}, 10, true});
  CHECK(even.mismatch == moving.mismatch);
  const ArcLength length(curve.view());
  for (std::size_t k = 0; k < t.size(); ++k) {
    CHECK(off_orthonormal(even.frames[k]) <= 1e-14);
    const double turn = turn_about(even.frames[k].tangent, moving.frames[k].normal, even.frames[k].normal);
    CHECK(close(turn, -moving.mismatch * length.at(t[k]) / length.length(), 1e-5, 1));
  }
  // The last step to the first is a step like the others.
  const auto jump = [](const MovingFrame& a, const MovingFrame& b) { return (a.normal - b.normal).norm(); };
  CHECK(jump(even.frames.back(), even.frames.front()) < 2 * jump(even.frames[198], even.frames[199]));
}

TEST_CASE("corners, cusps and pauses") {
  // A corner in the plane: the frame turns with the tangent, the normal to the plane stays.
  const BSplineCurve corner = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 2, 3, 3}).value(),
                                                 {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}})
                                  .value();
  const MovingFrames turned = frames(curve_view(corner), {0, 0.5, 1, 1.5, 2, 2.5}, {{0, 1, 0}});
  CHECK(close(turned.frames[1].normal, {0, 1, 0}, 1e-15));
  CHECK(close(turned.frames[2].normal, {-1, 0, 0}, 1e-14));  // at the corner: already along the next side
  CHECK(close(turned.frames[3].normal, {-1, 0, 0}, 1e-14));
  CHECK(close(turned.frames[5].normal, {-1, 0, 0}, 1e-14));
  CHECK(close(turned.frames[5].binormal, {0, -1, 0}, 1e-14));
  // The same with one long step over both corners.
  CHECK(close(frames(curve_view(corner), {0, 3}, {{0, 1, 0}}).frames[1].normal, {-1, 0, 0}, 1e-14));
  // There and back on one line: the normal goes on.
  const BezierCurve back = BezierCurve::make({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}).value();
  const MovingFrames reversed = frames(curve_view(back), {0, 0.25, 0.5, 0.75, 1}, {{0, 1, 2}});
  for (const MovingFrame& frame : reversed.frames) {
    CHECK(close(frame.normal, Eigen::Vector3d(0, 1, 2).normalized(), 1e-14));
    CHECK(off_orthonormal(frame) <= 1e-14);
  }
  CHECK(close(reversed.frames.front().tangent, {1, 0, 0}, 1e-15));
  CHECK(close(reversed.frames.back().tangent, {-1, 0, 0}, 1e-15));
  // A point.
  const Eigen::Vector3d here(1, 2, 3);
  const BezierCurve point = BezierCurve::make({here, here}).value();
  for (const MovingFrame& frame : frames(curve_view(point), {0, 0.5, 1}).frames) CHECK(off_orthonormal(frame) <= 1e-14);
  // A closed square: four right angles about one axis, and no mismatch.
  const BSplineCurve square = BSplineCurve::make(KnotVector::uniform(1, 4, Topology::closed, 0, 4).value(),
                                                 {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}})
                                  .value();
  CHECK(close(frames(curve_view(square), {0.5, 1.5}, {{0.3, 0, 1}}).mismatch, 0, 1e-14, 1));
}

TEST_CASE("what cannot be answered is refused, with the place") {
  const WaveCurve ring = circle(2);
  const auto error = [&](const std::vector<double>& t, const MovingFrameOptions& options = {}) {
    return rotation_minimising_frames(ring.view(), t, options).error().path;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(error({0, nan}) == "t[1]");
  CHECK(error({infinity}) == "t[0]");
  CHECK(error({0, 1, 1}) == "t[2]");
  CHECK(error({0, 2, 1}) == "t[2]");
  CHECK(error({-0.1}) == "t[0]");
  CHECK(error({1, 6.3}) == "t[1]");
  CHECK(error({0, round}) == "t");
  CHECK(error({0, 1}, {{0, 0, 0}, 0}) == "steps");
  CHECK(error({0, 1}, {{0, nan, 0}}) == "firstNormal");
  CHECK(frames(ring.view(), {}).frames.empty());
  CHECK(frames(ring.view(), {1}).frames.size() == 1);
}

}  // namespace knotwork::moving_frame_test
