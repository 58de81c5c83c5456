#include "knotwork/curve/arc_length.h"

#include <array>
#include <cmath>
#include <vector>

#include "knotwork/curve/bezier_curve.h"
#include "knotwork/curve/curve_measures.h"
#include "unit/analytic_curves.h"
#include "unit/oracle.h"

namespace knotwork::arc_length_test {
using namespace test;
namespace {

BSplineCurve report_spline() {
  const nlohmann::json& inputs = load_oracle("01_bspline_clamped.json")["cases"][0]["inputs"];
  std::vector<Eigen::Vector3d> points;
  for (const nlohmann::json& point : inputs["control_points"]) points.push_back(vector3(point));
  const KnotVector knots = KnotVector::make(3, Topology::open, inputs["knots"].get<std::vector<double>>()).value();
  return BSplineCurve::make(knots, points).value();
}

BezierCurve bezier(std::vector<Eigen::Vector3d> points) { return BezierCurve::make(std::move(points)).value(); }

/// The same curve at the parameter tau -> tau^3 (so that it pauses at 0), and shrunk, turned and moved.
struct Changed {
  const BSplineCurve& curve;
  RigidMotion motion{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  double scale = 1;
  bool cubed = false;

  void evaluate(double tau, std::span<Eigen::Vector3d> out) const {
    curve.evaluate(cubed ? tau * tau * tau : tau, out);
    if (cubed && out.size() > 1) out[1] *= 3 * tau * tau;
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = scale * (motion.turn * out[k]).eval();
    out[0] += motion.move;
  }
};

}  // namespace

TEST_CASE("oracle 08: lengths of the model curve, helix, circle, ellipse and the report's cubic") {
  const nlohmann::json& cases = load_oracle("08_differential_geometry.json")["cases"];
  REQUIRE(cases.contains("ellipse_2_3.5"));
  const nlohmann::json &model = cases["report_model_curve"], &cubic = cases["report_clamped_cubic_bspline"];
  const WaveCurve curve = report_model();
  const ArcLength length(curve.view());
  CHECK(close(length.length(), model["length_0_2pi"].get<double>(), oracle_tolerance));
  CHECK(close(length.at(1), model["length_0_1"].get<double>(), oracle_tolerance));
  CHECK(close(length.parameter_at(length.length() / 2), model["t_at_half_length"].get<double>(), oracle_tolerance));
  CHECK(close(arc_length(curve.view(), 0, 1), model["length_0_1"].get<double>(), oracle_tolerance));
  CHECK_FALSE(close(arc_length(curve.view(), 0, 1 + 1e-11), model["length_0_1"].get<double>(), oracle_tolerance));
  CHECK(close(arc_length(helix(1, 1, 0.25, 2).view()), cases["helix_1_0.25_0_4pi"]["length"].get<double>(),
              oracle_tolerance));
  CHECK(close(arc_length(circle(5).view()), cases["circle_radius_5"]["length"].get<double>(), oracle_tolerance));
  CHECK(close(arc_length(helix(3.5, 2, 0, 1).view()), read_case(cases["ellipse_2_3.5"])["length"].get<double>(),
              oracle_tolerance));
  const BSplineCurve spline = report_spline();
  CHECK(close(arc_length(curve_view(spline)), cubic["length"].get<double>(), oracle_tolerance));
  CHECK(close(arc_length(curve_view(spline), 0, 1), cubic["length_0_1"].get<double>(), oracle_tolerance));
}

TEST_CASE("lengths that are known: a parabola, a cusp, a corner, a line") {
  // (t, t^2) on [0,1]: (2 sqrt 5 + asinh 2) / 4.
  const BezierCurve parabola = bezier({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
  CHECK(close(arc_length(curve_view(parabola)), (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4, 1e-14));
  // (t^2, t^3) on [-1,1] has a cusp inside: 2 (13 sqrt 13 - 8) / 27.
  const double half_cusp = (13 * std::sqrt(13.0) - 8) / 27;
  const BezierCurve cusp = bezier({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}});
  CHECK(close(arc_length(curve_view(cusp)), 2 * half_cusp, 1e-13));
  CHECK(close(ArcLength(curve_view(cusp)).at(0.5), half_cusp, 1e-13));
  // The cusp at a place that no halving meets: (s^2, s^3), s = t - 0.3.
  const WaveCurve astroid{
      {{{0.75, 0, 0}, 1, 0}, {{0.25, 0, 0}, 3, 0}, {{0, 0.75, 0}, 1, sine}, {{0, -0.25, 0}, 3, sine}},
      0.3,
      0.3 + round};
  CHECK(close(arc_length(astroid.view()), 6, 1e-13));
  // A polygon: length by length.
  const BSplineCurve polygon = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 5, 5}).value(),
                                                  {{0, 0, 0}, {3, 4, 0}, {3, 4, 2}})
                                   .value();
  CHECK(close(arc_length(curve_view(polygon)), 7, 1e-15));
  CHECK(close(ArcLength(curve_view(polygon)).parameter_at(6), 3, 1e-15));
  // There and back again, (4t(1-t), 0, 0): speed is 0 in the middle.
  CHECK(close(arc_length(curve_view(bezier({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}))), 2, 1e-14));
}

TEST_CASE("the parameter at a length is the inverse of the length up to a parameter") {
  std::mt19937 random(31);
  for (const Topology topology : {Topology::open, Topology::closed}) {
    for (int degree = 1; degree <= 9; ++degree) {
      const BSplineCurve spline = random_spline(degree, degree + 5, topology, random);
      const ArcLength length(curve_view(spline));
      double before = -1;
      for (int k = 0; k <= 40; ++k) {
        const double s = length.length() * k / 40, t = length.parameter_at(s);
        CAPTURE(degree);
        CAPTURE(k);
        CHECK(close(length.at(t), s, 1e-13, length.length()));
        CHECK(t > before);
        before = t;
        std::array<Eigen::Vector3d, 2> c;
        spline.evaluate(t, c);
        if (k > 0 && k < 40) {
          const double h = 1e-6 * length.length(), dt = length.parameter_at(s + h) - length.parameter_at(s - h);
          // dt/ds = 1/|c'|, where the curve has no corner near.
          if (degree > 2 && speed(c) > 0.2) CHECK(close(dt / (2 * h), 1 / speed(c), 1e-4));
        }
      }
      CHECK(length.parameter_at(length.length()) == spline.knots().end());
      CHECK(length.parameter_at(0) == spline.knots().start());
    }
  }
}

TEST_CASE("length adds up, is turned round, and is the limit of the chords") {
  std::mt19937 random(32);
  const BSplineCurve spline = random_spline(3, 9, Topology::open, random);
  const CurveView view = curve_view(spline);
  const ArcLength length(view);
  for (const double t : {0.7, 2.0, 3.3, 5.9}) {
    CHECK(close(arc_length(view, 0, t) + arc_length(view, t, 6), length.length(), 1e-13));
    CHECK(close(arc_length(view, 0, t), length.at(t), 1e-13));
    CHECK(arc_length(view, t, 1) == -arc_length(view, 1, t));
    CHECK(arc_length(view, t, t) == 0);
  }
  double chords = 0;
  for (int k = 0; k < 4000; ++k) chords += (spline(6.0 * (k + 1) / 4000) - spline(6.0 * k / 4000)).norm();
  CHECK(close(chords, length.length(), 1e-4));
  CHECK(chords <= length.length());
}

TEST_CASE("length does not see the parameter, nor a motion; it scales") {
  std::mt19937 random(33);
  for (int k = 0; k < 20; ++k) {
    const BSplineCurve spline = random_spline(1 + k % 5, 8, Topology::open, random);
    const double whole = arc_length(curve_view(spline));
    std::vector<double> breaks;
    for (const double t : spline.knots().knots()) breaks.push_back(std::cbrt(t));
    const Changed cubed{spline, {Eigen::Matrix3d::Identity(), {0, 0, 0}}, 1, true};
    CHECK(close(arc_length(curve_view(cubed, 0, std::cbrt(6.0), Topology::open, breaks)), whole, 1e-12));
    const Changed moved{spline, random_motion(random), 1e-3};
    CHECK(close(arc_length(curve_view(moved, 0, 6, Topology::open, spline.knots().knots())), 1e-3 * whole, 1e-12));
    CHECK_FALSE(close(arc_length(curve_view(moved, 0, 6, Topology::open, spline.knots().knots())), whole, 1e-3));
  }
}

TEST_CASE("points at equal distances along the curve, open and closed") {
  const WaveCurve ellipse = helix(3, 1, 0, 1), coil = helix(1, 2, 0.5, 1);
  const ArcLength closed(ellipse.view()), open(coil.view());
  const std::vector<double> round_trip = closed.equidistant(12), one_way = open.equidistant(12);
  REQUIRE(round_trip.size() == 12);
  CHECK(round_trip.front() == 0);
  CHECK(one_way.front() == 0);
  CHECK(one_way.back() == round);
  for (std::size_t k = 0; k < 12; ++k) {
    CHECK(close(closed.at(round_trip[k]), closed.length() * static_cast<double>(k) / 12, 1e-13, closed.length()));
    CHECK(close(open.at(one_way[k]), open.length() * static_cast<double>(k) / 11, 1e-13, open.length()));
  }
  CHECK(close(round_trip[3], round / 4, 1e-13));  // by symmetry
  CHECK(open.equidistant(1) == std::vector<double>{0});
}

TEST_CASE("lengths and parameters beyond the ends stay at the ends") {
  const WaveCurve ring = circle(2);
  const ArcLength length(ring.view(), 1, 3);
  CHECK(length.at(0) == 0);
  CHECK(length.at(7) == length.length());
  CHECK(close(length.length(), 4, 1e-14));
  CHECK(length.parameter_at(-1) == 1);
  CHECK(length.parameter_at(100) == 3);
}

TEST_CASE("a curve without length, one that pauses, one far away, one of rounding") {
  const Eigen::Vector3d here(1, 0.1, 7);
  const BezierCurve point = bezier({here, here, here, here});
  const ArcLength nothing(curve_view(point));
  CHECK(close(nothing.length(), 0, 1e-14, 7));
  CHECK(nothing.equidistant(3).size() == 3);
  const ArcLength zero(curve_view(bezier({{0, 0, 0}, {0, 0, 0}})));
  CHECK(zero.length() == 0);
  CHECK(zero.parameter_at(0) == 0);
  CHECK(zero.parameter_at(1) == 0);
  // A polygon whose second side is a point: on from the first parameter that has the length.
  const BSplineCurve paused = BSplineCurve::make(KnotVector::make(1, Topology::open, {0, 0, 1, 2, 3, 3}).value(),
                                                 {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}})
                                  .value();
  const ArcLength with_pause(curve_view(paused));
  CHECK(close(with_pause.parameter_at(1), 1, 1e-14));
  CHECK(close(with_pause.parameter_at(1.5), 2.5, 1e-14));
  CHECK(close(with_pause.at(1.5), 1, 1e-15));
  // Far from the origin the points are rounded.
  const Eigen::Vector3d far(1e8, -1e8, 1e8);
  CHECK(close(arc_length(curve_view(bezier({far, far + Eigen::Vector3d(1, 0, 0), far + Eigen::Vector3d(1, 1, 0)}))),
              arc_length(curve_view(bezier({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}))), 1e-6));
  // So small that squares underflow, and so large that they would overflow above.
  for (const double size : {1e-200, 1e90}) {
    const BezierCurve line = bezier({{0, 0, 0}, {3 * size, 4 * size, 0}});
    CHECK(close(arc_length(curve_view(line)), 5 * size, 1e-15));
  }
}

}  // namespace knotwork::arc_length_test
