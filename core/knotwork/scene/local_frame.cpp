#include "knotwork/scene/local_frame.h"

namespace knotwork::scene {
namespace {

bool turns_nothing(const Eigen::Quaterniond& q) { return q.coeffs() == Eigen::Quaterniond::Identity().coeffs(); }

}  // namespace

Eigen::Affine3d local_map(const LocalFrame& local) {
  const PatchEdit& edit = local.edit;
  const PatchMotion& motion = local.motion;
  const Eigen::Matrix3d& f = local.axes;
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.translation() = local_origin(local);
  if (!turns_nothing(edit.rotation) || !turns_nothing(motion.own_rotation) || edit.scale != Eigen::Vector3d::Ones()) {
    const Eigen::Matrix3d turn = (edit.rotation.normalized() * motion.own_rotation).toRotationMatrix();
    map.linear() = f * turn * edit.scale.asDiagonal() * f.transpose();
  }
  if (!turns_nothing(motion.model_rotation)) map.linear() = map.linear() * motion.model_rotation.toRotationMatrix();
  return map;
}

Eigen::Vector3d local_origin(const LocalFrame& local) {
  const Eigen::Vector3d place = local.centre + local.motion.model_translation;
  const Eigen::Vector3d own = local.edit.translation + local.motion.own_translation;
  return own == Eigen::Vector3d::Zero() ? place : Eigen::Vector3d(place + local.axes * own);
}

Eigen::Matrix3d turned_axes(const LocalFrame& local) {
  return local.axes * local.edit.rotation.normalized().toRotationMatrix();
}

}  // namespace knotwork::scene
