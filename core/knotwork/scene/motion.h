#pragma once

#include <Eigen/Geometry>

#include "knotwork/scene/document.h"

namespace knotwork::scene {

/// The report's motion, frame-rate independent (THEORY 2.10): displacement of an even patch after clock time t with
/// rate a, in the parent's axes a (1 - cos t, sin t, 0), or along the turning local axes.
Eigen::Vector3d report_displacement_parent(double t, double rate);
Eigen::Vector3d report_displacement_local(double t, double rate);
/// The report's turn about the local x axis: angle 2t.
Eigen::Quaterniond report_rotation(double t);

/// The report's and the seed's frame-by-frame forms, kept to show what the frame rate does to them (oracle 11).
enum class MotionStep : unsigned char { seed_code, parent_axes, report_text };
/// The frame of an even (odd: sign -1) local after `frames` steps of dt, starting at the identity.
Eigen::Isometry3d stepped_motion(MotionStep step, int frames, double dt, int local);

/// What the animation adds to patch (i, j) at its clock, with period clock_period; the identity at time 0 and wherever
/// amplitude and shares say so. The displacement's sign alternates with i + j.
/// `breathe`, in the patch's own frame: along the normal by amplitude * translation * sin t, and a tilt about the own
/// x axis by at most 0.45 rad. `report`, in model axes: report_displacement_parent, and the turn about the x axis, its
/// share rounded to 0, 1 or 2 whole turns a period (the report's angle 2t is 2): others would jump as the clock wraps.
struct PatchMotion {
  Eigen::Vector3d own_translation = Eigen::Vector3d::Zero(), model_translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond own_rotation = Eigen::Quaterniond::Identity(), model_rotation = Eigen::Quaterniond::Identity();
};
PatchMotion patch_motion(const Animation& animation, PatchIndex patch);

}  // namespace knotwork::scene
