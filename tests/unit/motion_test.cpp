#include "knotwork/scene/motion.h"

#include <array>
#include <string>
#include <vector>

#include "knotwork/curve/blending_curve.h"
#include "unit/model_curves.h"
#include "unit/oracle.h"

namespace knotwork::scene::motion_test {
using namespace test;

namespace {

Eigen::Matrix3d oracle_rotation(const nlohmann::json& matrix) {
  Eigen::Matrix3d r;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      r(row, column) = matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].get<double>();
    }
  }
  return r;
}

Animation animation(MotionKind kind, double time) {
  Animation a;
  a.motion = kind;
  a.time = time;
  a.amplitude = 0.3;
  a.rotation = 1;
  return a;
}

}  // namespace

TEST_CASE("motion: the frame-by-frame forms meet oracle 11") {
  const nlohmann::json& oracle = load_oracle("11_motion.json");
  REQUIRE(oracle.contains("variants"));
  const double dt = oracle["dt"].get<double>();
  int states = 0;
  for (const auto& variant : oracle["variants"]) {
    read_case(variant);
    const std::string name = variant["variant"].get<std::string>();
    CAPTURE(name);
    const MotionStep step = name == "seed_code"     ? MotionStep::seed_code
                            : name == "parent_axes" ? MotionStep::parent_axes
                                                    : MotionStep::report_text;
    for (const auto& state : variant["states"]) {
      const int frames = state["frame"].get<int>();
      CAPTURE(frames);
      for (int local = 0; local < 2; ++local) {
        const auto index = static_cast<std::size_t>(local);
        const Eigen::Isometry3d frame = stepped_motion(step, frames, dt, local);
        CHECK(close(Eigen::Vector3d(frame.translation()), vector3(state["displacement_of_local_0_and_1"][index]),
                    oracle_tolerance));
        const Eigen::Matrix3d expected = oracle_rotation(state["matrix_of_local_0_and_1"][index]);
        CHECK((frame.linear() - expected).norm() <= oracle_tolerance * expected.norm());
        ++states;
      }
    }
  }
  CHECK(states == 30);
}

TEST_CASE("motion: the continuous limit meets oracle 11") {
  const nlohmann::json& oracle = load_oracle("11_motion.json");
  REQUIRE(oracle.contains("continuous_limit"));
  const double rate = oracle["continuous_limit_rate_a"].get<double>();
  int times = 0;
  for (const auto& entry : oracle["continuous_limit"]) {
    read_case(entry);
    const double t = entry["t"].get<double>();
    CAPTURE(t);
    CHECK(close(report_displacement_parent(t, rate), vector3(entry["parent_axes"]), oracle_tolerance));
    CHECK(close(report_displacement_local(t, rate), vector3(entry["local_axes"]), oracle_tolerance));
    ++times;
  }
  CHECK(times == 4);
}

TEST_CASE("motion: the report's three motions of a blending curve's locals meet oracle 06") {
  const nlohmann::json& oracle = load_oracle("06_blending_curve.json");
  REQUIRE(oracle.contains("cases"));
  int motions = 0;
  for (const auto& entry : oracle["cases"]) {
    const std::string name = entry["name"].get<std::string>();
    if (!name.starts_with("motion_")) continue;
    CAPTURE(name);
    const auto& inputs = entry["inputs"];
    const MotionStep step = name == "motion_seed_code"     ? MotionStep::seed_code
                            : name == "motion_parent_axes" ? MotionStep::parent_axes
                                                           : MotionStep::report_text;
    const KnotVector knots = KnotVector::make(1, Topology::closed, inputs["knots"].get<std::vector<double>>()).value();
    const BlendingKind kind = find_blending_family(inputs["B_function"].get<std::string>())->kind;
    std::vector<Eigen::Affine3d> locals = BlendingCurve::unmoved_locals(report_curve(), knots);
    for (std::size_t k = 0; k < locals.size(); ++k) {
      locals[k] = locals[k] *
                  stepped_motion(step, inputs["frames"].get<int>(), inputs["dt"].get<double>(), static_cast<int>(k));
      const Eigen::Affine3d expected = affine3(inputs["local_matrices_local_to_parent"][k]);
      CHECK((locals[k].matrix() - expected.matrix()).norm() <= oracle_tolerance * expected.matrix().norm());
    }
    const BlendingCurve curve =
        BlendingCurve::make(report_curve(), knots, BlendingFunction::make(kind).value(), {}, locals).value();
    for (const auto& at : entry["points"]) {
      std::array<Eigen::Vector3d, 4> jet;
      curve.evaluate(at["t"].get<double>(), jet);
      // The locals lie up to 5 apart, on knots 0.6 apart.
      const double scale[] = {5, 10, 50, 300};
      for (std::size_t k = 0; k < 4; ++k) {
        CHECK(close(jet[k], vector3(at["derivatives"][k]), oracle_tolerance, scale[k]));
      }
    }
    ++motions;
  }
  CHECK(motions == 3);
}

TEST_CASE("motion: small frames approach the continuous form, first order in dt") {
  const double t = 1.3, rate = 1.5;
  double last = 0;
  for (int frames : {100, 200, 400}) {
    const double dt = t / frames;
    // The step is 0.025 a frame; at this rate it stands for rate * dt.
    const Eigen::Vector3d stepped =
        stepped_motion(MotionStep::seed_code, frames, dt, 0).translation() * (rate * dt / 0.025);
    const double error = (stepped - report_displacement_local(t, rate)).norm();
    if (last > 0) CHECK(last / error == doctest::Approx(2).epsilon(0.1));
    last = error;
  }
  CHECK(last < 0.01);
}

TEST_CASE("motion: displacements are the integrals of their velocities") {
  const double h = 1e-4;
  for (double t : {0.1, 1.0, 2.5, 4.0, 6.0}) {
    CAPTURE(t);
    const Eigen::Vector3d velocity(std::sin(t), std::cos(t), 0);
    const auto slope = [&](auto f) -> Eigen::Vector3d { return (f(t + h, 1.0) - f(t - h, 1.0)) / (2 * h); };
    CHECK(close(slope(report_displacement_parent), velocity, 1e-7));
    CHECK(close(slope(report_displacement_local), report_rotation(t) * velocity, 1e-7));
    // A wrong velocity must be told apart.
    CHECK_FALSE(close(slope(report_displacement_local), velocity, 1e-7));
  }
}

TEST_CASE("motion: patches rest at time 0, swing against their neighbours and come back after a period") {
  for (MotionKind kind : {MotionKind::breathe, MotionKind::report}) {
    const PatchMotion rest = patch_motion(animation(kind, 0), {1, 2});
    CHECK(rest.own_translation == Eigen::Vector3d::Zero());
    CHECK(rest.model_translation == Eigen::Vector3d::Zero());
    CHECK(rest.own_rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
    CHECK(rest.model_rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());

    const PatchMotion even = patch_motion(animation(kind, 1), {1, 1}), odd = patch_motion(animation(kind, 1), {1, 2});
    const Eigen::Vector3d displacement = even.own_translation + even.model_translation;
    CHECK(displacement.norm() > 0.1);
    CHECK(close(Eigen::Vector3d(odd.own_translation + odd.model_translation), Eigen::Vector3d(-displacement), 1e-15));

    const PatchMotion start = patch_motion(animation(kind, 0.4), {1, 1});
    const PatchMotion later = patch_motion(animation(kind, 0.4 + clock_period), {1, 1});
    CHECK((start.own_translation - later.own_translation).norm() < 1e-14);
    CHECK((start.model_translation - later.model_translation).norm() < 1e-14);
    CHECK(start.own_rotation.angularDistance(later.own_rotation) < 1e-7);
    CHECK(start.model_rotation.angularDistance(later.model_rotation) < 1e-7);
  }
}

TEST_CASE("motion: breathing is along the normal, the report's is along its formula") {
  const PatchMotion breathing = patch_motion(animation(MotionKind::breathe, 0.7), {0, 0});
  CHECK(close(breathing.own_translation, {0, 0, 0.3 * std::sin(0.7)}, 1e-15));
  CHECK(breathing.own_rotation.angularDistance(Eigen::Quaterniond::Identity()) > 0.1);

  const PatchMotion report = patch_motion(animation(MotionKind::report, 0.7), {0, 0});
  CHECK(close(report.model_translation, report_displacement_local(0.7, 0.3), 1e-15));
  Animation unturned = animation(MotionKind::report, 0.7);
  unturned.rotation = 0;
  CHECK(close(patch_motion(unturned, {0, 0}).model_translation, report_displacement_parent(0.7, 0.3), 1e-15));
  CHECK((report.model_rotation.coeffs() - report_rotation(0.7).coeffs()).norm() < 1e-15);
}

TEST_CASE("motion: shares scale their part and 0 stops it") {
  Animation a = animation(MotionKind::breathe, 1);
  a.translation = 0;
  CHECK(patch_motion(a, {0, 0}).own_translation == Eigen::Vector3d::Zero());
  a.rotation = 0;
  CHECK(patch_motion(a, {0, 0}).own_rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());

  Animation r = animation(MotionKind::report, 1);
  // Half the share is one whole turn a period, and what lies between goes to the nearest whole number of turns.
  r.rotation = 0.5;
  CHECK(patch_motion(r, {0, 0}).model_rotation.angularDistance(report_rotation(0.5)) < 1e-7);
  r.rotation = 0.6;
  CHECK(patch_motion(r, {0, 0}).model_rotation.angularDistance(report_rotation(0.5)) < 1e-7);
  r.rotation = 0;
  CHECK(patch_motion(r, {0, 0}).model_rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
}

}  // namespace knotwork::scene::motion_test
