#include "knotwork/scene/motion.h"

#include <cmath>

namespace knotwork::scene {

namespace {

/// The report's step length, model units a frame.
constexpr double step_length = 0.025;
/// How far `breathe` tilts a patch at most, radians.
constexpr double largest_tilt = 0.45;

double alternating_sign(int index) { return index % 2 == 0 ? 1.0 : -1.0; }

Eigen::Quaterniond turn_about_x(double angle) { return {std::cos(angle / 2), std::sin(angle / 2), 0, 0}; }

PatchMotion breathe(const Animation& animation, double sign) {
  const double swing = sign * std::sin(animation.time);
  PatchMotion motion;
  motion.own_translation.z() = animation.amplitude * animation.translation * swing;
  const double tilt = largest_tilt * animation.rotation * swing;
  if (tilt != 0) motion.own_rotation = turn_about_x(tilt);
  return motion;
}

PatchMotion report(const Animation& animation, double sign) {
  PatchMotion motion;
  // Whole turns a period: anything between would jump when the clock starts again. With both of them the patch steps
  // along its own, turning axes, which is the report's motion; with one of them that path would not close.
  const double turns = std::round(2 * animation.rotation);
  const auto displacement = turns == 2 ? report_displacement_local : report_displacement_parent;
  motion.model_translation = sign * animation.translation * displacement(animation.time, animation.amplitude);
  if (turns != 0 && animation.time != 0) motion.model_rotation = turn_about_x(turns * animation.time);
  return motion;
}

}  // namespace

Eigen::Vector3d report_displacement_parent(double t, double rate) {
  // 1 - cos t without its cancellation near 0.
  const double s = std::sin(t / 2);
  return rate * Eigen::Vector3d(2 * s * s, std::sin(t), 0);
}

Eigen::Vector3d report_displacement_local(double t, double rate) {
  const double s = std::sin(t / 2), s3 = std::sin(1.5 * t);
  return rate * Eigen::Vector3d(2 * s * s, std::sin(t) / 2 + std::sin(3 * t) / 6, s * s + s3 * s3 / 3);
}

Eigen::Quaterniond report_rotation(double t) { return turn_about_x(2 * t); }

Eigen::Isometry3d stepped_motion(MotionStep step, int frames, double dt, int local) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const bool odd = local % 2 != 0;
  if (step == MotionStep::report_text && odd) return frame;

  const double length = step == MotionStep::report_text ? step_length * step_length : step_length * (odd ? -1 : 1);
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
  for (int m = 1; m <= frames; ++m) {
    Eigen::Vector3d move(std::sin(m * dt), std::cos(m * dt), 0);
    if (step == MotionStep::seed_code) move = report_rotation((m - 1) * dt) * move;
    displacement += length * move;
  }
  frame.translation() = displacement;
  // The angle is kept instead of a product of small turns: nothing drifts.
  frame.linear() = report_rotation(frames * dt).toRotationMatrix();
  return frame;
}

PatchMotion patch_motion(const Animation& animation, PatchIndex patch) {
  const double sign = alternating_sign(patch.first + patch.second);
  return animation.motion == MotionKind::report ? report(animation, sign) : breathe(animation, sign);
}

}  // namespace knotwork::scene
